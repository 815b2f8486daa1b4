/* Tapes of random models: random sizes, and random instructions that keep to all rules. */
#ifndef RANDOM_TAPE_H
#define RANDOM_TAPE_H

#include <stdint.h>
#include <string.h>

#include "check.h"
#include "lag/tape/tape_model.h"

enum { MOST_BYTES = 1 << 17, HEAD_BYTES = 24, MOST_PLACES = 40 };

/* A tape under way: all sections are written into `bytes` in their order. */
typedef struct random_tape {
    unsigned long long seed;
    unsigned char *bytes; /* (MOST_BYTES) */
    size_t count, section;
    uint32_t size[LAG_TAPE_NUMBER_OF_SIZES];
    uint32_t function[LAG_TAPE_FUNCTION_COUNT][2];
    uint32_t word[MOST_BYTES / 8];
    uint32_t words;
    int told; /* entries of the equations are */
} random_tape;

/* A whole number from 0 to `most`. */
static inline uint32_t any(unsigned long long *seed, uint32_t most)
{
    return (uint32_t)((draw(seed) + 1.0) * 0.5 * (double)most + 0.5);
}

static inline uint32_t crc32_of(const unsigned char *bytes, size_t count)
{
    uint32_t sum = 0xFFFFFFFFu;
    for (size_t i = 0; i < count; ++i) {
        sum ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit) {
            sum = sum >> 1 ^ (sum & 1u ? 0xEDB88320u : 0u);
        }
    }
    return ~sum;
}

/* Length and checksum of what follows the head. */
static inline void seal(unsigned char *bytes, size_t count)
{
    const uint64_t length = count - HEAD_BYTES;
    const uint32_t sum = crc32_of(bytes + HEAD_BYTES, count - HEAD_BYTES);
    memcpy(bytes + 12, &sum, sizeof sum);
    memcpy(bytes + 16, &length, sizeof length);
}

/* The next section. */
static inline void put_section(random_tape *tape, const void *data, size_t length)
{
    const uint64_t told = length;
    CHECK(tape->count + length + 8 <= MOST_BYTES);
    memcpy(tape->bytes + HEAD_BYTES + 8 * tape->section++, &told, sizeof told);
    if (length > 0) {
        memcpy(tape->bytes + tape->count, data, length);
    }
    memset(tape->bytes + tape->count + length, 0, 8);
    tape->count += (length + 7) / 8 * 8;
}

/* ---- instructions ---- */

static inline void put_word(random_tape *tape, uint32_t word)
{
    CHECK(tape->words < MOST_BYTES / 8);
    tape->word[tape->words++] = word;
}

/* Places a function may write to, and the length of its row. */
typedef struct row_of {
    uint32_t first, row;
} row_of;

static inline void put_reads(random_tape *tape, row_of row, uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i) {
        put_word(tape, any(&tape->seed, row.row - 1));
    }
}

static inline void put_place(random_tape *tape, row_of row)
{
    put_word(tape, row.first + any(&tape->seed, row.row - row.first - 1));
}

/* Operands over strides stand before the place of the first value, or behind that of the last one. */
static inline void put_strided(random_tape *tape, row_of row, uint32_t operation)
{
    static const uint32_t operands[] = {4, 6, 2, 2};
    const uint32_t least = row.first > 0 ? row.first : 1;
    const uint32_t count = 1 + any(&tape->seed, row.row - least - 1);
    const uint32_t place = least + any(&tape->seed, row.row - least - count);
    put_word(tape, operation);
    put_word(tape, count);
    put_word(tape, place);
    if (operation <= LAG_TAPE_STRIDED_THREE_PRODUCTS) {
        put_word(tape, any(&tape->seed, operation == LAG_TAPE_STRIDED_TWO_PRODUCTS ? 1 : 3));
    }
    for (uint32_t i = 0; i < operands[operation - LAG_TAPE_STRIDED_TWO_PRODUCTS]; ++i) {
        const uint32_t behind = row.row - place - count;
        const uint32_t stride = any(&tape->seed, 3);
        const uint32_t span = stride * (count - 1);
        if (span < behind) {
            put_word(tape, place + count + any(&tape->seed, behind - span - 1));
            put_word(tape, stride);
        } else {
            put_word(tape, any(&tape->seed, place - 1 - (span < place ? span : 0)));
            put_word(tape, span < place ? stride : 0);
        }
    }
}

