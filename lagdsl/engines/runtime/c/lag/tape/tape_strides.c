/* Instructions over strides, for one state: parts alike in the lanes of vectors. */
#ifndef LAG_ALIKE
#define LAG_ALIKE /* a tape gives the same bits on every processor, whether it has fused sums or not */
#endif

#include "lag/tape/tape_code.h"

#if defined(__GNUC__) && !defined(__wasm__)

static const double signs[4][2] = {{1.0, 1.0}, {1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}};

/* Behind operation, number and place, and the signs of sums. */
enum { FIRST = 3, FIRST_OF_SUM = 4 };

static double at(const double *row, const uint32_t *operand, size_t i)
{
    return row[operand[0] + i * operand[1]];
}

#pragma GCC diagnostic ignored "-Wpsabi" /* everything that takes or gives vectors is inlined */

#define INLINED static inline __attribute__((always_inline))
enum { AT_ONCE = 8, MOST_OPERANDS = 6 };
typedef double block __attribute__((vector_size(8 * AT_ONCE)));
typedef double block_memory __attribute__((vector_size(8 * AT_ONCE), aligned(8), may_alias));

/* Values of an operand: those that follow on each other at `from`, or one value, as often as a block holds it. */
typedef struct stream {
    const double *from;
    size_t mask; /* of how far a block is */
    double value[AT_ONCE];
} stream;

/* True if the operands are streams: no stride is longer than 1. */
INLINED int find_streams(const double *row, const uint32_t *operand, size_t count, stream *found)
{
    int all = 1;
    for (size_t k = 0; k < count; ++k, operand += 2) {
        found[k].from = row + operand[0];
        found[k].mask = (size_t)-1;
        all = all && operand[1] <= 1;
        if (operand[1] == 0) {
            for (size_t lane = 0; lane < AT_ONCE; ++lane) {
                found[k].value[lane] = row[operand[0]];
            }
            found[k].from = found[k].value;
            found[k].mask = 0;
        }
    }
    return all;
}

INLINED block block_of(const stream *operand, size_t i)
{
    return *(const block_memory *)(operand->from + (i & operand->mask));
}

INLINED block strided_block(const double *row, const uint32_t *operand, size_t i)
{
    const size_t stride = operand[1];
    const double *x = row + operand[0] + i * stride;
    return (block){x[0], x[stride], x[2 * stride], x[3 * stride], x[4 * stride], x[5 * stride], x[6 * stride], x[7 * stride]};
}

/* The last block may hold values of the one before it again: operands stand where no value goes. */
#define BLOCKS(operands)                                              \
    for (size_t i = 0; i < count; i += AT_ONCE) {                     \
        i = i + AT_ONCE > count ? count - AT_ONCE : i;                \
        *(block_memory *)(to + i) = operands;                         \
    }
#define S(k) block_of(streams + (k), i)
#define B(k) strided_block(row, first + 2 * (k), i)
#define EACH(number, formula)                                         \
    if (count < AT_ONCE) {                                            \
        ONE_BY_ONE(formula)                                           \
    } else if (find_streams(row, first, number, streams)) {           \
        BLOCKS(formula(S))                                            \
    } else {                                                          \
        BLOCKS(formula(B))                                            \
    }
#define A(k) at(row, first + 2 * (k), i)
#define ONE_BY_ONE(formula)                                           \
    for (size_t i = 0; i < count; ++i) {                              \
        to[i] = formula(A);                                           \
    }

#define SUM_OF_TWO(x) x(0) * x(1) + sign[1] * (x(2) * x(3))
#define SUM_OF_THREE(x) x(0) * x(1) + sign[0] * (x(2) * x(3)) + sign[1] * (x(4) * x(5))
#define PRODUCT(x) x(0) * x(1)
#define QUOTIENT(x) x(0) / x(1)

INLINED const uint32_t *run(const uint32_t *word, double *row)
{
    const size_t count = word[1];
    double *to = row + word[2];
    const uint32_t *first = word + FIRST;
    const double *sign;
    stream streams[MOST_OPERANDS];
    switch (*word) {
    case LAG_TAPE_STRIDED_TWO_PRODUCTS:
        first = word + FIRST_OF_SUM;
        sign = signs[word[FIRST]];
        EACH(4, SUM_OF_TWO)
        return first + 2 * 4;
    case LAG_TAPE_STRIDED_THREE_PRODUCTS:
        first = word + FIRST_OF_SUM;
        sign = signs[word[FIRST]];
        EACH(6, SUM_OF_THREE)
        return first + 2 * 6;
    case LAG_TAPE_STRIDED_MULTIPLY:
        EACH(2, PRODUCT)
        return first + 2 * 2;
    default:
        EACH(2, QUOTIENT)
        return first + 2 * 2;
    }
}

/* Wider registers where the processor has them, as in tape_lanes.c. */
#if defined(__x86_64__) && defined(__STDC_HOSTED__) && __STDC_HOSTED__ && !defined(__AVX2__)
#define RUN_IN(name, registers)                                                                       \
    __attribute__((target(registers))) static const uint32_t *name(const uint32_t *word, double *row) \
    {                                                                                                 \
        return run(word, row);                                                                        \
    }
RUN_IN(run_wide, "avx2")
RUN_IN(run_widest, "avx512f,avx512dq")
const uint32_t *lag_tape_run_strided(const uint32_t *word, double *row)
{
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) {
        return run_widest(word, row);
    }
    return __builtin_cpu_supports("avx2") ? run_wide(word, row) : run(word, row);
}
#else
const uint32_t *lag_tape_run_strided(const uint32_t *word, double *row)
{
    return run(word, row);
}
#endif

#else

/* One loop for all: the smallest code that stays fast. */
const uint32_t *lag_tape_run_strided(const uint32_t *word, double *row)
{
    const int sums = *word <= LAG_TAPE_STRIDED_THREE_PRODUCTS;
    const int three = *word == LAG_TAPE_STRIDED_THREE_PRODUCTS;
    const double second = sums && word[3] & (three ? 2u : 1u) ? -1.0 : 1.0;
    const double third = sums && word[3] & 1u ? -1.0 : 1.0;
    const uint32_t *x = word + (sums ? 4 : 3);
    for (uint32_t i = 0; i < word[1]; ++i) {
        const double a = row[x[0] + i * x[1]];
        const double b = row[x[2] + i * x[3]];
        double value = *word == LAG_TAPE_STRIDED_DIVIDE ? a / b : a * b;
        if (sums) {
            value += second * (row[x[4] + i * x[5]] * row[x[6] + i * x[7]]);
        }
        if (three) {
            value += third * (row[x[8] + i * x[9]] * row[x[10] + i * x[11]]);
        }
        row[word[2] + i] = value;
    }
    return x + (three ? 12 : sums ? 8 : 4);
}

#endif
