/* The functions of models that are filled from tapes. */
#include "lag/tape/tape_model.h"

#include "lag/columns.h"

static lag_status run(const lag_arguments *at, size_t function, double *const *results)
{
    const lag_tape *tape = at->context;
    const lag_tape_code code = {tape->words + tape->functions[2 * function], tape->constants, tape->constant_count};
    lag_tape_run(&code, at, at->workspace, results);
    return LAG_OK;
}

static lag_status prepare(const lag_arguments *at)
{
    return run(at, 0, NULL);
}

/* ---- the functions, generated ---- */
static lag_status start(const lag_arguments *at, double *q0, double *qd0, double *z0, double *u0)
{
    double *const results[] = {q0, qd0, z0, u0};
    return run(at, 1 + LAG_START, results);
}

static lag_status position_constraint(const lag_arguments *at, double *phi, double *jacobian)
{
    double *const results[] = {phi, jacobian};
    return run(at, 1 + LAG_POSITION_CONSTRAINT, results);
}

static lag_status velocity_constraint(const lag_arguments *at, double *residual, double *jacobian)
{
    double *const results[] = {residual, jacobian};
    return run(at, 1 + LAG_VELOCITY_CONSTRAINT, results);
}

static lag_status mass_matrix(const lag_arguments *at, double *mass)
{
    double *const results[] = {mass};
    return run(at, 1 + LAG_MASS_MATRIX, results);
}

static lag_status dynamics(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    double *const results[] = {mass, force, jacobian, gamma};
    return run(at, 1 + LAG_DYNAMICS, results);
}

static lag_status inverse_dynamics(const lag_arguments *at, double *force)
{
    double *const results[] = {force};
    return run(at, 1 + LAG_INVERSE_DYNAMICS, results);
}

static lag_status residual(const lag_arguments *at, double *motion, double *rows)
{
    double *const results[] = {motion, rows};
    return run(at, 1 + LAG_RESIDUAL, results);
}

static lag_status residual_tangent(const lag_arguments *at, double *motion, double *rows)
{
    double *const results[] = {motion, rows};
    return run(at, 1 + LAG_RESIDUAL_TANGENT, results);
}

static lag_status state_derivative(const lag_arguments *at, double *rates)
{
    double *const results[] = {rates};
    return run(at, 1 + LAG_STATE_DERIVATIVE, results);
}

static lag_status state_derivative_tangent(const lag_arguments *at, double *rates)
{
    double *const results[] = {rates};
    return run(at, 1 + LAG_STATE_DERIVATIVE_TANGENT, results);
}

static lag_status output(const lag_arguments *at, double *y)
{
    double *const results[] = {y};
    return run(at, 1 + LAG_OUTPUT, results);
}

static lag_status output_tangent(const lag_arguments *at, double *y)
{
    double *const results[] = {y};
    return run(at, 1 + LAG_OUTPUT_TANGENT, results);
}

static lag_status energies(const lag_arguments *at, double *total, double *kinetic, double *potential, double *jacobi)
{
    double *const results[] = {total, kinetic, potential, jacobi};
    return run(at, 1 + LAG_ENERGIES, results);
}

static lag_status momenta(const lag_arguments *at, double *momentum)
{
    double *const results[] = {momentum};
    return run(at, 1 + LAG_MOMENTA, results);
}

static lag_status power(const lag_arguments *at, double *load, double *dissipated)
{
    double *const results[] = {load, dissipated};
    return run(at, 1 + LAG_POWER, results);
}

static lag_status monitor(const lag_arguments *at, double *invariant, double *scale, double *assertion)
{
    double *const results[] = {invariant, scale, assertion};
    return run(at, 1 + LAG_MONITOR, results);
}

static lag_status initial_equation(const lag_arguments *at, double *residual)
{
    double *const results[] = {residual};
    return run(at, 1 + LAG_INITIAL_EQUATION, results);
}

static lag_status constraint_tangent(const lag_arguments *at, double *phi, double *residual)
{
    double *const results[] = {phi, residual};
    return run(at, 1 + LAG_CONSTRAINT_TANGENT, results);
}