static inline void put_operation(random_tape *tape, row_of row)
{
    const uint32_t operation = LAG_TAPE_SINCOS + any(&tape->seed, LAG_TAPE_OPERATIONS - 1 - LAG_TAPE_SINCOS);
    const uint32_t times = 1 + any(&tape->seed, 3);
    if (operation >= LAG_TAPE_STRIDED_TWO_PRODUCTS && row.row - row.first > 2) {
        put_strided(tape, row, operation);
        return;
    }
    put_word(tape, operation < LAG_TAPE_STRIDED_TWO_PRODUCTS ? operation : LAG_TAPE_MULTIPLY);
    put_word(tape, times);
    if (operation == LAG_TAPE_SINCOS) {
        put_reads(tape, row, times);
        for (uint32_t i = 0; i < 2 * times; ++i) {
            put_place(tape, row);
        }
        return;
    }
    for (uint32_t i = 0; i < times; ++i) {
        put_place(tape, row);
        if (operation <= LAG_TAPE_THREE_PRODUCTS) {
            put_word(tape, any(&tape->seed, operation == LAG_TAPE_TWO_PRODUCTS ? 1 : 3));
            put_reads(tape, row, operation == LAG_TAPE_TWO_PRODUCTS ? 4 : 6);
        } else {
            put_reads(tape, row, operation == LAG_TAPE_SELECT ? 3 : operation < LAG_TAPE_MULTIPLY ? 1 : 2);
        }
    }
}

static inline void put_loads(random_tape *tape, row_of row, const lag_tape_signature *of)
{
    for (uint32_t group = 0; group < LAG_TAPE_GROUPS; ++group) {
        const uint32_t length = (uint32_t)lag_tape_argument_length(tape->size, group);
        if ((of->arguments >> group & 1u) != 0 && length > 0 && length <= row.row - row.first) {
            const uint32_t first = any(&tape->seed, length - 1);
            const uint32_t count = any(&tape->seed, length - first);
            put_word(tape, LAG_TAPE_LOAD);
            put_word(tape, group);
            put_word(tape, first);
            put_word(tape, count);
            put_word(tape, row.first + any(&tape->seed, row.row - row.first - count));
        }
    }
}

static inline void put_stores(random_tape *tape, row_of row, const lag_tape_signature *of)
{
    for (uint32_t result = 0; result < of->count; ++result) {
        const uint32_t length = (uint32_t)lag_tape_result_length(tape->size, of, result);
        const int scattered = any(&tape->seed, 1) == 0;
        const uint32_t count = scattered ? any(&tape->seed, length) : length;
        put_word(tape, scattered ? LAG_TAPE_SCATTER : LAG_TAPE_STORE);
        put_word(tape, result);
        put_word(tape, scattered ? length : 0);
        put_word(tape, count);
        for (uint32_t i = 0; i < count && scattered; ++i) {
            put_word(tape, any(&tape->seed, length - 1));
        }
        put_reads(tape, row, count);
    }
}

static inline void put_function(random_tape *tape, const lag_tape_parts *parts, uint32_t which, row_of row)
{
    const lag_tape_signature *of = lag_tape_signature_of(parts, which);
    const uint32_t first = tape->words;
    if (which == 0) {
        put_word(tape, LAG_TAPE_CONSTANTS);
    }
    if (row.row > row.first) {
        put_word(tape, LAG_TAPE_TAN); /* nothing is read that was not written */
        put_word(tape, row.row - row.first);
        for (uint32_t place = row.first; place < row.row; ++place) {
            put_word(tape, place);
            put_word(tape, place % 4);
        }
        put_loads(tape, row, of);
        for (uint32_t i = any(&tape->seed, 8); i > 0; --i) {
            put_operation(tape, row);
        }
    }
    put_stores(tape, row, of);
    put_word(tape, LAG_TAPE_END);
    tape->function[which][0] = first;
    tape->function[which][1] = tape->words - first;
}

