/*
 * The problem of unilateral rows with Coulomb's friction, of impulses as of accelerations:
 *
 *     gamma = G lam + c,   0 <= lam_n, gamma_n >= 0, lam_n gamma_n = 0,   -lam_t in R Sign(gamma_t),   R = max(0, r + mu lam_n)
 *
 * with Sign(gamma) = gamma/norm(gamma), at gamma = 0 the unit disc. A slip has one component, or two in a plane. G need not be symmetric:
 * friction that slips adds its part to the columns of the normal rows.
 *
 * Without friction, and with a symmetric G, lam is that of a problem of least squares, which has a solution in any case: what of c is outside
 * of the range of G is left out. Scalar slips: lam_t = y - m with y, m >= 0 makes it one linear complementarity problem, by Lemke's method. Slips in a
 * plane: Gauss-Seidel's iteration with projection onto the discs. Both end with Newton's method on lam - proj(lam - D gamma) = 0.
 *
 * Source: Glocker, Set-Valued Force Laws (2001), chapters 5 and 8 (the complementarity problem); Alart, Curnier, Comput. Methods Appl. Mech. Eng. 92
 * (1991) 353 (Newton's method on the projection); Jourdan, Alart, Jean, Comput. Methods Appl. Mech. Eng. 155 (1998) 31 (Gauss-Seidel).
 */
#ifndef LAG_FRICTION_PROBLEM_H
#define LAG_FRICTION_PROBLEM_H

#include <stddef.h>

/* Laws of forces, of impulses and of energies hold to this part of their largest terms. */
static const double LAG_SOLVED = 1e-9;
/* Rows and their Delassus matrix are known to this part of their terms: what is below is none. */
static const double LAG_KNOWN_ROWS = 1e-12;

typedef struct lag_friction_problem {
    size_t normals, frictions;
    const double *components; /* (frictions) 1 or 2: components of the slips, whose rows follow those of the normals */
    double *compliance;       /* (size, size) G, size = normals + components; destroyed */
    double *rates;            /* (size) c; destroyed */
    double *limits;           /* (frictions) r; destroyed */
    double *coefficients;     /* (frictions, normals) mu; destroyed */
} lag_friction_problem;

/* Doubles for a problem, and for all that are not larger in any of these. */
size_t lag_friction_problem_memory(size_t normals, size_t frictions, size_t size);

/* Forces or impulses lam (size). Returns 1, or 0 where there are none, or they were not found: lam is zero then. */
int lag_friction_problem_solve(lag_friction_problem *problem, double *lam, double *memory);

#endif
