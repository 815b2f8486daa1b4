/* Tests optimization/friction_problem.c: unilateral rows with Coulomb's friction against cases that are solved by hand. */
#include "check.h"
#include "lag/optimization/friction_problem.h"

enum { MOST = 6 };

/* One normal and one slip, whose forces are told. */
static int solve(size_t slips, const double *compliance, const double *rates, double limit, double mu, double *lam)
{
    static double memory[4096];
    const double components[1] = {(double)slips};
    const size_t size = 1 + slips;
    double g[MOST * MOST];
    double c[MOST];
    double r[1] = {limit};
    double m[1] = {mu};
    for (size_t i = 0; i < size * size; ++i) {
        g[i] = compliance[i];
    }
    for (size_t i = 0; i < size; ++i) {
        c[i] = rates[i];
    }
    CHECK(lag_friction_problem_memory(1, 1, size) <= sizeof memory / sizeof memory[0]);
    lag_friction_problem problem = {.normals = 1, .frictions = 1, .components = components, .compliance = g, .rates = c, .limits = r, .coefficients = m};
    return lag_friction_problem_solve(&problem, lam, memory);
}

/* G = 1: the normal force is 2; a slip of (3, 4) has a force of R = 1/2 2 against it, in its own direction. */
static void sliding_in_a_plane_opposes_the_slip_with_its_limit(void)
{
    static const double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const double rates[3] = {-2.0, 3.0, 4.0};
    double lam[3];
    CHECK(solve(2, identity, rates, 0.0, 0.5, lam));
    CHECK_NEAR(lam[0], 2.0, 1e-12);
    CHECK_NEAR(lam[1], -0.6, 1e-12);
    CHECK_NEAR(lam[2], -0.8, 1e-12);
}

/* |(0.6, 0.7)| < 1 < 0.6 + 0.7: within the disc, though outside of the square that stands on its corner. */
static void sticking_in_a_plane_bears_all_within_the_disc(void)
{
    static const double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const double rates[3] = {-2.0, 0.6, 0.7};
    double lam[3];
    CHECK(solve(2, identity, rates, 0.0, 0.5, lam));
    CHECK_NEAR(lam[1], -0.6, 1e-12);
    CHECK_NEAR(lam[2], -0.7, 1e-12);
}

/* |(0.8, 0.8)| > 1 > 0.8: outside of the disc, though within the square around it. */
static void sliding_in_a_plane_is_not_that_of_each_component(void)
{
    static const double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const double rates[3] = {-2.0, 0.8, 0.8};
    double lam[3];
    CHECK(solve(2, identity, rates, 0.0, 0.5, lam));
    CHECK_NEAR(lam[1], -sqrt(0.5), 1e-12);
    CHECK_NEAR(lam[2], -sqrt(0.5), 1e-12);
}

/*
 * G = (1 1/2; 1/2 5/4), mu = 1/2. Slip -4.5: lam_t = lam_n/2, so -1 + (1 + 1/4) lam_n = 0. Slip -0.75: both rates are zero, so
 * lam = G^-1 (1, 3/4) = (7/8, 1/4), and 1/4 < 7/16.
 */
static void normal_force_and_friction_are_one_problem(void)
{
    static const double g[4] = {1.0, 0.5, 0.5, 1.25};
    static const double slides[2] = {-1.0, -4.5};
    static const double sticks[2] = {-1.0, -0.75};
    double lam[2];
    CHECK(solve(1, g, slides, 0.0, 0.5, lam));
    CHECK_NEAR(lam[0], 0.8, 1e-12);
    CHECK_NEAR(lam[1], 0.4, 1e-12);
    CHECK(solve(1, g, sticks, 0.0, 0.5, lam));
    CHECK_NEAR(lam[0], 0.875, 1e-12);
    CHECK_NEAR(lam[1], 0.25, 1e-12);
}

/* A row that opens bears nothing, and its friction only the part of its limit that follows no normal force. */
static void what_opens_bears_nothing(void)
{
    static const double g[4] = {1.0, 0.0, 0.0, 1.0};
    static const double rates[2] = {1.0, 5.0};
    double lam[2];
    CHECK(solve(1, g, rates, 0.25, 0.5, lam));
    CHECK_NEAR(lam[0], 0.0, 1e-15);
    CHECK_NEAR(lam[1], -0.25, 1e-12);
}

/* Normal rows alone: G = (2 1; 1 2), c = (-3, 1). The first alone leaves -3/2 -> gamma_2 = 1 + 3/2 > 0: lam = (3/2, 0). */
static void without_friction_either_force_or_rate_is_zero(void)
{
    double memory[256];
    double g[4] = {2.0, 1.0, 1.0, 2.0};
    double c[2] = {-3.0, 1.0};
    double lam[2];
    CHECK(lag_friction_problem_memory(2, 0, 2) <= sizeof memory / sizeof memory[0]);
    lag_friction_problem problem = {.normals = 2, .compliance = g, .rates = c};
    CHECK(lag_friction_problem_solve(&problem, lam, memory));
    CHECK_NEAR(lam[0], 1.5, 1e-14);
    CHECK_NEAR(lam[1], 0.0, 0.0);
}

/*
 * Painleve's: friction that slides presses its own contact, G_nn lam_n + G_nt (mu lam_n) = (1 - 2) lam_n = -c has no lam_n >= 0 for an
 * approach c < 0, and the slip cannot stop at once as its row has no compliance.
 */
static void wedging_has_no_forces(void)
{
    static const double g[4] = {1.0, -2.0, 0.0, 0.0};
    static const double rates[2] = {-1.0, -1.0};
    double lam[2];
    CHECK(!solve(1, g, rates, 0.0, 1.0, lam));
    CHECK_NEAR(fabs(lam[0]) + fabs(lam[1]), 0.0, 0.0);
}

int main(void)
{
    sliding_in_a_plane_opposes_the_slip_with_its_limit();
    sticking_in_a_plane_bears_all_within_the_disc();
    sliding_in_a_plane_is_not_that_of_each_component();
    normal_force_and_friction_are_one_problem();
    what_opens_bears_nothing();
    without_friction_either_force_or_rate_is_zero();
    wedging_has_no_forces();
    (void)printf("friction problem: ok\n");
    return EXIT_SUCCESS;
}
