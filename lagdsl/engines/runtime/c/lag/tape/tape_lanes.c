/* The interpreter of tapes, for several states or directions at once. */
#ifndef LAG_ALIKE
#define LAG_ALIKE /* a tape gives the same bits on every processor, whether it has fused sums or not */
#endif

#include <string.h>

#include "lag/tape/tape_code.h"
#include "lag/trigonometry.h"

#if LAG_TAPE_LANES

#pragma GCC diagnostic ignored "-Wpsabi" /* everything that takes or gives vectors is inlined */

typedef double block __attribute__((vector_size(8 * LAG_TAPE_LANES)));
typedef unsigned long long block_bits __attribute__((vector_size(8 * LAG_TAPE_LANES)));
typedef double block_memory __attribute__((vector_size(8 * LAG_TAPE_LANES), aligned(8), may_alias));

/* Choices without jumps, which nobody could foresee for eight states: where a comparison holds, all bits of its lane are set. */
#define CHOSEN(truth, x, y) ((block)(((block_bits)(truth) & (block_bits)(x)) | (~(block_bits)(truth) & (block_bits)(y))))
#define NUMBER(truth) ((block)((block_bits)(truth) & (block_bits)all))
#define ABS_OF_BLOCK(x) ((block)((block_bits)(x) & ~(block_bits)(-none)))
#define SIGN_OF_BLOCK(x) CHOSEN((x) > none, all, CHOSEN((x) < none, -all, (x)))
#define NOT_OF_BLOCK(x) NUMBER((x) == none)
#define MIN_OF_BLOCKS(x, y) CHOSEN((x) <= (y), (x), (y))
#define MAX_OF_BLOCKS(x, y) CHOSEN((x) >= (y), (x), (y))
#define LESS_OF_BLOCKS(x, y) NUMBER((x) < (y))
#define LESS_EQUAL_OF_BLOCKS(x, y) NUMBER((x) <= (y))
#define EQUAL_OF_BLOCKS(x, y) NUMBER((x) == (y))
#define AND_OF_BLOCKS(x, y) NUMBER(((x) != none) & ((y) != none))
#define OR_OF_BLOCKS(x, y) NUMBER(((x) != none) | ((y) != none))

#define INLINED static inline __attribute__((always_inline))
#define AS_BITS(x) ((block_bits)(x))
#define SUM_OF_PRODUCT(x, y, z) ((x) * (y) + (z))

/* All bits of lanes whose arguments vectors serve. */
INLINED block_bits sincos_of_block(const block *angle, block_memory *s, block_memory *c)
{
    const block x = *angle;
    const block none = {0.0};
    LAG_SINCOS_BODY(block, block_bits, x, AS_BITS, SUM_OF_PRODUCT, (double));
    *s = (block)sine;
    *c = (block)cosine;
    return (block_bits)(ABS_OF_BLOCK(x) <= none + LAG_SINCOS_LARGEST);
}

/* The others. */
static void turn_far(uint32_t count, const block *x, const uint32_t *from, block_memory *row)
{
    for (uint32_t i = 0; i < count; ++i) {
        for (size_t lane = 0; lane < LAG_TAPE_LANES; ++lane) {
            double sine;
            double cosine;
            if (!(fabs(x[i][lane]) <= LAG_SINCOS_LARGEST)) {
                lag_sincos(x[i][lane], &sine, &cosine);
                row[from[count + i]][lane] = sine;
                row[from[2 * count + i]][lane] = cosine;
            }
        }
    }
}

/* One look at all arguments: looking at lanes takes its time. */
INLINED void turn(const uint32_t *word, block_memory *row)
{
    const uint32_t count = word[1];
    const uint32_t *from = word + 2;
    block x[LAG_TAPE_ANGLES]; /* angles may stand where sines go */
    unsigned long long near[LAG_TAPE_LANES];
    block_bits all_near = ~(block_bits){0};
    for (uint32_t i = 0; i < count; ++i) {
        x[i] = row[from[i]];
    }
    for (uint32_t i = 0; i < count; ++i) {
        all_near &= sincos_of_block(x + i, row + from[count + i], row + from[2 * count + i]);
    }
    memcpy(near, &all_near, sizeof near);
    if ((near[0] & near[1] & near[2] & near[3] & near[4] & near[5] & near[6] & near[7]) == 0) {
        turn_far(count, x, from, row);
    }
}

INLINED void constants(const lag_tape_code *code, block_memory *row)
{
    const block zero = {0.0};
    for (size_t i = 0; i < code->count; ++i) {
        row[i] = code->constants[i] - zero;
    }
}

static void load(const uint32_t *word, const lag_arguments *at, block_memory *row)
{
    const double *from = word[1] == 0 ? at->times : lag_tape_argument(at, word[1]);
    memcpy(row + word[4], from + (size_t)word[2] * LAG_TAPE_LANES, word[3] * sizeof *row);
}

INLINED void store(const uint32_t *word, const block_memory *row, block_memory *result)
{
    for (uint32_t i = 0; i < word[3]; ++i) {
        result[word[2] + i] = row[word[4 + i]];
    }
}

INLINED void scatter(const uint32_t *word, const block_memory *row, block_memory *result)
{
    const uint32_t count = word[3];
    memset(result, 0, word[2] * sizeof *result);
    for (uint32_t i = 0; i < count; ++i) {
        result[word[4 + i]] = row[word[4 + count + i]];
    }
}

#if defined(__wasm__)
static const uint32_t *over_strides(const uint32_t *word, block_memory *row)
{
    const uint32_t *behind = word;
    uint32_t once[LAG_TAPE_ONCE];
    for (uint32_t i = 0; i < word[1]; ++i) {
        behind = lag_tape_once(word, i, once);
        lag_tape_run_lanes(&(lag_tape_code){.words = once}, NULL, (double *)row, NULL);
    }
    return behind;
}
#endif

