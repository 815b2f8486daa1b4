/* Attempts in lanes are those of each stepper alone, to the bit, also inside of steps: in every width of registers, in two groups. */
#include <string.h>

#include "check.h"
#include "lag/methods/attempts.h"
#include "problems.h"

enum { LANES = 4, GROUPS = 2, ALL = LANES * GROUPS, SIZE = 3, MOST = 4096 };

static const lag_ode SMOOTH = {.size = SIZE, .nq = 0, .rates = smooth_rates, .jacobian = smooth_jacobian};

/* Each lane by the rates of one; in the lane of this time, if any, there are none. */
static void rates(void *context, const double *t, const double *x, double *xd, double *fault)
{
    const double *wall = context;
    for (size_t k = 0; k < LANES; ++k) {
        double own[SIZE];
        double found[SIZE];
        for (size_t i = 0; i < SIZE; ++i) {
            own[i] = x[i * LANES + k];
        }
        (void)smooth_rates(NULL, t[k], own, found);
        for (size_t i = 0; i < SIZE; ++i) {
            xd[i * LANES + k] = found[i];
        }
        fault[k] = t[k] > *wall ? (double)NAN : fault[k];
    }
}

static void begin(lag_stepper *s, double *memory, size_t k)
{
    memset(memory, 0, MOST * sizeof(double));
    CHECK(lag_stepper_memory(&SMOOTH) <= MOST);
    lag_stepper_place(s, &SMOOTH, memory);
    s->t = 0.1 * (double)k;
    smooth_exact(s->t, s->x);
    for (size_t i = 0; i < SIZE; ++i) {
        s->tolerance[i] = k == 3 ? 1e-13 : 1e-8; /* one of them is rejected at first */
    }
    s->h = 0.5;
    s->h_least = 1e-14;
    CHECK(lag_stepper_begin(s, &lag_dop853, 2.0) == LAG_OK);
}

static void same(lag_stepper *together, lag_stepper *alone)
{
    double a[SIZE];
    double b[SIZE];
    const double inside = alone->t_before + 0.3 * (alone->t - alone->t_before);
    CHECK(together->t == alone->t && together->h == alone->h && together->last.urge == alone->last.urge);
    CHECK(memcmp(together->x, alone->x, sizeof a) == 0 && memcmp(together->f, alone->f, sizeof a) == 0);
    CHECK(together->counts.evaluations == alone->counts.evaluations && together->counts.rejections == alone->counts.rejections);
    CHECK(lag_stepper_dense(together, inside, a) == LAG_OK && lag_stepper_dense(alone, inside, b) == LAG_OK);
    CHECK(memcmp(a, b, sizeof a) == 0);
}

/* `announced`: the dense output is made in lanes, too; else stages are found again. */
static void steps_are_those_alone(size_t width, int announced, double wall)
{
    static double memory[ALL][MOST], memory_alone[ALL][MOST], lanes[GROUPS][MOST];
    lag_stepper together[ALL];
    lag_stepper alone[ALL];
    lag_stepper *given[ALL];
    lag_attempts groups[GROUPS];
    for (size_t g = 0; g < GROUPS; ++g) {
        CHECK(lag_attempts_memory(SIZE, LANES) <= MOST);
        lag_attempts_place(groups + g, SIZE, LANES, width, lanes[g]);
        groups[g].rates = rates;
        groups[g].context = &wall;
    }
    for (size_t k = 0; k < ALL; ++k) {
        begin(together + k, memory[k], k);
        begin(alone + k, memory_alone[k], k);
    }
    for (int round = 0; round < 6; ++round) {
        for (size_t k = 0; k < ALL; ++k) {
            given[k] = k == 6 ? NULL : together + k; /* one lane is free */
            if (given[k] != NULL) {
                lag_attempt_begin(given[k], 4.0);
                given[k]->attempt.dense = announced;
                lag_attempts_enter(groups + k / LANES, given[k], k % LANES);
            }
        }
        lag_attempts_make(groups, GROUPS);
        for (size_t k = 0; k < ALL; ++k) {
            if (given[k] != NULL && lag_attempts_settle(groups + k / LANES, given[k], k % LANES)) {
                CHECK(lag_stepper_step(together + k, 4.0) == LAG_OK && lag_stepper_step(alone + k, 4.0) == LAG_OK);
                const size_t more = together[k].attempt.bare && !together[k].attempt.dense ? LAG_DOP853_STAGES - 1 : 0;
                same(together + k, alone + k);
                together[k].counts.evaluations -= more;
            }
        }
    }
    CHECK(together[3].counts.rejections > 0);
}

/* Tolerances that follow the state, of two groups of numbers. */
typedef struct scales {
    double group[SIZE], natural[SIZE], cap[SIZE], largest[SIZE];
    lag_accuracy accuracy;
} scales;

