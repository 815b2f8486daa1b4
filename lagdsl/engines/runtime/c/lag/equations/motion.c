#include "lag/equations/motion.h"

#include <math.h>
#include <string.h>

#include "lag/equations/feedback.h"
#include "lag/equations/jacobian.h"
#include "lag/linalg/arena.h"

/* ---- discretes ---- */

enum { KINDS = LAG_KIND_LOAD + 1 };

/* The first entry of each kind or of a later one. */
static void find_first(const lag_model *model, size_t *first)
{
    size_t i = 0;
    for (unsigned kind = 0; kind < KINDS; ++kind) {
        while (i < model->nw && model->kinds != NULL && model->kinds[i] < kind) {
            ++i;
        }
        first[kind] = i;
    }
}

/* The one entry of a kind, if it is this one; nw where the model has none. */
static size_t only(const lag_model *model, lag_kind kind, size_t i)
{
    return i < model->nw && model->kinds[i] == (unsigned char)kind ? i : model->nw;
}

lag_places lag_places_of(const lag_model *model)
{
    size_t first[KINDS];
    find_first(model, first);
    return (lag_places){
        .contact = first[LAG_KIND_CONTACT],
        .impacts = first[LAG_KIND_IMPACTS],
        .sticks = first[LAG_KIND_STICKS],
        .direction = first[LAG_KIND_DIRECTION],
        .relation = first[LAG_KIND_RELATION],
        .timed = first[LAG_KIND_TIMED],
        .delay = first[LAG_KIND_DELAY],
        .delay_rate = first[LAG_KIND_DELAY_RATE],
        .condition = first[LAG_KIND_CONDITION],
        .clock = first[LAG_KIND_CLOCK],
        .initial = only(model, LAG_KIND_INITIAL, first[LAG_KIND_INITIAL]),
        .terminal = only(model, LAG_KIND_TERMINAL, first[LAG_KIND_TERMINAL]),
        .load = first[LAG_KIND_LOAD],
    };
}

void lag_places_clear(const lag_places *places, double *w)
{
    for (size_t i = places->clock; i < places->load; ++i) {
        w[i] = 0.0;
    }
}

/* ---- motion ---- */

/* Loads with their derivatives, three states for differences, and what serves again at the next state, where there are loads. */
static size_t loads_memory(const lag_model *model)
{
    const size_t states = 3 * lag_motion_size(model);
    return model->nload > 0 ? model->nload * (model->nq + model->nc) + states + lag_feedback_chord_memory(model) : 0;
}

/* Results with few entries: those of the dynamics, then the others. */
static size_t kept_memory(const lag_model *model)
{
    return lag_left_rows_kept(model) + (model->ngap + model->nq + 3 * model->nc) * model->nq;
}

static void place_written(lag_written *written, const lag_model *model, double *memory)
{
    const size_t rows = model->nc * model->nq;
    written->gaps = lag_take(&memory, model->ngap * model->nq);
    written->mass = lag_take(&memory, model->nq * model->nq);
    written->rows[0] = lag_take(&memory, rows);
    written->rows[1] = lag_take(&memory, rows);
    written->sought = lag_take(&memory, rows);
}

size_t lag_motion_memory(const lag_model *model)
{
    const size_t values = model->nu + model->nw + model->nq + model->nc + 1;
    return model->workspace + lag_jacobian_memory(model, NULL) + kept_memory(model) + values + loads_memory(model) + lag_delays_memory(model);
}

/* From so many directions on, several are followed at once: the functions for that have to be made first. */
enum { MANY_DIRECTIONS = 64 };

/* Of a state, for a difference. */
static const double DIFFERENCE = 1e-8;

static lag_status rates_of_motion(void *context, double t, const double *x, double *xd)
{
    lag_motion *motion = context;
    const size_t n = motion->model->nq;
    const lag_status status = lag_motion_solve(motion, t, x);
    if (status != LAG_OK) {
        return status;
    }
    memcpy(xd, x + n, n * sizeof(double));
    memcpy(xd + n, motion->qdd, n * sizeof(double));
    return motion->model->nz > 0 ? motion->model->state_derivative(&motion->at, xd + 2 * n) : LAG_OK;
}

/* By differences: derivatives at fixed loads are not those of the motion. */
static lag_status jacobian_with_loads(lag_motion *motion, double t, const double *x, double *matrix)
{
    const size_t size = lag_motion_size(motion->model);
    double *moved = motion->loads + motion->model->nload * (motion->model->nq + motion->model->nc);
    double *here = moved + size;
    double *there = here + size;
    lag_status status = rates_of_motion(motion, t, x, here);
    memcpy(moved, x, size * sizeof(double));
    for (size_t j = 0; j < size && status == LAG_OK; ++j) {
        const double by = DIFFERENCE * fmax(fabs(x[j]), 1.0);
        moved[j] = x[j] + by;
        status = rates_of_motion(motion, t, moved, there);
        moved[j] = x[j];
        for (size_t i = 0; i < size; ++i) {
            matrix[i * size + j] = (there[i] - here[i]) / by;
        }
    }
    return status;
}

/* True if there are functions of several directions for the present parameters, and `directions` are many. */
static int is_along(lag_motion *motion, size_t directions)
{
    lag_motion_along *along = &motion->along;
    if (along->tell == NULL || directions < MANY_DIRECTIONS) {
        return 0;
    }
    if (!along->asked) {
        along->asked = 1;
        along->tell(motion->context, &along->told);
    }
    if (along->told.tangents == NULL) {
        return 0;
    }
    if (!along->prepared) {
        lag_arguments at = motion->at;
        at.context = along->told.model->context;
        at.workspace = along->told.workspace;
        along->prepared = along->told.model->prepare(&at) == LAG_OK;
    }
    return along->prepared;
}