INLINED void run(const lag_tape_code *code, const lag_arguments *at, block_memory *row, double *const *results)
{
    static const double signs[4][2] = {{1.0, 1.0}, {1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}};
    const uint32_t *word = code->words;
    const block none = {0.0};
    const block all = 1.0 - none;
    uint32_t times;
    for (;;) {
        switch (*word) {
        case LAG_TAPE_END:
            return;
        case LAG_TAPE_CONSTANTS:
            constants(code, row);
            ++word;
            break;
        case LAG_TAPE_LOAD:
            load(word, at, row);
            word += 5;
            break;
        case LAG_TAPE_STORE:
            store(word, row, (block_memory *)results[word[1]]);
            word += 4 + word[3];
            break;
        case LAG_TAPE_SCATTER:
            scatter(word, row, (block_memory *)results[word[1]]);
            word += 4 + 2 * word[3];
            break;
        case LAG_TAPE_SINCOS:
            turn(word, row);
            word += 2 + 3 * word[1];
            break;
#define r(i) row[word[i]]
#define OPERATION(name, width, statement)               \
        case LAG_TAPE_##name:                           \
            times = word[1];                            \
            for (word += 2; times > 0; --times) {       \
                statement;                              \
                word += width;                          \
            }                                           \
            break;
#define EACH(expression)                                             \
    for (size_t lane = 0; lane < LAG_TAPE_LANES; ++lane) {           \
        r(0)[lane] = expression;                                     \
    }
#define OF_ONE(name, function) OPERATION(name, 2, EACH(function(r(1)[lane])))
#define OF_ONE_BLOCK(name, function) OPERATION(name, 2, const block x = r(1); r(0) = name##_OF_BLOCK(x))
#define OF_TWO_BLOCKS(name, function) OPERATION(name, 3, const block x = r(1); const block y = r(2); r(0) = name##_OF_BLOCKS(x, y))
#define OF_OPERATOR(name, operator) OPERATION(name, 3, r(0) = r(1) operator r(2))
#define OF_TWO(name, function) OPERATION(name, 3, EACH(function(r(1)[lane], r(2)[lane])))
        OPERATION(TWO_PRODUCTS, 6, r(0) = r(2) * r(3) + signs[word[1]][1] * (r(4) * r(5)))
        OPERATION(THREE_PRODUCTS, 8,
            r(0) = r(2) * r(3) + signs[word[1]][0] * (r(4) * r(5)) + signs[word[1]][1] * (r(6) * r(7)))
        LAG_TAPE_UNARY(OF_ONE)
        LAG_TAPE_UNARY_CHOICES(OF_ONE_BLOCK)
        LAG_TAPE_ARITHMETIC(OF_OPERATOR)
        LAG_TAPE_BINARY(OF_TWO)
        LAG_TAPE_BINARY_CHOICES(OF_TWO_BLOCKS)
        OPERATION(SELECT, 4, r(0) = CHOSEN(r(1) != none, r(2), r(3)))
#if !defined(__wasm__)
#define s(k) row[first[2 * (k)] + i * first[2 * (k) + 1]]
#define OVER_STRIDES(name, before, operands, expression)        \
        case LAG_TAPE_STRIDED_##name: {                         \
            const uint32_t *first = word + (before);            \
            for (size_t i = 0; i < word[1]; ++i) {              \
                row[word[2] + i] = expression;                  \
            }                                                   \
            word = first + 2 * (operands);                      \
            break;                                              \
        }
        OVER_STRIDES(TWO_PRODUCTS, 4, 4, s(0) * s(1) + signs[word[3]][1] * (s(2) * s(3)))
        OVER_STRIDES(THREE_PRODUCTS, 4, 6,
            s(0) * s(1) + signs[word[3]][0] * (s(2) * s(3)) + signs[word[3]][1] * (s(4) * s(5)))
        OVER_STRIDES(MULTIPLY, 3, 2, s(0) * s(1))
        OVER_STRIDES(DIVIDE, 3, 2, s(0) / s(1))
#endif
        default:
#if defined(__wasm__) /* the smallest code */
            word = over_strides(word, row);
            break;
#else
            return; /* checked tapes have no others */
#endif
        }
    }
}

/* Wider registers where the processor has them, which is asked when it runs: the library is one for all of them. */
#if defined(__x86_64__) && defined(__STDC_HOSTED__) && __STDC_HOSTED__ && !defined(__AVX2__)
#define RUN_IN(name, registers)                                                                                        \
    __attribute__((target(registers))) static void name(                                                               \
        const lag_tape_code *code, const lag_arguments *at, block_memory *row, double *const *results)                 \
    {                                                                                                                  \
        run(code, at, row, results);                                                                                   \
    }
RUN_IN(run_wide, "avx2")
RUN_IN(run_widest, "avx512f,avx512dq")
#define WIDE __builtin_cpu_supports("avx2")
#define WIDEST (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
#else
#define run_wide run
#define run_widest run
#define WIDE 0
#define WIDEST 0
#endif

size_t lag_tape_lanes_width(void)
{
    return WIDEST ? 8 : WIDE ? 4 : 2;
}

void lag_tape_run_lanes(const lag_tape_code *code, const lag_arguments *at, double *row, double *const *results)
{
    if (WIDEST) {
        run_widest(code, at, (block_memory *)row, results);
    } else if (WIDE) {
        run_wide(code, at, (block_memory *)row, results);
    } else {
        run(code, at, (block_memory *)row, results);
    }
}

#endif
