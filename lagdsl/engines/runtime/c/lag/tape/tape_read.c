/* The sections of a tape, found and compared with one another. */
#include <string.h>

#include "lag/tape/tape_model.h"

enum { HEAD = 24, LENGTHS = 8 * LAG_TAPE_SECTIONS };

/* No size is larger, so that products of two and sums of many of them are numbers of 64 bits. */
static const uint32_t LARGEST = 1u << 27;
static const uint32_t NOWHERE = 0xFFFFFFFFu;
static const uint64_t MAGIC = 0x0A6570617467616Cu; /* lagtape\n */

/* Of ISO 3309, four bits at a time. */
static uint32_t checksum(const unsigned char *bytes, size_t count)
{
    static const uint32_t table[16] = {
        0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC, 0x76DC4190, 0x6B6B51F4, 0x4DB26158, 0x5005713C,
        0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C, 0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C};
    uint32_t sum = 0xFFFFFFFFu;
    for (size_t i = 0; i < count; ++i) {
        sum ^= bytes[i];
        sum = (sum >> 4) ^ table[sum & 15u];
        sum = (sum >> 4) ^ table[sum & 15u];
    }
    return ~sum;
}

static uint64_t number_at(const unsigned char *bytes)
{
    uint64_t number;
    memcpy(&number, bytes, sizeof number);
    return number;
}

/* ---- sections ---- */

int lag_tape_divide(const unsigned char *bytes, size_t count, lag_tape_parts *parts)
{
    uint64_t left = count - HEAD - LENGTHS;
    const unsigned char *next = bytes + HEAD + LENGTHS;
    for (size_t i = 0; i < LAG_TAPE_SECTIONS; ++i) {
        const uint64_t length = number_at(bytes + HEAD + 8 * i);
        if (length > left) {
            return 0;
        }
        const uint64_t padded = (length + 7) / 8 * 8;
        if (padded > left) {
            return 0;
        }
        parts->part[i] = (lag_tape_part){next, length};
        next += padded;
        left -= padded;
    }
    parts->size = (const void *)parts->part[LAG_TAPE_SIZES].bytes;
    return left == 0;
}

static int holds(const lag_tape_parts *parts, lag_tape_section section, uint64_t entries, size_t width)
{
    return parts->part[section].length == entries * width;
}

/* A section that may be left out. */
static int may_hold(const lag_tape_parts *parts, lag_tape_section section, uint64_t entries, size_t width)
{
    return parts->part[section].length == 0 || holds(parts, section, entries, width);
}

static uint64_t slots(const uint32_t *size)
{
    static const unsigned char named[] = {LAG_TAPE_NQ, LAG_TAPE_NZ, LAG_TAPE_NU, LAG_TAPE_NW, LAG_TAPE_NP,
        LAG_TAPE_NC, LAG_TAPE_NY, LAG_TAPE_NI, LAG_TAPE_ND};
    uint64_t count = 0;
    for (size_t i = 0; i < sizeof named; ++i) {
        count += size[named[i]];
    }
    return count;
}

static uint64_t messages(const uint32_t *size)
{
    return (uint64_t)size[LAG_TAPE_NA] + size[LAG_TAPE_NFRICTION] + size[LAG_TAPE_NRESET] + size[LAG_TAPE_NSTOP] + size[LAG_TAPE_NFAIL];
}

uint64_t lag_tape_pattern_length(const lag_tape_parts *parts, lag_tape_section rows)
{
    return parts->part[rows].length / sizeof(uint32_t);
}

/* Numbers of a pattern of so many rows, with the first entry of each; none where it is not told. */
static uint64_t pattern(const lag_tape_parts *parts, lag_tape_section rows, uint64_t count)
{
    const uint64_t length = lag_tape_pattern_length(parts, rows);
    return length > 0 ? 2 * length + count + 1 : 0;
}

uint64_t lag_tape_components_length(const lag_tape_parts *parts)
{
    return parts->part[LAG_TAPE_COMPONENTS].length / sizeof(uint32_t);
}

