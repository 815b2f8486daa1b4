/* A model filled from a tape, as the files of the tape share it. */
#ifndef LAG_TAPE_MODEL_H
#define LAG_TAPE_MODEL_H

#include <stdint.h>

#include "lag/evaluate.h"
#include "lag/tape.h"
#include "lag/tape_code.h"

/* prepare(), then the functions of lag_function. */
enum { LAG_TAPE_FUNCTION_COUNT = 1 + LAG_TIME_TANGENT + 1 };

typedef struct lag_tape {
    lag_model model; /* whose context is this structure */
    lag_start start;
    size_t row;
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

/* Entries of the results of a function, prepare() among them; zero beyond the last one. */
void lag_tape_result_lengths(const uint32_t *size, size_t function, uint64_t lengths[LAG_TAPE_RESULTS]);

/* Entries of a group of arguments. */
uint64_t lag_tape_argument_length(const uint32_t *size, uint32_t group);

/* Whether all instructions are ones that can be run with a row and arrays of these sizes. */
int lag_tape_runs(const lag_tape_parts *parts);

/* Whether the model has a function, of lag_function. */
static inline int lag_tape_has(const lag_tape *tape, size_t function)
{
    return tape->functions[2 * (1 + function) + 1] > 0;
}

/* Gives the model its functions. */
void lag_tape_functions(lag_tape *tape);

#endif
