/*
 * Mechanisms for tests of the hybrid core: M qdd = f + J'lam with a diagonal M, bars B q = 0, gaps C q + d >= 0, dry friction with slips S qd,
 * relations a q + b > 0. Written by hand, one at a time: what stands in `law`. Hooks let forces, an energy and clauses follow the state.
 */
#ifndef LAW_H
#define LAW_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "lag/run.h"

enum { LAW_MOST = 8, LAW_ENTRIES = 48, LAW_NOTICES = 256 };

typedef double law_row[LAW_MOST];

static struct {
    size_t n, bars, contacts, frictions, relations, variables, timed;
    double mass[LAW_MOST], force[LAW_MOST], q[LAW_MOST], qd[LAW_MOST];
    law_row bar[LAW_MOST], gap[LAW_MOST], slip[2 * LAW_MOST], relation[LAW_MOST];
    double rest[LAW_MOST], restitution[LAW_MOST], border[LAW_MOST];
    double capture_speed, zeno_time;             /* of every contact */
    size_t components[LAW_MOST], under[LAW_MOST]; /* 1 or 2; the contact; `contacts`: none */
    double sliding[LAW_MOST], sticking[LAW_MOST]; /* the limits R and R_0, */
    double mu[LAW_MOST];                          /* or this part of the force of the contact */
    void (*push)(const lag_arguments *at, double *force);                         /* adds forces */
    void (*pass)(const lag_arguments *at, double *next, double *reset, double *value); /* of clauses */
    double (*potential)(const lag_arguments *at);
    size_t resets, reset[LAW_MOST];               /* entries of (q, qd) */
    int driven;                                   /* 1: bar 0 is a motor, whose rate is the input */
    size_t clocks, ends;                          /* ends: 1, there are entries for the start and the end */
    double first, period;                         /* of every clock */
} law;

static lag_places law_at; /* of what was placed last */
static size_t law_slips, law_rows, law_discretes;

static lag_status law_prepare(const lag_arguments *at)
{
    (void)at;
    return LAG_OK;
}

static lag_status law_start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    (void)at;
    (void)z;
    if (law.driven) {
        u[0] = 0.0;
    }
    memcpy(q, law.q, law.n * sizeof(double));
    memcpy(qd, law.qd, law.n * sizeof(double));
    return LAG_OK;
}

static double law_dot(const double *row, const double *x)
{
    double sum = 0.0;
    for (size_t j = 0; j < law.n; ++j) {
        sum += row[j] * x[j];
    }
    return sum;
}

/* One row of the constraints, where it acts. */
static void law_put(size_t row, double acts, const double *of, const double *x, double rest, double *residual, double *jacobian)
{
    for (size_t j = 0; j < law.n; ++j) {
        jacobian[row * law.n + j] = acts * of[j];
    }
    residual[row] = acts * (law_dot(of, x) + rest);
}

/* The friction of which slip s is a component. */
static size_t law_friction_of(size_t s)
{
    size_t k = 0;
    for (size_t first = 0; first + law.components[k] <= s; ++k) {
        first += law.components[k];
    }
    return k;
}

static void law_constrain(const lag_arguments *at, const double *x, int rates, double *residual, double *jacobian)
{
    for (size_t i = 0; i < law.bars; ++i) {
        law_put(i, 1.0, law.bar[i], x, law.driven && i == 0 && rates ? -at->u[0] : 0.0, residual, jacobian);
        residual[i] = law.driven && i == 0 && !rates ? 0.0 : residual[i];
    }
    for (size_t i = 0; i < law.contacts; ++i) {
        law_put(law.bars + i, at->w[law_at.contact + i], law.gap[i], x, rates ? 0.0 : law.rest[i], residual, jacobian);
    }
    for (size_t s = 0; s < law_slips; ++s) {
        const size_t row = law.bars + law.contacts + s;
        law_put(row, at->w[law_at.sticks + law_friction_of(s)], law.slip[s], x, 0.0, residual, jacobian);
        residual[row] = rates ? residual[row] : 0.0;
    }
}

static lag_status law_position(const lag_arguments *at, double *phi, double *jacobian)
{
    law_constrain(at, at->q, 0, phi, jacobian);
    return LAG_OK;
}

static lag_status law_velocity(const lag_arguments *at, double *residual, double *jacobian)
{
    law_constrain(at, at->qd, 1, residual, jacobian);
    return LAG_OK;
}

static lag_status law_mass(const lag_arguments *at, double *mass)
{
    (void)at;
    memset(mass, 0, law.n * law.n * sizeof(double));
    for (size_t i = 0; i < law.n; ++i) {
        mass[i * (law.n + 1)] = law.mass[i];
    }
    return LAG_OK;
}

