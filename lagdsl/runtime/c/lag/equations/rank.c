#include "lag/equations/rank.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/linalg.h"

/* Pivots of J, rows of size one: below this rank is nearly lost. */
static const double NEAR = 0.1;
/* With J' = J (1 + E) on the independent rows, no direction turns around while the norm of E is below one. */
static const double TURNED = 0.75;
static const double ZERO = 1e-12;

size_t lag_look_memory(size_t m, size_t n)
{
    return 3 * m * n + 3 * m + n;
}

void lag_look_place(lag_look *look, const lag_model *model, const double *sizes, const double *row_sizes, double *arena)
{
    const size_t m = model->nc;
    const size_t n = model->nq;
    memset(look, 0, sizeof *look);
    look->m = m;
    look->n = n;
    look->most = model->rank;
    look->sizes = sizes;
    look->row_sizes = row_sizes;
    look->rows = arena;
    look->now = look->rows + m * n;
    look->factors = look->now + m * n;
    look->tau = look->factors + m * n;
    look->diagonal = look->tau + m;
    look->pivot = look->diagonal + m;
    look->part = look->pivot + m;
}

/* Square of the length of row `which` of E: what the change of a row is in terms of the rows before. */
static double change_of(const lag_look *look, size_t which)
{
    const size_t n = look->n;
    const size_t r = look->rank;
    double sum = 0.0;
    for (size_t i = 0; i < n; ++i) {
        look->part[i] = look->now[which * n + i] - look->rows[which * n + i];
    }
    lag_qr_apply_transposed(r, n, look->factors, look->tau, look->part, 1);
    for (size_t i = r; i-- > 0;) {
        double value = look->part[i];
        for (size_t j = i + 1; j < r; ++j) {
            value -= look->factors[j * n + i] * look->part[j];
        }
        look->part[i] = value / look->diagonal[i];
        sum += look->part[i] * look->part[i];
    }
    return sum;
}

lag_status lag_look_at(lag_look *look, const double *jacobian)
{
    const size_t n = look->n;
    double change = 0.0;
    for (size_t i = 0; i < look->m; ++i) {
        const double weight = look->lasting == NULL || look->lasting[i] != 0.0 ? 1.0 / look->row_sizes[i] : 0.0;
        for (size_t j = 0; j < n; ++j) {
            look->now[i * n + j] = jacobian[i * n + j] * look->sizes[j] * weight;
        }
    }
    for (size_t i = 0; i < look->rank; ++i) {
        change += change_of(look, (size_t)look->pivot[i]);
    }
    if (!(change < TURNED * TURNED)) {
        return LAG_ATTENTION;
    }
    memcpy(look->rows, look->now, look->m * n * sizeof(double));
    memcpy(look->factors, look->now, look->m * n * sizeof(double));
    look->rank = lag_qr(look->m, n, look->factors, look->tau, look->diagonal, look->pivot, look->most, ZERO);
    const int full = look->rank == look->most && (look->rank == 0 || fabs(look->diagonal[look->rank - 1]) > NEAR);
    return full ? LAG_OK : LAG_ATTENTION;
}