static uint64_t rows(const lag_tape_parts *parts)
{
    const uint32_t *size = parts->size;
    const uint64_t listed = (uint64_t)size[LAG_TAPE_NK] + size[LAG_TAPE_NCONTACT] + size[LAG_TAPE_NSLIP] +
                            2 * (uint64_t)size[LAG_TAPE_NFRICTION] + size[LAG_TAPE_NSWITCHED] + size[LAG_TAPE_NRESET];
    return listed + pattern(parts, LAG_TAPE_JACOBIAN_ROWS, size[LAG_TAPE_NC]) + pattern(parts, LAG_TAPE_RESPONSE_ROWS, size[LAG_TAPE_NK]) +
           pattern(parts, LAG_TAPE_COUPLING_ROWS, size[LAG_TAPE_NK]) +
           pattern(parts, LAG_TAPE_EQUATIONS_ROWS, (uint64_t)size[LAG_TAPE_NQ] + size[LAG_TAPE_NZ] + size[LAG_TAPE_NC]) +
           (parts->part[LAG_TAPE_EQUATIONS_PLACES].length + parts->part[LAG_TAPE_EQUATIONS_GROUPS].length +
               parts->part[LAG_TAPE_EQUATIONS_VALUE_GROUPS].length) / sizeof(uint32_t) +
           lag_tape_components_length(parts);
}

/* Entries of a matrix, in the section of their rows and the one behind it, that can be nonzero. */
static int pattern_agrees(const lag_tape_parts *parts, lag_tape_section rows, uint64_t count, uint64_t width)
{
    const uint64_t length = lag_tape_pattern_length(parts, rows);
    return length <= count * width && holds(parts, rows, length, sizeof(uint32_t)) && holds(parts, rows + 1, length, sizeof(uint32_t));
}

/* Entries of the derivatives of the equations, with their order and the groups of columns. */
static int equations_agree(const lag_tape_parts *parts)
{
    const uint32_t *n = parts->size;
    const uint64_t rows = (uint64_t)n[LAG_TAPE_NQ] + n[LAG_TAPE_NZ] + n[LAG_TAPE_NC];
    const uint64_t values = (uint64_t)n[LAG_TAPE_NQ] + n[LAG_TAPE_NC];
    const uint64_t state = 2 * (uint64_t)n[LAG_TAPE_NQ] + n[LAG_TAPE_NZ];
    const int told = lag_tape_pattern_length(parts, LAG_TAPE_EQUATIONS_ROWS) > 0;
    return pattern_agrees(parts, LAG_TAPE_EQUATIONS_ROWS, rows, state + values) &&
           holds(parts, LAG_TAPE_EQUATIONS_PLACES, told ? rows : 0, sizeof(uint32_t)) &&
           holds(parts, LAG_TAPE_EQUATIONS_GROUPS, told ? state : 0, sizeof(uint32_t)) &&
           holds(parts, LAG_TAPE_EQUATIONS_VALUE_GROUPS, told ? values : 0, sizeof(uint32_t));
}