/* ---- tables ---- */

static inline void draw_sizes(random_tape *tape)
{
    uint32_t *n = tape->size;
    for (unsigned i = 0; i < LAG_TAPE_NUMBER_OF_SIZES; ++i) {
        n[i] = any(&tape->seed, 3);
    }
    n[LAG_TAPE_NGAP] += n[LAG_TAPE_NCONTACT];
    n[LAG_TAPE_RANK] = any(&tape->seed, n[LAG_TAPE_NC]);
    n[LAG_TAPE_NK] = any(&tape->seed, n[LAG_TAPE_NC] < 2 ? n[LAG_TAPE_NC] : 2);
    if (n[LAG_TAPE_NC] == 0) {
        n[LAG_TAPE_NCONTACT] = n[LAG_TAPE_NSWITCHED] = n[LAG_TAPE_NFRICTION] = 0;
    }
    n[LAG_TAPE_NSLIP] = n[LAG_TAPE_NFRICTION];
    if (2 * n[LAG_TAPE_NQ] + n[LAG_TAPE_NZ] == 0) {
        n[LAG_TAPE_NRESET] = 0;
    }
    n[LAG_TAPE_NW] = 1 + 2 * n[LAG_TAPE_NCONTACT] + n[LAG_TAPE_NINDICATOR] + n[LAG_TAPE_NTIMED] + n[LAG_TAPE_NCLOCK] + 3 +
                     2 * n[LAG_TAPE_NFRICTION] + n[LAG_TAPE_NLOAD] + 2 * n[LAG_TAPE_NDELAY];
    n[LAG_TAPE_PREPARED] = 4 + any(&tape->seed, 4);
    n[LAG_TAPE_ROW] = n[LAG_TAPE_PREPARED] + 4 + any(&tape->seed, MOST_PLACES);
    n[LAG_TAPE_NAME] = 0;
}

static inline void put_functions(random_tape *tape, const lag_tape_parts *parts)
{
    uint32_t *n = tape->size;
    const int solved = n[LAG_TAPE_NK] > 0 || any(&tape->seed, 1) == 0;
    const uint32_t elimination = 1 + LAG_ELIMINATION;
    tape->function[elimination][1] = (uint32_t)solved; /* signatures depend on it */
    tape->told = any(&tape->seed, 1) == 0 && n[LAG_TAPE_NQ] + n[LAG_TAPE_NZ] > 0;
    for (uint32_t i = 0; i < LAG_TAPE_ALONG; ++i) {
        const row_of row = {i == 0 ? 0 : n[LAG_TAPE_PREPARED], n[LAG_TAPE_ROW]};
        if (i != elimination || solved) {
            put_function(tape, parts, i, row);
        }
    }
    if (any(&tape->seed, 1) == 0) {
        put_function(tape, parts, LAG_TAPE_JACOBIAN, (row_of){n[LAG_TAPE_PREPARED], n[LAG_TAPE_ROW]});
    }
    for (uint32_t part = 0; part < 2; ++part) {
        const uint32_t base = LAG_TAPE_ALONG + part * LAG_TAPE_ALONG_COUNT;
        uint32_t *own = n + LAG_TAPE_SHARED + 2 * part;
        if (any(&tape->seed, 1) == 0) {
            own[0] = own[1] = 0;
            continue;
        }
        own[0] = n[LAG_TAPE_PREPARED] + any(&tape->seed, 3);
        own[1] = own[0] + 1 + any(&tape->seed, MOST_PLACES);
        put_function(tape, parts, base + LAG_TAPE_PRIMAL, (row_of){n[LAG_TAPE_PREPARED], n[LAG_TAPE_ROW]});
        for (uint32_t i = LAG_TAPE_RESIDUAL_ALONG; i < LAG_TAPE_ALONG_COUNT; ++i) {
            const int of_equations = tape->told && part == 0 && i == LAG_TAPE_RESIDUAL_ALONG;
            if (of_equations || i != (solved ? LAG_TAPE_RESIDUAL_ALONG : LAG_TAPE_ACCELERATION_ALONG)) {
                put_function(tape, parts, base + i, (row_of){own[0], own[1]});
            }
        }
    }
}

