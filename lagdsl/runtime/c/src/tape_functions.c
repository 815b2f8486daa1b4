/* The functions of models that are filled from tapes. */
#include "lag/tape_model.h"

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

#define FUNCTION_1(name, number)                                \
    static lag_status name(const lag_arguments *at, double *a)  \
    {                                                           \
        double *const results[] = {a};                          \
        return run(at, 1 + number, results);                    \
    }
#define FUNCTION_2(name, number)                                           \
    static lag_status name(const lag_arguments *at, double *a, double *b)  \
    {                                                                      \
        double *const results[] = {a, b};                                  \
        return run(at, 1 + number, results);                               \
    }
#define FUNCTION_3(name, number)                                                      \
    static lag_status name(const lag_arguments *at, double *a, double *b, double *c)  \
    {                                                                                 \
        double *const results[] = {a, b, c};                                          \
        return run(at, 1 + number, results);                                          \
    }
#define FUNCTION_4(name, number)                                                                 \
    static lag_status name(const lag_arguments *at, double *a, double *b, double *c, double *d)  \
    {                                                                                            \
        double *const results[] = {a, b, c, d};                                                  \
        return run(at, 1 + number, results);                                                     \
    }
#define FUNCTION_6(name, number)                                                                       \
    static lag_status name(                                                                            \
        const lag_arguments *at, double *a, double *b, double *c, double *d, double *e, double *f)     \
    {                                                                                                  \
        double *const results[] = {a, b, c, d, e, f};                                                  \
        return run(at, 1 + number, results);                                                           \
    }
#define FUNCTION_7(name, number)                                                                              \
    static lag_status name(                                                                                   \
        const lag_arguments *at, double *a, double *b, double *c, double *d, double *e, double *f, double *g) \
    {                                                                                                         \
        double *const results[] = {a, b, c, d, e, f, g};                                                      \
        return run(at, 1 + number, results);                                                                  \
    }

FUNCTION_4(start, LAG_START)
FUNCTION_2(position_constraint, LAG_POSITION_CONSTRAINT)
FUNCTION_2(velocity_constraint, LAG_VELOCITY_CONSTRAINT)
FUNCTION_1(mass_matrix, LAG_MASS_MATRIX)
FUNCTION_4(dynamics, LAG_DYNAMICS)
FUNCTION_1(inverse_dynamics, LAG_INVERSE_DYNAMICS)
FUNCTION_2(residual, LAG_RESIDUAL)
FUNCTION_2(residual_tangent, LAG_RESIDUAL_TANGENT)
FUNCTION_1(state_derivative, LAG_STATE_DERIVATIVE)
FUNCTION_1(state_derivative_tangent, LAG_STATE_DERIVATIVE_TANGENT)
FUNCTION_1(output, LAG_OUTPUT)
FUNCTION_1(output_tangent, LAG_OUTPUT_TANGENT)
FUNCTION_4(energies, LAG_ENERGIES)
FUNCTION_1(momenta, LAG_MOMENTA)
FUNCTION_2(power, LAG_POWER)
FUNCTION_3(monitor, LAG_MONITOR)
FUNCTION_1(initial_equation, LAG_INITIAL_EQUATION)
FUNCTION_2(constraint_tangent, LAG_CONSTRAINT_TANGENT)
FUNCTION_7(elimination, LAG_ELIMINATION)
FUNCTION_1(discrete_start, LAG_DISCRETE_START)
FUNCTION_1(indicator, LAG_INDICATOR)
FUNCTION_1(standing, LAG_STANDING)
FUNCTION_6(contact, LAG_CONTACT)
FUNCTION_2(clock, LAG_CLOCK)
FUNCTION_7(event, LAG_EVENT)
FUNCTION_7(time_event, LAG_TIME_EVENT)
FUNCTION_1(momentum_tangent, LAG_MOMENTUM_TANGENT)
FUNCTION_1(definition, LAG_DEFINITION)
FUNCTION_1(definition_tangent, LAG_DEFINITION_TANGENT)
FUNCTION_4(start_tangent, LAG_START_TANGENT)
FUNCTION_4(energies_tangent, LAG_ENERGIES_TANGENT)
FUNCTION_1(initial_equation_tangent, LAG_INITIAL_EQUATION_TANGENT)

static lag_status time_tangent(
    const lag_arguments *at,
    double *motion,
    double *rows,
    double *phi,
    double *residuals,
    double *rates,
    double *y,
    double *total,
    double *kinetic,
    double *potential,
    double *jacobi,
    double *d)
{
    double *const results[] = {motion, rows, phi, residuals, rates, y, total, kinetic, potential, jacobi, d};
    return run(at, 1 + LAG_TIME_TANGENT, results);
}

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
#define GIVE(name, number) model->name = lag_tape_has(tape, number) ? name : NULL
    GIVE(start, LAG_START);
    GIVE(position_constraint, LAG_POSITION_CONSTRAINT);
    GIVE(velocity_constraint, LAG_VELOCITY_CONSTRAINT);
    GIVE(mass_matrix, LAG_MASS_MATRIX);
    GIVE(dynamics, LAG_DYNAMICS);
    GIVE(inverse_dynamics, LAG_INVERSE_DYNAMICS);
    GIVE(residual, LAG_RESIDUAL);
    GIVE(residual_tangent, LAG_RESIDUAL_TANGENT);
    GIVE(state_derivative, LAG_STATE_DERIVATIVE);
    GIVE(state_derivative_tangent, LAG_STATE_DERIVATIVE_TANGENT);
    GIVE(output, LAG_OUTPUT);
    GIVE(output_tangent, LAG_OUTPUT_TANGENT);
    GIVE(energies, LAG_ENERGIES);
    GIVE(momenta, LAG_MOMENTA);
    GIVE(power, LAG_POWER);
    GIVE(monitor, LAG_MONITOR);
    GIVE(initial_equation, LAG_INITIAL_EQUATION);
    GIVE(constraint_tangent, LAG_CONSTRAINT_TANGENT);
    GIVE(elimination, LAG_ELIMINATION);
    GIVE(discrete_start, LAG_DISCRETE_START);
    GIVE(indicator, LAG_INDICATOR);
    GIVE(standing, LAG_STANDING);
    GIVE(contact, LAG_CONTACT);
    GIVE(clock, LAG_CLOCK);
    GIVE(event, LAG_EVENT);
    GIVE(time_event, LAG_TIME_EVENT);
    GIVE(momentum_tangent, LAG_MOMENTUM_TANGENT);
    GIVE(definition, LAG_DEFINITION);
    GIVE(definition_tangent, LAG_DEFINITION_TANGENT);
    GIVE(start_tangent, LAG_START_TANGENT);
    GIVE(energies_tangent, LAG_ENERGIES_TANGENT);
    GIVE(initial_equation_tangent, LAG_INITIAL_EQUATION_TANGENT);
    GIVE(time_tangent, LAG_TIME_TANGENT);
    if (formed && model->mass_matrix == NULL) {
        model->mass_matrix = mass_by_columns;
    }
    if (formed && model->dynamics == NULL) {
        model->dynamics = dynamics_by_columns;
    }
}