static int sizes_agree(const lag_tape_parts *parts)
{
    const uint32_t *n = parts->size;
    const uint64_t state = 2 * (uint64_t)n[LAG_TAPE_NQ] + n[LAG_TAPE_NZ];
    const size_t word = sizeof(uint32_t);
    return parts->part[LAG_TAPE_CONSTANT_POOL].length % sizeof(double) == 0 &&
           holds(parts, LAG_TAPE_DEFAULTS, n[LAG_TAPE_NP], sizeof(double)) &&
           holds(parts, LAG_TAPE_POSITION_LEVEL, n[LAG_TAPE_NC], 1) && holds(parts, LAG_TAPE_REDUNDANT, n[LAG_TAPE_NC], 1) &&
           holds(parts, LAG_TAPE_KINDS, n[LAG_TAPE_NW], 1) && holds(parts, LAG_TAPE_STRICT, n[LAG_TAPE_NINDICATOR], 1) &&
           holds(parts, LAG_TAPE_JUMPING, n[LAG_TAPE_NINDICATOR], 1) &&
           may_hold(parts, LAG_TAPE_WHOLE_INPUTS, n[LAG_TAPE_NU], 1) && holds(parts, LAG_TAPE_KEPT_ROWS, n[LAG_TAPE_NK], word) &&
           holds(parts, LAG_TAPE_CONTACT_ROWS, n[LAG_TAPE_NCONTACT], word) &&
           may_hold(parts, LAG_TAPE_ONE_WAY, n[LAG_TAPE_NCONTACT], 1) &&
           holds(parts, LAG_TAPE_FRICTION_ROWS, n[LAG_TAPE_NSLIP], word) &&
           holds(parts, LAG_TAPE_FRICTION_SLIPS, n[LAG_TAPE_NFRICTION], word) &&
           holds(parts, LAG_TAPE_FRICTION_CONTACTS, n[LAG_TAPE_NFRICTION], word) &&
           holds(parts, LAG_TAPE_SWITCHED_ROWS, n[LAG_TAPE_NSWITCHED], word) &&
           holds(parts, LAG_TAPE_RESET_PLACES, n[LAG_TAPE_NRESET], word) &&
           pattern_agrees(parts, LAG_TAPE_JACOBIAN_ROWS, n[LAG_TAPE_NC], n[LAG_TAPE_NQ]) &&
           pattern_agrees(parts, LAG_TAPE_RESPONSE_ROWS, n[LAG_TAPE_NK], n[LAG_TAPE_NQ]) &&
           pattern_agrees(parts, LAG_TAPE_COUPLING_ROWS, n[LAG_TAPE_NK], n[LAG_TAPE_NK]) &&
           equations_agree(parts) &&
           may_hold(parts, LAG_TAPE_COMPONENTS, (uint64_t)n[LAG_TAPE_NQ] + n[LAG_TAPE_NZ], word) &&
           may_hold(parts, LAG_TAPE_START_STATE, 1 + state, sizeof(double)) &&
           may_hold(parts, LAG_TAPE_START_FIXED, state, 1) && may_hold(parts, LAG_TAPE_START_WRITTEN, state, 1) &&
           may_hold(parts, LAG_TAPE_START_NOMINAL, state, sizeof(double)) &&
           may_hold(parts, LAG_TAPE_START_MINIMUM, n[LAG_TAPE_NQ], sizeof(double)) &&
           may_hold(parts, LAG_TAPE_START_MAXIMUM, n[LAG_TAPE_NQ], sizeof(double)) &&
           may_hold(parts, LAG_TAPE_START_FREE, n[LAG_TAPE_NP], 1) &&
           may_hold(parts, LAG_TAPE_START_PARAMETER_NOMINAL, n[LAG_TAPE_NP], sizeof(double)) &&
           may_hold(parts, LAG_TAPE_START_PARAMETER_MINIMUM, n[LAG_TAPE_NP], sizeof(double)) &&
           may_hold(parts, LAG_TAPE_START_PARAMETER_MAXIMUM, n[LAG_TAPE_NP], sizeof(double)) &&
           holds(parts, LAG_TAPE_SLOTS, 3 * slots(n), word) && holds(parts, LAG_TAPE_MESSAGES, messages(n), word) &&
           holds(parts, LAG_TAPE_FUNCTIONS, 2 * (LAG_TAPE_FUNCTION_COUNT - (lag_tape_parts_have(parts, LAG_TAPE_JACOBIAN) ? 0 : 1)), word) &&
           parts->part[LAG_TAPE_WORDS].length % word == 0;
}

/* ---- what they hold ---- */

static int below(const lag_tape_parts *parts, lag_tape_section section, uint64_t limit)
{
    const uint32_t *entry = (const void *)parts->part[section].bytes;
    const uint64_t count = parts->part[section].length / sizeof *entry;
    for (uint64_t i = 0; i < count; ++i) {
        if (entry[i] >= limit) {
            return 0;
        }
    }
    return 1;
}

