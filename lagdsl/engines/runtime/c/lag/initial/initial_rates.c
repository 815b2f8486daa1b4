/* Rates of a start: fixed ones, then written ones as far as the constraints leave them free, then least kinetic energy of the change. */
#include <math.h>
#include <string.h>

#include "lag/equations/rank.h"
#include "lag/initial/initial_rates.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"

/* Conditions at most. */
static size_t most(const lag_model *model)
{
    return model->nc + model->ne + model->nq;
}

static size_t directions_memory(size_t n)
{
    return 2 * n + n * n;
}

size_t lag_initialization_qd_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t all = most(model);
    return all * n + 2 * all + 10 * n + 3 * n * n + 2 * directions_memory(n) + 4 * m + m * m + n * m + lag_parts_memory(all, n) +
           lag_parts_memory(n, n) + lag_levenberg_marquardt_memory(m, n) + lag_parts_memory(m, n) + lag_svd_memory(all, n) + lag_svd_memory(n, m);
}

static lag_directions place_directions(size_t n, double *memory)
{
    return (lag_directions){.part = lag_take(&memory, n), .first = lag_take(&memory, n), .numbers = lag_take(&memory, n * n)};
}

static void lay_out(lag_rates *r, lag_initialization *b)
{
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t all = most(model);
    double *memory = b->memory;
    double **const by_coordinate[] = {
        &r->fixed, &r->v, &r->wanted, &r->place, &r->its.v, &r->its.wanted, &r->part, &r->change, &r->force, &r->branch.moved, NULL};
    double **const by_row[] = {&r->branch.part, &r->branch.first, &r->branch.acts, &r->branch.gamma, NULL};
    double **const squares[] = {&r->its.free, &r->its.other, &r->inner, NULL};
    memset(r, 0, sizeof *r);
    r->b = b;
    lag_take_all(&memory, n, by_coordinate);
    lag_take_all(&memory, m, by_row);
    lag_take_all(&memory, n * n, squares);
    r->its.block = lag_take(&memory, all * n);
    r->right = lag_take(&memory, all);
    r->its.right = lag_take(&memory, all);
    r->free = place_directions(n, lag_take(&memory, directions_memory(n)));
    r->unbound = place_directions(n, lag_take(&memory, directions_memory(n)));
    r->branch.numbers = lag_take(&memory, m * m);
    r->branch.turned = lag_take(&memory, n * m);
    r->parts = lag_parts_begin(0, 0, lag_take(&memory, lag_parts_memory(all, n)));
    r->tied = lag_take(&memory, lag_parts_memory(n, n));
    r->branch.minimizer = lag_take(&memory, lag_levenberg_marquardt_memory(m, n) + lag_parts_memory(m, n));
    r->svd = memory;
}

/* ---- one part ---- */

/* Records the condition that is violated, and its residual; fixed rates are counted behind all rows. */
static void record_violated(lag_rates *r, size_t which, double residual)
{
    lag_initialization *b = r->b;
    const size_t m = b->motion->model->nc;
    const size_t rows = m + lag_rates_equations(r);
    b->told.fault = LAG_INITIAL_RATES;
    b->told.which = which;
    b->told.residual = which < m ? residual * b->row_sizes[which] : residual;
    if (which >= rows) {
        const size_t j = (size_t)r->fixed[which - rows];
        b->told.which = m + j;
        b->told.residual = residual * b->sizes[j];
    }
}

