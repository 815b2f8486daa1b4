#include "lag/evaluate.h"

lag_status lag_prepare(const lag_model *model, const lag_arguments *at)
{
    return model->prepare(at);
}

/* ---- the functions, generated ---- */
static lag_status evaluate_start(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const q0 = results;
    double *const qd0 = q0 + model->nq;
    double *const z0 = qd0 + model->nq;
    double *const u0 = z0 + model->nz;
    return model->start == NULL ? LAG_MISSING : model->start(at, q0, qd0, z0, u0);
}

static lag_status evaluate_position_constraint(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const phi = results;
    double *const jacobian = phi + model->nc;
    return model->position_constraint == NULL ? LAG_MISSING : model->position_constraint(at, phi, jacobian);
}

static lag_status evaluate_velocity_constraint(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const residual = results;
    double *const jacobian = residual + model->nc;
    return model->velocity_constraint == NULL ? LAG_MISSING : model->velocity_constraint(at, residual, jacobian);
}

static lag_status evaluate_mass_matrix(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->mass_matrix == NULL ? LAG_MISSING : model->mass_matrix(at, results);
}

static lag_status evaluate_dynamics(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const mass = results;
    double *const force = mass + model->nq * model->nq;
    double *const jacobian = force + model->nq;
    double *const gamma = jacobian + model->nc * model->nq;
    return model->dynamics == NULL ? LAG_MISSING : model->dynamics(at, mass, force, jacobian, gamma);
}

static lag_status evaluate_inverse_dynamics(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->inverse_dynamics == NULL ? LAG_MISSING : model->inverse_dynamics(at, results);
}

static lag_status evaluate_residual(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const motion = results;
    double *const rows = motion + model->nq;
    return model->residual == NULL ? LAG_MISSING : model->residual(at, motion, rows);
}

static lag_status evaluate_residual_tangent(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const motion = results;
    double *const rows = motion + model->nq;
    return model->residual_tangent == NULL ? LAG_MISSING : model->residual_tangent(at, motion, rows);
}

static lag_status evaluate_state_derivative(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->state_derivative == NULL ? LAG_MISSING : model->state_derivative(at, results);
}

static lag_status evaluate_state_derivative_tangent(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->state_derivative_tangent == NULL ? LAG_MISSING : model->state_derivative_tangent(at, results);
}

static lag_status evaluate_output(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->output == NULL ? LAG_MISSING : model->output(at, results);
}

static lag_status evaluate_output_tangent(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->output_tangent == NULL ? LAG_MISSING : model->output_tangent(at, results);
}

static lag_status evaluate_energies(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const total = results;
    double *const kinetic = total + 1;
    double *const potential = kinetic + 1;
    double *const jacobi = potential + 1;
    return model->energies == NULL ? LAG_MISSING : model->energies(at, total, kinetic, potential, jacobi);
}

static lag_status evaluate_momenta(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->momenta == NULL ? LAG_MISSING : model->momenta(at, results);
}

static lag_status evaluate_power(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const load = results;
    double *const dissipated = load + model->nq;
    return model->power == NULL ? LAG_MISSING : model->power(at, load, dissipated);
}

static lag_status evaluate_monitor(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const invariant = results;
    double *const scale = invariant + model->ni;
    double *const assertion = scale + model->ni;
    return model->monitor == NULL ? LAG_MISSING : model->monitor(at, invariant, scale, assertion);
}

static lag_status evaluate_initial_equation(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->initial_equation == NULL ? LAG_MISSING : model->initial_equation(at, results);
}

static lag_status evaluate_constraint_tangent(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const phi = results;
    double *const residual = phi + model->nc;
    return model->constraint_tangent == NULL ? LAG_MISSING : model->constraint_tangent(at, phi, residual);
}

static lag_status evaluate_elimination(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const qdd = results;
    double *const lam = qdd + model->nq;
    double *const response = lam + model->nc;
    double *const lam_response = response + model->nk * model->nq;
    double *const jacobian = lam_response + model->nk * model->nc;
    double *const gamma = jacobian + model->nk * model->nq;
    double *const pivot = gamma + model->nk;
    return model->elimination == NULL ? LAG_MISSING : model->elimination(at, qdd, lam, response, lam_response, jacobian, gamma, pivot);
}

static lag_status evaluate_discrete_start(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->discrete_start == NULL ? LAG_MISSING : model->discrete_start(at, results);
}

static lag_status evaluate_indicator(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->indicator == NULL ? LAG_MISSING : model->indicator(at, results);
}

static lag_status evaluate_indicator_rate(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const rate = results;
    double *const acceleration = rate + model->nindicator;
    return model->indicator_rate == NULL ? LAG_MISSING : model->indicator_rate(at, rate, acceleration);
}

static lag_status evaluate_standing(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->standing == NULL ? LAG_MISSING : model->standing(at, results);
}