static int texts_end(const lag_tape_parts *parts)
{
    const lag_tape_part *texts = &parts->part[LAG_TAPE_TEXTS];
    const uint32_t *slot = (const void *)parts->part[LAG_TAPE_SLOTS].bytes;
    if (texts->length == 0 || texts->bytes[texts->length - 1] != 0 || parts->size[LAG_TAPE_NAME] >= texts->length) {
        return 0;
    }
    for (uint64_t i = 0; i < 3 * slots(parts->size); ++i) {
        if (slot[i] >= texts->length && !(i % 3 == 2 && slot[i] == NOWHERE)) {
            return 0;
        }
    }
    return below(parts, LAG_TAPE_MESSAGES, texts->length);
}

/* Kinds stand in their order, as many of each as there are contacts, frictions, relations, delays, clocks and loads. */
static int kinds_agree(const lag_tape_parts *parts)
{
    const uint32_t *n = parts->size;
    const unsigned char *kind = parts->part[LAG_TAPE_KINDS].bytes;
    uint32_t found[LAG_KIND_LOAD + 1] = {0};
    for (uint32_t i = 0; i < n[LAG_TAPE_NW]; ++i) {
        if (kind[i] > LAG_KIND_LOAD || (i > 0 && kind[i] < kind[i - 1])) {
            return 0;
        }
        ++found[kind[i]];
    }
    return found[LAG_KIND_CONTACT] == n[LAG_TAPE_NCONTACT] && found[LAG_KIND_IMPACTS] == n[LAG_TAPE_NCONTACT] &&
           found[LAG_KIND_RELATION] == n[LAG_TAPE_NINDICATOR] && found[LAG_KIND_TIMED] == n[LAG_TAPE_NTIMED] &&
           found[LAG_KIND_CLOCK] == n[LAG_TAPE_NCLOCK] && found[LAG_KIND_STICKS] == n[LAG_TAPE_NFRICTION] &&
           found[LAG_KIND_DIRECTION] == n[LAG_TAPE_NSLIP] && found[LAG_KIND_LOAD] == n[LAG_TAPE_NLOAD] &&
           found[LAG_KIND_DELAY] == n[LAG_TAPE_NDELAY] && found[LAG_KIND_DELAY_RATE] == n[LAG_TAPE_NDELAY];
}

/* The functions of several directions are all there that the model needs, with rows that fit; or none is. */
static int along_agrees(const lag_tape_parts *parts, unsigned part)
{
    const uint32_t *n = parts->size;
    const uint32_t *table = (const void *)parts->part[LAG_TAPE_FUNCTIONS].bytes;
    const uint32_t *own = table + 2 * (LAG_TAPE_ALONG + part * LAG_TAPE_ALONG_COUNT);
    const uint32_t shared = n[LAG_TAPE_SHARED + 2 * part];
    const uint32_t row = n[LAG_TAPE_ALONG_ROW + 2 * part];
    const int solved = table[2 * (1 + LAG_ELIMINATION) + 1] > 0;
    const int of_equations = part == 0 && lag_tape_pattern_length(parts, LAG_TAPE_EQUATIONS_ROWS) > 0;
    int there[LAG_TAPE_ALONG_COUNT];
    int any = 0;
    for (unsigned i = 0; i < LAG_TAPE_ALONG_COUNT; ++i) {
        there[i] = own[2 * i + 1] > 0;
        any |= there[i];
    }
    if (!any) {
        return shared == 0 && row == 0;
    }
    return there[LAG_TAPE_PRIMAL] && there[LAG_TAPE_RESIDUAL_ALONG] == (!solved || of_equations) && there[LAG_TAPE_ACCELERATION_ALONG] == solved &&
           (there[LAG_TAPE_RATES_ALONG] || n[LAG_TAPE_NZ] == 0) && (there[LAG_TAPE_OUTPUT_ALONG] || n[LAG_TAPE_NY] == 0) &&
           n[LAG_TAPE_PREPARED] <= shared && shared <= n[LAG_TAPE_ROW] && shared <= row;
}