/* So many entries below `limit`, ascending where there may be no two the same. */
static inline void put_rows(random_tape *tape, uint32_t count, uint32_t limit)
{
    uint32_t rows[64];
    for (uint32_t i = 0; i < count; ++i) {
        rows[i] = count <= limit ? i + (limit - count) : any(&tape->seed, limit - 1);
    }
    put_section(tape, rows, count * sizeof *rows);
}

static inline void put_kinds(random_tape *tape)
{
    const uint32_t *n = tape->size;
    const uint32_t counts[LAG_KIND_LOAD + 1] = {[LAG_KIND_VARIABLE] = 1, [LAG_KIND_CONTACT] = n[LAG_TAPE_NCONTACT],
        [LAG_KIND_IMPACTS] = n[LAG_TAPE_NCONTACT], [LAG_KIND_RELATION] = n[LAG_TAPE_NINDICATOR],
        [LAG_KIND_TIMED] = n[LAG_TAPE_NTIMED], [LAG_KIND_CONDITION] = 1, [LAG_KIND_CLOCK] = n[LAG_TAPE_NCLOCK],
        [LAG_KIND_INITIAL] = 1, [LAG_KIND_TERMINAL] = 1, [LAG_KIND_STICKS] = n[LAG_TAPE_NFRICTION],
        [LAG_KIND_DIRECTION] = n[LAG_TAPE_NSLIP], [LAG_KIND_LOAD] = n[LAG_TAPE_NLOAD], [LAG_KIND_DELAY] = n[LAG_TAPE_NDELAY],
        [LAG_KIND_DELAY_RATE] = n[LAG_TAPE_NDELAY]};
    unsigned char kinds[64];
    uint32_t end = 0;
    for (unsigned kind = 0; kind <= LAG_KIND_LOAD; ++kind) {
        for (uint32_t i = 0; i < counts[kind]; ++i) {
            kinds[end++] = (unsigned char)kind;
        }
    }
    CHECK(end == n[LAG_TAPE_NW]);
    put_section(tape, kinds, end);
}

/* Rows and columns of `least` or more entries of a matrix, in any order. */
static inline void put_pattern(random_tape *tape, uint32_t least, uint32_t rows, uint32_t columns)
{
    const uint32_t most = rows * columns < 64 ? rows * columns : 64;
    const uint32_t entries = least + any(&tape->seed, most - least);
    put_rows(tape, entries, rows);
    put_rows(tape, entries, columns);
}

