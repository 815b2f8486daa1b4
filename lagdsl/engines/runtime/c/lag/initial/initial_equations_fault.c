/* Why no state satisfies the initial equations. */
#include <math.h>
#include <string.h>

#include "lag/initial/initial_equations.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"

void lag_joint_find_worst(const lag_joint_parts *t, lag_joint *joint)
{
    lag_initialization *b = joint->b;
    double worst = -1.0;
    b->told.fault = LAG_INITIAL_EQUATIONS;
    lag_joint_residuals(joint, t->best, joint->here);
    for (size_t k = 0; k < joint->rows; ++k) {
        const size_t i = (size_t)joint->row[k];
        const double size = isfinite(joint->here[i]) ? fabs(joint->here[i] * joint->scale[i]) : (double)INFINITY;
        if (size > worst) {
            worst = size;
            b->told.which = i < b->rows ? (size_t)b->row[i] : i - b->rows;
            b->told.residual = size;
        }
    }
}

void lag_joint_count_excess(const lag_joint_parts *t, lag_joint *joint)
{
    lag_initialization *b = joint->b;
    double *memory = t->memory;
    double *matrix = lag_take(&memory, joint->all_rows * joint->all);
    double *room = lag_take(&memory, lag_parts_memory(joint->all_rows, joint->all));
    lag_joint_put(joint, t->best);
    memcpy(joint->origin, joint->at, joint->all * sizeof(double));
    lag_fill(joint->all, 0.0, t->best);
    const lag_parts chosen = lag_parts_of(joint->rows, joint->count, NULL, room);
    lag_joint_evaluate(joint, &chosen, t->best, joint->one, matrix);
    const size_t part = lag_initialization_rank(joint->rows, joint->count, matrix, memory);
    joint->count = joint->all;
    for (size_t k = 0; k < joint->all; ++k) {
        joint->free[k] = (double)k;
    }
    const lag_parts all = lag_parts_of(joint->rows, joint->all, NULL, room);
    lag_joint_evaluate(joint, &all, t->best, joint->one, matrix);
    const size_t whole = lag_initialization_rank(joint->rows, joint->all, matrix, memory);
    b->told.excess = whole > part ? whole - part : 0;
    b->told.general = joint->all - whole;
}

void lag_joint_find_undecided(const lag_joint_parts *t, lag_joint *joint)
{
    lag_initialization *b = joint->b;
    const size_t size = lag_motion_size(b->motion->model);
    double *memory = t->memory;
    double *matrix = lag_take(&memory, joint->rows * joint->count);
    const lag_parts whole = lag_parts_of(joint->rows, joint->count, NULL, lag_take(&memory, lag_parts_memory(joint->rows, joint->count)));
    double *chosen = t->trial;
    lag_fill(joint->all, 0.0, chosen);
    lag_joint_evaluate(joint, &whole, t->best, joint->one, matrix);
    const lag_svd svd = lag_svd_of(joint->rows, joint->count, matrix, memory);
    const size_t rank = lag_svd_rank(&svd, LAG_ROUGH_RANK);
    for (size_t k = 0; k < joint->count; ++k) {
        double along = 0.0;
        for (size_t i = rank; i < joint->count; ++i) {
            along += svd.v[i * joint->count + k] * svd.v[i * joint->count + k];
        }
        chosen[(size_t)joint->free[k]] = sqrt(along) <= LAG_ROUGH_RANK ? 1.0 : 0.0;
    }
    for (size_t k = size; k < joint->all; ++k) {
        if (chosen[k] == 0.0 && b->told.fault == LAG_INITIAL_NONE) {
            b->told.fault = LAG_INITIAL_PARAMETERS;
            b->told.which = (size_t)joint->parameter[k - size];
        }
    }
}