/* Each friction has one or two slips, which are all of them, and acts under a contact that is there. */
static int frictions_agree(const lag_tape_parts *parts)
{
    const uint32_t *n = parts->size;
    const uint32_t *slips = (const void *)parts->part[LAG_TAPE_FRICTION_SLIPS].bytes;
    uint64_t count = 0;
    for (uint32_t i = 0; i < n[LAG_TAPE_NFRICTION]; ++i) {
        if (slips[i] < 1 || slips[i] > 2) {
            return 0;
        }
        count += slips[i];
    }
    return count == n[LAG_TAPE_NSLIP] && below(parts, LAG_TAPE_FRICTION_ROWS, n[LAG_TAPE_NC]) &&
           below(parts, LAG_TAPE_FRICTION_CONTACTS, (uint64_t)n[LAG_TAPE_NCONTACT] + 1);
}

static int rows_agree(const lag_tape_parts *parts)
{
    const uint32_t *n = parts->size;
    const uint64_t rates = (uint64_t)n[LAG_TAPE_NQ] + n[LAG_TAPE_NZ];
    const uint64_t state = rates + n[LAG_TAPE_NQ];
    const uint64_t values = (uint64_t)n[LAG_TAPE_NQ] + n[LAG_TAPE_NC];
    const uint32_t *kept = (const void *)parts->part[LAG_TAPE_KEPT_ROWS].bytes;
    for (uint32_t i = 1; i < n[LAG_TAPE_NK]; ++i) {
        if (kept[i] <= kept[i - 1]) {
            return 0;
        }
    }
    return n[LAG_TAPE_RANK] <= n[LAG_TAPE_NC] && n[LAG_TAPE_NGAP] >= n[LAG_TAPE_NCONTACT] &&
           n[LAG_TAPE_PREPARED] <= n[LAG_TAPE_ROW] && along_agrees(parts, 0) && along_agrees(parts, 1) && below(parts, LAG_TAPE_KEPT_ROWS, n[LAG_TAPE_NC]) &&
           frictions_agree(parts) && below(parts, LAG_TAPE_CONTACT_ROWS, n[LAG_TAPE_NC]) && below(parts, LAG_TAPE_SWITCHED_ROWS, n[LAG_TAPE_NC]) &&
           below(parts, LAG_TAPE_JACOBIAN_ROWS, n[LAG_TAPE_NC]) && below(parts, LAG_TAPE_JACOBIAN_COLUMNS, n[LAG_TAPE_NQ]) &&
           below(parts, LAG_TAPE_RESPONSE_ROWS, n[LAG_TAPE_NK]) && below(parts, LAG_TAPE_RESPONSE_COLUMNS, n[LAG_TAPE_NQ]) &&
           below(parts, LAG_TAPE_COUPLING_ROWS, n[LAG_TAPE_NK]) && below(parts, LAG_TAPE_COUPLING_COLUMNS, n[LAG_TAPE_NK]) &&
           below(parts, LAG_TAPE_COMPONENTS, rates) && below(parts, LAG_TAPE_EQUATIONS_ROWS, rates + n[LAG_TAPE_NC]) &&
           below(parts, LAG_TAPE_EQUATIONS_PLACES, rates + n[LAG_TAPE_NC]) && below(parts, LAG_TAPE_EQUATIONS_COLUMNS, state + values) &&
           below(parts, LAG_TAPE_EQUATIONS_GROUPS, state) && below(parts, LAG_TAPE_EQUATIONS_VALUE_GROUPS, values) &&
           below(parts, LAG_TAPE_RESET_PLACES, state);
}

