#include "lag/linalg/pivoted_cholesky.h"

#include <math.h>

#include "lag/linalg/arena.h"

size_t lag_pivoted_cholesky_memory(size_t n)
{
    return 2 * n * n + 9 * n;
}

void lag_pivoted_cholesky_place(lag_pivoted_cholesky *c, size_t n, double *memory)
{
    c->n = n;
    c->alone = 0;
    c->left = lag_take(&memory, n);
    c->weight = lag_take(&memory, n);
    c->count = lag_take(&memory, n);
    c->chosen = lag_take(&memory, n);
    c->place = lag_take(&memory, n);
    c->size = lag_take(&memory, n);
    c->heap = lag_take(&memory, n);
    c->at = lag_take(&memory, n);
    c->mark = lag_take(&memory, n);
    c->factor = lag_take(&memory, n * n);
    c->beside = lag_take(&memory, n * n);
    lag_fill(n, 0.0, c->count);
    lag_fill(n, 0.0, c->mark);
    lag_fill(n, (double)n, c->place);
}

void lag_pivoted_cholesky_join(lag_pivoted_cholesky *c, size_t i, size_t k, double entry)
{
    *lag_pivoted_cholesky_entry(c, i, k) = entry;
    c->beside[i * c->n + (size_t)c->count[i]++] = (double)k;
    c->beside[k * c->n + (size_t)c->count[k]++] = (double)i;
}

/* ---- rows by their rests: a heap, the longest first ---- */

/* 1: of rows with equal rests the first comes first. */
static int is_before(const lag_pivoted_cholesky *c, size_t one, size_t other)
{
    return c->size[one] > c->size[other] || (c->size[one] == c->size[other] && one < other);
}

static void put(lag_pivoted_cholesky *c, size_t at, size_t row)
{
    c->heap[at] = (double)row;
    c->at[row] = (double)at;
}

/* The row at a position of the heap of so many, whose rest became shorter, goes down to its place. */
static void sink(lag_pivoted_cholesky *c, size_t count, size_t at)
{
    const size_t row = (size_t)c->heap[at];
    for (size_t child = 2 * at + 1; child < count; child = 2 * at + 1) {
        if (child + 1 < count && is_before(c, (size_t)c->heap[child + 1], (size_t)c->heap[child])) {
            ++child;
        }
        if (!is_before(c, (size_t)c->heap[child], row)) {
            break;
        }
        put(c, at, (size_t)c->heap[child]);
        at = child;
    }
    put(c, at, row);
}

/* Rows that stand beside others are in the heap, `count` of them. The largest rest of all. */
static double fill_heap(lag_pivoted_cholesky *c, size_t *count)
{
    double first = 0.0;
    for (size_t i = 0; i < c->n; ++i) {
        c->size[i] = c->left[i] * c->weight[i];
        first = c->size[i] > first ? c->size[i] : first;
        if (c->count[i] > 0.0) {
            put(c, (*count)++, i);
        }
    }
    for (size_t i = *count / 2; i-- > 0;) {
        sink(c, *count, i);
    }
    return first;
}

/* ---- elimination ---- */

/* Of the rows beside row i those that are not chosen are left in its list. */
static void forget_chosen(lag_pivoted_cholesky *c, size_t i)
{
    size_t left = 0;
    for (size_t k = 0; k < (size_t)c->count[i]; ++k) {
        const size_t other = lag_pivoted_cholesky_beside(c, i, k);
        c->beside[i * c->n + left] = (double)other;
        left += !lag_pivoted_cholesky_has(c, other);
    }
    c->count[i] = (double)left;
}

/* Takes from the entries of row `number` of the list of a pivot with the later ones there what these have through it. */
static void update(lag_pivoted_cholesky *c, size_t pivot, size_t number)
{
    const size_t i = lag_pivoted_cholesky_beside(c, pivot, number);
    const size_t end = (size_t)c->count[pivot];
    const double own = *lag_pivoted_cholesky_entry(c, pivot, i);
    const double mark = c->place[pivot] * (double)c->n + (double)number + 1.0; /* of no other row before */
    const int some_lack = number + 1 < end && c->count[i] < (double)(c->n - 1);
    for (size_t k = 0; k < (size_t)c->count[i] && some_lack; ++k) {
        c->mark[lag_pivoted_cholesky_beside(c, i, k)] = mark;
    }
    for (size_t k = number + 1; k < end; ++k) {
        const size_t other = lag_pivoted_cholesky_beside(c, pivot, k);
        const double part = own * *lag_pivoted_cholesky_entry(c, pivot, other);
        if (some_lack && c->mark[other] != mark) {
            lag_pivoted_cholesky_join(c, i, other, -part);
        } else {
            *lag_pivoted_cholesky_entry(c, i, other) -= part;
        }
    }
}

