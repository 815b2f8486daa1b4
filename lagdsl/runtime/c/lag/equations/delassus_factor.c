#include "lag/equations/delassus_factor.h"

#include <math.h>

#include "lag/linalg/arena.h"

/* The same figures as in the NumPy modules: see their file `delassus` for what they mean. */
static const double LEAST_PIVOT = 1e-6;
static const double LARGEST_EXCESS = 1e-10;
static const double SHORT_RESPONSE = 1e-3;

/* ---- S ---- */

/* Diagonal of S, and the squares of the factors that make it comparable: one, but for rows that are short. */
static void weigh(lag_delassus *s)
{
    double longest = 0.0;
    for (size_t i = 0; i < s->kept; ++i) {
        s->left[i] = lag_delassus_along(s, i, s->response + i * s->n);
        longest = fmax(longest, s->left[i]);
    }
    for (size_t i = 0; i < s->kept; ++i) {
        const double part = fmin(1.0, s->left[i] / (SHORT_RESPONSE * SHORT_RESPONSE * longest));
        s->weight[i] = s->left[i] > 0.0 ? part / s->left[i] : 0.0;
    }
}

/* Rows i and k stand beside each other, with this entry of S. */
static void join(lag_delassus *s, size_t i, size_t k, double entry)
{
    *lag_delassus_entry(s, i, k) = entry;
    s->beside[i * s->kept + (size_t)s->count[i]++] = (double)k;
    s->beside[k * s->kept + (size_t)s->count[k]++] = (double)i;
}

/* Entries of S beside the diagonal that are not zero. */
static void form(lag_delassus *s)
{
    const lag_pattern *couplings = s->patterns.couplings;
    lag_fill(s->kept, 0.0, s->count);
    for (size_t i = 0; i < s->kept; ++i) {
        const size_t first = couplings != NULL ? couplings->first[i] : 0;
        const size_t end = couplings != NULL ? couplings->first[i + 1] : i;
        for (size_t e = first; e < end; ++e) {
            const size_t k = couplings != NULL ? couplings->column[e] : e;
            const double entry = k < i ? lag_delassus_along(s, i, s->response + k * s->n) : 0.0;
            if (entry != 0.0) {
                join(s, i, k, entry);
            }
        }
    }
}

/* ---- rows by their rests: a heap, the longest first ---- */

typedef struct heap {
    double *rows, *at; /* (kept) (kept) the rows in it; where each is */
    double *size;      /* (kept) of what is left of each row */
    size_t count;
} heap;

/* 1: of rows with equal rests the first comes first. */
static int is_before(const heap *h, size_t one, size_t other)
{
    return h->size[one] > h->size[other] || (h->size[one] == h->size[other] && one < other);
}

static void put(heap *h, size_t at, size_t row)
{
    h->rows[at] = (double)row;
    h->at[row] = (double)at;
}

/* The row at a position, whose rest became shorter, goes down to its place. */
static void sink(heap *h, size_t at)
{
    const size_t row = (size_t)h->rows[at];
    for (size_t child = 2 * at + 1; child < h->count; child = 2 * at + 1) {
        if (child + 1 < h->count && is_before(h, (size_t)h->rows[child + 1], (size_t)h->rows[child])) {
            ++child;
        }
        if (!is_before(h, (size_t)h->rows[child], row)) {
            break;
        }
        put(h, at, (size_t)h->rows[child]);
        at = child;
    }
    put(h, at, row);
}

static void take_first(heap *h)
{
    put(h, 0, (size_t)h->rows[--h->count]);
    sink(h, 0);
}

/* Those that stand beside others; the largest of all. */
static double fill_heap(const lag_delassus *s, heap *h)
{
    double first = 0.0;
    *h = (heap){.rows = s->work.rest, .at = s->work.part, .size = s->work.x};
    for (size_t i = 0; i < s->kept; ++i) {
        h->size[i] = s->left[i] * s->weight[i];
        first = h->size[i] > first ? h->size[i] : first;
        if (s->count[i] > 0.0) {
            put(h, h->count++, i);
        }
    }
    for (size_t i = h->count / 2; i-- > 0;) {
        sink(h, i);
    }
    return first;
}

/* ---- elimination ---- */

/* Of the rows beside row i those that are not chosen are left in its list. */
static void forget_chosen(lag_delassus *s, size_t i)
{
    size_t left = 0;
    for (size_t k = 0; k < (size_t)s->count[i]; ++k) {
        const size_t other = lag_delassus_beside(s, i, k);
        s->beside[i * s->kept + left] = (double)other;
        left += s->place[other] == (double)s->kept;
    }
    s->count[i] = (double)left;
}

