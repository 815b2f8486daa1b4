/*
 * The instructions of a tape (lag/tape.h): what a function of a model computes, over a row of doubles.
 *
 * An instruction is a row of 32-bit words: an operation, how often it is done, and, each time, the place in the row where the value
 * goes and those of the operands. It is done time after time, in order. There are no jumps: END is the last one. The others are
 *
 *     CONSTANTS                                       the row begins with the constants of the tape
 *     LOAD group first count place                    entries of an argument, count of them from `first` on
 *     STORE result first count operands...            entries of a result
 *     SCATTER result length count entries... operands...    entries of a result, zero elsewhere
 *     SINCOS count operands... places... places...    sines and cosines of the same arguments
 *     TWO_PRODUCTS count (place signs a b c d)...     a*b + c*d, with signs 1 a*b - c*d
 *     THREE_PRODUCTS count (place signs a b c d e f)...    a*b + c*d + e*f, with signs 1 - e*f, with 2 - c*d, with 3 both
 *
 *     STRIDED_... count place signs (place stride)...    one of these (signs: of sums only), time after time: the value goes to the next place, an
 *                                                     operand is its stride further. No operand stands where a value goes
 *
 * Every value is rounded as that of separate operations, from left to right. Few operations that do much make few jumps from one
 * to the next, which processors foresee.
 */
#ifndef LAG_TAPE_CODE_H
#define LAG_TAPE_CODE_H

#include <stdint.h>

#include "lag/model.h"

/* Name, function of single numbers. */
#define LAG_TAPE_UNARY(X) \
    X(TAN, tan)           \
    X(ASIN, asin)         \
    X(ACOS, acos)         \
    X(ATAN, atan)         \
    X(SINH, sinh)         \
    X(COSH, cosh)         \
    X(TANH, tanh)         \
    X(EXP, exp)           \
    X(LOG, log)           \
    X(SQRT, sqrt)         \
    X(FLOOR, floor)       \
    X(CEIL, ceil)

/* The same, of what needs no library: vectors have it, too. */
#define LAG_TAPE_UNARY_CHOICES(X) \
    X(ABS, fabs)                  \
    X(SIGN, lag_sign)             \
    X(NOT, lag_not)

/* Name, operator. */
#define LAG_TAPE_ARITHMETIC(X) \
    X(MULTIPLY, *)             \
    X(DIVIDE, /)

#define LAG_TAPE_BINARY(X)          \
    X(POWER, pow)                   \
    X(ATAN2, atan2)                 \
    X(MOD, lag_mod)

#define LAG_TAPE_BINARY_CHOICES(X)  \
    X(MIN, lag_min)                 \
    X(MAX, lag_max)                 \
    X(LESS, lag_less)               \
    X(LESS_EQUAL, lag_less_equal)   \
    X(EQUAL, lag_equal)             \
    X(AND, lag_and)                 \
    X(OR, lag_or)

/* Name, number of operands. */
#define LAG_TAPE_STRIDED(X) \
    X(TWO_PRODUCTS, 4)      \
    X(THREE_PRODUCTS, 6)    \
    X(MULTIPLY, 2)          \
    X(DIVIDE, 2)

#define LAG_TAPE_NAME(name, function) LAG_TAPE_##name,
#define LAG_TAPE_STRIDED_NAME(name, operands) LAG_TAPE_STRIDED_##name,

enum {
    LAG_TAPE_END,
    LAG_TAPE_CONSTANTS,
    LAG_TAPE_LOAD,
    LAG_TAPE_STORE,
    LAG_TAPE_SCATTER,
    LAG_TAPE_SINCOS,
    LAG_TAPE_TWO_PRODUCTS,
    LAG_TAPE_THREE_PRODUCTS,
    LAG_TAPE_UNARY(LAG_TAPE_NAME)
    LAG_TAPE_UNARY_CHOICES(LAG_TAPE_NAME)
    LAG_TAPE_ARITHMETIC(LAG_TAPE_NAME)
    LAG_TAPE_BINARY(LAG_TAPE_NAME)
    LAG_TAPE_BINARY_CHOICES(LAG_TAPE_NAME)
    LAG_TAPE_SELECT,
    LAG_TAPE_STRIDED(LAG_TAPE_STRIDED_NAME)
    LAG_TAPE_OPERATIONS
};

/* Arguments of one SINCOS at most. */
#define LAG_TAPE_ANGLES 32

/* Groups of arguments: members of lag_arguments in their order, the time first. */
enum { LAG_TAPE_PARAMETERS = 6, LAG_TAPE_GROUPS = 16, LAG_TAPE_RESULTS = 11 /* of one function, at most */ };

typedef struct lag_tape_code {
    const uint32_t *words;
    const double *constants;
    size_t count; /* of constants */
} lag_tape_code;

/* The array of a group; the time is an array, too. */
const double *lag_tape_argument(const lag_arguments *at, uint32_t group);

/* Words of an instruction that is done once, and END. */
enum { LAG_TAPE_ONCE = 11 };

/* The instruction over strides at `word` as it is done at time i, into `once`; returns the word behind it. */
static inline const uint32_t *lag_tape_once(const uint32_t *word, uint32_t i, uint32_t once[LAG_TAPE_ONCE])
{
    static const unsigned char plain[] = {LAG_TAPE_TWO_PRODUCTS, LAG_TAPE_THREE_PRODUCTS, LAG_TAPE_MULTIPLY, LAG_TAPE_DIVIDE};
    static const unsigned char operands[] = {4, 6, 2, 2};
    const uint32_t which = *word - LAG_TAPE_STRIDED_TWO_PRODUCTS;
    *once++ = plain[which];
    *once++ = 1;
    *once++ = word[2] + i;
    word += 3;
    if (which < 2) {
        *once++ = *word++;
    }
    for (unsigned k = 0; k < operands[which]; ++k, word += 2) {
        *once++ = word[0] + i * word[1];
    }
    *once = LAG_TAPE_END;
    return word;
}

/* Runs the instruction over strides at `word`; returns the word behind it. */
const uint32_t *lag_tape_run_strided(const uint32_t *word, double *row);

/* Runs instructions over `row`. */
void lag_tape_run(const lag_tape_code *code, const lag_arguments *at, double *row, double *const *results);

/*
 * The same for LAG_TAPE_LANES states, or directions, at once: every place of the row and every entry of arguments and results has
 * so many numbers, one after the other. All lanes get the bits that they get alone.
 */
#if defined(__GNUC__)
#define LAG_TAPE_LANES 8
void lag_tape_run_lanes(const lag_tape_code *code, const lag_arguments *at, double *row, double *const *results);
/* Doubles in a register of the processor, as far as the library is compiled for it. */
size_t lag_tape_lanes_width(void);
#else
#define LAG_TAPE_LANES 0
#endif

#endif
