/*
 * Two angles of moment of inertia 1 with sin a + sin b = 0: on the branch b = -a they turn with constant rates, through a quarter turn,
 * where the branch b = a + pi crosses. With a little more than 0 on the right they must turn back instead.
 */
#include <string.h>

#include "check.h"
#include "lag/serialization.h"

enum { SIZE = 4, ROWS = 301 };

static lag_status prepare(const lag_arguments *at)
{
    (void)at;
    return LAG_OK;
}

static lag_status start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    (void)z;
    (void)u;
    q[0] = 1.0;
    q[1] = asin(at->p[0] - sin(1.0));
    qd[0] = 1.0;
    qd[1] = -cos(q[0]) / cos(q[1]);
    return LAG_OK;
}

static lag_status position(const lag_arguments *at, double *phi, double *jacobian)
{
    phi[0] = sin(at->q[0]) + sin(at->q[1]) - at->p[0];
    jacobian[0] = cos(at->q[0]);
    jacobian[1] = cos(at->q[1]);
    return LAG_OK;
}

static lag_status velocity(const lag_arguments *at, double *residual, double *jacobian)
{
    jacobian[0] = cos(at->q[0]);
    jacobian[1] = cos(at->q[1]);
    residual[0] = jacobian[0] * at->qd[0] + jacobian[1] * at->qd[1];
    return LAG_OK;
}

static lag_status mass(const lag_arguments *at, double *m)
{
    (void)at;
    m[0] = m[3] = 1.0;
    m[1] = m[2] = 0.0;
    return LAG_OK;
}

static lag_status dynamics(const lag_arguments *at, double *m, double *force, double *jacobian, double *gamma)
{
    jacobian[0] = cos(at->q[0]);
    jacobian[1] = cos(at->q[1]);
    gamma[0] = sin(at->q[0]) * at->qd[0] * at->qd[0] + sin(at->q[1]) * at->qd[1] * at->qd[1];
    force[0] = force[1] = 0.0;
    return mass(at, m);
}

static const lag_slot Q[2] = {{"a", "rad", NULL}, {"b", "rad", NULL}};
static const lag_slot C[1] = {{"c", "1", NULL}};
static const double P[1] = {0.0};
static const unsigned char ONE[1] = {1};
static const unsigned char NONE[1] = {0};

static const lag_model MODEL = {.version = LAG_MODEL_VERSION,
    .size = sizeof(lag_model),
    .name = "Angles",
    .nq = 2,
    .np = 1,
    .nc = 1,
    .rank = 1,
    .coordinates = Q,
    .constraints = C,
    .defaults = P,
    .position_level = ONE,
    .redundant = NONE,
    .prepare = prepare,
    .start = start,
    .position_constraint = position,
    .velocity_constraint = velocity,
    .mass_matrix = mass,
    .dynamics = dynamics};

static double times[ROWS];
static double rows[ROWS * SIZE];

static lag_run *place_filling(const lag_model *model, const double *p, double tolerance)
{
    const lag_run_options options = {.p = p,
        .method = &lag_dop853,
        .tolerance = tolerance,
        .careful = 1,
        .count = ROWS,
        .times = times,
        .rows = rows};
    void *block = malloc(lag_run_size(model, &options));
    CHECK(block != NULL);
    return lag_run_place(block, model, &options);
}

static lag_run *place(const double *p, double tolerance)
{
    return place_filling(&MODEL, p, tolerance);
}

static void crossed(double tolerance)
{
    lag_run *run = place(P, tolerance);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_to(run, times[ROWS - 1], 0) == LAG_OK);
    CHECK(run->row == ROWS);
    for (int i = 0; i < ROWS; ++i) {
        CHECK_NEAR(rows[SIZE * i], 1.0 + times[i], 1e-8);
        CHECK_NEAR(rows[SIZE * i + 1], -1.0 - times[i], 1e-8);
        CHECK_NEAR(rows[SIZE * i + 2], 1.0, 1e-7);
    }
    free(run);
}

/* sin a + sin b = p > 0: as a comes near to a quarter turn, b does not get to -pi/2 any more, and a goes on; p < 0: a turns back. */
static void missed(double error)
{
    const double p[1] = {error};
    lag_run *run = place(p, 1e-8);
    double most = 0.0;
    double least = 0.0;
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_to(run, 1.2, 0) == LAG_OK);
    for (int i = 0; i < ROWS && times[i] < 1.2; ++i) {
        const double *x = rows + SIZE * i;
        most = fmax(most, x[0]);
        least = fmin(least, x[1]);
        CHECK_NEAR(sin(x[0]) + sin(x[1]), error, 1e-9);
        CHECK_NEAR(x[2] * x[2] + x[3] * x[3], rows[2] * rows[2] + rows[3] * rows[3], 1e-6);
    }
    CHECK(error > 0.0 ? least > -1.5708 && most > 2.0 : most < 1.5708 && least < -2.0);
    free(run);
}

/* Saved before every step, also before and behind the crossing, and taken back by another run. */
static void taken_back(void)
{
    lag_run *one = place(P, 1e-9);
    lag_run *other = place(P, 1e-9);
    unsigned char *bytes = malloc(lag_run_saved_size(&MODEL, &one->options));
    size_t branch = 0;
    int going = 1;
    CHECK(bytes != NULL);
    CHECK(lag_run_begin(one, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_restart(one, 2.0) == LAG_OK);
    while (going) {
        CHECK(lag_run_step(one, 2.0) == LAG_OK);
        branch += one->stepper.method == &lag_branch_switching;
        lag_run_save(one, bytes);
        CHECK(lag_run_load(other, bytes) == LAG_OK);
        for (int k = 0; k < 2 && going; ++k) {
            CHECK(lag_run_finish(other, 2.0) == LAG_OK);
            going = other->stepper.t < 2.0;
            CHECK(!going || lag_run_step(other, 2.0) == LAG_OK);
        }
        CHECK(lag_run_load(other, bytes) == LAG_OK);
        CHECK(lag_run_finish(one, 2.0) == LAG_OK);
        CHECK(lag_run_finish(other, 2.0) == LAG_OK);
        CHECK(memcmp(one->stepper.x, other->stepper.x, SIZE * sizeof(double)) == 0);
        CHECK(one->stepper.t == other->stepper.t && one->stepper.h == other->stepper.h);
        CHECK(one->stepper.method == other->stepper.method);
        going = one->stepper.t < 2.0;
    }
    CHECK(branch == 1);
    CHECK_NEAR(one->stepper.x[0], 3.0, 1e-8);
    free(bytes);
    free(one);
    free(other);
}

/* Before the crossing the functions become those of another filling, and the first one is gone. */
static void filled_anew(void)
{
    lag_model first = MODEL;
    lag_run *run = place_filling(&first, P, 1e-10);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_to(run, 0.2, 0) == LAG_OK);
    CHECK(lag_run_change(run, &MODEL, NULL) == LAG_OK);
    memset(&first, 0xff, sizeof first);
    CHECK(lag_run_to(run, 2.0, 0) == LAG_OK);
    CHECK_NEAR(run->stepper.x[0], 3.0, 1e-8);
    CHECK_NEAR(run->stepper.x[1], -3.0, 1e-8);
    free(run);
}

int main(void)
{
    for (int i = 0; i < ROWS; ++i) {
        times[i] = 0.01 * i;
    }
    crossed(1e-6);
    crossed(1e-10);
    missed(1e-4);
    missed(1e-8);
    missed(-1e-8);
    missed(-1e-4);
    taken_back();
    filled_anew();
    (void)printf("singular: ok\n");
    return EXIT_SUCCESS;
}
