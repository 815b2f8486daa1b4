/* The functions of models from tapes, of several states or of several directions at once. */
#include "lag/lanes.h"
#include "lag/tape/tape_model.h"

#if LAG_TAPE_LANES

static lag_tape_code code_of(const lag_tape *tape, size_t function)
{
    return (lag_tape_code){tape->words + tape->functions[2 * function], tape->constants, tape->constant_count};
}

static lag_status run(const lag_arguments *at, size_t function, double *const *results)
{
    const lag_tape_code code = code_of(at->context, function);
    lag_tape_run_lanes(&code, at, at->workspace, results);
    return LAG_OK;
}

/* ---- states ---- */

static lag_status prepare(const lag_arguments *at)
{
    return run(at, 0, NULL);
}

static lag_status dynamics(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    double *const results[] = {mass, force, jacobian, gamma};
    return run(at, 1 + LAG_DYNAMICS, results);
}

static lag_status elimination(const lag_arguments *at, double *qdd, double *lam, double *response, double *lam_response,
    double *jacobian, double *gamma, double *pivot)
{
    double *const results[] = {qdd, lam, response, lam_response, jacobian, gamma, pivot};
    return run(at, 1 + LAG_ELIMINATION, results);
}

static lag_status state_derivative(const lag_arguments *at, double *rates)
{
    double *const results[] = {rates};
    return run(at, 1 + LAG_STATE_DERIVATIVE, results);
}

static lag_status monitor(const lag_arguments *at, double *invariant, double *scale, double *assertion)
{
    double *const results[] = {invariant, scale, assertion};
    return run(at, 1 + LAG_MONITOR, results);
}

/* ---- directions ---- */

/* The row of the directions follows on that of the state. */
static double *row_along(const lag_arguments *at)
{
    const lag_tape *tape = at->context;
    return at->workspace + lag_tape_aligned(tape->row);
}

/* At the state alone; what directions share is then in all lanes. */
static lag_status primal(const lag_arguments *at, size_t part, double *const *results)
{
    const lag_tape *tape = at->context;
    const lag_tape_code code = code_of(tape, LAG_TAPE_ALONG + part * LAG_TAPE_ALONG_COUNT + LAG_TAPE_PRIMAL);
    double *to = row_along(at);
    lag_tape_run(&code, at, at->workspace, results);
    for (size_t i = 0; i < tape->shared[part]; ++i) {
        const lag_lanes value = lag_lanes_of(at->workspace[i]);
        lag_lanes_memory *row = (lag_lanes_memory *)(void *)(to + i * LAG_TAPE_LANES);
        for (size_t k = 0; k < LAG_TAPE_LANES / LAG_LANES; ++k) {
            row[k] = value;
        }
    }
    return LAG_OK;
}

static lag_status run_along(const lag_arguments *at, size_t part, size_t which, double *const *results)
{
    const lag_tape_code code = code_of(at->context, LAG_TAPE_ALONG + part * LAG_TAPE_ALONG_COUNT + which);
    lag_tape_run_lanes(&code, at, row_along(at), results);
    return LAG_OK;
}

#define OF_PART(name, part)                                                                                     \
    static lag_status name##_primal(const lag_arguments *at)                                                    \
    {                                                                                                           \
        return primal(at, part, NULL);                                                                          \
    }                                                                                                           \
    static lag_status name##_motion(const lag_arguments *at, double *qdd, double *lam, double *pivot)           \
    {                                                                                                           \
        double *const results[] = {qdd, lam, pivot};                                                            \
        return primal(at, part, results);                                                                       \
    }                                                                                                           \
    static lag_status name##_residual(const lag_arguments *at, double *motion, double *rows)                    \
    {                                                                                                           \
        double *const results[] = {motion, rows};                                                               \
        return run_along(at, part, LAG_TAPE_RESIDUAL_ALONG, results);                                           \
    }                                                                                                           \
    static lag_status name##_acceleration(                                                                      \
        const lag_arguments *at, double *qdd, double *lam, double *rows, double *pivot)                         \
    {                                                                                                           \
        double *const results[] = {qdd, lam, rows, pivot};                                                      \
        return run_along(at, part, LAG_TAPE_ACCELERATION_ALONG, results);                                       \
    }                                                                                                           \
    static lag_status name##_rates(const lag_arguments *at, double *rates)                                      \
    {                                                                                                           \
        double *const results[] = {rates};                                                                      \
        return run_along(at, part, LAG_TAPE_RATES_ALONG, results);                                              \
    }                                                                                                           \
    static lag_status name##_output(const lag_arguments *at, double *y)                                         \
    {                                                                                                           \
        double *const results[] = {y};                                                                          \
        return run_along(at, part, LAG_TAPE_OUTPUT_ALONG, results);                                             \
    }

