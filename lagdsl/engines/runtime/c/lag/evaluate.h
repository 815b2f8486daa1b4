/* Any function of a model by number. */
#ifndef LAG_EVALUATE_H
#define LAG_EVALUATE_H

#include "lag/model.h"

/* In the order of the function pointers of lag_model. */
typedef enum lag_function {
    /* ---- the functions, generated ---- */
    LAG_START,
    LAG_POSITION_CONSTRAINT,
    LAG_VELOCITY_CONSTRAINT,
    LAG_MASS_MATRIX,
    LAG_DYNAMICS,
    LAG_INVERSE_DYNAMICS,
    LAG_RESIDUAL,
    LAG_RESIDUAL_TANGENT,
    LAG_STATE_DERIVATIVE,
    LAG_STATE_DERIVATIVE_TANGENT,
    LAG_OUTPUT,
    LAG_OUTPUT_TANGENT,
    LAG_ENERGIES,
    LAG_MOMENTA,
    LAG_POWER,
    LAG_MONITOR,
    LAG_INITIAL_EQUATION,
    LAG_CONSTRAINT_TANGENT,
    LAG_ELIMINATION,
    LAG_DISCRETE_START,
    LAG_INDICATOR,
    LAG_INDICATOR_RATE,
    LAG_STANDING,
    LAG_CONTACT,
    LAG_CLOCK,
    LAG_EVENT,
    LAG_TIME_EVENT,
    LAG_CORNER,
    LAG_WAY,
    LAG_TURN,
    LAG_DELAYED,
    LAG_FRICTION,
    LAG_LOAD,
    LAG_LOAD_TANGENT,
    LAG_LOAD_GAIN,
    LAG_MOMENTUM_TANGENT,
    LAG_DEFINITION,
    LAG_DEFINITION_TANGENT,
    LAG_START_TANGENT,
    LAG_ENERGIES_TANGENT,
    LAG_INITIAL_EQUATION_TANGENT,
    LAG_TIME_TANGENT,
    LAG_CORRECTION,
    LAG_EQUATION_TERMS,
    LAG_REGRESSOR,
    LAG_KINEMATICS
#define LAG_LAST_FUNCTION LAG_KINEMATICS
    /* ---- end of what is generated ---- */
} lag_function;

/* prepare() of the model. */
lag_status lag_prepare(const lag_model *model, const lag_arguments *at);

/* Results are written one after the other into `results`, each in the order that lag/model.h tells. LAG_MISSING: the model lacks it. */
lag_status lag_evaluate(const lag_model *model, lag_function which, const lag_arguments *at, double *results);

#endif