/* v of minimum norm, and what it leaves free; 0: the conditions contradict each other, which is told. */
static int satisfy(lag_rates *r, size_t which)
{
    const size_t n = r->its.columns;
    const lag_model *model = r->b->motion->model;
    int with_equations = 0;
    size_t first = 0;
    const size_t count = lag_parts_rows(&r->parts, which, &first);
    double largest = 0.0;
    double worst = 0.0;
    size_t place = 0;
    for (size_t i = 0; i < count; ++i) {
        const size_t row = (size_t)r->parts.row[first + i];
        r->its.right[i] = r->right[row];
        with_equations = with_equations || (r->b->equations.slopes != NULL && row >= model->nc && row < model->nc + model->ne);
    }
    const lag_svd svd = lag_svd_of(count, n, r->its.block, r->svd);
    const double least = lag_initialization_least(&svd, with_equations ? LAG_ROUGH_RANK : LAG_RANK); /* their derivatives are differences */
    const size_t rank = lag_svd_rank(&svd, least);
    lag_svd_solve(&svd, r->its.right, least, 0.0, r->its.v);
    for (size_t i = 0; i < count; ++i) {
        const double left = fabs(lag_dot(n, r->its.block + i * n, r->its.v) - r->its.right[i]);
        largest = fmax(largest, fabs(r->its.right[i]));
        if (left > worst) {
            worst = left;
            place = i;
        }
    }
    r->its.width = n - rank;
    memcpy(r->its.free, svd.v + rank * n, (n - rank) * n * sizeof(double));
    if (worst <= (with_equations ? LAG_HOLDS : LAG_RANK) * (1.0 + largest)) {
        return 1;
    }
    record_violated(r, (size_t)r->parts.row[first + place], worst);
    return 0;
}

/* Written rates in turn, each if it is independent of the constraints and those before it. */
static void impose(lag_rates *r, const double *column)
{
    const lag_initialization *b = r->b;
    const size_t n = r->its.columns;
    for (size_t j = 0; j < n; ++j) {
        const size_t place = b->motion->model->nq + (size_t)column[j];
        double length = 0.0;
        if (b->starts.written[place] == 0.0 || b->starts.fixed[place] != 0.0) {
            continue;
        }
        for (size_t i = 0; i < r->its.width; ++i) {
            r->part[i] = r->its.free[i * n + j];
            length += r->part[i] * r->part[i];
        }
        if (!(sqrt(length) > LAG_FOLLOWS)) { /* the others decide it, as at dead centers */
            continue;
        }
        const double missing = (r->its.wanted[j] - r->its.v[j]) / length;
        for (size_t i = 0; i < r->its.width; ++i) {
            lag_axpy(n, r->part[i] * missing, r->its.free + i * n, r->its.v);
        }
        const lag_svd svd = lag_svd_of(1, r->its.width, r->part, r->svd);
        for (size_t i = 0; i + 1 < r->its.width; ++i) {
            lag_fill(n, 0.0, r->its.other + i * n);
            for (size_t k = 0; k < r->its.width; ++k) {
                lag_axpy(n, svd.v[(i + 1) * r->its.width + k], r->its.free + k * n, r->its.other + i * n);
            }
        }
        --r->its.width;
        memcpy(r->its.free, r->its.other, r->its.width * n * sizeof(double));
    }
}

/* The rest: nearest to the start values. */
static void approach(lag_rates *r)
{
    const size_t n = r->its.columns;
    for (size_t j = 0; j < n; ++j) {
        r->change[j] = r->its.wanted[j] - r->its.v[j];
    }
    for (size_t i = 0; i < r->its.width; ++i) {
        lag_axpy(n, lag_dot(n, r->its.free + i * n, r->change), r->its.free + i * n, r->its.v);
    }
}

/* The free directions of a part stand behind other directions. */
static void append(const lag_rates *r, size_t which, lag_directions *directions)
{
    const size_t n = r->its.columns;
    for (size_t i = 0; i < r->its.width; ++i, ++directions->count, directions->end += n) {
        directions->part[directions->count] = (double)which;
        directions->first[directions->count] = (double)directions->end;
        memcpy(directions->numbers + directions->end, r->its.free + i * n, n * sizeof(double));
    }
}