static lag_status elimination(
        const lag_arguments *at, double *qdd, double *lam, double *response, double *lam_response, double *jacobian, double *gamma,
        double *pivot)
{
    double *const results[] = {qdd, lam, response, lam_response, jacobian, gamma, pivot};
    return run(at, 1 + LAG_ELIMINATION, results);
}

static lag_status discrete_start(const lag_arguments *at, double *w0)
{
    double *const results[] = {w0};
    return run(at, 1 + LAG_DISCRETE_START, results);
}

static lag_status indicator(const lag_arguments *at, double *g)
{
    double *const results[] = {g};
    return run(at, 1 + LAG_INDICATOR, results);
}

static lag_status indicator_rate(const lag_arguments *at, double *rate, double *acceleration)
{
    double *const results[] = {rate, acceleration};
    return run(at, 1 + LAG_INDICATOR_RATE, results);
}

static lag_status standing(const lag_arguments *at, double *next)
{
    double *const results[] = {next};
    return run(at, 1 + LAG_STANDING, results);
}

static lag_status contact(
        const lag_arguments *at, double *gap, double *speed, double *jacobian, double *restitution, double *capture_speed,
        double *zeno_time)
{
    double *const results[] = {gap, speed, jacobian, restitution, capture_speed, zeno_time};
    return run(at, 1 + LAG_CONTACT, results);
}

static lag_status clock(const lag_arguments *at, double *first, double *period)
{
    double *const results[] = {first, period};
    return run(at, 1 + LAG_CLOCK, results);
}

static lag_status event(
        const lag_arguments *at, double *next, double *reset, double *value, double *collision, double *restitution, double *stop,
        double *fail)
{
    double *const results[] = {next, reset, value, collision, restitution, stop, fail};
    return run(at, 1 + LAG_EVENT, results);
}

static lag_status time_event(
        const lag_arguments *at, double *value, double *told, double *distance, double *rate, double *affine, double *entry)
{
    double *const results[] = {value, told, distance, rate, affine, entry};
    return run(at, 1 + LAG_TIME_EVENT, results);
}

static lag_status corner(const lag_arguments *at, double *far, double *solved)
{
    double *const results[] = {far, solved};
    return run(at, 1 + LAG_CORNER, results);
}

static lag_status way(const lag_arguments *at, double *way)
{
    double *const results[] = {way};
    return run(at, 1 + LAG_WAY, results);
}

static lag_status turn(const lag_arguments *at, double *value, double *rate, double *turn, double *entry)
{
    double *const results[] = {value, rate, turn, entry};
    return run(at, 1 + LAG_TURN, results);
}

static lag_status delayed(const lag_arguments *at, double *value, double *time, double *direct)
{
    double *const results[] = {value, time, direct};
    return run(at, 1 + LAG_DELAYED, results);
}

static lag_status friction(
        const lag_arguments *at, double *slip, double *jacobian, double *limit, double *sticking, double *gain,
        double *sticking_gain)
{
    double *const results[] = {slip, jacobian, limit, sticking, gain, sticking_gain};
    return run(at, 1 + LAG_FRICTION, results);
}

static lag_status load(const lag_arguments *at, double *load, double *by_acceleration, double *by_multiplier)
{
    double *const results[] = {load, by_acceleration, by_multiplier};
    return run(at, 1 + LAG_LOAD, results);
}

static lag_status load_tangent(const lag_arguments *at, double *load)
{
    double *const results[] = {load};
    return run(at, 1 + LAG_LOAD_TANGENT, results);
}

static lag_status load_gain(const lag_arguments *at, double *motion, double *rates, double *y, double *load)
{
    double *const results[] = {motion, rates, y, load};
    return run(at, 1 + LAG_LOAD_GAIN, results);
}

static lag_status momentum_tangent(const lag_arguments *at, double *momentum)
{
    double *const results[] = {momentum};
    return run(at, 1 + LAG_MOMENTUM_TANGENT, results);
}

static lag_status definition(const lag_arguments *at, double *d)
{
    double *const results[] = {d};
    return run(at, 1 + LAG_DEFINITION, results);
}

static lag_status definition_tangent(const lag_arguments *at, double *d)
{
    double *const results[] = {d};
    return run(at, 1 + LAG_DEFINITION_TANGENT, results);
}

