/* The interpreter of tapes, for one state. Instructions have been checked (tape_check.c): nothing is looked at here. */
#include <string.h>

#include "lag/tape_code.h"
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

static void scatter(const uint32_t *word, const double *row, double *result)
{
    const uint32_t count = word[3];
    memset(result, 0, word[2] * sizeof(double));
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

/* From label to label where the compiler knows addresses of labels: every instruction has its own jump, which processors foresee. */
#if defined(__GNUC__) && !defined(__wasm__)
#pragma GCC diagnostic ignored "-Wpedantic"
#define BEGIN NEXT;
#define CASE(name) at_##name
#define NEXT goto *labels[*word]
#define TWO_LABELS(name, count, expression) &&at_##name, &&at_##name##_ON,
#define ONE_LABEL(name, function) &&at_##name,
#define LABELS                                                                                                    \
    static const void *const labels[] = {&&at_END, &&at_CONSTANTS, &&at_LOAD, &&at_STORE, &&at_SCATTER, &&at_SINCOS, \
        LAG_TAPE_ARITHMETIC(TWO_LABELS) LAG_TAPE_UNARY(ONE_LABEL) LAG_TAPE_BINARY(ONE_LABEL) &&at_SELECT};
#define FINISH
#else
#define BEGIN for (;;) { switch (*word) {
#define CASE(name) case LAG_TAPE_##name
#define NEXT continue
#define LABELS
#define FINISH }}
#endif

void lag_tape_run(const lag_tape_code *code, const lag_arguments *at, double *row, double *const *results)
{
    LABELS
    const uint32_t *word = code->words;
    double v = 0.0;
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
        scatter(word, row, results[word[1]]);
        word += 4 + 2 * word[3];
        NEXT;
    CASE(SINCOS):
        sincos_of(word, row);
        word += 2 + 3 * word[1];
        NEXT;
#define r(i) row[operand[i]]
#define TWO_CASES(name, count, expression)       \
    CASE(name): {                                \
        const uint32_t *const operand = word + 2; \
        (void)operand;                           \
        v = expression;                          \
        row[word[1]] = v;                        \
        word += 2 + count;                       \
        NEXT;                                    \
    }                                            \
    CASE(name##_ON): {                           \
        const uint32_t *const operand = word + 1; \
        (void)operand;                           \
        v = expression;                          \
        word += 1 + count;                       \
        NEXT;                                    \
    }
    LAG_TAPE_ARITHMETIC(TWO_CASES)
#define UNARY_CASE(name, function)               \
    CASE(name):                                  \
        v = function(row[word[2]]);              \
        row[word[1]] = v;                        \
        word += 3;                               \
        NEXT;
    LAG_TAPE_UNARY(UNARY_CASE)
#define BINARY_CASE(name, function)              \
    CASE(name):                                  \
        v = function(row[word[2]], row[word[3]]); \
        row[word[1]] = v;                        \
        word += 4;                               \
        NEXT;
    LAG_TAPE_BINARY(BINARY_CASE)
    CASE(SELECT):
        v = lag_select(row[word[2]], row[word[3]], row[word[4]]);
        row[word[1]] = v;
        word += 5;
        NEXT;
    FINISH
}