/* The tape of another random model, in `bytes`; returns its length. */
static inline size_t write_random_tape(random_tape *tape)
{
    static const double numbers[64] = {1.0, -1.0, 0.5, 1e5, 1e6, -2.0};
    static const unsigned char flags[64] = {1, 0, 1};
    static const uint32_t ones[8] = {1, 1, 1, 1, 1, 1, 1, 1};
    static const char texts[] = "Model\0x\0m/s\0place:1";
    uint32_t indices[3 * 128];
    lag_tape_parts parts = {.size = tape->size};
    uint32_t *n = tape->size;
    tape->count = HEAD_BYTES + 8 * LAG_TAPE_SECTIONS;
    tape->section = 0;
    tape->words = 0;
    memset(tape->function, 0, sizeof tape->function);
    draw_sizes(tape);
    parts.part[LAG_TAPE_FUNCTIONS].bytes = (const void *)tape->function;
    put_functions(tape, &parts);
    const uint32_t state = 2 * n[LAG_TAPE_NQ] + n[LAG_TAPE_NZ];
    const int started = any(&tape->seed, 1) == 0;
    put_section(tape, n, sizeof tape->size);
    put_section(tape, numbers, 4 * sizeof(double));
    put_section(tape, numbers, n[LAG_TAPE_NP] * sizeof(double));
    put_section(tape, flags, n[LAG_TAPE_NC]);
    put_section(tape, flags, n[LAG_TAPE_NC]);
    put_kinds(tape);
    put_section(tape, flags, n[LAG_TAPE_NINDICATOR]);
    put_section(tape, flags, n[LAG_TAPE_NINDICATOR]);
    put_section(tape, flags, any(&tape->seed, 1) == 0 ? n[LAG_TAPE_NU] : 0);
    put_section(tape, flags, any(&tape->seed, 1) == 0 ? n[LAG_TAPE_NCONTACT] : 0);
    put_rows(tape, n[LAG_TAPE_NK], n[LAG_TAPE_NC]);
    put_rows(tape, n[LAG_TAPE_NCONTACT], n[LAG_TAPE_NC]);
    put_rows(tape, n[LAG_TAPE_NSLIP], n[LAG_TAPE_NC]);
    put_section(tape, ones, n[LAG_TAPE_NFRICTION] * sizeof *ones);
    put_rows(tape, n[LAG_TAPE_NFRICTION], n[LAG_TAPE_NCONTACT] + 1);
    put_rows(tape, n[LAG_TAPE_NSWITCHED], n[LAG_TAPE_NC]);
    put_rows(tape, n[LAG_TAPE_NRESET], state);
    put_pattern(tape, 0, n[LAG_TAPE_NC], n[LAG_TAPE_NQ]);
    put_pattern(tape, 0, n[LAG_TAPE_NK], n[LAG_TAPE_NQ]);
    put_pattern(tape, 0, n[LAG_TAPE_NK], n[LAG_TAPE_NK]);
    const uint32_t members = n[LAG_TAPE_NQ] + n[LAG_TAPE_NZ];
    const uint32_t equations = members + n[LAG_TAPE_NC];
    const uint32_t values = n[LAG_TAPE_NQ] + n[LAG_TAPE_NC];
    const uint32_t told = (uint32_t)tape->told;
    put_pattern(tape, told, told * equations, state + values);
    put_rows(tape, told * equations, equations);
    put_rows(tape, told * state, state);
    put_rows(tape, told * values, values);
    put_rows(tape, any(&tape->seed, 1) == 0 ? members : 0, members);
    put_section(tape, numbers, started ? (1 + state) * sizeof(double) : 0);
    put_section(tape, flags, started ? state : 0);
    put_section(tape, flags, 0);
    put_section(tape, numbers, started ? state * sizeof(double) : 0);
    put_section(tape, numbers, 0);
    put_section(tape, numbers, started ? n[LAG_TAPE_NQ] * sizeof(double) : 0);
    put_section(tape, flags, started ? n[LAG_TAPE_NP] : 0);
    for (int i = 0; i < 3; ++i) {
        put_section(tape, numbers, started ? n[LAG_TAPE_NP] * sizeof(double) : 0);
    }
    const uint32_t slots = n[LAG_TAPE_NQ] + n[LAG_TAPE_NZ] + n[LAG_TAPE_NU] + n[LAG_TAPE_NW] + n[LAG_TAPE_NP] + n[LAG_TAPE_NC] +
                           n[LAG_TAPE_NY] + n[LAG_TAPE_NI] + n[LAG_TAPE_ND];
    for (uint32_t i = 0; i < 3 * slots; ++i) {
        indices[i] = i % 3 == 2 && any(&tape->seed, 1) == 0 ? 0xFFFFFFFFu : any(&tape->seed, sizeof texts - 1);
    }
    put_section(tape, indices, 3 * slots * sizeof *indices);
    const uint32_t messages = n[LAG_TAPE_NA] + n[LAG_TAPE_NFRICTION] + n[LAG_TAPE_NRESET] + n[LAG_TAPE_NSTOP] + n[LAG_TAPE_NFAIL];
    memset(indices, 0, sizeof indices);
    put_section(tape, indices, messages * sizeof *indices);
    put_section(tape, texts, sizeof texts);
    put_section(tape, tape->function, sizeof tape->function);
    put_section(tape, tape->word, tape->words * sizeof(uint32_t));
    CHECK(tape->section == LAG_TAPE_SECTIONS);
    memcpy(tape->bytes, "lagtape\n", 8);
    const uint32_t version = LAG_TAPE_VERSION;
    memcpy(tape->bytes + 8, &version, sizeof version);
    seal(tape->bytes, tape->count);
    return tape->count;
}

#endif
