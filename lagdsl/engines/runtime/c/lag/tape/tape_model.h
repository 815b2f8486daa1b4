/* A model filled from a tape, as the files of the tape share it. */
#ifndef LAG_TAPE_MODEL_H
#define LAG_TAPE_MODEL_H

#include <stdint.h>

#include "lag/evaluate.h"
#include "lag/tape.h"
#include "lag/tape/tape_code.h"

/* The functions of several directions. */
enum {
    LAG_TAPE_PRIMAL,
    LAG_TAPE_RESIDUAL_ALONG,
    LAG_TAPE_ACCELERATION_ALONG,
    LAG_TAPE_RATES_ALONG,
    LAG_TAPE_OUTPUT_ALONG,
    LAG_TAPE_ALONG_COUNT
};

/* prepare(), the functions of lag_function, those of directions of states and inputs, and of parameters; jacobian(), which the table may lack. */
enum {
    LAG_TAPE_ALONG = 1 + LAG_LAST_FUNCTION + 1,
    LAG_TAPE_JACOBIAN = LAG_TAPE_ALONG + 2 * LAG_TAPE_ALONG_COUNT,
    LAG_TAPE_FUNCTION_COUNT
};

typedef struct lag_tape {
    lag_model model; /* whose context is this structure */
    lag_start start;
    lag_pattern jacobian, response, coupling, equations;
    lag_patterns patterns; /* of these, those that are told */
    lag_states states;
    lag_tangents tangents[2], differentiated; /* of states and inputs, of parameters; with jacobian() alone, or nothing */
    size_t row, shared[2], along_row[2];
    const uint32_t *words, *functions;
    const double *constants;
    size_t constant_count;
} lag_tape;

/* A section: its bytes and how many there are. */
typedef struct lag_tape_part {
    const unsigned char *bytes;
    uint64_t length;
} lag_tape_part;

/* The sections of a tape, and the sizes among them. */
typedef struct lag_tape_parts {
    lag_tape_part part[LAG_TAPE_SECTIONS];
    const uint32_t *size; /* (LAG_TAPE_NUMBER_OF_SIZES) */
} lag_tape_parts;

/*
 * Signature of a function: the groups of arguments that it reads, one bit each; the number of its results; their rows and
 * columns as indices of sizes, or LAG_TAPE_NUMBER_OF_SIZES for a single one.
 */
typedef struct lag_tape_signature {
    uint32_t arguments;
    unsigned char count;
    unsigned char results[LAG_TAPE_RESULTS][2];
} lag_tape_signature;

/* Lengths that are sums of sizes, behind that of a single one: nq + nc + nz, nq + nz, 2 nq + nz + nu. */
enum { LAG_TAPE_EQUATIONS = LAG_TAPE_NUMBER_OF_SIZES + 1, LAG_TAPE_RATES, LAG_TAPE_VARIABLES };

/* True if the table has the function. */
int lag_tape_parts_have(const lag_tape_parts *parts, size_t function);

/* Of the function in that place of LAG_TAPE_FUNCTIONS. */
const lag_tape_signature *lag_tape_signature_of(const lag_tape_parts *parts, size_t function);

/* Entries of a group of arguments, and of a result. */
uint64_t lag_tape_argument_length(const uint32_t *size, uint32_t group);
uint64_t lag_tape_result_length(const uint32_t *size, const lag_tape_signature *of, uint32_t which);

/* True if primal() computes the accelerations, too: no multiplier is left to run time. */
static inline int lag_tape_moves(const lag_tape_parts *parts)
{
    const uint32_t *table = (const void *)parts->part[LAG_TAPE_FUNCTIONS].bytes;
    return parts->size[LAG_TAPE_NK] == 0 && table[2 * (1 + LAG_ELIMINATION) + 1] > 0;
}

/* True if all instructions can run with a row and arrays of these sizes. */
int lag_tape_runs(const lag_tape_parts *parts);

/* True if the model has a function, of lag_function. */
static inline int lag_tape_has(const lag_tape *tape, size_t function)
{
    return tape->functions[2 * (1 + function) + 1] > 0;
}

/* Finds the parts; false if they do not fill `count` bytes exactly. */
int lag_tape_divide(const unsigned char *bytes, size_t count, lag_tape_parts *parts);

/* Entries of a pattern, whose rows are this section. */
uint64_t lag_tape_pattern_length(const lag_tape_parts *parts, lag_tape_section rows);

/* Coordinates and states whose component is told. */
uint64_t lag_tape_components_length(const lag_tape_parts *parts);

/* Doubles of the workspace of one state. */
uint64_t lag_tape_workspace(const uint32_t *size);

/* Gives the model its functions. */
void lag_tape_functions(lag_tape *tape);

/* Gives it its derivatives, if it has some. */
void lag_tape_differentiated(lag_tape *tape, int has);

/* Gives the model its functions of several states and directions. */
void lag_tape_parallel(lag_tape *tape);

/* Doubles of the row of one state, where another row follows. */
static inline uint64_t lag_tape_aligned(uint64_t row)
{
    return (row + 7) / 8 * 8;
}

#endif
