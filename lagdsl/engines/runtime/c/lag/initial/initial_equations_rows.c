/* Rows of initial equations and of what they tie together, and their derivatives. */
#include <math.h>
#include <string.h>

#include "lag/equations/entries.h"
#include "lag/initial/initial_equations_rows.h"
#include "lag/linalg/arena.h"

/* An entry that is smaller, as a part of its row, is none: derivatives are differences. */
static const double ABSENT = 1e-8;
/* Beside the start, rows are looked at in so many points. */
enum { POINTS = 3 };

static size_t count_rows(const lag_model *model)
{
    return lag_initialization_rows(model) + model->nc + model->ne;
}

size_t lag_joint_memory(const lag_model *model)
{
    const size_t all = lag_motion_size(model) + model->np;
    const size_t rows = count_rows(model);
    return model->np + 5 * all + rows * all + 5 * rows + model->nq + model->nc;
}

void lag_joint_place(lag_joint *joint, lag_initialization *b, double **memory)
{
    const lag_model *model = b->motion->model;
    const size_t size = lag_motion_size(model);
    const unsigned char *free = b->start != NULL ? b->start->free : NULL;
    memset(joint, 0, sizeof *joint);
    joint->b = b;
    joint->all_rows = count_rows(model);
    joint->parameter = lag_take(memory, model->np);
    for (size_t i = 0; free != NULL && b->told.p != NULL && i < model->np; ++i) {
        if (free[i]) {
            joint->parameter[joint->parameters++] = (double)i;
        }
    }
    joint->all = size + joint->parameters;
    joint->origin = lag_take(memory, joint->all);
    joint->width = lag_take(memory, joint->all);
    joint->scale = lag_take(memory, joint->all_rows);
    joint->pattern = lag_take(memory, joint->all_rows * joint->all);
    joint->row = lag_take(memory, joint->all_rows);
    joint->free = lag_take(memory, joint->all);
    joint->at = lag_take(memory, joint->all);
    joint->one = lag_take(memory, joint->all_rows);
    joint->other = lag_take(memory, joint->all_rows);
    joint->here = lag_take(memory, joint->all_rows);
    joint->y = lag_take(memory, joint->all);
    joint->qdd = lag_take(memory, model->nq);
    joint->lam = lag_take(memory, model->nc);
    memcpy(joint->origin, b->starts.x, size * sizeof(double));
    memcpy(joint->width, b->starts.widths, size * sizeof(double));
    for (size_t k = 0; k < joint->parameters; ++k) {
        const size_t i = (size_t)joint->parameter[k];
        const double value = b->told.p[i];
        const double said = b->start->parameter_nominal != NULL ? fabs(b->start->parameter_nominal[i]) : 0.0;
        joint->origin[size + k] = value;
        joint->width[size + k] = said > 0.0 ? said : value != 0.0 ? fabs(value) : 1.0;
    }
}

void lag_joint_take_all(lag_joint *joint)
{
    for (size_t i = 0; i < joint->all_rows; ++i) {
        joint->row[i] = (double)i;
    }
    for (size_t k = 0; k < joint->all; ++k) {
        joint->free[k] = (double)k;
    }
    joint->rows = joint->all_rows;
    joint->count = joint->all;
}

/* Parameters that change are prepared, discretes follow them. */
static void put_parameters(const lag_joint *joint)
{
    lag_initialization *b = joint->b;
    const size_t size = lag_motion_size(b->motion->model);
    int changed = 0;
    for (size_t k = 0; k < joint->parameters; ++k) {
        double *p = b->told.p + (size_t)joint->parameter[k];
        changed = changed || *p != joint->at[size + k];
        *p = joint->at[size + k];
    }
    if (changed) {
        lag_initialization_parameters(b);
    }
}

