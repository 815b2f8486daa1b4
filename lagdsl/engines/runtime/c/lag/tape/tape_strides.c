/* Instructions over strides, for one state: parts alike in the lanes of vectors. */
#ifndef LAG_ALIKE
#define LAG_ALIKE /* a tape gives the same bits on every processor, whether it has fused sums or not */
#endif

#include <math.h>

#include "lag/tape/tape_code.h"

static const double signs[4][2] = {{1.0, 1.0}, {1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}};

/* Behind operation, number and place, and the signs of sums. */
enum { FIRST = 3, FIRST_OF_SUM = 4 };

static double at(const double *row, const uint32_t *operand, size_t i)
{
    return row[operand[0] + i * operand[1]];
}

#if defined(__GNUC__)

#pragma GCC diagnostic ignored "-Wpsabi" /* everything that takes or gives vectors is inlined */

#define INLINED static inline __attribute__((always_inline))
enum { AT_ONCE = 8 };
typedef double block __attribute__((vector_size(8 * AT_ONCE)));
typedef double block_memory __attribute__((vector_size(8 * AT_ONCE), aligned(8), may_alias));

INLINED block blocks_at(const double *row, const uint32_t *operand, size_t i)
{
    const size_t stride = operand[1];
    const double *x = row + operand[0] + i * stride;
    if (stride == 1) {
        return *(const block_memory *)x;
    }
    return (block){x[0], x[stride], x[2 * stride], x[3 * stride], x[4 * stride], x[5 * stride], x[6 * stride], x[7 * stride]};
}

INLINED block root_of(block x)
{
    block root = x;
    for (size_t lane = 0; lane < AT_ONCE; ++lane) {
        root[lane] = sqrt(x[lane]);
    }
    return root;
}

/* The last block may hold values of the one before it again: operands stand where no value goes. */
#define EACH(expression_of_blocks, expression)                                            \
    for (size_t i = 0; i < count && count >= AT_ONCE; i += AT_ONCE) {                     \
        i = i + AT_ONCE > count ? count - AT_ONCE : i;                                    \
        *(block_memory *)(to + i) = expression_of_blocks;                                 \
    }                                                                                     \
    for (size_t i = 0; i < count && count < AT_ONCE; ++i) {                               \
        to[i] = expression;                                                               \
    }
#define B(k) blocks_at(row, first + 2 * (k), i)
#else
#define INLINED static
#define EACH(expression_of_blocks, expression)                                            \
    for (size_t i = 0; i < count; ++i) {                                                  \
        to[i] = expression;                                                               \
    }
#endif
#define A(k) at(row, first + 2 * (k), i)

INLINED const uint32_t *run(const uint32_t *word, double *row)
{
    const size_t count = word[1];
    double *to = row + word[2];
    const uint32_t *first = word + FIRST;
    const double *sign;
    switch (*word) {
    case LAG_TAPE_STRIDED_TWO_PRODUCTS:
        first = word + FIRST_OF_SUM;
        sign = signs[word[FIRST]];
        EACH(B(0) * B(1) + sign[1] * (B(2) * B(3)), A(0) * A(1) + sign[1] * (A(2) * A(3)))
        return first + 2 * 4;
    case LAG_TAPE_STRIDED_THREE_PRODUCTS:
        first = word + FIRST_OF_SUM;
        sign = signs[word[FIRST]];
        EACH(B(0) * B(1) + sign[0] * (B(2) * B(3)) + sign[1] * (B(4) * B(5)),
            A(0) * A(1) + sign[0] * (A(2) * A(3)) + sign[1] * (A(4) * A(5)))
        return first + 2 * 6;
    case LAG_TAPE_STRIDED_SQRT:
        EACH(root_of(B(0)), sqrt(A(0)))
        return first + 2;
    case LAG_TAPE_STRIDED_MULTIPLY:
        EACH(B(0) * B(1), A(0) * A(1))
        return first + 2 * 2;
    default:
        EACH(B(0) / B(1), A(0) / A(1))
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
