/*
 * Turn of J: the least real part among the eigenvalues of L^-1 J Q, with J = L Q' as it was before. They are those of J times the
 * pseudoinverse of J before.
 */
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/eigenvalues.h"
#include "lag/linalg/linalg.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"

/* Rows and columns of a part, and where its rows and its factors stand. */
typedef struct place {
    size_t rows, columns, row, factor;
} place;

static place first_place(const lag_singular *s)
{
    size_t first = 0;
    return (place){lag_parts_rows(&s->parts, 0, &first), lag_parts_columns(&s->parts, 0, &first), 0, 0};
}

/* That of the next part. */
static place next_place(const lag_singular *s, size_t which, place at)
{
    size_t first = 0;
    place next = at;
    next.row += at.rows;
    next.factor += at.rows * at.columns;
    if (which + 1 < s->parts.count) {
        next.rows = lag_parts_rows(&s->parts, which + 1, &first);
        next.columns = lag_parts_columns(&s->parts, which + 1, &first);
    }
    return next;
}

static void see(lag_singular *s)
{
    const size_t n = s->run->motion.model->nq;
    place at = first_place(s);
    for (size_t which = 0; which < s->parts.count; at = next_place(s, which, at), ++which) {
        size_t kept = 0;
        if (at.rows > 0 && at.columns > 0) {
            double *factors = s->factors + at.factor;
            const double *diagonal = s->diagonal + at.row;
            (void)lag_parts_block(&s->parts, which, n, s->before, factors);
            const size_t rank = lag_qr(at.rows, at.columns, factors, s->tau + at.row, s->diagonal + at.row, s->pivot + at.row,
                (size_t)s->counts[which], 0.0);
            while (kept < rank && fabs(diagonal[kept]) > LAG_LOST) {
                ++kept;
            }
        }
        s->kept[which] = (double)kept;
    }
    s->seen = 1;
}

/* L^-1 J Q of the rows that are kept, with the part's J in `other`, into `turned`. */
static void turn(lag_singular *s, size_t kept, place at)
{
    const double *factors = s->factors + at.factor;
    for (size_t a = 0; a < kept; ++a) {
        double *row = s->other + (size_t)s->pivot[at.row + a] * at.columns;
        double *line = s->turned + a * kept;
        lag_qr_apply_transposed(kept, at.columns, factors, s->tau + at.row, row, 1);
        memcpy(line, row, kept * sizeof(double));
        for (size_t b = 0; b < a; ++b) {
            lag_axpy(kept, -factors[a * at.columns + b], s->turned + b * kept, line);
        }
        for (size_t b = 0; b < kept; ++b) {
            line[b] /= s->diagonal[at.row + a];
        }
    }
}

double lag_singular_turn(lag_singular *s, const double *jacobian)
{
    double least = (double)INFINITY;
    if (!s->seen) {
        see(s);
    }
    place at = first_place(s);
    for (size_t which = 0; which < s->parts.count; at = next_place(s, which, at), ++which) {
        if (at.rows > 0 && at.columns > 0) {
            const size_t kept = (size_t)s->kept[which];
            (void)lag_parts_block(&s->parts, which, s->run->motion.model->nq, jacobian, s->other);
            turn(s, kept, at);
            const double part = lag_least_real_part(kept, s->turned, s->memory);
            if (!(part >= least)) {
                least = part < least ? part : -(double)INFINITY;
            }
        }
    }
    return least;
}
