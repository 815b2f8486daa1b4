/* Looking at every word of a tape before any is run. */
#include "lag/tape/tape_model.h"

enum { ONE = LAG_TAPE_NUMBER_OF_SIZES };

#define NUMBER {ONE, ONE}
#define VECTOR(length) {LAG_TAPE_##length, ONE}
#define MATRIX(rows, columns) {LAG_TAPE_##rows, LAG_TAPE_##columns}

static const lag_tape_signature SIGNATURES[LAG_TAPE_ALONG] = {
    {1u << LAG_TAPE_PARAMETERS, 0, {NUMBER}},
    /* ---- the functions, generated ---- */
    [1 + LAG_START] = {0x0041, 4, {VECTOR(NQ), VECTOR(NQ), VECTOR(NZ), VECTOR(NU)}},
    [1 + LAG_POSITION_CONSTRAINT] = {0x007f, 2, {VECTOR(NC), MATRIX(NC, NQ)}},
    [1 + LAG_VELOCITY_CONSTRAINT] = {0x007f, 2, {VECTOR(NC), MATRIX(NC, NQ)}},
    [1 + LAG_MASS_MATRIX] = {0x007f, 1, {MATRIX(NQ, NQ)}},
    [1 + LAG_DYNAMICS] = {0x007f, 4, {MATRIX(NQ, NQ), VECTOR(NQ), MATRIX(NC, NQ), VECTOR(NC)}},
    [1 + LAG_INVERSE_DYNAMICS] = {0x00ff, 1, {VECTOR(NQ)}},
    [1 + LAG_RESIDUAL] = {0x01ff, 2, {VECTOR(NQ), VECTOR(NC)}},
    [1 + LAG_RESIDUAL_TANGENT] = {0x3fff, 2, {VECTOR(NQ), VECTOR(NC)}},
    [1 + LAG_STATE_DERIVATIVE] = {0x01ff, 1, {VECTOR(NZ)}},
    [1 + LAG_STATE_DERIVATIVE_TANGENT] = {0xffff, 1, {VECTOR(NZ)}},
    [1 + LAG_OUTPUT] = {0x01ff, 1, {VECTOR(NY)}},
    [1 + LAG_OUTPUT_TANGENT] = {0xffff, 1, {VECTOR(NY)}},
    [1 + LAG_ENERGIES] = {0x007f, 4, {NUMBER, NUMBER, NUMBER, NUMBER}},
    [1 + LAG_MOMENTA] = {0x007f, 1, {VECTOR(NQ)}},
    [1 + LAG_POWER] = {0x007f, 2, {VECTOR(NQ), VECTOR(NQ)}},
    [1 + LAG_MONITOR] = {0x01ff, 3, {VECTOR(NI), VECTOR(NI), VECTOR(NA)}},
    [1 + LAG_INITIAL_EQUATION] = {0x01ff, 1, {VECTOR(NE)}},
    [1 + LAG_CONSTRAINT_TANGENT] = {0x3e7f, 2, {VECTOR(NC), VECTOR(NC)}},
    [1 + LAG_ELIMINATION] = {0x007f, 7, {VECTOR(NQ), VECTOR(NC), MATRIX(NK, NQ), MATRIX(NK, NC), MATRIX(NK, NQ),
        VECTOR(NK), NUMBER}},
    [1 + LAG_DISCRETE_START] = {0x0041, 1, {VECTOR(NW)}},
    [1 + LAG_INDICATOR] = {0x01ff, 1, {VECTOR(NINDICATOR)}},
    [1 + LAG_INDICATOR_RATE] = {0xd9ff, 2, {VECTOR(NINDICATOR), VECTOR(NINDICATOR)}},
    [1 + LAG_STANDING] = {0x01ff, 1, {VECTOR(NW)}},
    [1 + LAG_CONTACT] = {0x007f, 6, {VECTOR(NGAP), VECTOR(NGAP), MATRIX(NGAP, NQ), VECTOR(NCONTACT), VECTOR(NCONTACT),
        VECTOR(NCONTACT)}},
    [1 + LAG_CLOCK] = {0x0041, 2, {VECTOR(NCLOCK), VECTOR(NCLOCK)}},
    [1 + LAG_EVENT] = {0x01ff, 7, {VECTOR(NW), VECTOR(NRESET), VECTOR(NRESET), VECTOR(NCOLLISION), VECTOR(NCOLLISION),
        VECTOR(NSTOP), VECTOR(NFAIL)}},
    [1 + LAG_TIME_EVENT] = {0x0061, 6, {VECTOR(NTIMED), VECTOR(NTIMED), VECTOR(NDISTANCE), VECTOR(NDISTANCE), VECTOR(NDISTANCE),
        VECTOR(NDISTANCE)}},
    [1 + LAG_CORNER] = {0x01ff, 2, {VECTOR(NCORNER), NUMBER}},
    [1 + LAG_WAY] = {0x007f, 1, {VECTOR(NWAY)}},
    [1 + LAG_TURN] = {0x007f, 4, {VECTOR(NTURN), VECTOR(NTURN), VECTOR(NTURN), VECTOR(NTURN)}},
    [1 + LAG_DELAYED] = {0x007f, 3, {VECTOR(NDELAY), VECTOR(NDELAY), NUMBER}},
    [1 + LAG_FRICTION] = {0x01ff, 6, {VECTOR(NSLIP), MATRIX(NSLIP, NQ), VECTOR(NFRICTION), VECTOR(NFRICTION), MATRIX(NFRICTION, NC),
        MATRIX(NFRICTION, NC)}},
    [1 + LAG_LOAD] = {0x01ff, 3, {VECTOR(NLOAD), MATRIX(NLOAD, NQ), MATRIX(NLOAD, NC)}},
    [1 + LAG_LOAD_TANGENT] = {0xffff, 1, {VECTOR(NLOAD)}},
    [1 + LAG_LOAD_GAIN] = {0x01ff, 4, {MATRIX(NQ, NLOAD), MATRIX(NZ, NLOAD), MATRIX(NY, NLOAD), MATRIX(NLOAD, NLOAD)}},
    [1 + LAG_MOMENTUM_TANGENT] = {0x047f, 1, {VECTOR(NQ)}},
    [1 + LAG_DEFINITION] = {0x01ff, 1, {VECTOR(ND)}},
    [1 + LAG_DEFINITION_TANGENT] = {0xffff, 1, {VECTOR(ND)}},
    [1 + LAG_START_TANGENT] = {0x2041, 4, {VECTOR(NQ), VECTOR(NQ), VECTOR(NZ), VECTOR(NU)}},
    [1 + LAG_ENERGIES_TANGENT] = {0x3e7f, 4, {NUMBER, NUMBER, NUMBER, NUMBER}},
    [1 + LAG_INITIAL_EQUATION_TANGENT] = {0xffff, 1, {VECTOR(NE)}},
    [1 + LAG_TIME_TANGENT] = {0x01ff, 11, {VECTOR(NQ), VECTOR(NC), VECTOR(NC), VECTOR(NC), VECTOR(NZ),
        VECTOR(NY), NUMBER, NUMBER, NUMBER, NUMBER, VECTOR(ND)}},
    [1 + LAG_CORRECTION] = {0x017f, 3, {VECTOR(NQ), VECTOR(NC), NUMBER}},
    [1 + LAG_EQUATION_TERMS] = {0x007f, 3, {MATRIX(NQ, NQ), VECTOR(NQ), VECTOR(NQ)}},
    [1 + LAG_REGRESSOR] = {0x00ff, 2, {MATRIX(NQ, NINERTIAL), VECTOR(NINERTIAL)}},
    [1 + LAG_KINEMATICS] = {0x007f, 5, {VECTOR(NPLACE), VECTOR(NAXES), VECTOR(NTWIST), MATRIX(NTWIST, NQ), VECTOR(NTWIST)}},
    /* ---- end of what is generated ---- */
};