static lag_status evaluate_contact(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const gap = results;
    double *const speed = gap + model->ngap;
    double *const jacobian = speed + model->ngap;
    double *const restitution = jacobian + model->ngap * model->nq;
    double *const capture_speed = restitution + model->ncontact;
    double *const zeno_time = capture_speed + model->ncontact;
    return model->contact == NULL ? LAG_MISSING : model->contact(at, gap, speed, jacobian, restitution, capture_speed, zeno_time);
}

static lag_status evaluate_clock(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const first = results;
    double *const period = first + model->nclock;
    return model->clock == NULL ? LAG_MISSING : model->clock(at, first, period);
}

static lag_status evaluate_event(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const next = results;
    double *const reset = next + model->nw;
    double *const value = reset + model->nreset;
    double *const collision = value + model->nreset;
    double *const restitution = collision + model->ncollision;
    double *const stop = restitution + model->ncollision;
    double *const fail = stop + model->nstop;
    return model->event == NULL ? LAG_MISSING : model->event(at, next, reset, value, collision, restitution, stop, fail);
}

static lag_status evaluate_time_event(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const value = results;
    double *const told = value + model->ntimed;
    double *const distance = told + model->ntimed;
    double *const rate = distance + model->ndistance;
    double *const affine = rate + model->ndistance;
    double *const entry = affine + model->ndistance;
    return model->time_event == NULL ? LAG_MISSING : model->time_event(at, value, told, distance, rate, affine, entry);
}

static lag_status evaluate_corner(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const far = results;
    double *const solved = far + model->ncorner;
    return model->corner == NULL ? LAG_MISSING : model->corner(at, far, solved);
}

static lag_status evaluate_way(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->way == NULL ? LAG_MISSING : model->way(at, results);
}

static lag_status evaluate_turn(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const value = results;
    double *const rate = value + model->nturn;
    double *const turn = rate + model->nturn;
    double *const entry = turn + model->nturn;
    return model->turn == NULL ? LAG_MISSING : model->turn(at, value, rate, turn, entry);
}

static lag_status evaluate_delayed(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const value = results;
    double *const time = value + model->ndelay;
    double *const direct = time + model->ndelay;
    return model->delayed == NULL ? LAG_MISSING : model->delayed(at, value, time, direct);
}

static lag_status evaluate_friction(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const slip = results;
    double *const jacobian = slip + model->nslip;
    double *const limit = jacobian + model->nslip * model->nq;
    double *const sticking = limit + model->nfriction;
    double *const gain = sticking + model->nfriction;
    double *const sticking_gain = gain + model->nfriction * model->nc;
    return model->friction == NULL ? LAG_MISSING : model->friction(at, slip, jacobian, limit, sticking, gain, sticking_gain);
}

static lag_status evaluate_load(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const load = results;
    double *const by_acceleration = load + model->nload;
    double *const by_multiplier = by_acceleration + model->nload * model->nq;
    return model->load == NULL ? LAG_MISSING : model->load(at, load, by_acceleration, by_multiplier);
}

static lag_status evaluate_load_tangent(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->load_tangent == NULL ? LAG_MISSING : model->load_tangent(at, results);
}

static lag_status evaluate_load_gain(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const motion = results;
    double *const rates = motion + model->nq * model->nload;
    double *const y = rates + model->nz * model->nload;
    double *const load = y + model->ny * model->nload;
    return model->load_gain == NULL ? LAG_MISSING : model->load_gain(at, motion, rates, y, load);
}

static lag_status evaluate_momentum_tangent(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->momentum_tangent == NULL ? LAG_MISSING : model->momentum_tangent(at, results);
}

static lag_status evaluate_definition(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->definition == NULL ? LAG_MISSING : model->definition(at, results);
}

static lag_status evaluate_definition_tangent(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->definition_tangent == NULL ? LAG_MISSING : model->definition_tangent(at, results);
}

static lag_status evaluate_start_tangent(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const q = results;
    double *const qd = q + model->nq;
    double *const z = qd + model->nq;
    double *const u = z + model->nz;
    return model->start_tangent == NULL ? LAG_MISSING : model->start_tangent(at, q, qd, z, u);
}

static lag_status evaluate_energies_tangent(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const total = results;
    double *const kinetic = total + 1;
    double *const potential = kinetic + 1;
    double *const jacobi = potential + 1;
    return model->energies_tangent == NULL ? LAG_MISSING : model->energies_tangent(at, total, kinetic, potential, jacobi);
}

static lag_status evaluate_initial_equation_tangent(const lag_model *model, const lag_arguments *at, double *results)
{
    return model->initial_equation_tangent == NULL ? LAG_MISSING : model->initial_equation_tangent(at, results);
}

