/*
 * The instructions of a tape (lag/tape.h): what a function of a model computes, over a row of doubles.
 *
 * An instruction is a few 32-bit words: the operation, where its value goes, its operands, all places in the row. The value of an
 * instruction of arithmetic is also passed on to the next one, as `v`; "..._ON" does only that, and has no place. Every value is
 * rounded as that of a separate operation, in the order that the expression says. There are no jumps: END is the last one.
 *
 *     CONSTANTS                                      the row begins with the constants of the tape
 *     LOAD group first count place                   entries of an argument, count of them from `first` on
 *     STORE result first count operands...           entries of a result
 *     SCATTER result length count entries... operands...    entries of a result, zero elsewhere
 *     SINCOS count operands... places... places...   sines and cosines of the same arguments
 */
#ifndef LAG_TAPE_CODE_H
#define LAG_TAPE_CODE_H

#include <stdint.h>

#include "lag/model.h"

/* Name, number of operands, expression. */
#define LAG_TAPE_ARITHMETIC(X)                          \
    X(NEGATE, 1, -r(0))                                 \
    X(ADD, 2, r(0) + r(1))                              \
    X(SUBTRACT, 2, r(0) - r(1))                         \
    X(MULTIPLY, 2, r(0) * r(1))                         \
    X(DIVIDE, 2, r(0) / r(1))                           \
    X(MUL_ADD, 3, r(0) * r(1) + r(2))                   \
    X(MUL_SUB, 3, r(0) * r(1) - r(2))                   \
    X(SUB_MUL, 3, r(2) - r(0) * r(1))                   \
    X(MUL_ADD_MUL, 4, r(0) * r(1) + r(2) * r(3))        \
    X(MUL_SUB_MUL, 4, r(0) * r(1) - r(2) * r(3))        \
    X(V_NEGATE, 0, -v)                                  \
    X(V_ADD, 1, v + r(0))                               \
    X(V_SUBTRACT, 1, v - r(0))                          \
    X(SUBTRACT_V, 1, r(0) - v)                          \
    X(V_MULTIPLY, 1, v * r(0))                          \
    X(V_DIVIDE, 1, v / r(0))                            \
    X(DIVIDE_V, 1, r(0) / v)                            \
    X(MUL_ADD_V, 2, r(0) * r(1) + v)                    \
    X(MUL_SUB_V, 2, r(0) * r(1) - v)                    \
    X(V_SUB_MUL, 2, v - r(0) * r(1))                    \
    X(V_MUL_ADD, 2, v * r(0) + r(1))                    \
    X(V_MUL_SUB, 2, v * r(0) - r(1))                    \
    X(SUB_V_MUL, 2, r(1) - v * r(0))                    \
    X(V_MUL_ADD_MUL, 3, v * r(0) + r(1) * r(2))         \
    X(V_MUL_SUB_MUL, 3, v * r(0) - r(1) * r(2))         \
    X(MUL_SUB_V_MUL, 3, r(1) * r(2) - v * r(0))

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
    X(ABS, fabs)          \
    X(SIGN, lag_sign)     \
    X(FLOOR, floor)       \
    X(CEIL, ceil)         \
    X(NOT, lag_not)

#define LAG_TAPE_BINARY(X)           \
    X(POWER, pow)                    \
    X(ATAN2, atan2)                  \
    X(MOD, lag_mod)                  \
    X(MIN, lag_min)                  \
    X(MAX, lag_max)                  \
    X(LESS, lag_less)                \
    X(LESS_EQUAL, lag_less_equal)    \
    X(EQUAL, lag_equal)              \
    X(AND, lag_and)                  \
    X(OR, lag_or)

#define LAG_TAPE_TWO_NAMES(name, count, expression) LAG_TAPE_##name, LAG_TAPE_##name##_ON,
#define LAG_TAPE_ONE_NAME(name, function) LAG_TAPE_##name,

enum {
    LAG_TAPE_END,
    LAG_TAPE_CONSTANTS,
    LAG_TAPE_LOAD,
    LAG_TAPE_STORE,
    LAG_TAPE_SCATTER,
    LAG_TAPE_SINCOS,
    LAG_TAPE_ARITHMETIC(LAG_TAPE_TWO_NAMES)
    LAG_TAPE_UNARY(LAG_TAPE_ONE_NAME)
    LAG_TAPE_BINARY(LAG_TAPE_ONE_NAME)
    LAG_TAPE_SELECT,
    LAG_TAPE_OPERATIONS
};

/* Arguments of one SINCOS at most. */
#define LAG_TAPE_ANGLES 32

/* Groups of arguments: members of lag_arguments in their order, the time first. */
enum { LAG_TAPE_GROUPS = 16, LAG_TAPE_RESULTS = 11 /* of one function, at most */ };

typedef struct lag_tape_code {
    const uint32_t *words;
    const double *constants;
    size_t count; /* of constants */
} lag_tape_code;

/* The array of a group; the time is an array, too. */
const double *lag_tape_argument(const lag_arguments *at, uint32_t group);

/* Runs instructions over `row`. */
void lag_tape_run(const lag_tape_code *code, const lag_arguments *at, double *row, double *const *results);

#endif
