/*
 * M a - J' lam = f, J a = gamma in blocks: coordinates that here no entry of M and of J ties to each other do not move each other. Rates that are held are
 * rows, too, where the others can do with them.
 */
#ifndef LAG_BLOCKS_H
#define LAG_BLOCKS_H

#include "lag/dynamics.h"

typedef struct lag_blocks {
    const lag_model *model;
    const double *mass, *jacobian; /* (nq, nq) (nc, nq) */
    double *tied;            /* (nq) sets of coordinates; the least number of each is that of its block */
    double *place;           /* (nc) a coordinate of each row; nq: it is zero */
    /* one block: */
    size_t n, rows;          /* its coordinates, its rows with those that are held */
    double *coordinate;      /* (n) */
    double *own_mass, *own_rows; /* (n, n) (rows, n) */
    double *force, *right;   /* (n) (rows) of the system that is solved, */
    double *change, *lam;    /* (n) (rows) and its solution */
    lag_system system;
    double *memory;
} lag_blocks;

/* Doubles for the blocks of a model. */
size_t lag_blocks_memory(const lag_model *model);

/* The blocks that M and J tie; the caller may tie more. Both must stay. */
lag_blocks lag_blocks_of(const lag_model *model, const double *mass, const double *jacobian, double *memory);

/* 1: there is a block of this number. Its coordinates are listed. */
int lag_blocks_take(lag_blocks *blocks, size_t which);

/* The entries of x (nq) in the block that was taken, into `own` (n), and back. */
void lag_blocks_gather(const lag_blocks *blocks, const double *x, double *own);
void lag_blocks_scatter(const lag_blocks *blocks, const double *own, double *x);

/*
 * Solves the block that was taken for f (nq) and -gamma (nc; null: zero); `held` (nq flags, or null): these accelerations are zero, if all rows can be
 * satisfied with that. LAG_SINGULAR: *coordinate (if not null) is not determined.
 */
lag_status lag_blocks_solve(lag_blocks *blocks, const double *f, const double *residual, const double *held, size_t *coordinate);

#endif
