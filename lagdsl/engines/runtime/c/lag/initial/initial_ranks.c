/*
 * Ranks at other parameters and starts than those the model was compiled with. A linkage that moves because of its special dimensions
 * (Bennett's) is rigid with others, and one that does not may get them.
 *
 * Rows that depend on each other on the constraint set only are independent beside it, so ranks are those of general points on it, on the
 * branch on which the motion starts, found by walking along.
 */
#include <math.h>
#include <string.h>

#include "lag/equations/entries.h"
#include "lag/equations/rank.h"
#include "lag/initial/initial_scaling.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"

/* J is known to so many residuals; a point is as good as exact if that is better than roughly. */
static const double KNOWN = 1e3;
static const double SHORTER = 0.6;
enum { WANTED = 3, TRIES = 24 };

typedef struct walk {
    lag_initialization *b;
    lag_levenberg_marquardt minimizer;
    lag_parts parts, all; /* of the position rows, of all rows */
    lag_equations equations;
    double *here, *step, *point;    /* (nq) in natural sizes */
    double *residual, *jacobian;    /* (rows) (entries of the parts) */
    double *block, *part, *inner;   /* (nc, nq) (nq) (nq) */
    double *ranks;                  /* (nc + nq) of each part, the largest so far, */
    double *rough;                  /* (nc + nq) and of points where the rows hold by and large */
    double *best;                   /* (entries of all parts) J where the rank of a part was largest */
    double *basis;                  /* (nq, nq) of one part */
    double *svd;
} walk;

size_t lag_initialization_rank_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    return lag_levenberg_marquardt_memory(m, n) + 2 * lag_parts_memory(m, n) + 3 * n + m + 3 * m * n + n * n + 2 * n + 2 * (m + n) + lag_svd_memory(m, n);
}

static void at_point(void *context, const lag_parts *parts, const double *y, double *residual, double *jacobian)
{
    walk *w = context;
    lag_initialization *b = w->b;
    for (size_t j = 0; j < b->motion->model->nq; ++j) {
        b->q[j] = y[j] * b->sizes[j];
    }
    lag_initialization_positions(b);
    for (size_t i = 0; i < b->rows; ++i) {
        const size_t row = (size_t)b->row[i];
        residual[i] = b->phi[row] / b->row_sizes[row];
    }
    for (size_t which = 0; which < parts->count; ++which) {
        lag_initialization_gather(b, parts, which, b->row, lag_parts_block(parts, which, jacobian));
    }
}

/* Parts of all rows, or of those of position level, by the coordinates that they depend on. */
static lag_parts find_parts(const lag_initialization *b, int positions, double *memory)
{
    const lag_model *model = b->motion->model;
    lag_parts parts = lag_parts_begin(positions ? b->rows : model->nc, model->nq, memory);
    for (size_t i = 0; i < parts.m; ++i) {
        const lag_entries entries = lag_entries_of(model, positions ? (size_t)b->row[i] : i);
        for (size_t k = entries.first; k < entries.end; ++k) {
            lag_parts_join(&parts, i, lag_entry_column(&entries, k));
        }
    }
    lag_parts_end(&parts);
    return parts;
}

static void place(walk *w, lag_initialization *b)
{
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    const size_t m = model->nc;
    double *memory = b->memory;
    memset(w, 0, sizeof *w);
    w->b = b;
    w->equations = (lag_equations){at_point, w};
    w->parts = find_parts(b, 1, lag_take(&memory, lag_parts_memory(m, n)));
    w->all = find_parts(b, 0, lag_take(&memory, lag_parts_memory(m, n)));
    lag_levenberg_marquardt_place(&w->minimizer, &w->parts, lag_take(&memory, lag_levenberg_marquardt_memory(m, n)));
    w->here = lag_take(&memory, n);
    w->step = lag_take(&memory, n);
    w->point = lag_take(&memory, n);
    w->residual = lag_take(&memory, m);
    w->jacobian = lag_take(&memory, lag_parts_entries(&w->parts));
    w->block = lag_take(&memory, m * n);
    w->part = lag_take(&memory, n);
    w->inner = lag_take(&memory, n);
    w->ranks = lag_take(&memory, m + n);
    w->rough = lag_take(&memory, m + n);
    w->best = lag_take(&memory, lag_parts_entries(&w->all));
    w->basis = lag_take(&memory, n * n);
    w->svd = memory;
    lag_fill(lag_parts_entries(&w->all), 0.0, w->best);
    lag_fill(m + n, 0.0, w->ranks);
    lag_fill(m + n, 0.0, w->rough);
}