lag_along lag_motion_functions(lag_motion *motion, size_t directions)
{
    return is_along(motion, directions) ? motion->along.told : (lag_along){motion->model, NULL, motion->at.workspace, motion->memory};
}

static lag_status jacobian(void *context, double t, const double *x, double *matrix)
{
    lag_motion *motion = context;
    if (motion->model->nload > 0) {
        return jacobian_with_loads(motion, t, x, matrix);
    }
    lag_motion_set_state(motion, t, x);
    const lag_range state = {0, lag_motion_size(motion->model)};
    const lag_along by = lag_motion_functions(motion, lag_motion_size(motion->model));
    lag_arguments at = motion->at;
    at.context = by.model->context;
    at.workspace = by.workspace;
    at.kept = by.tangents == NULL ? at.kept : NULL;
    return lag_jacobian(by.model, by.tangents, &at, state, by.memory, matrix, NULL, &motion->coordinate);
}

lag_ode lag_motion_ode(const lag_model *model)
{
    return (lag_ode){
        .size = lag_motion_size(model),
        .nq = model->nq,
        .nc = model->nc,
        .rates = rates_of_motion,
        .jacobian = jacobian,
        .patterns = model->patterns,
        .linearize = lag_motion_linearize,
    };
}

void lag_motion_place(lag_motion *motion, const lag_model *model, double *memory)
{
    memset(motion, 0, sizeof *motion);
    motion->model = model;
    motion->places = lag_places_of(model);
    motion->at.context = model->context;
    motion->at.workspace = memory;
    motion->memory = motion->at.workspace + model->workspace;
    motion->kept = (lag_kept){motion->memory + lag_jacobian_memory(model, NULL), kept_memory(model)};
    motion->at.kept = &motion->kept;
    place_written(&motion->written, model, motion->kept.first + lag_left_rows_kept(model));
    motion->u = motion->kept.first + motion->kept.count;
    motion->w = motion->u + model->nu;
    motion->qdd = motion->w + model->nw;
    motion->lam = motion->qdd + model->nq;
    motion->loads = motion->lam + model->nc + 1;
    motion->at.u = motion->u;
    motion->at.w = motion->w;
    motion->at.qdd = motion->qdd;
    motion->at.lam = motion->lam;
    double *delays = motion->loads + loads_memory(model);
    lag_delays_place(&motion->delays, &motion->model, &motion->at, motion->w + motion->places.delay, motion->w + motion->places.delay_rate, delays);
    motion->until = (double)INFINITY;
    motion->ode = lag_motion_ode(model);
    motion->ode.context = motion;
}

lag_status lag_motion_parameters(lag_motion *motion, const double *p)
{
    motion->at.p = p;
    return lag_motion_prepare(motion);
}

lag_status lag_motion_prepare(lag_motion *motion)
{
    motion->along.prepared = 0;
    return motion->model->prepare(&motion->at);
}

lag_status lag_motion_start(lag_motion *motion, double t, double *x)
{
    const size_t n = motion->model->nq;
    motion->at.t = t;
    const lag_model *model = motion->model;
    const lag_status status = model->discrete_start != NULL ? model->discrete_start(&motion->at, motion->w) : LAG_OK;
    return status == LAG_OK ? model->start(&motion->at, x, x + n, x + 2 * n, motion->u) : status;
}

void lag_motion_set_state(lag_motion *motion, double t, const double *x)
{
    const size_t n = motion->model->nq;
    motion->at.t = t;
    motion->at.q = x;
    motion->at.qd = x + n;
    motion->at.z = x + 2 * n;
    if (motion->inputs != NULL) {
        motion->inputs(motion->context, t, t >= motion->until, motion->u);
    }
    if (motion->model->ndelay > 0) {
        lag_delays_set(&motion->delays, t);
    }
}

lag_status lag_motion_take_loads(lag_motion *motion, const lag_arguments *at)
{
    const lag_model *model = motion->model;
    double *slopes = motion->loads;
    return model->load(at, motion->w + motion->places.load, slopes, slopes + model->nload * model->nq);
}

lag_status lag_motion_solve(lag_motion *motion, double t, const double *x)
{
    const lag_model *model = motion->model;
    lag_motion_set_state(motion, t, x);
    double *chord = motion->loads + model->nload * (model->nq + model->nc) + 3 * lag_motion_size(model);
    const lag_status status = lag_forward_dynamics_along(
        model, &motion->at, motion->memory, chord, motion->qdd, motion->lam, &motion->coordinate);
    return status == LAG_OK && model->nload > 0 ? lag_motion_take_loads(motion, &motion->at) : status;
}

void lag_motion_try(lag_motion *motion, double t, const double *x)
{
    const int solved = lag_motion_solve(motion, t, x) == LAG_OK;
    lag_fill(solved ? 0 : motion->model->nq, (double)NAN, motion->qdd);
    lag_fill(solved ? 0 : motion->model->nc, (double)NAN, motion->lam);
}

lag_status lag_motion_know(lag_motion *motion, double t, const double *x, const double *xd)
{
    const lag_model *model = motion->model;
    if (xd == NULL || model->nc > 0 || model->nload > 0) {
        return lag_motion_solve(motion, t, x);
    }
    lag_motion_set_state(motion, t, x);
    memcpy(motion->qdd, xd + model->nq, model->nq * sizeof(double));
    return LAG_OK;
}
