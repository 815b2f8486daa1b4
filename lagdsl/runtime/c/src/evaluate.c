#include "lag/evaluate.h"

lag_status lag_prepare(const lag_model *model, const lag_arguments *at)
{
    return model->prepare(at);
}

/* What models with discretes have beside. */
static lag_status evaluate_event(const lag_model *model, lag_function which, const lag_arguments *at, double *r)
{
    const size_t gaps = model->ngap;
    const size_t contacts = model->ncontact;
    double *laws = r + 2 * gaps + gaps * model->nq;
    double *collisions = r + model->nw + 2 * model->nreset;
    double *ends = collisions + 2 * model->ncollision;
    if (model->event == NULL) {
        return LAG_MISSING;
    }
    switch (which) {
    case LAG_DISCRETE_START:
        return model->discrete_start(at, r);
    case LAG_INDICATOR:
        return model->indicator(at, r);
    case LAG_STANDING:
        return model->standing(at, r);
    case LAG_CONTACT:
        return model->contact(at, r, r + gaps, r + 2 * gaps, laws, laws + contacts, laws + 2 * contacts);
    case LAG_CLOCK:
        return model->clock(at, r, r + model->nclock);
    case LAG_EVENT:
        return model->event(at, r, r + model->nw, r + model->nw + model->nreset, collisions, collisions + model->ncollision, ends,
            ends + model->nstop);
    default:
        return LAG_MISSING;
    }
}

static lag_status eliminate(const lag_model *model, const lag_arguments *at, double *r)
{
    double *response = r + model->nq + model->nc;
    double *lam_response = response + model->nk * model->nq;
    double *jacobian = lam_response + model->nk * model->nc;
    double *gamma = jacobian + model->nk * model->nq;
    return model->elimination(at, r, r + model->nq, response, lam_response, jacobian, gamma, gamma + model->nk);
}

/* What models have that were compiled with their named values. */
static lag_status evaluate_named(const lag_model *model, lag_function which, const lag_arguments *at, double *r)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    double *rows = r + n;
    double *rates = rows + 3 * m;
    double *y = rates + model->nz;
    if (model->definition == NULL) {
        return LAG_MISSING;
    }
    switch (which) {
    case LAG_DEFINITION:
        return model->definition(at, r);
    case LAG_DEFINITION_TANGENT:
        return model->definition_tangent(at, r);
    case LAG_START_TANGENT:
        return model->start_tangent(at, r, r + n, r + 2 * n, r + 2 * n + model->nz);
    case LAG_ENERGIES_TANGENT:
        return model->energies_tangent(at, r, r + 1, r + 2, r + 3);
    case LAG_INITIAL_EQUATION_TANGENT:
        return model->initial_equation_tangent(at, r);
    case LAG_TIME_TANGENT:
        return model->time_tangent(at, r, rows, rows + m, rows + 2 * m, rates, y, y + model->ny, y + model->ny + 1, y + model->ny + 2,
            y + model->ny + 3, y + model->ny + 4);
    default:
        return LAG_MISSING;
    }
}

lag_status lag_evaluate(const lag_model *model, lag_function which, const lag_arguments *at, double *r)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    switch (which) {
    case LAG_START:
        return model->start(at, r, r + n, r + 2 * n, r + 2 * n + model->nz);
    case LAG_POSITION_CONSTRAINT:
        return model->position_constraint(at, r, r + m);
    case LAG_VELOCITY_CONSTRAINT:
        return model->velocity_constraint(at, r, r + m);
    case LAG_MASS_MATRIX:
        return model->mass_matrix(at, r);
    case LAG_DYNAMICS:
        return model->dynamics(at, r, r + n * n, r + n * n + n, r + n * n + n + m * n);
    case LAG_INVERSE_DYNAMICS:
        return model->inverse_dynamics(at, r);
    case LAG_RESIDUAL:
        return model->residual(at, r, r + n);
    case LAG_RESIDUAL_TANGENT:
        return model->residual_tangent(at, r, r + n);
    case LAG_STATE_DERIVATIVE:
        return model->state_derivative(at, r);
    case LAG_STATE_DERIVATIVE_TANGENT:
        return model->state_derivative_tangent(at, r);
    case LAG_OUTPUT:
        return model->output(at, r);
    case LAG_OUTPUT_TANGENT:
        return model->output_tangent(at, r);
    case LAG_ENERGIES:
        return model->energies(at, r, r + 1, r + 2, r + 3);
    case LAG_MOMENTA:
        return model->momenta(at, r);
    case LAG_POWER:
        return model->power(at, r, r + n);
    case LAG_MONITOR:
        return model->monitor(at, r, r + model->ni, r + 2 * model->ni);
    case LAG_INITIAL_EQUATION:
        return model->initial_equation(at, r);
    case LAG_CONSTRAINT_TANGENT:
        return model->constraint_tangent(at, r, r + m);
    case LAG_ELIMINATION:
        if (model->elimination == NULL) {
            return LAG_MISSING;
        }
        return eliminate(model, at, r);
    case LAG_DISCRETE_START:
    case LAG_INDICATOR:
    case LAG_STANDING:
    case LAG_CONTACT:
    case LAG_CLOCK:
    case LAG_EVENT:
        return evaluate_event(model, which, at, r);
    case LAG_MOMENTUM_TANGENT:
        if (model->momentum_tangent == NULL) {
            return LAG_MISSING;
        }
        return model->momentum_tangent(at, r);
    case LAG_DEFINITION:
    case LAG_DEFINITION_TANGENT:
    case LAG_START_TANGENT:
    case LAG_ENERGIES_TANGENT:
    case LAG_INITIAL_EQUATION_TANGENT:
    case LAG_TIME_TANGENT:
        return evaluate_named(model, which, at, r);
    }
    return LAG_MISSING;
}