/* The part of `step` that the position rows leave free. */
static void keep_tangent(walk *w)
{
    at_point(w, &w->parts, w->here, w->residual, w->jacobian);
    for (size_t which = 0; which < w->parts.count; ++which) {
        size_t first = 0;
        const size_t rows = lag_parts_rows(&w->parts, which, &first);
        const size_t columns = lag_parts_columns(&w->parts, which, &first);
        const double *block = lag_parts_block(&w->parts, which, w->jacobian);
        if (rows == 0 || columns == 0 || !lag_finite(rows * columns, block)) {
            continue;
        }
        const lag_svd svd = lag_svd_of(rows, columns, block, w->svd);
        for (size_t j = 0; j < columns; ++j) {
            w->part[j] = w->step[(size_t)w->parts.column[first + j]];
            w->inner[j] = 0.0;
        }
        for (size_t i = lag_svd_rank(&svd, LAG_FOLLOWS); i < columns; ++i) {
            double along = 0.0;
            for (size_t j = 0; j < columns; ++j) {
                along += svd.v[i * columns + j] * w->part[j];
            }
            for (size_t j = 0; j < columns; ++j) {
                w->inner[j] += along * svd.v[i * columns + j];
            }
        }
        for (size_t j = 0; j < columns; ++j) {
            w->step[(size_t)w->parts.column[first + j]] = w->inner[j];
        }
    }
}

/* Writes the part of a row (n) that is orthogonal to the orthonormal ones into w->part; returns its share of the length. */
static double left_of(walk *w, size_t n, const double *row, size_t count)
{
    const double length = sqrt(lag_dot(n, row, row));
    memcpy(w->part, row, n * sizeof(double));
    for (int again = 0; again < 2; ++again) {
        for (size_t k = 0; k < count; ++k) {
            const double along = lag_dot(n, w->basis + k * n, w->part);
            for (size_t j = 0; j < n; ++j) {
                w->part[j] -= along * w->basis[k * n + j];
            }
        }
    }
    return length > LAG_NO_ROW ? sqrt(lag_dot(n, w->part, w->part)) / length : 0.0;
}

/*
 * Rows of a part in turn, those of position level first, each if it depends on none of those before, until there are as many as the rank:
 * with that known no tolerance of its own decides: it is lowered down to round-off. The others are flagged.
 */
static void flag_dependent(walk *w, size_t which, size_t rank)
{
    const lag_model *model = w->b->motion->model;
    unsigned char *flags = w->b->told.dependent;
    size_t first = 0;
    size_t count = 0;
    const size_t n = lag_parts_columns(&w->all, which, &first);
    const size_t rows = lag_parts_rows(&w->all, which, &first);
    const double *best = lag_parts_block(&w->all, which, w->best);
    for (double least = LAG_FOLLOWS; count < rank && least > LAG_EXACT; least *= 0.1) {
        count = 0;
        for (int velocities = 0; velocities < 2; ++velocities) {
            for (size_t i = 0; i < rows; ++i) {
                const size_t row = (size_t)w->all.row[first + i];
                if ((model->position_level[row] == 0) != velocities) {
                    continue;
                }
                const double left = left_of(w, n, best + i * n, count);
                flags[row] = !(count < rank && left > least);
                if (!flags[row]) {
                    const double length = sqrt(lag_dot(n, w->part, w->part));
                    for (size_t j = 0; j < n; ++j) {
                        w->basis[count * n + j] = w->part[j] / length;
                    }
                    ++count;
                }
            }
        }
    }
    for (size_t i = first; i < first + rows && rank == 0; ++i) {
        flags[(size_t)w->all.row[i]] = 1;
    }
}