/* Arguments that have lanes in functions of several directions. */
#define ALONG 0xfe00

/* In the order of lag_tangents. */
static const lag_tape_signature SIGNATURES_ALONG[LAG_TAPE_ALONG_COUNT] = {
    {0x01ff, 0, {NUMBER}},
    {ALONG, 2, {VECTOR(NQ), VECTOR(NC)}},
    {ALONG, 4, {VECTOR(NQ), VECTOR(NC), VECTOR(NK), NUMBER}},
    {ALONG, 1, {VECTOR(NZ)}},
    {ALONG, 1, {VECTOR(NY)}},
};

/* Instead of the first of them, where no multiplier is left to run time. */
static const lag_tape_signature MOTION = {0x007f, 3, {VECTOR(NQ), VECTOR(NC), NUMBER}};

/* Instead of all of these. */
static const lag_tape_signature JACOBIAN = {0x007f, 6, {VECTOR(NQ), VECTOR(NC), NUMBER, MATRIX(RATES, EQUATIONS),
    MATRIX(EQUATIONS, VARIABLES), MATRIX(EQUATIONS, NP)}};

static uint64_t length_of(const uint32_t *size, unsigned which)
{
    const uint64_t n = size[LAG_TAPE_NQ];
    switch (which) {
    case ONE: return 1;
    case LAG_TAPE_EQUATIONS: return n + size[LAG_TAPE_NC] + size[LAG_TAPE_NZ];
    case LAG_TAPE_RATES: return n + size[LAG_TAPE_NZ];
    case LAG_TAPE_VARIABLES: return 2 * n + size[LAG_TAPE_NZ] + size[LAG_TAPE_NU];
    default: return size[which];
    }
}

