/* The interpreter of tapes, for one state. Instructions have been checked (tape_check.c): nothing is checked here. */
#ifndef LAG_ALIKE
#define LAG_ALIKE /* a tape gives the same bits on every processor, whether it has fused sums or not */
#endif

#include <string.h>

#include "lag/tape/tape_code.h"
#include "lag/trigonometry.h"

const double *lag_tape_argument(const lag_arguments *at, uint32_t group)
{
    switch (group) {
    case 0: return &at->t;
    case 1: return at->q;
    case 2: return at->qd;
    case 3: return at->z;
    case 4: return at->u;
    case 5: return at->w;
    case 6: return at->p;
    case 7: return at->qdd;
    case 8: return at->lam;
    case 9: return at->dq;
    case 10: return at->dqd;
    case 11: return at->dz;
    case 12: return at->du;
    case 13: return at->dp;
    case 14: return at->dqdd;
    default: return at->dlam;
    }
}

static void load(const uint32_t *word, const lag_arguments *at, double *row)
{
    memcpy(row + word[4], lag_tape_argument(at, word[1]) + word[2], word[3] * sizeof(double));
}

static void store(const uint32_t *word, const double *row, double *result)
{
    const uint32_t *from = word + 4;
    double *to = result + word[2];
    for (uint32_t i = 0; i < word[3]; ++i) {
        to[i] = row[from[i]];
    }
}

static void scatter(const uint32_t *word, const lag_arguments *at, const double *row, double *result)
{
    const uint32_t count = word[3];
    if (!lag_is_kept(at, result)) {
        memset(result, 0, word[2] * sizeof(double));
    }
    for (uint32_t i = 0; i < count; ++i) {
        result[word[4 + i]] = row[word[4 + count + i]];
    }
}

static void sincos_of(const uint32_t *word, double *row)
{
    const uint32_t count = word[1];
    const uint32_t *from = word + 2;
    double x[LAG_TAPE_ANGLES];
    double s[LAG_TAPE_ANGLES];
    double c[LAG_TAPE_ANGLES];
    for (uint32_t i = 0; i < count; ++i) {
        x[i] = row[from[i]];
    }
    lag_sincos_many(count, x, s, c);
    for (uint32_t i = 0; i < count; ++i) {
        row[from[count + i]] = s[i];
        row[from[2 * count + i]] = c[i];
    }
}

/*
 * From label to label where the compiler knows addresses of labels: every instruction has its own jump, which processors foresee.
 * GCC would make them one again.
 */
#if defined(__GNUC__) && !defined(__wasm__)
#pragma GCC diagnostic ignored "-Wpedantic"
#define NEXT goto *labels[*word]
#define CASE(name) at_##name
#define LABEL(name) &&at_##name,
#define LABEL_OF_FUNCTION(name, function) LABEL(name)
#define LABEL_OF_STRIDED(name, operands) LABEL(STRIDED)
#define LABELS                                                                                       \
    static const void *const labels[] = {                                                            \
        LABEL(END) LABEL(CONSTANTS) LABEL(LOAD) LABEL(STORE) LABEL(SCATTER) LABEL(SINCOS)            \
        LABEL(TWO_PRODUCTS) LABEL(THREE_PRODUCTS) LAG_TAPE_UNARY(LABEL_OF_FUNCTION)                  \
        LAG_TAPE_UNARY_CHOICES(LABEL_OF_FUNCTION) LAG_TAPE_ARITHMETIC(LABEL_OF_FUNCTION)             \
        LAG_TAPE_BINARY(LABEL_OF_FUNCTION) LAG_TAPE_BINARY_CHOICES(LABEL_OF_FUNCTION) LABEL(SELECT)                     \
        LAG_TAPE_STRIDED(LABEL_OF_STRIDED)};
#define STRIDED CASE(STRIDED):
#define BEGIN NEXT;
#define FINISH
#else
#define NEXT continue
#define CASE(name) case LAG_TAPE_##name
#define CASE_OF_STRIDED(name, operands) CASE(STRIDED_##name):
#define STRIDED LAG_TAPE_STRIDED(CASE_OF_STRIDED)
#define LABELS
#define BEGIN for (;;) { switch (*word) {
#define FINISH }}
#endif
#if defined(__GNUC__) && !defined(__clang__)
#define KEPT_APART __attribute__((optimize("no-gcse", "no-crossjumping")))
#else
#define KEPT_APART
#endif

KEPT_APART void lag_tape_run(const lag_tape_code *code, const lag_arguments *at, double *row, double *const *results)
{
    LABELS
    static const double signs[4][2] = {{1.0, 1.0}, {1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}};
    const uint32_t *word = code->words;
    uint32_t times;
    BEGIN
    CASE(END): return;
    CASE(CONSTANTS):
        memcpy(row, code->constants, code->count * sizeof(double));
        ++word;
        NEXT;
    CASE(LOAD):
        load(word, at, row);
        word += 5;
        NEXT;
    CASE(STORE):
        store(word, row, results[word[1]]);
        word += 4 + word[3];
        NEXT;
    CASE(SCATTER):
        scatter(word, at, row, results[word[1]]);
        word += 4 + 2 * word[3];
        NEXT;
    CASE(SINCOS):
        sincos_of(word, row);
        word += 2 + 3 * word[1];
        NEXT;
#define r(i) row[word[i]]
#define OPERATION(name, width, expression)       \
    CASE(name):                                  \
        times = word[1];                         \
        word += 2;                               \
        do {                                     \
            r(0) = expression;                   \
            word += width;                       \
        } while (--times > 0);                   \
        NEXT;
#define OF_ONE(name, function) OPERATION(name, 2, function(r(1)))
#define OF_OPERATOR(name, operator) OPERATION(name, 3, r(1) operator r(2))
#define OF_TWO(name, function) OPERATION(name, 3, function(r(1), r(2)))
    OPERATION(TWO_PRODUCTS, 6, r(2) * r(3) + signs[word[1]][1] * (r(4) * r(5)))
    OPERATION(THREE_PRODUCTS, 8, r(2) * r(3) + signs[word[1]][0] * (r(4) * r(5)) + signs[word[1]][1] * (r(6) * r(7)))
    LAG_TAPE_UNARY(OF_ONE)
    LAG_TAPE_UNARY_CHOICES(OF_ONE)
    LAG_TAPE_ARITHMETIC(OF_OPERATOR)
    LAG_TAPE_BINARY(OF_TWO)
    LAG_TAPE_BINARY_CHOICES(OF_TWO)
    OPERATION(SELECT, 4, lag_select(r(1), r(2), r(3)))
    STRIDED
        word = lag_tape_run_strided(word, row);
        NEXT;
    FINISH
}