/* Forces, with friction that slides against its direction. Limits that follow contacts act in blows and at rest only. */
static void law_forces(const lag_arguments *at, double *force)
{
    size_t first = 0;
    memcpy(force, law.force, law.n * sizeof(double));
    for (size_t k = 0; k < law.frictions; ++k) {
        const size_t count = law.components[k];
        double along[2] = {0.0, 0.0};
        for (size_t a = 0; a < count; ++a) {
            const double own = at->w[law_at.direction + first + a];
            along[a] = count > 1 ? own + law_dot(law.slip[first + a], at->qd) : own;
        }
        const double length = count > 1 ? hypot(along[0], along[1]) : 1.0;
        for (size_t a = 0; a < count && length > 0.0 && at->w[law_at.sticks + k] == 0.0; ++a) {
            for (size_t j = 0; j < law.n; ++j) {
                force[j] -= law.sliding[k] * along[a] / length * law.slip[first + a][j];
            }
        }
        first += count;
    }
    if (law.push != NULL) {
        law.push(at, force);
    }
}

static lag_status law_dynamics(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    law_forces(at, force);
    law_constrain(at, at->qd, 1, gamma, jacobian);
    memset(gamma, 0, law_rows * sizeof(double));
    return law_mass(at, mass);
}

static lag_status law_inverse_dynamics(const lag_arguments *at, double *force)
{
    law_forces(at, force);
    for (size_t i = 0; i < law.n; ++i) {
        force[i] = law.mass[i] * at->qdd[i] - force[i];
    }
    return LAG_OK;
}

static lag_status law_tangent(const lag_arguments *at, double *motion, double *rows)
{
    (void)at;
    memset(motion, 0, law.n * sizeof(double));
    memset(rows, 0, law_rows * sizeof(double));
    return LAG_OK;
}

static lag_status law_contact(
    const lag_arguments *at, double *gap, double *speed, double *jacobian, double *restitution, double *capture_speed, double *zeno_time)
{
    for (size_t i = 0; i < law.contacts; ++i) {
        gap[i] = law_dot(law.gap[i], at->q) + law.rest[i];
        speed[i] = law_dot(law.gap[i], at->qd);
        memcpy(jacobian + i * law.n, law.gap[i], law.n * sizeof(double));
        restitution[i] = law.restitution[i];
        capture_speed[i] = law.capture_speed;
        zeno_time[i] = law.zeno_time;
    }
    return LAG_OK;
}

static lag_status law_friction(const lag_arguments *at, double *slip, double *jacobian, double *limit, double *sticking, double *gain, double *sticking_gain)
{
    for (size_t s = 0; s < law_slips; ++s) {
        slip[s] = law_dot(law.slip[s], at->qd);
        memcpy(jacobian + s * law.n, law.slip[s], law.n * sizeof(double));
    }
    memset(gain, 0, law.frictions * law_rows * sizeof(double));
    for (size_t k = 0; k < law.frictions; ++k) {
        const size_t row = law.bars + law.under[k];
        const double part = law.under[k] < law.contacts ? law.mu[k] : 0.0;
        const double force = part > 0.0 ? part * at->lam[row] : 0.0;
        limit[k] = law.sliding[k] + force;
        sticking[k] = law.sticking[k] + force;
        if (part > 0.0) {
            gain[k * law_rows + row] = part;
        }
    }
    memcpy(sticking_gain, gain, law.frictions * law_rows * sizeof(double));
    return LAG_OK;
}

static lag_status law_indicator(const lag_arguments *at, double *g)
{
    for (size_t i = 0; i < law.relations; ++i) {
        g[i] = law_dot(law.relation[i], at->q) + law.border[i];
    }
    return LAG_OK;
}

static lag_status law_indicator_rate(const lag_arguments *at, double *rate, double *acceleration)
{
    for (size_t i = 0; i < law.relations; ++i) {
        rate[i] = law_dot(law.relation[i], at->qd);
        acceleration[i] = law_dot(law.relation[i], at->qdd);
    }
    return LAG_OK;
}

static lag_status law_energies(const lag_arguments *at, double *total, double *kinetic, double *potential, double *jacobi)
{
    *kinetic = 0.0;
    for (size_t j = 0; j < law.n; ++j) {
        *kinetic += 0.5 * law.mass[j] * at->qd[j] * at->qd[j];
    }
    *potential = law.potential(at);
    *total = *jacobi = *kinetic + *potential;
    return LAG_OK;
}

static lag_status law_discrete_start(const lag_arguments *at, double *w)
{
    (void)at;
    memset(w, 0, law_discretes * sizeof(double));
    return LAG_OK;
}

static lag_status law_event(const lag_arguments *at, double *next, double *reset, double *value, double *collision, double *restitution,
    double *stop, double *fail)
{
    (void)collision;
    (void)restitution;
    (void)stop;
    (void)fail;
    memcpy(next, at->w, law_discretes * sizeof(double));
    memset(reset, 0, law.resets * sizeof(double));
    if (law.pass != NULL) {
        law.pass(at, next, reset, value);
    }
    return LAG_OK;
}

static lag_status law_clock(const lag_arguments *at, double *first, double *period)
{
    (void)at;
    for (size_t i = 0; i < law.clocks; ++i) {
        first[i] = law.first;
        period[i] = law.period;
    }
    return LAG_OK;
}