void lag_joint_put(const lag_joint *joint, const double *y)
{
    lag_initialization *b = joint->b;
    const size_t n = b->motion->model->nq;
    memcpy(joint->at, joint->origin, joint->all * sizeof(double));
    for (size_t k = 0; k < joint->count; ++k) {
        const size_t i = (size_t)joint->free[k];
        joint->at[i] += joint->width[i] * y[k];
    }
    memcpy(b->q, joint->at, n * sizeof(double));
    memcpy(b->qd, joint->at + n, n * sizeof(double));
    memcpy(b->z, joint->at + 2 * n, b->motion->model->nz * sizeof(double));
    put_parameters(joint);
}

void lag_joint_residuals(const lag_joint *joint, const double *y, double *residual)
{
    lag_initialization *b = joint->b;
    lag_motion *motion = b->motion;
    const lag_model *model = motion->model;
    double *equations = residual + b->rows + model->nc;
    lag_joint_put(joint, y);
    if (model->nc > 0) {
        lag_initialization_positions(b);
        for (size_t i = 0; i < b->rows; ++i) {
            residual[i] = b->phi[(size_t)b->row[i]] / b->row_sizes[(size_t)b->row[i]];
        }
        lag_initialization_velocities(b);
        for (size_t i = 0; i < model->nc; ++i) {
            residual[b->rows + i] = b->phi[i] / b->row_sizes[i];
        }
    }
    motion->at.q = b->q;
    motion->at.qd = b->qd;
    motion->at.z = b->z;
    lag_status status = lag_forward_dynamics(model, &motion->at, motion->memory, joint->qdd, joint->lam, &motion->coordinate);
    lag_arguments at = motion->at;
    at.qdd = joint->qdd;
    at.lam = joint->lam;
    if (status == LAG_OK) {
        status = model->initial_equation(&at, equations);
    }
    if (status != LAG_OK) {
        lag_fill(model->ne, (double)NAN, equations);
    }
    for (size_t i = 0; i < joint->all_rows; ++i) {
        residual[i] /= joint->scale[i];
    }
}

/* Column k from the residuals on both sides of y. */
static void fill_column(const lag_joint *joint, const lag_parts *parts, size_t k, double *jacobian)
{
    size_t first = 0;
    size_t begin = 0;
    size_t place = 0;
    const size_t which = (size_t)parts->column_part[k];
    const size_t rows = lag_parts_rows(parts, which, &first);
    const size_t columns = lag_parts_columns(parts, which, &begin);
    double *block = lag_parts_block(parts, which, jacobian);
    while ((size_t)parts->column[begin + place] != k) {
        ++place;
    }
    for (size_t i = 0; i < rows; ++i) {
        const size_t row = (size_t)joint->row[(size_t)parts->row[first + i]];
        block[i * columns + place] = (joint->one[row] - joint->other[row]) / (2.0 * LAG_DIFFERENCE);
    }
}

/* By central differences: rows of the initial equations hold accelerations, whose derivatives nobody else needs. */
static void differentiate(const lag_joint *joint, const lag_parts *parts, const double *y, double *jacobian)
{
    memcpy(joint->y, y, joint->count * sizeof(double));
    for (size_t k = 0; k < joint->count; ++k) {
        const double here = joint->y[k];
        joint->y[k] = here + LAG_DIFFERENCE;
        lag_joint_residuals(joint, joint->y, joint->one);
        joint->y[k] = here - LAG_DIFFERENCE;
        lag_joint_residuals(joint, joint->y, joint->other);
        joint->y[k] = here;
        fill_column(joint, parts, k, jacobian);
    }
}

/* Columns from `first` on of J, whose rows begin behind `before` others, as the model knows them. */
static void overwrite(const lag_joint *joint, const lag_parts *parts, size_t before, size_t first, double *jacobian)
{
    const lag_initialization *b = joint->b;
    const size_t n = b->motion->model->nq;
    const size_t count = before == 0 ? b->rows : b->motion->model->nc;
    for (size_t place = 0; place < joint->rows; ++place) { /* row after row of all blocks */
        const size_t i = (size_t)parts->row[place];
        const size_t which = (size_t)parts->row_part[i];
        size_t begin = 0;
        size_t top = 0;
        const size_t columns = lag_parts_columns(parts, which, &begin);
        (void)lag_parts_rows(parts, which, &top);
        double *line = lag_parts_block(parts, which, jacobian) + (place - top) * columns;
        const size_t row = (size_t)joint->row[i];
        const size_t its = row >= before && row < before + count ? (before == 0 ? (size_t)b->row[row] : row - before) : 0;
        for (size_t k = 0; row >= before && row < before + count && k < columns; ++k) {
            const size_t unknown = (size_t)joint->free[(size_t)parts->column[begin + k]];
            if (unknown >= first && unknown < first + n) {
                const double entry = b->jacobian[its * n + unknown - first] / b->row_sizes[its];
                line[k] = entry * joint->width[unknown] / joint->scale[row];
            }
        }
    }
}