static lag_status evaluate_time_tangent(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const motion = results;
    double *const rows = motion + model->nq;
    double *const phi = rows + model->nc;
    double *const residual = phi + model->nc;
    double *const rates = residual + model->nc;
    double *const y = rates + model->nz;
    double *const total = y + model->ny;
    double *const kinetic = total + 1;
    double *const potential = kinetic + 1;
    double *const jacobi = potential + 1;
    double *const d = jacobi + 1;
    return model->time_tangent == NULL ? LAG_MISSING : model->time_tangent(at, motion, rows, phi, residual, rates, y, total, kinetic, potential, jacobi, d);
}

static lag_status evaluate_correction(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const change = results;
    double *const lam_change = change + model->nq;
    double *const pivot = lam_change + model->nc;
    return model->correction == NULL ? LAG_MISSING : model->correction(at, change, lam_change, pivot);
}

static lag_status evaluate_equation_terms(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const coriolis = results;
    double *const gravity = coriolis + model->nq * model->nq;
    double *const bias = gravity + model->nq;
    return model->equation_terms == NULL ? LAG_MISSING : model->equation_terms(at, coriolis, gravity, bias);
}

static lag_status evaluate_regressor(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const regressor = results;
    double *const inertial = regressor + model->nq * model->ninertial;
    return model->regressor == NULL ? LAG_MISSING : model->regressor(at, regressor, inertial);
}

static lag_status evaluate_kinematics(const lag_model *model, const lag_arguments *at, double *results)
{
    double *const position = results;
    double *const rotation = position + model->nplace;
    double *const velocity = rotation + model->naxes;
    double *const jacobian = velocity + model->ntwist;
    double *const bias = jacobian + model->ntwist * model->nq;
    return model->kinematics == NULL ? LAG_MISSING : model->kinematics(at, position, rotation, velocity, jacobian, bias);
}

lag_status lag_evaluate(const lag_model *model, lag_function which, const lag_arguments *at, double *results)
{
    static lag_status (*const functions[])(const lag_model *model, const lag_arguments *at, double *results) = {
        [LAG_START] = evaluate_start, [LAG_POSITION_CONSTRAINT] = evaluate_position_constraint,
        [LAG_VELOCITY_CONSTRAINT] = evaluate_velocity_constraint, [LAG_MASS_MATRIX] = evaluate_mass_matrix,
        [LAG_DYNAMICS] = evaluate_dynamics, [LAG_INVERSE_DYNAMICS] = evaluate_inverse_dynamics, [LAG_RESIDUAL] = evaluate_residual,
        [LAG_RESIDUAL_TANGENT] = evaluate_residual_tangent, [LAG_STATE_DERIVATIVE] = evaluate_state_derivative,
        [LAG_STATE_DERIVATIVE_TANGENT] = evaluate_state_derivative_tangent, [LAG_OUTPUT] = evaluate_output,
        [LAG_OUTPUT_TANGENT] = evaluate_output_tangent, [LAG_ENERGIES] = evaluate_energies, [LAG_MOMENTA] = evaluate_momenta,
        [LAG_POWER] = evaluate_power, [LAG_MONITOR] = evaluate_monitor, [LAG_INITIAL_EQUATION] = evaluate_initial_equation,
        [LAG_CONSTRAINT_TANGENT] = evaluate_constraint_tangent, [LAG_ELIMINATION] = evaluate_elimination,
        [LAG_DISCRETE_START] = evaluate_discrete_start, [LAG_INDICATOR] = evaluate_indicator,
        [LAG_INDICATOR_RATE] = evaluate_indicator_rate, [LAG_STANDING] = evaluate_standing, [LAG_CONTACT] = evaluate_contact,
        [LAG_CLOCK] = evaluate_clock, [LAG_EVENT] = evaluate_event, [LAG_TIME_EVENT] = evaluate_time_event,
        [LAG_CORNER] = evaluate_corner, [LAG_WAY] = evaluate_way, [LAG_TURN] = evaluate_turn, [LAG_DELAYED] = evaluate_delayed,
        [LAG_FRICTION] = evaluate_friction, [LAG_LOAD] = evaluate_load, [LAG_LOAD_TANGENT] = evaluate_load_tangent,
        [LAG_LOAD_GAIN] = evaluate_load_gain, [LAG_MOMENTUM_TANGENT] = evaluate_momentum_tangent,
        [LAG_DEFINITION] = evaluate_definition, [LAG_DEFINITION_TANGENT] = evaluate_definition_tangent,
        [LAG_START_TANGENT] = evaluate_start_tangent, [LAG_ENERGIES_TANGENT] = evaluate_energies_tangent,
        [LAG_INITIAL_EQUATION_TANGENT] = evaluate_initial_equation_tangent, [LAG_TIME_TANGENT] = evaluate_time_tangent,
        [LAG_CORRECTION] = evaluate_correction, [LAG_EQUATION_TERMS] = evaluate_equation_terms,
        [LAG_REGRESSOR] = evaluate_regressor, [LAG_KINEMATICS] = evaluate_kinematics,
    };
    return (size_t)which < sizeof functions / sizeof *functions ? functions[which](model, at, results) : LAG_MISSING;
}
/* ---- end of what is generated ---- */
