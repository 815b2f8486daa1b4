/* Entries of rows of J (nc, nq), and of what has its pattern, that can be nonzero. */
#ifndef LAG_ENTRIES_H
#define LAG_ENTRIES_H

#include <math.h>

#include "lag/model.h"

/* The entries of one row, from `first` on; a null `column` means all columns. Among all entries the row begins behind `before`. */
typedef struct lag_entries {
    size_t first, end, before;
    const size_t *column;
} lag_entries;

static inline lag_entries lag_entries_of(const lag_model *model, size_t row)
{
    const lag_pattern *pattern = lag_jacobian_pattern(model);
    if (pattern == NULL) {
        return (lag_entries){0, model->nq, row * model->nq, NULL};
    }
    return (lag_entries){pattern->first[row], pattern->first[row + 1], 0, pattern->column};
}

/* The column of entry k. */
static inline size_t lag_entry_column(const lag_entries *entries, size_t k)
{
    return entries->column != NULL ? entries->column[k] : k;
}

/* The row times y (nq). */
static inline double lag_entries_dot(const lag_entries *entries, const double *row, const double *y)
{
    double sum = 0.0;
    for (size_t k = entries->first; k < entries->end; ++k) {
        sum += row[lag_entry_column(entries, k)] * y[lag_entry_column(entries, k)];
    }
    return sum;
}

/* True if all entries of J are numbers. */
static inline int lag_entries_finite(const lag_model *model, const double *jacobian)
{
    int finite = 1;
    for (size_t i = 0; i < model->nc && finite; ++i) {
        const lag_entries entries = lag_entries_of(model, i);
        for (size_t k = entries.first; k < entries.end && finite; ++k) {
            finite = isfinite(jacobian[i * model->nq + lag_entry_column(&entries, k)]) != 0;
        }
    }
    return finite;
}

/* Entries of all rows. */
static inline size_t lag_entries_count(const lag_model *model)
{
    return lag_jacobian_pattern(model) != NULL ? lag_jacobian_pattern(model)->count : model->nc * model->nq;
}

#endif
