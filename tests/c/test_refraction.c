/*
 * Tests events/refraction.c: across a step of energy momenta change along the gradient by the impulse that balances the energy; the motion turns back
 * where its energy does not suffice.
 */
#include "law.h"

static double step; /* V behind the border */

static double step_of(const lag_arguments *at)
{
    return at->w[law_at.relation] != 0.0 ? step : 0.0;
}

/* A particle in a plane reaches a border a x + b y = 0 after 1 s, with these rates and masses. */
static lag_run *cross(lag_model *model, double a, double b, double mx, double my, double vx, double vy, double energy)
{
    law_clear(2);
    law.relations = 1;
    law.relation[0][0] = a;
    law.relation[0][1] = b;
    law.mass[0] = mx;
    law.mass[1] = my;
    law.qd[0] = vx;
    law.qd[1] = vy;
    law.q[0] = -vx;
    law.q[1] = -vy;
    law.potential = step_of;
    step = energy;
    *model = law_model();
    lag_run *run = law_begin(model, LAG_OK);
    CHECK(lag_run_to(run, 1.5, 0) == LAG_OK);
    return run;
}

/* v'^2 = v^2 - 2 dV/m */
static void a_step_takes_its_energy_from_the_normal_speed(void)
{
    static const double cases[][4] = {/* m, v, dV, v' */
        {1.0, 3.0, 2.5, 2.0}, {2.0, 3.0, 5.0, 2.0}, {1.0, 2.0, -2.5, 3.0}, {1.0, 1.0, 0.5 - 5e-9, 1e-4}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        lag_model model;
        double at = 0.0;
        lag_run *run = cross(&model, 1.0, 0.0, cases[k][0], 1.0, cases[k][1], 0.0, cases[k][2]);
        CHECK_NEAR(run->stepper.x[2], cases[k][3], 1e-9 / cases[k][3]);
        CHECK(run->motion.w[law_at.relation] == 1.0 && law_count(LAG_TRUE, &at) == 1);
        CHECK_NEAR(at, 1.0, 1e-12);
        free(run);
    }
}

/* 2 dV/m > v^2: it is thrown back with the same speed, and the relation does not turn. */
static void what_cannot_climb_the_step_turns_back(void)
{
    lag_model model;
    double at = 0.0;
    lag_run *run = cross(&model, 1.0, 0.0, 1.0, 1.0, 2.0, 0.5, 2.5);
    CHECK_NEAR(run->stepper.x[2], -2.0, 1e-9);
    CHECK_NEAR(run->stepper.x[3], 0.5, 1e-15);
    CHECK(run->motion.w[law_at.relation] == 0.0 && law_count(LAG_TRUE, &at) == 0);
    free(run);
}

/* The same border in other units: only its direction counts. Along (3, 4)/5: 5 of (3, 4), and sqrt(25 - 9) = 4 behind dV = 9/2. */
static void only_the_direction_of_the_border_counts(void)
{
    static const double sizes[3] = {1.0, 1e-4, 1e4};
    for (size_t k = 0; k < 3; ++k) {
        lag_model model;
        lag_run *run = cross(&model, 3.0 * sizes[k], 4.0 * sizes[k], 1.0, 1.0, 3.0, 4.0, 4.5);
        CHECK_NEAR(run->stepper.x[2], 2.4, 1e-9);
        CHECK_NEAR(run->stepper.x[3], 3.2, 1e-9);
        free(run);
    }
}

/*
 * Snell: the momentum along the border stays. Masses 1 and 4, gradient (1, 1): p changes by mu (1, 1), with mu^2 (1 + 1/4)/2 + mu (vx + vy) + dV = 0,
 * the root near zero.
 */
static void momenta_change_along_the_gradient_by_what_the_energy_asks_for(void)
{
    static const double energies[2] = {1.5, -2.0};
    for (size_t k = 0; k < 2; ++k) {
        lag_model model;
        const double mu = (-3.0 + sqrt(9.0 - 2.5 * energies[k])) / 1.25;
        lag_run *run = cross(&model, 1.0, 1.0, 1.0, 4.0, 2.0, 1.0, energies[k]);
        CHECK_NEAR(run->stepper.x[2], 2.0 + mu, 1e-9);
        CHECK_NEAR(run->stepper.x[3], 1.0 + 0.25 * mu, 1e-9);
        free(run);
    }
}

int main(void)
{
    a_step_takes_its_energy_from_the_normal_speed();
    what_cannot_climb_the_step_turns_back();
    only_the_direction_of_the_border_counts();
    momenta_change_along_the_gradient_by_what_the_energy_asks_for();
    (void)printf("refraction: ok\n");
    return EXIT_SUCCESS;
}