uint64_t lag_tape_argument_length(const uint32_t *size, uint32_t group)
{
    static const unsigned char which[LAG_TAPE_GROUPS] = {
        ONE, LAG_TAPE_NQ, LAG_TAPE_NQ, LAG_TAPE_NZ, LAG_TAPE_NU, LAG_TAPE_NW, LAG_TAPE_NP, LAG_TAPE_NQ, LAG_TAPE_NC,
        LAG_TAPE_NQ, LAG_TAPE_NQ, LAG_TAPE_NZ, LAG_TAPE_NU, LAG_TAPE_NP, LAG_TAPE_NQ, LAG_TAPE_NC};
    return length_of(size, which[group]);
}

uint64_t lag_tape_result_length(const uint32_t *size, const lag_tape_signature *of, uint32_t which)
{
    return length_of(size, of->results[which][0]) * length_of(size, of->results[which][1]);
}

const lag_tape_signature *lag_tape_signature_of(const lag_tape_parts *parts, size_t function)
{
    if (function < LAG_TAPE_ALONG) {
        return SIGNATURES + function;
    }
    if (function == LAG_TAPE_JACOBIAN) {
        return &JACOBIAN;
    }
    const size_t which = (function - LAG_TAPE_ALONG) % LAG_TAPE_ALONG_COUNT;
    return which == LAG_TAPE_PRIMAL && lag_tape_moves(parts) ? &MOTION : SIGNATURES_ALONG + which;
}

/* Position of the check: words up to `end`, of a function that may write from `first` on in a row of `row` places. */
typedef struct view {
    const uint32_t *word, *end;
    const uint32_t *size;
    uint64_t first, row, constants;
    const lag_tape_signature *own; /* of the function */
} view;

/* True if `count` words follow the present one. */
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
    if (!enough(at, 4) || w[1] >= LAG_TAPE_GROUPS || (at->own->arguments >> w[1] & 1u) == 0) {
        return 0;
    }
    const uint64_t length = lag_tape_argument_length(at->size, w[1]);
    return w[2] <= length && w[3] <= length - w[2] && writable(at, w[4], w[3]) ? 5 : 0;
}

static uint64_t store(const view *at)
{
    const uint32_t *w = at->word;
    if (!enough(at, 3) || w[1] >= at->own->count || !enough(at, 3 + (uint64_t)w[3])) {
        return 0;
    }
    const uint64_t length = lag_tape_result_length(at->size, at->own, w[1]);
    return w[2] <= length && w[3] <= length - w[2] && readable(at, w + 4, w[3]) ? 4 + (uint64_t)w[3] : 0;
}