OF_PART(state, 0)
OF_PART(parameter, 1)

static int has_along(const lag_tape *tape, size_t part, size_t which)
{
    return tape->functions[2 * (LAG_TAPE_ALONG + part * LAG_TAPE_ALONG_COUNT + which) + 1] > 0;
}

void lag_tape_parallel(lag_tape *tape)
{
    static const lag_tangents all[2] = {
        {LAG_TAPE_LANES, 0, 0, state_primal, state_motion, state_residual, state_acceleration, state_rates, state_output, NULL},
        {LAG_TAPE_LANES, 0, 0, parameter_primal, parameter_motion, parameter_residual, parameter_acceleration, parameter_rates,
            parameter_output, NULL},
    };
    const int moves = tape->model.nk == 0 && lag_tape_has(tape, LAG_ELIMINATION);
    tape->states = (lag_states){
        .lanes = LAG_TAPE_LANES,
        .workspace = LAG_TAPE_LANES * tape->row,
        .width = lag_tape_lanes_width(),
        .prepare = prepare,
        .dynamics = lag_tape_has(tape, LAG_DYNAMICS) ? dynamics : NULL,
        .elimination = lag_tape_has(tape, LAG_ELIMINATION) ? elimination : NULL,
        .state_derivative = tape->model.nz > 0 ? state_derivative : NULL,
        .monitor = lag_tape_has(tape, LAG_MONITOR) ? monitor : NULL,
    };
    tape->differentiated.width = lag_tape_lanes_width();
    for (size_t part = 0; part < 2; ++part) {
        lag_tangents *own = tape->tangents + part;
        *own = all[part];
        own->width = lag_tape_lanes_width();
        own->workspace = (size_t)lag_tape_aligned(tape->row) + LAG_TAPE_LANES * tape->along_row[part];
        own->primal = moves ? NULL : own->primal;
        own->motion = moves ? own->motion : NULL;
        own->residual = has_along(tape, part, LAG_TAPE_RESIDUAL_ALONG) ? own->residual : NULL;
        own->acceleration = has_along(tape, part, LAG_TAPE_ACCELERATION_ALONG) ? own->acceleration : NULL;
        own->state_derivative = has_along(tape, part, LAG_TAPE_RATES_ALONG) ? own->state_derivative : NULL;
        own->output = has_along(tape, part, LAG_TAPE_OUTPUT_ALONG) ? own->output : NULL;
    }
}

const lag_states *lag_tape_states(const lag_model *model)
{
    const lag_tape *tape = model->context;
    return &tape->states;
}

const lag_tangents *lag_tape_tangents(const lag_model *model, int parameters)
{
    const lag_tape *tape = model->context;
    const size_t part = parameters ? 1 : 0;
    return has_along(tape, part, LAG_TAPE_PRIMAL) ? tape->tangents + part : NULL;
}

#else

void lag_tape_parallel(lag_tape *tape)
{
    (void)tape;
}

const lag_states *lag_tape_states(const lag_model *model)
{
    (void)model;
    return NULL;
}

const lag_tangents *lag_tape_tangents(const lag_model *model, int parameters)
{
    (void)model;
    (void)parameters;
    return NULL;
}

#endif
