/* Looking at every word of a tape before any is run. */
#include "lag/tape_model.h"

/* Lengths that results are written in: sizes, ONE for a single number, NONE for no result. */
enum { ONE = LAG_TAPE_NUMBER_OF_SIZES, NONE };

/* Rows and columns of a result. */
typedef struct shape {
    unsigned char rows, columns;
} shape;

#define VECTOR(size) {LAG_TAPE_##size, ONE}
#define MATRIX(rows, columns) {LAG_TAPE_##rows, LAG_TAPE_##columns}
#define NUMBER {ONE, ONE}
#define LAST {NONE, ONE}

/* In the order of lag_function. */
static const shape RESULTS[LAG_TAPE_FUNCTION_COUNT][LAG_TAPE_RESULTS + 1] = {
    {LAST},
    [1 + LAG_START] = {VECTOR(NQ), VECTOR(NQ), VECTOR(NZ), VECTOR(NU), LAST},
    [1 + LAG_POSITION_CONSTRAINT] = {VECTOR(NC), MATRIX(NC, NQ), LAST},
    [1 + LAG_VELOCITY_CONSTRAINT] = {VECTOR(NC), MATRIX(NC, NQ), LAST},
    [1 + LAG_MASS_MATRIX] = {MATRIX(NQ, NQ), LAST},
    [1 + LAG_DYNAMICS] = {MATRIX(NQ, NQ), VECTOR(NQ), MATRIX(NC, NQ), VECTOR(NC), LAST},
    [1 + LAG_INVERSE_DYNAMICS] = {VECTOR(NQ), LAST},
    [1 + LAG_RESIDUAL] = {VECTOR(NQ), VECTOR(NC), LAST},
    [1 + LAG_RESIDUAL_TANGENT] = {VECTOR(NQ), VECTOR(NC), LAST},
    [1 + LAG_STATE_DERIVATIVE] = {VECTOR(NZ), LAST},
    [1 + LAG_STATE_DERIVATIVE_TANGENT] = {VECTOR(NZ), LAST},
    [1 + LAG_OUTPUT] = {VECTOR(NY), LAST},
    [1 + LAG_OUTPUT_TANGENT] = {VECTOR(NY), LAST},
    [1 + LAG_ENERGIES] = {NUMBER, NUMBER, NUMBER, NUMBER, LAST},
    [1 + LAG_MOMENTA] = {VECTOR(NQ), LAST},
    [1 + LAG_POWER] = {VECTOR(NQ), VECTOR(NQ), LAST},
    [1 + LAG_MONITOR] = {VECTOR(NI), VECTOR(NI), VECTOR(NA), LAST},
    [1 + LAG_INITIAL_EQUATION] = {VECTOR(NE), LAST},
    [1 + LAG_CONSTRAINT_TANGENT] = {VECTOR(NC), VECTOR(NC), LAST},
    [1 + LAG_ELIMINATION] =
        {VECTOR(NQ), VECTOR(NC), MATRIX(NK, NQ), MATRIX(NK, NC), MATRIX(NK, NQ), VECTOR(NK), NUMBER, LAST},
    [1 + LAG_DISCRETE_START] = {VECTOR(NW), LAST},
    [1 + LAG_INDICATOR] = {VECTOR(NINDICATOR), LAST},
    [1 + LAG_STANDING] = {VECTOR(NW), LAST},
    [1 + LAG_CONTACT] =
        {VECTOR(NGAP), VECTOR(NGAP), MATRIX(NGAP, NQ), VECTOR(NCONTACT), VECTOR(NCONTACT), VECTOR(NCONTACT), LAST},
    [1 + LAG_CLOCK] = {VECTOR(NCLOCK), VECTOR(NCLOCK), LAST},
    [1 + LAG_EVENT] =
        {VECTOR(NW), VECTOR(NRESET), VECTOR(NRESET), VECTOR(NCOLLISION), VECTOR(NCOLLISION), VECTOR(NSTOP), VECTOR(NFAIL), LAST},
    [1 + LAG_TIME_EVENT] =
        {VECTOR(NTIMED), VECTOR(NTIMED), VECTOR(NDISTANCE), VECTOR(NDISTANCE), VECTOR(NDISTANCE), VECTOR(NDISTANCE), VECTOR(NDISTANCE),
            LAST},
    [1 + LAG_MOMENTUM_TANGENT] = {VECTOR(NQ), LAST},
    [1 + LAG_DEFINITION] = {VECTOR(ND), LAST},
    [1 + LAG_DEFINITION_TANGENT] = {VECTOR(ND), LAST},
    [1 + LAG_START_TANGENT] = {VECTOR(NQ), VECTOR(NQ), VECTOR(NZ), VECTOR(NU), LAST},
    [1 + LAG_ENERGIES_TANGENT] = {NUMBER, NUMBER, NUMBER, NUMBER, LAST},
    [1 + LAG_INITIAL_EQUATION_TANGENT] = {VECTOR(NE), LAST},
    [1 + LAG_TIME_TANGENT] =
        {VECTOR(NQ), VECTOR(NC), VECTOR(NC), VECTOR(NC), VECTOR(NZ), VECTOR(NY), NUMBER, NUMBER, NUMBER, NUMBER, VECTOR(ND), LAST},
};

