/* Rates that nothing asks for: the change from the wanted ones has the least kinetic energy. */
#include <math.h>
#include <string.h>

#include "lag/initial/initial_rates.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

void lag_rates_move(const lag_rates *r, const lag_directions *directions, size_t which, double by, double *x)
{
    const double *numbers = directions->numbers + (size_t)directions->first[which];
    size_t first = 0;
    const size_t columns = lag_parts_columns(&r->parts, (size_t)directions->part[which], &first);
    for (size_t k = 0; k < columns; ++k) {
        x[(size_t)r->parts.column[first + k]] += by * numbers[k];
    }
}

double lag_rates_product(const lag_rates *r, const lag_directions *directions, size_t which, const double *x)
{
    const double *numbers = directions->numbers + (size_t)directions->first[which];
    double sum = 0.0;
    size_t first = 0;
    const size_t columns = lag_parts_columns(&r->parts, (size_t)directions->part[which], &first);
    for (size_t k = 0; k < columns; ++k) {
        sum += numbers[k] * x[(size_t)r->parts.column[first + k]];
    }
    return sum;
}

/* M times a free direction into r->force. */
static void push(lag_rates *r, const double *mass, size_t which)
{
    const size_t n = r->b->motion->model->nq;
    const double *sizes = r->b->sizes;
    const double *numbers = r->free.numbers + (size_t)r->free.first[which];
    size_t first = 0;
    const size_t columns = lag_parts_columns(&r->parts, (size_t)r->free.part[which], &first);
    lag_fill(n, 0.0, r->force);
    for (size_t k = 0; k < columns; ++k) {
        const size_t j = (size_t)r->parts.column[first + k];
        const double by = numbers[k] * sizes[j];
        for (size_t i = 0; i < n; ++i) {
            const double entry = mass[j * n + i];
            r->force[i] += isfinite(entry) ? by * entry * sizes[i] : 0.0;
        }
    }
}

/* K of directions that are tied, each as long that its own entry is one; 0: one has no energy. */
static int scale(size_t count, double *block, double *scales)
{
    for (size_t i = 0; i < count; ++i) {
        if (!(block[i * count + i] > 0.0)) {
            return 0;
        }
        scales[i] = 1.0 / sqrt(block[i * count + i]);
    }
    for (size_t i = 0; i < count; ++i) {
        for (size_t k = 0; k < count; ++k) {
            block[i * count + k] *= scales[i] * scales[k];
        }
    }
    return 1;
}

/* x (count) of K x = `right`, in its place; of several the shortest. */
static void solve(lag_rates *r, const lag_parts *tied, size_t which, size_t count, double *right)
{
    double *block = r->its.block;
    double *scales = r->its.v;
    (void)lag_parts_gather(tied, which, r->free.count, r->inner, block);
    if (scale(count, block, scales) && lag_cholesky(count, block, LAG_RANK) == count) {
        for (size_t i = 0; i < count; ++i) {
            right[i] *= scales[i];
        }
        lag_cholesky_solve(count, block, right);
        for (size_t i = 0; i < count; ++i) {
            right[i] *= scales[i];
        }
        return;
    }
    (void)lag_parts_gather(tied, which, r->free.count, r->inner, block);
    const lag_svd svd = lag_svd_of(count, count, block, r->svd);
    lag_svd_solve(&svd, right, LAG_RANK, 0.0, r->its.wanted);
    memcpy(right, r->its.wanted, count * sizeof(double));
}

void lag_initialization_least_energy(lag_rates *r)
{
    lag_motion *motion = r->b->motion;
    const size_t n = motion->model->nq;
    const size_t width = r->free.count;
    for (size_t j = 0; j < n; ++j) {
        r->change[j] = r->wanted[j] - r->v[j];
    }
    if (width == 0 || !lag_any(n, r->change) || motion->model->mass_matrix(&motion->at, motion->written.mass) != LAG_OK) {
        return;
    }
    lag_parts tied = lag_parts_begin(width, width, r->tied);
    for (size_t i = 0; i < width; ++i) {
        push(r, motion->written.mass, i);
        r->part[i] = lag_dot(n, r->force, r->change);
        lag_parts_join(&tied, i, i);
        for (size_t k = 0; k < width; ++k) {
            r->inner[i * width + k] = lag_rates_product(r, &r->free, k, r->force);
            if (r->inner[i * width + k] != 0.0) {
                lag_parts_join(&tied, i, k);
            }
        }
    }
    lag_parts_end(&tied);
    for (size_t which = 0; which < tied.count; ++which) {
        size_t first = 0;
        const size_t count = lag_parts_rows(&tied, which, &first);
        for (size_t i = 0; i < count; ++i) {
            r->its.right[i] = r->part[(size_t)tied.row[first + i]];
        }
        if (lag_any(count, r->its.right)) {
            solve(r, &tied, which, count, r->its.right);
            for (size_t i = 0; i < count; ++i) {
                lag_rates_move(r, &r->free, (size_t)tied.row[first + i], r->its.right[i], r->v);
            }
        }
    }
}
