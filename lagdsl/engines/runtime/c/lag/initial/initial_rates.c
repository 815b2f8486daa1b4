/* Rates of a start: fixed ones, then written ones as far as the constraints leave them free, then least kinetic energy of the change. */
#include <math.h>
#include <string.h>

#include "lag/equations/entries.h"
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

size_t lag_initialization_qd_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t all = most(model) + n;
    return m * n + 3 * all * n + 2 * most(model) + 4 * n + 5 * n * n + 3 * n + 2 * m + n * m + m * m + lag_parts_memory(all, n) +
           lag_levenberg_marquardt_memory(m, n) + lag_parts_memory(m, n) + lag_svd_memory(all, n) + lag_svd_memory(n, m);
}

static void place(lag_rates *r, lag_initialization *b)
{
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t all = most(model) + n;
    double *memory = b->memory;
    memset(r, 0, sizeof *r);
    r->b = b;
    r->rows = lag_take(&memory, m * n);
    r->table = lag_take(&memory, all * n);
    r->pattern = lag_take(&memory, all * n);
    r->its.block = lag_take(&memory, all * n);
    r->right = lag_take(&memory, most(model));
    r->its.right = lag_take(&memory, most(model));
    r->v = lag_take(&memory, n);
    r->wanted = lag_take(&memory, n);
    r->its.v = lag_take(&memory, n);
    r->its.wanted = lag_take(&memory, n);
    r->free = lag_take(&memory, n * n);
    r->unbound = lag_take(&memory, n * n);
    r->its.free = lag_take(&memory, n * n);
    r->its.other = lag_take(&memory, n * n);
    r->inner = lag_take(&memory, n * n);
    r->part = lag_take(&memory, n);
    r->change = lag_take(&memory, n);
    r->force = lag_take(&memory, n);
    r->branch.gamma = lag_take(&memory, m);
    r->branch.act = lag_take(&memory, m);
    r->branch.turned = lag_take(&memory, n * m);
    r->branch.vanishing = lag_take(&memory, m * m);
    r->parts = lag_parts_of(0, 0, NULL, lag_take(&memory, lag_parts_memory(all, n)));
    r->branch.minimizer = lag_take(&memory, lag_levenberg_marquardt_memory(m, n) + lag_parts_memory(m, n));
    r->svd = memory;
}

/* ---- conditions ---- */

/* True if rows are clearly independent and the start values satisfy all of them: then these are the rates. */
static int are_as_wanted(const lag_rates *r)
{
    lag_initialization *b = r->b;
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    int alike = b->equations.slopes == NULL;
    for (size_t i = 0; i < model->nc && alike; ++i) {
        const lag_entries entries = lag_entries_of(model, i);
        const double right = -b->phi[i] / b->row_sizes[i];
        double sum = 0.0;
        for (size_t k = entries.first; k < entries.end; ++k) {
            const size_t j = lag_entry_column(&entries, k);
            sum += b->jacobian[i * n + j] * b->sizes[j] / b->row_sizes[i] * (b->starts.x[n + j] / b->sizes[j]);
        }
        alike = fabs(sum - right) <= LAG_EXACT * (1.0 + fabs(right));
    }
    return alike && lag_initialization_is_regular(b, r->svd);
}

/* J v + b = 0, the initial equations as they are near the rates of the start, and the fixed rates. */
static void state_conditions(lag_rates *r, const double *x)
{
    const lag_initialization *b = r->b;
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    const size_t m = model->nc;
    size_t count = m;
    for (size_t i = 0; i < m; ++i) {
        for (size_t j = 0; j < n; ++j) {
            r->rows[i * n + j] = b->jacobian[i * n + j] * b->sizes[j] / b->row_sizes[i];
        }
        r->right[i] = -b->phi[i] / b->row_sizes[i];
    }
    memcpy(r->table, r->rows, m * n * sizeof(double));
    for (size_t i = 0; b->equations.slopes != NULL && i < model->ne; ++i, ++count) {
        memcpy(r->table + count * n, b->equations.slopes + i * n, n * sizeof(double));
        r->right[count] = 0.0;
        for (size_t j = 0; j < n; ++j) {
            r->right[count] += b->equations.slopes[i * n + j] * x[n + j] / b->sizes[j];
        }
    }
    for (size_t j = 0; j < n; ++j) {
        r->wanted[j] = r->v[j] = b->starts.x[n + j] / b->sizes[j];
        if (b->starts.fixed[n + j] != 0.0) {
            lag_fill(n, 0.0, r->table + count * n);
            r->table[count * n + j] = 1.0;
            r->right[count++] = r->wanted[j];
        }
    }
    r->conditions = count;
}

/* M behind the conditions, and the rates that belong together. */
static void find_parts(lag_rates *r)
{
    const lag_initialization *b = r->b;
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    double *mass = r->table + r->conditions * n;
    double *memory = r->parts.row_part;
    if (model->mass_matrix(&b->motion->at, mass) != LAG_OK) {
        lag_fill(n * n, 0.0, mass);
    }
    for (size_t k = 0; k < n * n; ++k) {
        mass[k] = isfinite(mass[k]) ? mass[k] * b->sizes[k / n] * b->sizes[k % n] : 0.0;
    }
    lag_fill(model->nc * n, 0.0, r->pattern);
    lag_initialization_spread(b, r->pattern);
    for (size_t k = 0; k < (r->conditions + n) * n; ++k) {
        r->pattern[k] = r->table[k] != 0.0 || (k < model->nc * n && r->pattern[k] != 0.0);
    }
    for (size_t j = 0; j < n; ++j) {
        r->pattern[(r->conditions + j) * n + j] = 1.0;
    }
    r->parts = lag_parts_of(r->conditions + n, n, r->pattern, memory);
}