static uint64_t length_of(const uint32_t *size, unsigned which)
{
    return which == ONE ? 1u : size[which];
}

void lag_tape_result_lengths(const uint32_t *size, size_t function, uint64_t lengths[LAG_TAPE_RESULTS])
{
    const shape *shapes = RESULTS[function];
    size_t i = 0;
    for (; shapes[i].rows != NONE; ++i) {
        lengths[i] = length_of(size, shapes[i].rows) * length_of(size, shapes[i].columns);
    }
    for (; i < LAG_TAPE_RESULTS; ++i) {
        lengths[i] = 0;
    }
}

uint64_t lag_tape_argument_length(const uint32_t *size, uint32_t group)
{
    static const unsigned char which[LAG_TAPE_GROUPS] = {
        ONE, LAG_TAPE_NQ, LAG_TAPE_NQ, LAG_TAPE_NZ, LAG_TAPE_NU, LAG_TAPE_NW, LAG_TAPE_NP, LAG_TAPE_NQ, LAG_TAPE_NC,
        LAG_TAPE_NQ, LAG_TAPE_NQ, LAG_TAPE_NZ, LAG_TAPE_NU, LAG_TAPE_NP, LAG_TAPE_NQ, LAG_TAPE_NC};
    return length_of(size, which[group]);
}

/* What is looked at: words up to `end`, of a function that may write from `first` on in a row of `row` places. */
typedef struct view {
    const uint32_t *word, *end;
    const uint32_t *size;
    uint64_t first, row, constants;
    uint64_t lengths[LAG_TAPE_RESULTS];
} view;

/* Whether `count` words follow the present one. */
static int enough(const view *at, uint64_t count)
{
    return (uint64_t)(at->end - at->word) > count;
}

/* Places that are read. */
static int readable(const view *at, const uint32_t *places, uint64_t count)
{
    for (uint64_t i = 0; i < count; ++i) {
        if (places[i] >= at->row) {
            return 0;
        }
    }
    return 1;
}

/* `count` places from `place` on that are written. */
static int writable(const view *at, uint64_t place, uint64_t count)
{
    return place >= at->first && place <= at->row && count <= at->row - place;
}

/* Each of these functions tells how many words its instruction has; 0: it is none. */

static uint64_t constants(const view *at)
{
    return at->first == 0 && at->constants <= at->row ? 1 : 0;
}

static uint64_t load(const view *at)
{
    const uint32_t *w = at->word;
    if (!enough(at, 4) || w[1] >= LAG_TAPE_GROUPS) {
        return 0;
    }
    const uint64_t length = lag_tape_argument_length(at->size, w[1]);
    return w[2] <= length && w[3] <= length - w[2] && writable(at, w[4], w[3]) ? 5 : 0;
}

static uint64_t store(const view *at)
{
    const uint32_t *w = at->word;
    if (!enough(at, 3) || w[1] >= LAG_TAPE_RESULTS || !enough(at, 3 + (uint64_t)w[3])) {
        return 0;
    }
    const uint64_t length = at->lengths[w[1]];
    return w[2] <= length && w[3] <= length - w[2] && readable(at, w + 4, w[3]) ? 4 + (uint64_t)w[3] : 0;
}