static lag_status start_tangent(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    double *const results[] = {q, qd, z, u};
    return run(at, 1 + LAG_START_TANGENT, results);
}

static lag_status energies_tangent(const lag_arguments *at, double *total, double *kinetic, double *potential, double *jacobi)
{
    double *const results[] = {total, kinetic, potential, jacobi};
    return run(at, 1 + LAG_ENERGIES_TANGENT, results);
}

static lag_status initial_equation_tangent(const lag_arguments *at, double *residual)
{
    double *const results[] = {residual};
    return run(at, 1 + LAG_INITIAL_EQUATION_TANGENT, results);
}

static lag_status time_tangent(
        const lag_arguments *at, double *motion, double *rows, double *phi, double *residual, double *rates, double *y,
        double *total, double *kinetic, double *potential, double *jacobi, double *d)
{
    double *const results[] = {motion, rows, phi, residual, rates, y, total, kinetic, potential, jacobi, d};
    return run(at, 1 + LAG_TIME_TANGENT, results);
}

static lag_status correction(const lag_arguments *at, double *change, double *lam_change, double *pivot)
{
    double *const results[] = {change, lam_change, pivot};
    return run(at, 1 + LAG_CORRECTION, results);
}

static lag_status equation_terms(const lag_arguments *at, double *coriolis, double *gravity, double *bias)
{
    double *const results[] = {coriolis, gravity, bias};
    return run(at, 1 + LAG_EQUATION_TERMS, results);
}

static lag_status regressor(const lag_arguments *at, double *regressor, double *inertial)
{
    double *const results[] = {regressor, inertial};
    return run(at, 1 + LAG_REGRESSOR, results);
}

static lag_status kinematics(
        const lag_arguments *at, double *position, double *rotation, double *velocity, double *jacobian, double *bias)
{
    double *const results[] = {position, rotation, velocity, jacobian, bias};
    return run(at, 1 + LAG_KINEMATICS, results);
}