static void follow(scales *own, lag_stepper *s, size_t k)
{
    const double part = k == 3 ? 1e-7 : 1.0; /* attempts of this one are rejected at first */
    *own = (scales){.group = {0.0, 0.0, 2.0}, .natural = {part, part, 2.0 * part}, .cap = {0.5 * part, 0.5 * part, 3.0 * part}};
    own->accuracy = (lag_accuracy){
        .size = SIZE, .group = own->group, .natural = own->natural, .cap = own->cap, .largest = own->largest, .relative = 1e-7
    };
    lag_accuracy_after(&own->accuracy, s->x, s->tolerance);
}

/* One attempt of all lanes; those that do not go on are closed, settled and opened again. The number of steps that were made without their steppers. */
static size_t go_on(lag_attempts *groups, lag_stepper *s, scales *own, int first)
{
    size_t without = 0;
    for (size_t k = 0; k < ALL; ++k) {
        lag_attempts *group = groups + k / LANES;
        const size_t place = k % LANES;
        if (!first && (group->step.accepted[place] != 0.0 || group->step.refused[place] != 0.0)) {
            continue;
        }
        if (!first) {
            without += lag_attempts_close(group, place, s + k, &own[k].accuracy);
            if (lag_attempts_settle(group, s + k, place)) {
                CHECK(lag_stepper_step(s + k, 4.0) == LAG_OK);
                lag_accuracy_after(&own[k].accuracy, s[k].x, s[k].tolerance);
            }
        }
        lag_attempt_begin(s + k, 4.0);
        s[k].attempt.dense = 0;
        lag_attempts_enter(group, s + k, place);
        lag_attempts_open(group, place, &own[k].accuracy);
        group->step.row[place] = (double)INFINITY;
        group->step.border[place] = (double)INFINITY;
        group->step.left[place] = 1.0 + (double)(k % 3); /* some come back after a step or two */
    }
    lag_attempts_make(groups, GROUPS);
    return without;
}

/* Lanes that go on without their steppers are where these are alone, with their tolerances and counts. */
static void open_lanes_are_those_alone(size_t width)
{
    static double memory[ALL][MOST], memory_alone[ALL][MOST], lanes[GROUPS][MOST];
    static const double never = (double)INFINITY;
    lag_stepper together[ALL];
    lag_stepper alone[ALL];
    scales of_together[ALL];
    scales of_alone[ALL];
    lag_attempts groups[GROUPS];
    size_t without = 0;
    for (size_t g = 0; g < GROUPS; ++g) {
        lag_attempts_place(groups + g, SIZE, LANES, width, lanes[g]);
        groups[g].rates = rates;
        groups[g].context = (void *)(size_t)&never;
    }
    for (size_t k = 0; k < ALL; ++k) {
        begin(together + k, memory[k], k);
        begin(alone + k, memory_alone[k], k);
        follow(of_together + k, together + k, k);
        follow(of_alone + k, alone + k, k);
    }
    for (int round = 0; round < 7; ++round) {
        without += go_on(groups, together, of_together, round == 0);
    }
    for (size_t k = 0; k < ALL; ++k) {
        without += lag_attempts_close(groups + k / LANES, k % LANES, together + k, &of_together[k].accuracy);
        while (alone[k].counts.steps < together[k].counts.steps) {
            CHECK(lag_stepper_step(alone + k, 4.0) == LAG_OK);
            lag_accuracy_after(&of_alone[k].accuracy, alone[k].x, alone[k].tolerance);
        }
        CHECK(together[k].t == alone[k].t && together[k].h == alone[k].h && together[k].last.error == alone[k].last.error);
        CHECK(memcmp(together[k].x, alone[k].x, SIZE * sizeof(double)) == 0 && memcmp(together[k].f, alone[k].f, SIZE * sizeof(double)) == 0);
        CHECK(memcmp(together[k].tolerance, alone[k].tolerance, SIZE * sizeof(double)) == 0);
        CHECK(memcmp(of_together[k].largest, of_alone[k].largest, SIZE * sizeof(double)) == 0);
        CHECK(together[k].counts.evaluations == alone[k].counts.evaluations && together[k].counts.rejections == alone[k].counts.rejections);
    }
    CHECK(without > 0 && together[3].counts.rejections > 0);
}

int main(void)
{
    static const size_t widths[] = {2, 4, 8};
    for (size_t i = 0; i < 3; ++i) {
#if defined(__x86_64__)
        const int there = widths[i] == 2 || (widths[i] == 4 ? __builtin_cpu_supports("avx") : __builtin_cpu_supports("avx512f"));
#else
        const int there = widths[i] == 2;
#endif
        if (there) {
            steps_are_those_alone(widths[i], 1, (double)INFINITY);
            steps_are_those_alone(widths[i], 0, (double)INFINITY);
            steps_are_those_alone(widths[i], 1, 0.9); /* lanes that fail are left to attempts alone */
            open_lanes_are_those_alone(widths[i]);
        }
    }
    (void)printf("attempts: ok\n");
    return EXIT_SUCCESS;
}