/* True if all functions are there that every model has, and those that this model requires. */
static int functions_there(const lag_tape_parts *parts)
{
    const uint32_t *n = parts->size;
    const uint32_t *table = (const void *)parts->part[LAG_TAPE_FUNCTIONS].bytes;
    const int by_columns = table[2 * (1 + LAG_MOMENTUM_TANGENT) + 1] > 0;
    for (unsigned i = 0; i <= LAG_LAST_FUNCTION; ++i) {
        const int written_out = i == LAG_MASS_MATRIX || i == LAG_DYNAMICS;
        const int every = i < LAG_ELIMINATION && !(written_out && by_columns);
        const int of_events = i >= LAG_DISCRETE_START && i <= LAG_TIME_EVENT && n[LAG_TAPE_NW] > 0;
        const int of_forces = (i == LAG_FRICTION && n[LAG_TAPE_NFRICTION] > 0) || (i >= LAG_LOAD && i <= LAG_LOAD_GAIN && n[LAG_TAPE_NLOAD] > 0);
        const int of_delays = i == LAG_DELAYED && n[LAG_TAPE_NDELAY] > 0;
        const int of_kept = i == LAG_ELIMINATION && n[LAG_TAPE_NK] > 0;
        const int named = i == LAG_DEFINITION && n[LAG_TAPE_ND] > 0;
        if ((every || of_events || of_forces || of_delays || of_kept || named) && table[2 * (1 + i) + 1] == 0) {
            return 0;
        }
    }
    return 1;
}

/* ---- memory ---- */

/* Bytes of the model: its structure, slots, messages, rows; each of them takes multiples of 8. */
static uint64_t needed(const lag_tape_parts *parts)
{
    const uint32_t *size = parts->size;
    const uint64_t head = (sizeof(lag_tape) + 7) / 8 * 8;
    const uint64_t tables = slots(size) * sizeof(lag_slot) + messages(size) * sizeof(char *) + rows(parts) * sizeof(size_t);
    return head + (tables + 7) / 8 * 8;
}

uint64_t lag_tape_workspace(const uint32_t *size)
{
    return (uint64_t)size[LAG_TAPE_ROW] + 5 * (uint64_t)size[LAG_TAPE_NQ] + size[LAG_TAPE_NC];
}

/* More than any workspace has. */
static uint64_t largest_workspace(const uint32_t *size)
{
    return lag_tape_workspace(size) + 8 + 8 * ((uint64_t)size[LAG_TAPE_ROW] + size[LAG_TAPE_ALONG_ROW] + size[LAG_TAPE_PARAMETER_ALONG_ROW]);
}

lag_status lag_tape_check(const void *bytes, size_t count, size_t *memory)
{
    const unsigned char *all = bytes;
    lag_tape_parts parts;
    uint32_t head[2]; /* version, checksum */
    *memory = 0;
    if ((uintptr_t)all % 8 != 0 || count < HEAD + LENGTHS || number_at(all) != MAGIC) {
        return LAG_BAD_STATE_DATA;
    }
    memcpy(head, all + sizeof MAGIC, sizeof head);
    if (head[0] != LAG_TAPE_VERSION || number_at(all + 16) != count - HEAD || checksum(all + HEAD, count - HEAD) != head[1] ||
        !lag_tape_divide(all, count, &parts) || !holds(&parts, LAG_TAPE_SIZES, LAG_TAPE_NUMBER_OF_SIZES, sizeof(uint32_t))) {
        return LAG_BAD_STATE_DATA;
    }
    for (size_t i = 0; i < LAG_TAPE_NUMBER_OF_SIZES; ++i) {
        if (parts.size[i] > LARGEST) {
            return LAG_BAD_STATE_DATA;
        }
    }
    if (!sizes_agree(&parts) || !texts_end(&parts) || !kinds_agree(&parts) || !rows_agree(&parts) ||
        !functions_there(&parts) || !lag_tape_runs(&parts) || needed(&parts) > SIZE_MAX / 2 ||
        largest_workspace(parts.size) > SIZE_MAX / 2 / sizeof(double)) {
        return LAG_BAD_STATE_DATA;
    }
    *memory = (size_t)needed(&parts);
    return LAG_OK;
}