static uint64_t scatter(const view *at)
{
    const uint32_t *w = at->word;
    if (!enough(at, 3) || w[1] >= LAG_TAPE_RESULTS || !enough(at, 3 + 2 * (uint64_t)w[3]) || w[2] > at->lengths[w[1]]) {
        return 0;
    }
    for (uint32_t i = 0; i < w[3]; ++i) {
        if (w[4 + i] >= w[2]) {
            return 0;
        }
    }
    return readable(at, w + 4 + w[3], w[3]) ? 4 + 2 * (uint64_t)w[3] : 0;
}

static uint64_t angles(const view *at)
{
    const uint32_t *w = at->word;
    if (!enough(at, 1) || w[1] > LAG_TAPE_ANGLES || !enough(at, 1 + 3 * (uint64_t)w[1]) || !readable(at, w + 2, w[1])) {
        return 0;
    }
    for (uint32_t i = 0; i < 2 * w[1]; ++i) {
        if (!writable(at, w[2 + w[1] + i], 1)) {
            return 0;
        }
    }
    return 2 + 3 * (uint64_t)w[1];
}

/* Words of one time, and of these how many are before the operands. */
static uint64_t width_of(uint32_t operation, uint64_t *before)
{
#define OF_ONE(name, function) 2,
#define OF_TWO(name, function) 3,
    static const unsigned char widths[] = {6, 8, LAG_TAPE_UNARY(OF_ONE) LAG_TAPE_BINARY(OF_TWO) 4};
    *before = operation <= LAG_TAPE_THREE_PRODUCTS ? 2 : 1;
    return widths[operation - LAG_TAPE_TWO_PRODUCTS];
}

static uint64_t operation(const view *at)
{
    uint64_t before;
    const uint64_t width = width_of(*at->word, &before);
    const uint32_t most = *at->word == LAG_TAPE_TWO_PRODUCTS ? 1 : 3; /* of signs */
    if (!enough(at, 1) || at->word[1] == 0 || !enough(at, 1 + width * at->word[1])) {
        return 0;
    }
    for (uint64_t i = 0; i < at->word[1]; ++i) {
        const uint32_t *own = at->word + 2 + i * width;
        if (!writable(at, own[0], 1) || (before > 1 && own[1] > most) || !readable(at, own + before, width - before)) {
            return 0;
        }
    }
    return 2 + width * at->word[1];
}

static uint64_t instruction(const view *at)
{
    switch (*at->word) {
    case LAG_TAPE_CONSTANTS: return constants(at);
    case LAG_TAPE_LOAD: return load(at);
    case LAG_TAPE_STORE: return store(at);
    case LAG_TAPE_SCATTER: return scatter(at);
    case LAG_TAPE_SINCOS: return angles(at);
    default: return *at->word > LAG_TAPE_END && *at->word < LAG_TAPE_OPERATIONS ? operation(at) : 0;
    }
}

/* Whether END, and nothing behind it, ends the words. */
static int function_runs(view *at)
{
    while (at->word < at->end && *at->word != LAG_TAPE_END) {
        const uint64_t count = instruction(at);
        if (count == 0) {
            return 0;
        }
        at->word += count;
    }
    return at->word + 1 == at->end;
}

int lag_tape_runs(const lag_tape_parts *parts)
{
    const uint32_t *table = (const void *)parts->part[LAG_TAPE_FUNCTIONS].bytes;
    const uint32_t *words = (const void *)parts->part[LAG_TAPE_WORDS].bytes;
    const uint64_t count = parts->part[LAG_TAPE_WORDS].length / sizeof(uint32_t);
    view at = {.size = parts->size, .row = parts->size[LAG_TAPE_ROW]};
    at.constants = parts->part[LAG_TAPE_CONSTANT_POOL].length / sizeof(double);
    for (size_t i = 0; i < LAG_TAPE_FUNCTION_COUNT; ++i) {
        const uint64_t first = table[2 * i];
        const uint64_t own = table[2 * i + 1];
        if (first > count || own > count - first || (i == 0 && own == 0)) {
            return 0;
        }
        at.word = words + first;
        at.end = at.word + own;
        at.first = i == 0 ? 0 : parts->size[LAG_TAPE_PREPARED];
        lag_tape_result_lengths(parts->size, i, at.lengths);
        if (own > 0 && !function_runs(&at)) {
            return 0;
        }
    }
    return 1;
}