/* The rates of a part, as if it were alone; 0: there are none. */
static int solve_part(lag_rates *r, size_t which)
{
    size_t first = 0;
    size_t row = 0;
    r->its.columns = lag_parts_columns(&r->parts, which, &first);
    const size_t conditions = lag_parts_rows(&r->parts, which, &row);
    const double *column = r->parts.column + first;
    for (size_t j = 0; j < r->its.columns; ++j) {
        r->its.wanted[j] = r->wanted[(size_t)column[j]];
    }
    for (size_t i = 0; r->its.columns == 0 && i < conditions; ++i) { /* rows that no rate moves */
        const size_t its = (size_t)r->parts.row[row + i];
        if (!(fabs(r->right[its]) <= LAG_RANK)) {
            record_violated(r, its, fabs(r->right[its]));
            return 0;
        }
    }
    if (r->its.columns == 0) {
        return 1;
    }
    if (conditions == 0) { /* a rate alone */
        r->its.v[0] = r->its.wanted[0];
        r->its.free[0] = 1.0;
        r->its.width = 1;
    } else {
        lag_rates_gather(r, which, r->its.block);
        if (!satisfy(r, which)) {
            return 0;
        }
    }
    append(r, which, &r->unbound);
    impose(r, column);
    approach(r);
    append(r, which, &r->free);
    for (size_t j = 0; j < r->its.columns; ++j) {
        r->v[(size_t)column[j]] = r->its.v[j];
    }
    return 1;
}

/* a b of quaternions, or a' b. Hamilton's product, scalar first. */
static void multiply(const double *a, int conjugate, const double *b, double *product)
{
    const double s = conjugate ? -1.0 : 1.0;
    product[0] = a[0] * b[0] - s * (a[1] * b[1] + a[2] * b[2] + a[3] * b[3]);
    product[1] = a[0] * b[1] + s * (a[1] * b[0] + a[2] * b[3] - a[3] * b[2]);
    product[2] = a[0] * b[2] + s * (a[2] * b[0] + a[3] * b[1] - a[1] * b[3]);
    product[3] = a[0] * b[3] + s * (a[3] * b[0] + a[1] * b[2] - a[2] * b[1]);
}

/* The rates of quaternions, of unit length as they are written, belong to angular velocities in own axes: they turn with positions that have moved to x. */
static void turn_rates(lag_initialization *b, const double *x)
{
    const size_t n = b->motion->model->nq;
    const unsigned char *told = b->start != NULL ? b->start->written : NULL;
    for (size_t j = 0; told != NULL && j + 4 <= n; ++j) {
        double turned[4];
        const double *e = b->starts.x + j;
        if ((told[n + j] & LAG_QUATERNION) == 0 || lag_same(4, e, x + j)) {
            continue;
        }
        const double length = sqrt(lag_dot(4, e, e));
        multiply(e, 1, b->starts.x + n + j, turned);
        multiply(x + j, 0, turned, b->starts.x + n + j);
        for (size_t k = 0; k < 4; ++k) {
            b->starts.x[n + j + k] /= length;
        }
    }
}

void lag_initialization_find_qd(lag_initialization *b, double *x)
{
    const size_t n = b->motion->model->nq;
    lag_rates r;
    if (b->motion->model->nc == 0 && b->equations.slopes == NULL) {
        return;
    }
    lay_out(&r, b);
    turn_rates(b, x);
    memcpy(b->q, x, n * sizeof(double));
    lag_fill(n, 0.0, b->qd);
    lag_initialization_velocities(b);
    const int regular = b->motion->model->nc == 0 || lag_initialization_is_regular(b, r.svd);
    if (regular && lag_rates_are_satisfied(&r)) { /* these are the rates */
        memcpy(x + n, b->starts.x + n, n * sizeof(double));
        return;
    }
    lag_rates_state_conditions(&r, x);
    lag_rates_find_parts(&r);
    int possible = 1;
    for (size_t which = 0; which < r.parts.count && possible; ++which) {
        possible = solve_part(&r, which);
    }
    if (possible) {
        lag_initialization_least_energy(&r);
    }
    if (possible && !regular) {
        lag_initialization_branch(&r);
    }
    for (size_t j = 0; j < n; ++j) {
        const double rate = r.v[j] * b->sizes[j];
        const double wanted = b->starts.x[n + j]; /* what is met is kept exactly, not to within round-off */
        x[n + j] = possible && fabs(rate - wanted) <= LAG_EXACT * fmax(fabs(wanted), b->sizes[j]) ? wanted : rate;
    }
}