/* Ranks of all parts at `point`, which is on the constraints up to the residual; 0: a function is not finite there. */
static int find_ranks(walk *w, double residual)
{
    lag_initialization *b = w->b;
    const size_t n = b->motion->model->nq;
    double *ranks = KNOWN * residual <= LAG_ROUGH_RANK ? w->ranks : w->rough;
    for (size_t j = 0; j < n; ++j) {
        b->q[j] = w->point[j] * b->sizes[j];
    }
    lag_initialization_velocities(b);
    int finite = 1;
    for (size_t which = 0; which < w->all.count && finite; ++which) {
        size_t first = 0;
        const size_t rows = lag_parts_rows(&w->all, which, &first);
        const size_t columns = lag_parts_columns(&w->all, which, &first);
        lag_initialization_gather(w->b, &w->all, which, NULL, w->block);
        finite = lag_finite(rows * columns, w->block);
        if (finite && rows > 0 && columns > 0) {
            const lag_svd svd = lag_svd_of(rows, columns, w->block, w->svd);
            const double least = fmax(LAG_RANK, KNOWN * residual) * fmax(svd.value[0], LAG_CONTENT);
            size_t rank = 0;
            while (rank < svd.k && svd.value[rank] > least) {
                ++rank;
            }
            if ((double)rank > ranks[which]) {
                ranks[which] = (double)rank;
                memcpy(lag_parts_block(&w->all, which, w->best), w->block, rows * columns * sizeof(double));
            }
        }
    }
    return finite;
}

/* Further along the set; 0: there are no numbers, or no way back to it. */
static int take_step(walk *w, unsigned long long *seed, size_t which, double scale, double *residual)
{
    lag_initialization *b = w->b;
    const size_t n = b->motion->model->nq;
    lag_initialization_point(b, seed, which, b->starts.x, w->step);
    for (size_t j = 0; j < n; ++j) {
        w->step[j] = (w->step[j] - b->starts.x[j]) / b->sizes[j];
    }
    keep_tangent(w);
    for (size_t j = 0; j < n; ++j) {
        w->point[j] = w->here[j] + scale * w->step[j];
    }
    lag_descend(&w->minimizer, &w->equations, &w->parts, LAG_EXACT, LAG_DESCENTS, w->point);
    *residual = lag_levenberg_marquardt_size(&w->minimizer, &w->parts);
    return *residual <= LAG_HOLDS && find_ranks(w, *residual);
}

void lag_initialization_find_rank(lag_initialization *b, const double *x)
{
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    walk w;
    unsigned long long seed = 20011;
    double scale = 1.0;
    double residual = 0.0;
    size_t found = 0;
    size_t rank = 0;
    place(&w, b);
    memcpy(b->qd, x + n, n * sizeof(double));
    for (size_t j = 0; j < n; ++j) {
        w.here[j] = x[j] / b->sizes[j];
    }
    for (size_t k = 0; k < TRIES && found < WANTED; ++k) {
        if (take_step(&w, &seed, k, scale, &residual)) {
            memcpy(w.here, w.point, n * sizeof(double));
            found += KNOWN * residual <= LAG_ROUGH_RANK;
        } else {
            scale *= SHORTER;
        }
    }
    for (size_t which = 0; which < w.all.count; ++which) {
        const size_t part = (size_t)(found > 0 ? w.ranks : w.rough)[which];
        rank += part;
        if (b->told.dependent != NULL) {
            flag_dependent(&w, which, part);
        }
    }
    b->told.rank = rank;
    if (rank > model->rank) {
        b->told.fault = LAG_INITIAL_RANK;
        b->told.which = rank - model->rank;
    }
}
