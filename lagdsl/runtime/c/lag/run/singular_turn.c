/* Turn of J: U' J V / values, in the singular vectors of J as it was before. */
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/eigenvalues.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"

/* Rows and columns of a part, and where its vectors stand. */
typedef struct place {
    size_t rows, columns, values, left, right;
} place;

static place first_place(const lag_singular *s)
{
    size_t first = 0;
    return (place){lag_parts_rows(&s->parts, 0, &first), lag_parts_columns(&s->parts, 0, &first), 0, 0, 0};
}

/* That of the next part. */
static place next_place(const lag_singular *s, size_t which, place at)
{
    size_t first = 0;
    place next = at;
    next.values += at.rows;
    next.left += at.rows * at.rows;
    next.right += at.columns * at.columns;
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
            (void)lag_parts_block(&s->parts, which, n, s->before, s->block);
            const lag_svd svd = lag_svd_of(at.rows, at.columns, s->block, s->memory);
            while (kept < svd.k && (double)kept < s->counts[which] && svd.value[kept] > LAG_LOST) {
                ++kept;
            }
            memcpy(s->values + at.values, svd.value, kept * sizeof(double));
            memcpy(s->left_vectors + at.left, svd.u, kept * at.rows * sizeof(double));
            memcpy(s->right_vectors + at.right, svd.v, kept * at.columns * sizeof(double));
        }
        s->kept[which] = (double)kept;
    }
    s->seen = 1;
}

/* The part's J, in `other`, in the vectors of before. */
static void turn(lag_singular *s, size_t kept, place at)
{
    const double *left = s->left_vectors + at.left;
    const double *right = s->right_vectors + at.right;
    for (size_t a = 0; a < kept; ++a) {
        double *line = s->block; /* row a of U' J */
        lag_fill(at.columns, 0.0, line);
        for (size_t i = 0; i < at.rows; ++i) {
            for (size_t j = 0; j < at.columns; ++j) {
                line[j] += left[a * at.rows + i] * s->other[i * at.columns + j];
            }
        }
        for (size_t b = 0; b < kept; ++b) {
            s->turned[a * kept + b] = lag_dot(at.columns, line, right + b * at.columns) / s->values[at.values + a];
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