static void eliminate(lag_pivoted_cholesky *c, size_t in_heap, size_t pivot)
{
    forget_chosen(c, pivot);
    for (size_t k = 0; k < (size_t)c->count[pivot]; ++k) {
        const size_t i = lag_pivoted_cholesky_beside(c, pivot, k);
        double *entry = lag_pivoted_cholesky_entry(c, pivot, i);
        *entry /= c->left[pivot];
        c->left[i] -= *entry * *entry;
        c->size[i] = c->left[i] * c->weight[i];
        sink(c, in_heap, (size_t)c->at[i]);
    }
    for (size_t k = 0; k < (size_t)c->count[pivot]; ++k) {
        update(c, pivot, k);
    }
}

static void choose(lag_pivoted_cholesky *c, size_t row, size_t *rank)
{
    c->chosen[*rank] = (double)row;
    c->place[row] = (double)(*rank)++;
    c->left[row] = sqrt(c->left[row]);
}

/* 1: a row is chosen; 0: its rest is round-off; -1: neither. */
static int judge(lag_pivoted_cholesky *c, size_t row, double least, double excess, size_t *rank)
{
    if (c->size[row] <= excess) {
        return 0;
    }
    if (!(c->size[row] > least) || !isfinite(c->left[row])) {
        return -1;
    }
    choose(c, row, rank);
    return 1;
}

size_t lag_pivoted_cholesky_factor(lag_pivoted_cholesky *c, double least, double excess)
{
    size_t in_heap = 0;
    size_t rank = 0;
    int judged = 1;
    const double first = fill_heap(c, &in_heap);
    for (size_t i = 0; i < c->n && judged >= 0; ++i) { /* those beside no others */
        judged = c->count[i] > 0.0 ? judged : judge(c, i, least * first, excess * first, &rank);
    }
    c->alone = rank;
    judged = judged >= 0;
    while (in_heap > 0 && judged > 0) {
        const size_t pivot = (size_t)c->heap[0];
        judged = judge(c, pivot, least * first, excess * first, &rank);
        if (judged > 0) {
            put(c, 0, (size_t)c->heap[--in_heap]);
            sink(c, in_heap, 0);
            eliminate(c, in_heap, pivot);
        }
    }
    for (size_t i = 0, k = rank; i < c->n; ++i) {
        if (!lag_pivoted_cholesky_has(c, i)) {
            c->chosen[k++] = (double)i;
        }
    }
    return judged < 0 ? c->n + 1 : rank;
}

/* ---- solution ---- */

void lag_pivoted_cholesky_solve_lower(const lag_pivoted_cholesky *c, size_t rank, double *x)
{
    for (size_t k = c->alone; k < rank; ++k) {
        const size_t pivot = (size_t)c->chosen[k];
        x[pivot] /= c->left[pivot];
        for (size_t e = 0; e < (size_t)c->count[pivot]; ++e) {
            const size_t i = lag_pivoted_cholesky_beside(c, pivot, e);
            x[i] -= *lag_pivoted_cholesky_entry(c, pivot, i) * x[pivot];
        }
    }
}

void lag_pivoted_cholesky_solve_upper(const lag_pivoted_cholesky *c, size_t rank, double *x)
{
    for (size_t k = rank; k-- > c->alone;) {
        const size_t pivot = (size_t)c->chosen[k];
        for (size_t e = 0; e < (size_t)c->count[pivot]; ++e) {
            const size_t i = lag_pivoted_cholesky_beside(c, pivot, e);
            x[pivot] -= lag_pivoted_cholesky_has(c, i) ? *lag_pivoted_cholesky_entry(c, pivot, i) * x[i] : 0.0;
        }
        x[pivot] /= c->left[pivot];
    }
}