/* The entries of w by kind. */
static size_t law_kinds(unsigned char *kinds)
{
    const size_t counts[][2] = {{LAG_KIND_VARIABLE, law.variables}, {LAG_KIND_CONTACT, law.contacts}, {LAG_KIND_IMPACTS, law.contacts},
        {LAG_KIND_STICKS, law.frictions}, {LAG_KIND_DIRECTION, law_slips}, {LAG_KIND_RELATION, law.relations}, {LAG_KIND_TIMED, law.timed},
        {LAG_KIND_CLOCK, law.clocks}, {LAG_KIND_INITIAL, law.ends}, {LAG_KIND_TERMINAL, law.ends}};
    size_t count = 0;
    for (size_t k = 0; k < sizeof counts / sizeof counts[0]; ++k) {
        for (size_t i = 0; i < counts[k][1]; ++i) {
            kinds[count++] = (unsigned char)counts[k][0];
        }
    }
    return count;
}

/* The model of what stands in `law` now. */
static inline lag_model law_model(void)
{
    static const double nothing[1];
    static unsigned char kinds[LAW_ENTRIES], ones[LAW_ENTRIES], levels[LAW_ENTRIES], zeros[LAW_ENTRIES];
    static size_t rows[LAW_MOST], slips[2 * LAW_MOST];
    static lag_slot slots[LAW_ENTRIES];
    law_slips = 0;
    for (size_t k = 0; k < law.frictions; ++k) {
        law_slips += law.components[k];
    }
    law_rows = law.bars + law.contacts + law_slips;
    law_discretes = law_kinds(kinds);
    for (size_t i = 0; i < LAW_ENTRIES; ++i) {
        slots[i] = (lag_slot){"q", "m", NULL};
        ones[i] = 1;
        levels[i] = i < law.bars + law.contacts && !(law.driven && i == 0);
    }
    for (size_t i = 0; i < law.contacts; ++i) {
        rows[i] = law.bars + i;
    }
    for (size_t s = 0; s < law_slips; ++s) {
        slips[s] = law.bars + law.contacts + s;
    }
    const lag_model model = {
        .version = LAG_MODEL_VERSION, .size = sizeof(lag_model), .name = "Law",
        .nq = law.n, .nu = law.driven ? 1 : 0, .inputs = slots, .nw = law_discretes, .nc = law_rows, .rank = law_rows < law.n ? law_rows : law.n, .workspace = 1,
        .coordinates = slots, .discretes = slots, .constraints = slots, .defaults = nothing, .position_level = levels, .redundant = zeros,
        .prepare = law_prepare, .start = law_start, .position_constraint = law_position, .velocity_constraint = law_velocity,
        .mass_matrix = law_mass, .dynamics = law_dynamics, .inverse_dynamics = law_inverse_dynamics, .residual_tangent = law_tangent,
        .energies = law.potential != NULL ? law_energies : NULL,
        .ncontact = law.contacts, .ngap = law.contacts, .nslip = law_slips, .nfriction = law.frictions, .nindicator = law.relations,
        .nreset = law.resets, .nclock = law.clocks, .ntimed = law.timed, .clock = law_clock, .discrete_start = law_discrete_start,
        .contact = law_contact, .friction = law_friction,
        .indicator = law_indicator, .indicator_rate = law_indicator_rate, .event = law_event, .kinds = kinds, .strict = ones,
        .contact_rows = rows, .friction_rows = slips, .friction_slips = law.components, .friction_contacts = law.under,
        .reset_places = law.reset,
    };
    law_at = lag_places_of(&model);
    return model;
}

/* ---- runs ---- */

static struct {
    size_t count;
    lag_event_notice what[LAW_NOTICES];
    double rate[LAW_NOTICES]; /* of the first coordinate, as it was told */
} law_told;

static inline lag_status law_note(void *context, lag_run *run, const lag_event_notice *notice)
{
    (void)context;
    (void)run;
    CHECK(law_told.count < LAW_NOTICES);
    law_told.rate[law_told.count] = notice->x[law.n];
    law_told.what[law_told.count++] = *notice;
    return LAG_OK;
}

/* So many of a kind were told; the time of the first one. */
static inline size_t law_count(lag_event_kind what, double *first)
{
    size_t count = 0;
    for (size_t k = 0; k < law_told.count; ++k) {
        if (law_told.what[k].what == what) {
            *first = count++ == 0 ? law_told.what[k].t : *first;
        }
    }
    return count;
}

/* A run of `model` that begins at 0 s, in an experiment of 10 s; the caller frees it. */
static inline lag_run *law_begin(const lag_model *model, lag_status expected)
{
    const lag_run_options options = {.tolerance = 1e-10, .length = 10.0, .callbacks.tell = law_note};
    void *block = malloc(lag_run_size(model, &options));
    CHECK(block != NULL);
    lag_run *run = lag_run_place(block, model, &options);
    law_told.count = 0;
    CHECK(lag_run_begin(run, 0.0, NULL) == expected);
    return run;
}

/* Nothing yet, but for defaults of contacts. */
static inline void law_clear(size_t n)
{
    memset(&law, 0, sizeof law);
    law.n = n;
    law.capture_speed = law.zeno_time = -1.0;
    for (size_t j = 0; j < n; ++j) {
        law.mass[j] = 1.0;
    }
}

#endif