/* ---- one part ---- */

/* Records the condition that is violated, and its residual; fixed rates are counted behind all rows. */
static void record_violated(lag_rates *r, size_t which, double residual)
{
    lag_initialization *b = r->b;
    const size_t n = b->motion->model->nq;
    const size_t m = b->motion->model->nc;
    size_t number = m + (b->equations.slopes != NULL ? b->motion->model->ne : 0);
    b->told.fault = LAG_INITIAL_RATES;
    b->told.which = which;
    b->told.residual = which < m ? residual * b->row_sizes[which] : residual;
    for (size_t j = 0; which >= m && j < n; ++j) {
        if (b->starts.fixed[n + j] != 0.0 && number++ == which) {
            b->told.which = m + j;
            b->told.residual = residual * b->sizes[j];
        }
    }
}

/* v of minimum norm, and what it leaves free; 0: the conditions contradict each other, which is told. */
static int satisfy(lag_rates *r, size_t which)
{
    const size_t n = r->its.columns;
    const lag_model *model = r->b->motion->model;
    int with_equations = 0;
    size_t first = 0;
    const size_t count = lag_parts_rows(&r->parts, which, &first) - n;
    double largest = 0.0;
    double worst = 0.0;
    size_t place = 0;
    for (size_t i = 0; i < count; ++i) {
        const size_t row = (size_t)r->parts.row[first + i];
        r->its.right[i] = r->right[row];
        with_equations = with_equations || (r->b->equations.slopes != NULL && row >= model->nc && row < model->nc + model->ne);
    }
    const lag_svd svd = lag_svd_of(count, n, r->its.block, r->svd);
    const double least = with_equations ? LAG_ROUGH_RANK : LAG_RANK; /* their derivatives are differences */
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

/* The rest: nearest to the start values, then with the least kinetic energy of the change. */
static void complete(lag_rates *r, const double *mass)
{
    const size_t n = r->its.columns;
    const size_t width = r->its.width;
    for (size_t j = 0; j < n; ++j) {
        r->change[j] = r->its.wanted[j] - r->its.v[j];
    }
    for (size_t i = 0; i < width; ++i) {
        lag_axpy(n, lag_dot(n, r->its.free + i * n, r->change), r->its.free + i * n, r->its.v);
    }
    for (size_t j = 0; j < n; ++j) {
        r->change[j] = r->its.wanted[j] - r->its.v[j];
    }
    for (size_t i = 0; i < width; ++i) { /* free' M, then free' M free and free' M (wanted - v) */
        lag_fill(n, 0.0, r->its.other + i * n);
        for (size_t k = 0; k < n; ++k) {
            lag_axpy(n, r->its.free[i * n + k], mass + k * n, r->its.other + i * n);
        }
    }
    for (size_t i = 0; i < width; ++i) {
        for (size_t k = 0; k < width; ++k) {
            r->inner[i * width + k] = lag_dot(n, r->its.other + i * n, r->its.free + k * n);
        }
        r->part[i] = lag_dot(n, r->its.other + i * n, r->change);
    }
    if (width > 0) {
        const lag_svd svd = lag_svd_of(width, width, r->inner, r->svd);
        lag_svd_solve(&svd, r->part, LAG_RANK, 0.0, r->force);
    }
    for (size_t i = 0; i < width; ++i) {
        lag_axpy(n, r->force[i], r->its.free + i * n, r->its.v);
    }
}

/* Rows of a part among those of all rates, behind `width` others. */
static size_t append(const lag_rates *r, const double *column, size_t width, double *all)
{
    const size_t n = r->b->motion->model->nq;
    for (size_t i = 0; i < r->its.width; ++i) {
        lag_fill(n, 0.0, all + (width + i) * n);
        for (size_t j = 0; j < r->its.columns; ++j) {
            all[(width + i) * n + (size_t)column[j]] = r->its.free[i * r->its.columns + j];
        }
    }
    return width + r->its.width;
}

/* The rates of a part, as if it were alone; 0: there are none. */
static int solve_part(lag_rates *r, size_t which)
{
    size_t first = 0;
    size_t row = 0;
    r->its.columns = lag_parts_columns(&r->parts, which, &first);
    const size_t conditions = lag_parts_rows(&r->parts, which, &row) - r->its.columns;
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
    if (conditions == 0 || r->its.columns == 0) {
        return 1; /* as wanted */
    }
    (void)lag_parts_gather(&r->parts, which, r->b->motion->model->nq, r->table, r->its.block);
    if (!satisfy(r, which)) {
        return 0;
    }
    r->unbound_width = append(r, column, r->unbound_width, r->unbound);
    impose(r, column);
    complete(r, r->its.block + conditions * r->its.columns);
    r->width = append(r, column, r->width, r->free);
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
    place(&r, b);
    turn_rates(b, x);
    memcpy(b->q, x, n * sizeof(double));
    lag_fill(n, 0.0, b->qd);
    lag_initialization_velocities(b);
    if (are_as_wanted(&r)) {
        memcpy(x + n, b->starts.x + n, n * sizeof(double));
        return;
    }
    state_conditions(&r, x);
    find_parts(&r);
    int possible = 1;
    for (size_t which = 0; which < r.parts.count && possible; ++which) {
        possible = solve_part(&r, which);
    }
    if (possible && b->motion->model->nc > 0) {
        lag_initialization_branch(&r);
    }
    for (size_t j = 0; j < n; ++j) {
        const double rate = r.v[j] * b->sizes[j];
        const double wanted = b->starts.x[n + j]; /* what is met is kept exactly, not to within round-off */
        x[n + j] = possible && fabs(rate - wanted) <= LAG_EXACT * fmax(fabs(wanted), b->sizes[j]) ? wanted : rate;
    }
}