void lag_joint_evaluate(void *context, const lag_parts *parts, const double *y, double *residual, double *jacobian)
{
    const lag_joint *joint = context;
    lag_initialization *b = joint->b;
    differentiate(joint, parts, y, jacobian);
    lag_joint_residuals(joint, y, joint->here);
    for (size_t i = 0; i < joint->rows; ++i) {
        residual[i] = joint->here[(size_t)joint->row[i]];
    }
    if (b->motion->model->nc > 0) {
        lag_initialization_positions(b);
        overwrite(joint, parts, 0, 0, jacobian);
        lag_initialization_velocities(b);
        overwrite(joint, parts, b->rows, b->motion->model->nq, jacobian);
    }
}

/* ---- what depends on what ---- */

/* Lengths of rows, and the entries that they have. */
static void find_lengths(lag_joint *joint, const double *jacobian)
{
    for (size_t i = 0; i < joint->all_rows; ++i) {
        double sum = 0.0;
        for (size_t k = 0; k < joint->all; ++k) {
            sum += jacobian[i * joint->all + k] * jacobian[i * joint->all + k];
        }
        const double length = isfinite(sum) ? sqrt(sum) : 0.0;
        for (size_t k = 0; k < joint->all && length > 0.0; ++k) {
            const double entry = fabs(jacobian[i * joint->all + k]);
            joint->pattern[i * joint->all + k] = joint->pattern[i * joint->all + k] != 0.0 || entry > ABSENT * length;
        }
        joint->one[i] = length;
    }
}

void lag_joint_measure(lag_joint *joint, double *memory)
{
    const lag_initialization *b = joint->b;
    const size_t n = b->motion->model->nq;
    unsigned long long seed = 20011;
    double *jacobian = lag_take(&memory, joint->all_rows * joint->all);
    const lag_parts whole = lag_parts_of(joint->all_rows, joint->all, NULL, memory);
    lag_joint_take_all(joint);
    lag_fill(joint->all_rows, 1.0, joint->scale);
    lag_fill(joint->all_rows, 0.0, joint->here);
    lag_fill(joint->all_rows * joint->all, 0.0, joint->pattern);
    for (size_t i = 0; i < b->rows + b->motion->model->nc; ++i) { /* J, of coordinates or of rates */
        const int rates = i >= b->rows;
        const size_t row = rates ? i - b->rows : (size_t)b->row[i];
        const lag_entries entries = lag_entries_of(b->motion->model, row);
        for (size_t k = entries.first; k < entries.end; ++k) {
            joint->pattern[i * joint->all + (rates ? n : 0) + lag_entry_column(&entries, k)] = 1.0;
        }
    }
    for (int point = 0; point <= POINTS; ++point) {
        double *y = joint->at; /* copied before it is written */
        for (size_t k = 0; k < joint->all; ++k) {
            y[k] = point == 0 ? 0.0 : 0.4 * lag_initialization_draw(&seed);
        }
        differentiate(joint, &whole, y, jacobian);
        find_lengths(joint, jacobian);
        for (size_t i = 0; i < joint->all_rows; ++i) { /* that of the start, where there is one */
            joint->here[i] = joint->here[i] > 0.0 ? joint->here[i] : joint->one[i];
        }
    }
    for (size_t i = 0; i < joint->all_rows; ++i) {
        joint->scale[i] = joint->here[i] > 0.0 ? joint->here[i] : 1.0;
    }
}
