/* The sections of a tape: found, compared with one another, and laid out as a model. */
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

/* Where they are. Not: they do not fill `count` bytes exactly. */
static int divide(const unsigned char *bytes, size_t count, lag_tape_parts *parts)
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
    return (uint64_t)size[LAG_TAPE_NA] + size[LAG_TAPE_NRESET] + size[LAG_TAPE_NSTOP] + size[LAG_TAPE_NFAIL];
}

/* Entries of J that can be nonzero. */
static uint64_t pattern_length(const lag_tape_parts *parts)
{
    return parts->part[LAG_TAPE_JACOBIAN_ROWS].length / sizeof(uint32_t);
}

/* Coordinates and states whose component is told. */
static uint64_t components_length(const lag_tape_parts *parts)
{
    return parts->part[LAG_TAPE_COMPONENTS].length / sizeof(uint32_t);
}

static uint64_t rows(const lag_tape_parts *parts)
{
    const uint32_t *size = parts->size;
    const uint64_t listed = (uint64_t)size[LAG_TAPE_NK] + size[LAG_TAPE_NCONTACT] + size[LAG_TAPE_NSWITCHED] + size[LAG_TAPE_NRESET];
    return listed + 2 * pattern_length(parts) + components_length(parts);
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
           holds(parts, LAG_TAPE_KEPT_ROWS, n[LAG_TAPE_NK], word) &&
           holds(parts, LAG_TAPE_CONTACT_ROWS, n[LAG_TAPE_NCONTACT], word) &&
           holds(parts, LAG_TAPE_SWITCHED_ROWS, n[LAG_TAPE_NSWITCHED], word) &&
           holds(parts, LAG_TAPE_RESET_PLACES, n[LAG_TAPE_NRESET], word) &&
           pattern_length(parts) <= (uint64_t)n[LAG_TAPE_NC] * n[LAG_TAPE_NQ] &&
           holds(parts, LAG_TAPE_JACOBIAN_ROWS, pattern_length(parts), word) &&
           holds(parts, LAG_TAPE_JACOBIAN_COLUMNS, pattern_length(parts), word) &&
           may_hold(parts, LAG_TAPE_COMPONENTS, (uint64_t)n[LAG_TAPE_NQ] + n[LAG_TAPE_NZ], word) &&
           may_hold(parts, LAG_TAPE_START_STATE, 1 + state, sizeof(double)) &&
           may_hold(parts, LAG_TAPE_START_FIXED, state, 1) && may_hold(parts, LAG_TAPE_START_WRITTEN, state, 1) &&
           may_hold(parts, LAG_TAPE_START_NOMINAL, state, sizeof(double)) &&
           may_hold(parts, LAG_TAPE_START_MINIMUM, n[LAG_TAPE_NQ], sizeof(double)) &&
           may_hold(parts, LAG_TAPE_START_MAXIMUM, n[LAG_TAPE_NQ], sizeof(double)) &&
           holds(parts, LAG_TAPE_SLOTS, 3 * slots(n), word) && holds(parts, LAG_TAPE_MESSAGES, messages(n), word) &&
           holds(parts, LAG_TAPE_FUNCTIONS, 2 * LAG_TAPE_FUNCTION_COUNT, word) &&
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

/* Kinds stand in their order, as many of each as there are contacts, relations and clocks. */
static int kinds_agree(const lag_tape_parts *parts)
{
    const uint32_t *n = parts->size;
    const unsigned char *kind = parts->part[LAG_TAPE_KINDS].bytes;
    uint32_t found[LAG_KIND_TERMINAL + 1] = {0};
    for (uint32_t i = 0; i < n[LAG_TAPE_NW]; ++i) {
        if (kind[i] > LAG_KIND_TERMINAL || (i > 0 && kind[i] < kind[i - 1])) {
            return 0;
        }
        ++found[kind[i]];
    }
    return found[LAG_KIND_CONTACT] == n[LAG_TAPE_NCONTACT] && found[LAG_KIND_IMPACTS] == n[LAG_TAPE_NCONTACT] &&
           found[LAG_KIND_RELATION] == n[LAG_TAPE_NINDICATOR] && found[LAG_KIND_TIMED] == n[LAG_TAPE_NTIMED] &&
           found[LAG_KIND_CLOCK] == n[LAG_TAPE_NCLOCK];
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
    int there[LAG_TAPE_ALONG_COUNT];
    int any = 0;
    for (unsigned i = 0; i < LAG_TAPE_ALONG_COUNT; ++i) {
        there[i] = own[2 * i + 1] > 0;
        any |= there[i];
    }
    if (!any) {
        return shared == 0 && row == 0;
    }
    return there[LAG_TAPE_PRIMAL] && there[LAG_TAPE_RESIDUAL_ALONG] == !solved && there[LAG_TAPE_ACCELERATION_ALONG] == solved &&
           (there[LAG_TAPE_RATES_ALONG] || n[LAG_TAPE_NZ] == 0) && (there[LAG_TAPE_OUTPUT_ALONG] || n[LAG_TAPE_NY] == 0) &&
           n[LAG_TAPE_PREPARED] <= shared && shared <= n[LAG_TAPE_ROW] && shared <= row;
}

static int rows_agree(const lag_tape_parts *parts)
{
    const uint32_t *n = parts->size;
    const uint32_t *kept = (const void *)parts->part[LAG_TAPE_KEPT_ROWS].bytes;
    for (uint32_t i = 1; i < n[LAG_TAPE_NK]; ++i) {
        if (kept[i] <= kept[i - 1]) {
            return 0;
        }
    }
    return n[LAG_TAPE_RANK] <= n[LAG_TAPE_NC] && n[LAG_TAPE_NGAP] >= n[LAG_TAPE_NCONTACT] &&
           n[LAG_TAPE_PREPARED] <= n[LAG_TAPE_ROW] && along_agrees(parts, 0) && along_agrees(parts, 1) && below(parts, LAG_TAPE_KEPT_ROWS, n[LAG_TAPE_NC]) &&
           below(parts, LAG_TAPE_CONTACT_ROWS, n[LAG_TAPE_NC]) && below(parts, LAG_TAPE_SWITCHED_ROWS, n[LAG_TAPE_NC]) &&
           below(parts, LAG_TAPE_JACOBIAN_ROWS, n[LAG_TAPE_NC]) && below(parts, LAG_TAPE_JACOBIAN_COLUMNS, n[LAG_TAPE_NQ]) &&
           below(parts, LAG_TAPE_COMPONENTS, (uint64_t)n[LAG_TAPE_NQ] + n[LAG_TAPE_NZ]) &&
           below(parts, LAG_TAPE_RESET_PLACES, 2 * (uint64_t)n[LAG_TAPE_NQ] + n[LAG_TAPE_NZ]);
}

/* Those that every model has, and those that what it has asks for. */
static int functions_there(const lag_tape_parts *parts)
{
    const uint32_t *n = parts->size;
    const uint32_t *table = (const void *)parts->part[LAG_TAPE_FUNCTIONS].bytes;
    const int by_columns = table[2 * (1 + LAG_MOMENTUM_TANGENT) + 1] > 0;
    for (unsigned i = 0; i <= LAG_TIME_TANGENT; ++i) {
        const int written_out = i == LAG_MASS_MATRIX || i == LAG_DYNAMICS;
        const int every = i < LAG_ELIMINATION && !(written_out && by_columns);
        const int of_events = i >= LAG_DISCRETE_START && i <= LAG_TIME_EVENT && n[LAG_TAPE_NW] > 0;
        const int of_kept = i == LAG_ELIMINATION && n[LAG_TAPE_NK] > 0;
        const int named = i == LAG_DEFINITION && n[LAG_TAPE_ND] > 0;
        if ((every || of_events || of_kept || named) && table[2 * (1 + i) + 1] == 0) {
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

/* Doubles of the workspace of one state. */
static uint64_t workspace(const uint32_t *size)
{
    return (uint64_t)size[LAG_TAPE_ROW] + 2 * (uint64_t)size[LAG_TAPE_NQ] + size[LAG_TAPE_NC];
}

/* More than any workspace has. */
static uint64_t largest_workspace(const uint32_t *size)
{
    return workspace(size) + 8 + 8 * ((uint64_t)size[LAG_TAPE_ROW] + size[LAG_TAPE_ALONG_ROW] + size[LAG_TAPE_PARAMETER_ALONG_ROW]);
}

lag_status lag_tape_check(const void *bytes, size_t count, size_t *arena)
{
    const unsigned char *all = bytes;
    lag_tape_parts parts;
    uint32_t head[2]; /* version, checksum */
    *arena = 0;
    if ((uintptr_t)all % 8 != 0 || count < HEAD + LENGTHS || number_at(all) != MAGIC) {
        return LAG_BAD_STATE_DATA;
    }
    memcpy(head, all + sizeof MAGIC, sizeof head);
    if (head[0] != LAG_TAPE_VERSION || number_at(all + 16) != count - HEAD || checksum(all + HEAD, count - HEAD) != head[1] ||
        !divide(all, count, &parts) || !holds(&parts, LAG_TAPE_SIZES, LAG_TAPE_NUMBER_OF_SIZES, sizeof(uint32_t))) {
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
    *arena = (size_t)needed(&parts);
    return LAG_OK;
}

/* ---- the model ---- */

static const char *text(const lag_tape_parts *parts, uint32_t first)
{
    return first == NOWHERE ? NULL : (const char *)parts->part[LAG_TAPE_TEXTS].bytes + first;
}

/* The next `count` slots; none: null. */
static const lag_slot *take_slots(const lag_tape_parts *parts, const uint32_t **from, lag_slot **to, size_t count)
{
    lag_slot *first = *to;
    for (size_t i = 0; i < count; ++i) {
        first[i] = (lag_slot){text(parts, (*from)[0]), text(parts, (*from)[1]), text(parts, (*from)[2])};
        *from += 3;
    }
    *to += count;
    return count > 0 ? first : NULL;
}

static const char *const *take_texts(const lag_tape_parts *parts, const uint32_t **from, const char ***to, size_t count)
{
    const char **first = *to;
    for (size_t i = 0; i < count; ++i) {
        first[i] = text(parts, *(*from)++);
    }
    *to += count;
    return count > 0 ? first : NULL;
}

static const size_t *take_rows(const lag_tape_parts *parts, lag_tape_section section, size_t **to, size_t count)
{
    const uint32_t *from = (const void *)parts->part[section].bytes;
    size_t *first = *to;
    for (size_t i = 0; i < count; ++i) {
        first[i] = from[i];
    }
    *to += count;
    return count > 0 ? first : NULL;
}

/* A section as it stands; null where it is empty. */
static const void *section(const lag_tape_parts *parts, lag_tape_section which)
{
    return parts->part[which].length > 0 ? parts->part[which].bytes : NULL;
}

static void give_sizes(lag_model *model, const uint32_t *size)
{
    model->nq = size[LAG_TAPE_NQ];
    model->nz = size[LAG_TAPE_NZ];
    model->nu = size[LAG_TAPE_NU];
    model->nw = size[LAG_TAPE_NW];
    model->np = size[LAG_TAPE_NP];
    model->nc = size[LAG_TAPE_NC];
    model->ny = size[LAG_TAPE_NY];
    model->ni = size[LAG_TAPE_NI];
    model->na = size[LAG_TAPE_NA];
    model->nd = size[LAG_TAPE_ND];
    model->ne = size[LAG_TAPE_NE];
    model->rank = size[LAG_TAPE_RANK];
    model->nk = size[LAG_TAPE_NK];
    model->nindicator = size[LAG_TAPE_NINDICATOR];
    model->ncontact = size[LAG_TAPE_NCONTACT];
    model->ngap = size[LAG_TAPE_NGAP];
    model->nclock = size[LAG_TAPE_NCLOCK];
    model->nreset = size[LAG_TAPE_NRESET];
    model->ncollision = size[LAG_TAPE_NCOLLISION];
    model->nstop = size[LAG_TAPE_NSTOP];
    model->nfail = size[LAG_TAPE_NFAIL];
    model->ntimed = size[LAG_TAPE_NTIMED];
    model->ndistance = size[LAG_TAPE_NDISTANCE];
    model->ncorner = size[LAG_TAPE_NCORNER];
    model->nswitched = size[LAG_TAPE_NSWITCHED];
    model->prepared = size[LAG_TAPE_PREPARED];
    model->workspace = (size_t)workspace(size);
}

/* Slots, messages and rows, in this order, in `memory`. */
static void give_tables(lag_tape *tape, const lag_tape_parts *parts, unsigned char *arena)
{
    lag_model *model = &tape->model;
    const uint32_t *slot = (const void *)parts->part[LAG_TAPE_SLOTS].bytes;
    const uint32_t *message = (const void *)parts->part[LAG_TAPE_MESSAGES].bytes;
    lag_slot *slot_memory = (void *)arena;
    model->coordinates = take_slots(parts, &slot, &slot_memory, model->nq);
    model->states = take_slots(parts, &slot, &slot_memory, model->nz);
    model->inputs = take_slots(parts, &slot, &slot_memory, model->nu);
    model->discretes = take_slots(parts, &slot, &slot_memory, model->nw);
    model->parameters = take_slots(parts, &slot, &slot_memory, model->np);
    model->constraints = take_slots(parts, &slot, &slot_memory, model->nc);
    model->outputs = take_slots(parts, &slot, &slot_memory, model->ny);
    model->invariants = take_slots(parts, &slot, &slot_memory, model->ni);
    model->definitions = take_slots(parts, &slot, &slot_memory, model->nd);
    const char **message_memory = (void *)slot_memory;
    model->assertions = take_texts(parts, &message, &message_memory, model->na);
    model->resets = take_texts(parts, &message, &message_memory, model->nreset);
    model->stops = take_texts(parts, &message, &message_memory, model->nstop);
    model->failures = take_texts(parts, &message, &message_memory, model->nfail);
    size_t *row_memory = (void *)message_memory;
    model->kept_rows = take_rows(parts, LAG_TAPE_KEPT_ROWS, &row_memory, model->nk);
    model->contact_rows = take_rows(parts, LAG_TAPE_CONTACT_ROWS, &row_memory, model->ncontact);
    model->switched_rows = take_rows(parts, LAG_TAPE_SWITCHED_ROWS, &row_memory, model->nswitched);
    model->reset_places = take_rows(parts, LAG_TAPE_RESET_PLACES, &row_memory, model->nreset);
    tape->pattern = (lag_pattern){.rows = model->nc, .columns = model->nq, .count = (size_t)pattern_length(parts)};
    tape->pattern.row = take_rows(parts, LAG_TAPE_JACOBIAN_ROWS, &row_memory, tape->pattern.count);
    tape->pattern.column = take_rows(parts, LAG_TAPE_JACOBIAN_COLUMNS, &row_memory, tape->pattern.count);
    model->jacobian_pattern = tape->pattern.count > 0 ? &tape->pattern : NULL;
    model->components = take_rows(parts, LAG_TAPE_COMPONENTS, &row_memory, (size_t)components_length(parts));
    model->defaults = section(parts, LAG_TAPE_DEFAULTS);
    model->position_level = section(parts, LAG_TAPE_POSITION_LEVEL);
    model->redundant = section(parts, LAG_TAPE_REDUNDANT);
    model->kinds = section(parts, LAG_TAPE_KINDS);
    model->strict = section(parts, LAG_TAPE_STRICT);
}

static void give_start(lag_start *start, const lag_tape_parts *parts)
{
    const double *state = section(parts, LAG_TAPE_START_STATE);
    if (state != NULL) {
        start->t = state[0];
        start->x = state + 1;
    }
    start->fixed = section(parts, LAG_TAPE_START_FIXED);
    start->written = section(parts, LAG_TAPE_START_WRITTEN);
    start->nominal = section(parts, LAG_TAPE_START_NOMINAL);
    start->minimum = section(parts, LAG_TAPE_START_MINIMUM);
    start->maximum = section(parts, LAG_TAPE_START_MAXIMUM);
}

const lag_model *lag_tape_model(const void *bytes, size_t count, void *arena)
{
    lag_tape *tape = arena;
    lag_tape_parts parts;
    divide(bytes, count, &parts);
    memset(tape, 0, sizeof *tape);
    tape->row = parts.size[LAG_TAPE_ROW];
    for (size_t part = 0; part < 2; ++part) {
        tape->shared[part] = parts.size[LAG_TAPE_SHARED + 2 * part];
        tape->along_row[part] = parts.size[LAG_TAPE_ALONG_ROW + 2 * part];
    }
    tape->words = (const void *)parts.part[LAG_TAPE_WORDS].bytes;
    tape->functions = (const void *)parts.part[LAG_TAPE_FUNCTIONS].bytes;
    tape->constants = (const void *)parts.part[LAG_TAPE_CONSTANT_POOL].bytes;
    tape->constant_count = (size_t)(parts.part[LAG_TAPE_CONSTANT_POOL].length / sizeof(double));
    tape->model.version = LAG_MODEL_VERSION;
    tape->model.size = sizeof(lag_model);
    tape->model.name = text(&parts, parts.size[LAG_TAPE_NAME]);
    tape->model.context = tape;
    give_sizes(&tape->model, parts.size);
    give_tables(tape, &parts, (unsigned char *)arena + (sizeof *tape + 7) / 8 * 8);
    give_start(&tape->start, &parts);
    lag_tape_functions(tape);
    lag_tape_parallel(tape);
    return &tape->model;
}

const lag_start *lag_tape_start(const lag_model *model)
{
    const lag_tape *tape = model->context;
    return tape->start.x != NULL ? &tape->start : NULL;
}
