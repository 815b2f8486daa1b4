/* A model laid out from the sections of a tape, which tape_read.c has compared. */
#include <string.h>

#include "lag/tape/tape_model.h"

static const uint32_t NOWHERE = 0xFFFFFFFFu;

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

/* A pattern with so many rows, in the section of these and the one behind it, row by row; null where it is not told. */
static const lag_pattern *take_pattern(const lag_tape_parts *parts, lag_tape_section section, size_t rows, size_t columns, size_t **to, lag_pattern *pattern)
{
    *pattern = (lag_pattern){.rows = rows, .columns = columns, .count = (size_t)lag_tape_pattern_length(parts, section)};
    if (pattern->count == 0) {
        return NULL;
    }
    pattern->row = take_rows(parts, section, to, pattern->count);
    pattern->column = take_rows(parts, section + 1, to, pattern->count);
    size_t *first = *to;
    for (size_t i = 0, k = 0; i <= rows; ++i) {
        while (k < pattern->count && pattern->row[k] < i) {
            ++k;
        }
        first[i] = k;
    }
    pattern->first = first;
    *to += rows + 1;
    return pattern;
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
    model->nway = size[LAG_TAPE_NWAY];
    model->nturn = size[LAG_TAPE_NTURN];
    model->ndelay = size[LAG_TAPE_NDELAY];
    model->nslip = size[LAG_TAPE_NSLIP];
    model->nfriction = size[LAG_TAPE_NFRICTION];
    model->nload = size[LAG_TAPE_NLOAD];
    model->nswitched = size[LAG_TAPE_NSWITCHED];
    model->ninertial = size[LAG_TAPE_NINERTIAL];
    model->nplace = size[LAG_TAPE_NPLACE];
    model->naxes = size[LAG_TAPE_NAXES];
    model->ntwist = size[LAG_TAPE_NTWIST];
    model->prepared = size[LAG_TAPE_PREPARED];
    model->workspace = (size_t)lag_tape_workspace(size);
}

/* Slots, messages and rows, in this order, in `memory`. */
static void give_tables(lag_tape *tape, const lag_tape_parts *parts, unsigned char *memory)
{
    lag_model *model = &tape->model;
    const uint32_t *slot = (const void *)parts->part[LAG_TAPE_SLOTS].bytes;
    const uint32_t *message = (const void *)parts->part[LAG_TAPE_MESSAGES].bytes;
    lag_slot *slot_memory = (void *)memory;
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
    model->frictions = take_texts(parts, &message, &message_memory, model->nfriction);
    model->resets = take_texts(parts, &message, &message_memory, model->nreset);
    model->stops = take_texts(parts, &message, &message_memory, model->nstop);
    model->failures = take_texts(parts, &message, &message_memory, model->nfail);
    size_t *row_memory = (void *)message_memory;
    model->kept_rows = take_rows(parts, LAG_TAPE_KEPT_ROWS, &row_memory, model->nk);
    model->contact_rows = take_rows(parts, LAG_TAPE_CONTACT_ROWS, &row_memory, model->ncontact);
    model->friction_rows = take_rows(parts, LAG_TAPE_FRICTION_ROWS, &row_memory, model->nslip);
    model->friction_slips = take_rows(parts, LAG_TAPE_FRICTION_SLIPS, &row_memory, model->nfriction);
    model->friction_contacts = take_rows(parts, LAG_TAPE_FRICTION_CONTACTS, &row_memory, model->nfriction);
    model->switched_rows = take_rows(parts, LAG_TAPE_SWITCHED_ROWS, &row_memory, model->nswitched);
    model->reset_places = take_rows(parts, LAG_TAPE_RESET_PLACES, &row_memory, model->nreset);
    tape->patterns.jacobian = take_pattern(parts, LAG_TAPE_JACOBIAN_ROWS, model->nc, model->nq, &row_memory, &tape->jacobian);
    tape->patterns.response = take_pattern(parts, LAG_TAPE_RESPONSE_ROWS, model->nk, model->nq, &row_memory, &tape->response);
    tape->patterns.coupling = take_pattern(parts, LAG_TAPE_COUPLING_ROWS, model->nk, model->nk, &row_memory, &tape->coupling);
    const size_t equations = model->nq + model->nz + model->nc;
    tape->patterns.equations =
        take_pattern(parts, LAG_TAPE_EQUATIONS_ROWS, equations, 2 * model->nq + equations, &row_memory, &tape->equations);
    const int told = tape->patterns.equations != NULL;
    tape->patterns.place = take_rows(parts, LAG_TAPE_EQUATIONS_PLACES, &row_memory, told ? equations : 0);
    tape->patterns.group = take_rows(parts, LAG_TAPE_EQUATIONS_GROUPS, &row_memory, told ? 2 * model->nq + model->nz : 0);
    tape->patterns.value_group = take_rows(parts, LAG_TAPE_EQUATIONS_VALUE_GROUPS, &row_memory, told ? model->nq + model->nc : 0);
    model->patterns = &tape->patterns;
    model->components = take_rows(parts, LAG_TAPE_COMPONENTS, &row_memory, (size_t)lag_tape_components_length(parts));
    model->defaults = section(parts, LAG_TAPE_DEFAULTS);
    model->position_level = section(parts, LAG_TAPE_POSITION_LEVEL);
    model->redundant = section(parts, LAG_TAPE_REDUNDANT);
    model->kinds = section(parts, LAG_TAPE_KINDS);
    model->strict = section(parts, LAG_TAPE_STRICT);
    model->jumping = section(parts, LAG_TAPE_JUMPING);
    model->whole_inputs = section(parts, LAG_TAPE_WHOLE_INPUTS);
    model->one_way = section(parts, LAG_TAPE_ONE_WAY);
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
    start->free = section(parts, LAG_TAPE_START_FREE);
    start->parameter_nominal = section(parts, LAG_TAPE_START_PARAMETER_NOMINAL);
    start->parameter_minimum = section(parts, LAG_TAPE_START_PARAMETER_MINIMUM);
    start->parameter_maximum = section(parts, LAG_TAPE_START_PARAMETER_MAXIMUM);
}

const lag_model *lag_tape_model(const void *bytes, size_t count, void *memory)
{
    lag_tape *tape = memory;
    lag_tape_parts parts;
    lag_tape_divide(bytes, count, &parts);
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
    give_tables(tape, &parts, (unsigned char *)memory + (sizeof *tape + 7) / 8 * 8);
    give_start(&tape->start, &parts);
    lag_tape_functions(tape);
    lag_tape_differentiated(tape, lag_tape_parts_have(&parts, LAG_TAPE_JACOBIAN) && tape->functions[2 * LAG_TAPE_JACOBIAN + 1] > 0);
    lag_tape_parallel(tape);
    return &tape->model;
}

const lag_start *lag_tape_start(const lag_model *model)
{
    const lag_tape *tape = model->context;
    return tape->start.x != NULL ? &tape->start : NULL;
}