static uint64_t scatter(const view *at)
{
    const uint32_t *w = at->word;
    if (!enough(at, 3) || w[1] >= at->own->count || !enough(at, 3 + 2 * (uint64_t)w[3]) || w[2] > lag_tape_result_length(at->size, at->own, w[1])) {
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
    static const unsigned char widths[] = {6, 8, LAG_TAPE_UNARY(OF_ONE) LAG_TAPE_UNARY_CHOICES(OF_ONE)
            LAG_TAPE_ARITHMETIC(OF_TWO) LAG_TAPE_BINARY(OF_TWO) LAG_TAPE_BINARY_CHOICES(OF_TWO) 4};
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

static uint64_t strided(const view *at)
{
#define OPERANDS(name, operands) operands,
    static const unsigned char numbers[] = {LAG_TAPE_STRIDED(OPERANDS)};
    const uint32_t *w = at->word;
    const uint32_t which = w[0] - LAG_TAPE_STRIDED_TWO_PRODUCTS;
    const uint32_t most = w[0] == LAG_TAPE_STRIDED_TWO_PRODUCTS ? 1 : 3; /* of signs */
    const uint64_t before = w[0] <= LAG_TAPE_STRIDED_THREE_PRODUCTS ? 4 : 3;
    const uint64_t width = before + 2 * (uint64_t)numbers[which];
    if (!enough(at, width - 1) || w[1] == 0 || !writable(at, w[2], w[1]) || (before > 3 && w[3] > most)) {
        return 0;
    }
    for (const uint32_t *operand = w + before; operand < w + width; operand += 2) {
        const uint64_t first = operand[0];
        const uint64_t last = first + (uint64_t)operand[1] * (w[1] - 1u);
        if (last >= at->row || (last >= w[2] && first < (uint64_t)w[2] + w[1])) {
            return 0;
        }
    }
    return width;
}

static uint64_t instruction(const view *at)
{
    switch (*at->word) {
    case LAG_TAPE_CONSTANTS: return constants(at);
    case LAG_TAPE_LOAD: return load(at);
    case LAG_TAPE_STORE: return store(at);
    case LAG_TAPE_SCATTER: return scatter(at);
    case LAG_TAPE_SINCOS: return angles(at);
    default:
        if (*at->word >= LAG_TAPE_STRIDED_TWO_PRODUCTS) {
            return *at->word < LAG_TAPE_OPERATIONS ? strided(at) : 0;
        }
        return *at->word > LAG_TAPE_END ? operation(at) : 0;
    }
}

/* True if END, and nothing behind it, ends the words. */
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

/* Signature and row of a function. */
static void find_signature(view *at, const lag_tape_parts *parts, size_t function)
{
    const uint32_t *size = parts->size;
    at->own = lag_tape_signature_of(parts, function);
    at->first = function == 0 ? 0 : size[LAG_TAPE_PREPARED];
    at->row = size[LAG_TAPE_ROW];
    if (function >= LAG_TAPE_ALONG && function < LAG_TAPE_JACOBIAN && (function - LAG_TAPE_ALONG) % LAG_TAPE_ALONG_COUNT != LAG_TAPE_PRIMAL) {
        const size_t part = (function - LAG_TAPE_ALONG) / LAG_TAPE_ALONG_COUNT;
        at->first = size[LAG_TAPE_SHARED + 2 * part];
        at->row = size[LAG_TAPE_ALONG_ROW + 2 * part];
    }
}

int lag_tape_parts_have(const lag_tape_parts *parts, size_t function)
{
    return function < parts->part[LAG_TAPE_FUNCTIONS].length / (2 * sizeof(uint32_t));
}

int lag_tape_runs(const lag_tape_parts *parts)
{
    const uint32_t *table = (const void *)parts->part[LAG_TAPE_FUNCTIONS].bytes;
    const uint32_t *words = (const void *)parts->part[LAG_TAPE_WORDS].bytes;
    const uint64_t count = parts->part[LAG_TAPE_WORDS].length / sizeof(uint32_t);
    view at = {.size = parts->size};
    at.constants = parts->part[LAG_TAPE_CONSTANT_POOL].length / sizeof(double);
    for (size_t i = 0; i < LAG_TAPE_FUNCTION_COUNT && lag_tape_parts_have(parts, i); ++i) {
        const uint64_t first = table[2 * i];
        const uint64_t own = table[2 * i + 1];
        if (first > count || own > count - first || (i == 0 && own == 0)) {
            return 0;
        }
        find_signature(&at, parts, i);
        at.word = words + first;
        at.end = at.word + own;
        if (own > 0 && !function_runs(&at)) {
            return 0;
        }
    }
    return 1;
}
