/* Tests impulses/position_maps.c: where a mass is, is the same on both sides of an instant, as well as the instant and the numbers are known. */
#include "law.h"

/* A mass at q0, with its discrete at q0 + q1. */
static lag_status way(const lag_arguments *at, double *place)
{
    place[0] = at->q[0] + at->w[0] * at->q[1];
    return LAG_OK;
}

/* The discrete turns where q1 has this value and this rate, at an instant that is known to a moment. */
static lag_status turn(double q1, double rate, double moment, double peak)
{
    const double x[4] = {3.0, q1, 5.0, rate};
    const double peaks[4] = {3.0, peak, 5.0, 1.0};
    const double before[1] = {0.0};
    law_clear(2);
    law.variables = 1;
    lag_model model = law_model();
    model.nway = 1;
    model.way = way;
    lag_run *run = law_begin(&model, LAG_OK);
    run->motion.w[0] = 1.0;
    const lag_status status = lag_position_maps_continue(&run->instants.maps, 0.0, x, x, before, moment, peaks);
    free(run);
    return status;
}

static void a_mass_does_not_jump(void)
{
    CHECK(turn(1e-3, 0.0, 0.0, 1.0) == LAG_WAY_JUMP);
    CHECK(turn(-1e-3, 0.0, 0.0, 1.0) == LAG_WAY_JUMP);
}

/* A corner of the way is none: at q1 = 0 only the rate jumps. */
static void a_way_may_have_a_corner(void)
{
    CHECK(turn(0.0, 100.0, 0.0, 1.0) == LAG_OK);
}

/* Off by 1e-6: what 1 m/s makes of a moment of 1e-6 s, but not of one of 1e-9 s. 3 m are known to 3e-9. */
static void a_jump_is_judged_by_what_is_known(void)
{
    CHECK(turn(1e-6, 1.0, 1e-6, 1.0) == LAG_OK);
    CHECK(turn(1e-6, 1.0, 1e-9, 1.0) == LAG_WAY_JUMP);
    CHECK(turn(1e-9, 0.0, 0.0, 1.0) == LAG_OK);
    CHECK(turn(1e-6, 0.0, 0.0, 1e10) == LAG_OK); /* the motion has been 1e10 m away */
}

int main(void)
{
    a_mass_does_not_jump();
    a_way_may_have_a_corner();
    a_jump_is_judged_by_what_is_known();
    (void)printf("position maps: ok\n");
    return EXIT_SUCCESS;
}