/* Takes from the entries of row i with the later ones of the list of a pivot what these have through it. */
static void update(lag_delassus *s, size_t pivot, size_t number)
{
    const size_t i = lag_delassus_beside(s, pivot, number);
    const double own = *lag_delassus_entry(s, pivot, i);
    double *mark = s->work.mark;
    const int some_lack = s->count[i] < (double)(s->kept - 1);
    for (size_t k = 0; some_lack && k < (size_t)s->count[i]; ++k) {
        mark[lag_delassus_beside(s, i, k)] = 1.0;
    }
    for (size_t k = number + 1; k < (size_t)s->count[pivot]; ++k) {
        const size_t other = lag_delassus_beside(s, pivot, k);
        const double part = own * *lag_delassus_entry(s, pivot, other);
        if (some_lack && mark[other] == 0.0) {
            join(s, i, other, -part);
            mark[other] = 1.0;
        } else {
            *lag_delassus_entry(s, i, other) -= part;
        }
    }
    for (size_t k = 0; some_lack && k < (size_t)s->count[i]; ++k) {
        mark[lag_delassus_beside(s, i, k)] = 0.0;
    }
}

/* 1: a rest is long enough to be chosen; 0: it is round-off; -1: neither. */
static int judge(double size, double left, double first)
{
    if (size <= LARGEST_EXCESS * first) {
        return 0;
    }
    return size > LEAST_PIVOT * first && isfinite(left) ? 1 : -1;
}

static void choose(lag_delassus *s, size_t row, size_t *rank)
{
    s->chosen[*rank] = (double)row;
    s->place[row] = (double)(*rank)++;
    s->left[row] = sqrt(s->left[row]);
}

static void eliminate(lag_delassus *s, heap *h, size_t pivot)
{
    forget_chosen(s, pivot);
    for (size_t k = 0; k < (size_t)s->count[pivot]; ++k) {
        const size_t i = lag_delassus_beside(s, pivot, k);
        double *entry = lag_delassus_entry(s, pivot, i);
        *entry /= s->left[pivot];
        s->left[i] -= *entry * *entry;
        h->size[i] = s->left[i] * s->weight[i];
        sink(h, (size_t)h->at[i]);
    }
    for (size_t k = 0; k < (size_t)s->count[pivot]; ++k) {
        update(s, pivot, k);
    }
}

/* Rows that stand beside no others; 0: one of them is neither long enough nor round-off. */
static int choose_lone(lag_delassus *s, const heap *h, double first, size_t *rank)
{
    int sound = 1;
    for (size_t i = 0; i < s->kept && sound; ++i) {
        const int judged = s->count[i] > 0.0 ? 0 : judge(h->size[i], s->left[i], first);
        sound = judged >= 0;
        if (judged > 0) {
            choose(s, i, rank);
        }
    }
    return sound;
}

size_t lag_delassus_eliminate(lag_delassus *s)
{
    heap h;
    size_t rank = 0;
    int judged = 1;
    weigh(s);
    form(s);
    lag_fill(s->kept, 0.0, s->work.mark);
    lag_fill(s->kept, (double)s->kept, s->place);
    const double first = fill_heap(s, &h);
    if (!choose_lone(s, &h, first, &rank)) {
        return s->kept + 1;
    }
    while (h.count > 0 && judged > 0) {
        const size_t pivot = (size_t)h.rows[0];
        judged = judge(h.size[pivot], s->left[pivot], first);
        if (judged > 0) {
            take_first(&h);
            choose(s, pivot, &rank);
            eliminate(s, &h, pivot);
        }
    }
    for (size_t i = 0, k = rank; i < s->kept; ++i) {
        if (s->place[i] == (double)s->kept) {
            s->chosen[k++] = (double)i;
        }
    }
    return judged < 0 ? s->kept + 1 : rank;
}

/* ---- solution ---- */

void lag_delassus_solve_lower(const lag_delassus *s, double *x)
{
    for (size_t k = 0; k < s->rank; ++k) {
        const size_t pivot = (size_t)s->chosen[k];
        x[pivot] /= s->left[pivot];
        for (size_t e = 0; e < (size_t)s->count[pivot]; ++e) {
            const size_t i = lag_delassus_beside(s, pivot, e);
            x[i] -= *lag_delassus_entry(s, pivot, i) * x[pivot];
        }
    }
}

void lag_delassus_solve_upper(const lag_delassus *s, double *x)
{
    for (size_t k = s->rank; k-- > 0;) {
        const size_t pivot = (size_t)s->chosen[k];
        for (size_t e = 0; e < (size_t)s->count[pivot]; ++e) {
            const size_t i = lag_delassus_beside(s, pivot, e);
            x[pivot] -= s->place[i] < (double)s->kept ? *lag_delassus_entry(s, pivot, i) * x[i] : 0.0;
        }
        x[pivot] /= s->left[pivot];
    }
}