static void give(lag_tape *tape)
{
    tape->model.start = lag_tape_has(tape, LAG_START) ? start : NULL;
    tape->model.position_constraint = lag_tape_has(tape, LAG_POSITION_CONSTRAINT) ? position_constraint : NULL;
    tape->model.velocity_constraint = lag_tape_has(tape, LAG_VELOCITY_CONSTRAINT) ? velocity_constraint : NULL;
    tape->model.mass_matrix = lag_tape_has(tape, LAG_MASS_MATRIX) ? mass_matrix : NULL;
    tape->model.dynamics = lag_tape_has(tape, LAG_DYNAMICS) ? dynamics : NULL;
    tape->model.inverse_dynamics = lag_tape_has(tape, LAG_INVERSE_DYNAMICS) ? inverse_dynamics : NULL;
    tape->model.residual = lag_tape_has(tape, LAG_RESIDUAL) ? residual : NULL;
    tape->model.residual_tangent = lag_tape_has(tape, LAG_RESIDUAL_TANGENT) ? residual_tangent : NULL;
    tape->model.state_derivative = lag_tape_has(tape, LAG_STATE_DERIVATIVE) ? state_derivative : NULL;
    tape->model.state_derivative_tangent = lag_tape_has(tape, LAG_STATE_DERIVATIVE_TANGENT) ? state_derivative_tangent : NULL;
    tape->model.output = lag_tape_has(tape, LAG_OUTPUT) ? output : NULL;
    tape->model.output_tangent = lag_tape_has(tape, LAG_OUTPUT_TANGENT) ? output_tangent : NULL;
    tape->model.energies = lag_tape_has(tape, LAG_ENERGIES) ? energies : NULL;
    tape->model.momenta = lag_tape_has(tape, LAG_MOMENTA) ? momenta : NULL;
    tape->model.power = lag_tape_has(tape, LAG_POWER) ? power : NULL;
    tape->model.monitor = lag_tape_has(tape, LAG_MONITOR) ? monitor : NULL;
    tape->model.initial_equation = lag_tape_has(tape, LAG_INITIAL_EQUATION) ? initial_equation : NULL;
    tape->model.constraint_tangent = lag_tape_has(tape, LAG_CONSTRAINT_TANGENT) ? constraint_tangent : NULL;
    tape->model.elimination = lag_tape_has(tape, LAG_ELIMINATION) ? elimination : NULL;
    tape->model.discrete_start = lag_tape_has(tape, LAG_DISCRETE_START) ? discrete_start : NULL;
    tape->model.indicator = lag_tape_has(tape, LAG_INDICATOR) ? indicator : NULL;
    tape->model.indicator_rate = lag_tape_has(tape, LAG_INDICATOR_RATE) ? indicator_rate : NULL;
    tape->model.standing = lag_tape_has(tape, LAG_STANDING) ? standing : NULL;
    tape->model.contact = lag_tape_has(tape, LAG_CONTACT) ? contact : NULL;
    tape->model.clock = lag_tape_has(tape, LAG_CLOCK) ? clock : NULL;
    tape->model.event = lag_tape_has(tape, LAG_EVENT) ? event : NULL;
    tape->model.time_event = lag_tape_has(tape, LAG_TIME_EVENT) ? time_event : NULL;
    tape->model.corner = lag_tape_has(tape, LAG_CORNER) ? corner : NULL;
    tape->model.way = lag_tape_has(tape, LAG_WAY) ? way : NULL;
    tape->model.turn = lag_tape_has(tape, LAG_TURN) ? turn : NULL;
    tape->model.delayed = lag_tape_has(tape, LAG_DELAYED) ? delayed : NULL;
    tape->model.friction = lag_tape_has(tape, LAG_FRICTION) ? friction : NULL;
    tape->model.load = lag_tape_has(tape, LAG_LOAD) ? load : NULL;
    tape->model.load_tangent = lag_tape_has(tape, LAG_LOAD_TANGENT) ? load_tangent : NULL;
    tape->model.load_gain = lag_tape_has(tape, LAG_LOAD_GAIN) ? load_gain : NULL;
    tape->model.momentum_tangent = lag_tape_has(tape, LAG_MOMENTUM_TANGENT) ? momentum_tangent : NULL;
    tape->model.definition = lag_tape_has(tape, LAG_DEFINITION) ? definition : NULL;
    tape->model.definition_tangent = lag_tape_has(tape, LAG_DEFINITION_TANGENT) ? definition_tangent : NULL;
    tape->model.start_tangent = lag_tape_has(tape, LAG_START_TANGENT) ? start_tangent : NULL;
    tape->model.energies_tangent = lag_tape_has(tape, LAG_ENERGIES_TANGENT) ? energies_tangent : NULL;
    tape->model.initial_equation_tangent = lag_tape_has(tape, LAG_INITIAL_EQUATION_TANGENT) ? initial_equation_tangent : NULL;
    tape->model.time_tangent = lag_tape_has(tape, LAG_TIME_TANGENT) ? time_tangent : NULL;
    tape->model.correction = lag_tape_has(tape, LAG_CORRECTION) ? correction : NULL;
    tape->model.equation_terms = lag_tape_has(tape, LAG_EQUATION_TERMS) ? equation_terms : NULL;
    tape->model.regressor = lag_tape_has(tape, LAG_REGRESSOR) ? regressor : NULL;
    tape->model.kinematics = lag_tape_has(tape, LAG_KINEMATICS) ? kinematics : NULL;
}
/* ---- end of what is generated ---- */

/* M and the rest from products with it, in memory beyond that of all other functions. */
static lag_status mass_by_columns(const lag_arguments *at, double *mass)
{
    const lag_tape *tape = at->context;
    return lag_mass_by_columns(&tape->model, at, at->workspace + tape->row, mass);
}

static lag_status dynamics_by_columns(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    const lag_tape *tape = at->context;
    return lag_dynamics_by_columns(&tape->model, at, at->workspace + tape->row, mass, force, jacobian, gamma);
}

void lag_tape_functions(lag_tape *tape)
{
    lag_model *model = &tape->model;
    const int formed = lag_tape_has(tape, LAG_MOMENTUM_TANGENT);
    model->prepare = prepare;
    give(tape);
    if (formed && model->mass_matrix == NULL) {
        model->mass_matrix = mass_by_columns;
    }
    if (formed && model->dynamics == NULL) {
        model->dynamics = dynamics_by_columns;
    }
}
