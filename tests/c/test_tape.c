/*
 * Tapes of random models are taken and run within their bounds, which the address sanitizer sees: all arrays are exactly as long as
 * the model says. A changed tape is refused; with its checksum mended it is refused or runs within its bounds.
 */
#include "random_tape.h"

#include "lag/batch.h"
#include "lag/dynamics.h"
#include "lag/equations/jacobian.h"

enum { CHANGES = 40 };

/* So many doubles and not one more; values that functions like. */
static double *numbers(uint64_t count)
{
    double *x = malloc(count * sizeof(double) + (count == 0));
    CHECK(x != NULL);
    for (uint64_t i = 0; i < count; ++i) {
        x[i] = 0.25 + 0.5 * (double)(i % 3);
    }
    return x;
}

/* Arguments of the groups in `mask`, each of `lanes` numbers an entry; others are null. */
typedef struct given {
    lag_arguments at;
    double *array[LAG_TAPE_GROUPS];
} given;

static void give(given *to, const lag_model *model, const uint32_t *size, uint32_t mask, uint64_t lanes, uint64_t workspace)
{
    memset(to, 0, sizeof *to);
    for (uint32_t group = 1; group < LAG_TAPE_GROUPS; ++group) {
        to->array[group] = mask >> group & 1u ? numbers(lanes * lag_tape_argument_length(size, group)) : NULL;
    }
    double **const a = to->array;
    a[0] = numbers(lanes);
    to->at = (lag_arguments){.t = 0.5, .q = a[1], .qd = a[2], .z = a[3], .u = a[4], .w = a[5], .p = a[6], .qdd = a[7], .lam = a[8],
        .dq = a[9], .dqd = a[10], .dz = a[11], .du = a[12], .dp = a[13], .dqdd = a[14], .dlam = a[15],
        .times = lanes > 1 ? a[0] : NULL, .workspace = numbers(workspace), .context = model->context};
}

static void take_back(given *to)
{
    for (uint32_t group = 0; group < LAG_TAPE_GROUPS; ++group) {
        free(to->array[group]);
    }
    free(to->at.workspace);
}

/* All functions of one state. */
static void run_singly(const lag_model *model, const lag_tape_parts *parts)
{
    for (uint32_t i = 0; i < LAG_TAPE_ALONG - 1; ++i) {
        const lag_tape_signature *of = lag_tape_signature_of(parts, 1 + i);
        /* what is formed column by column reads what its parts read */
        const uint32_t mask = i == LAG_MASS_MATRIX || i == LAG_DYNAMICS ? 0x01ff : of->arguments | 1u << LAG_TAPE_PARAMETERS;
        uint64_t length = 0;
        given to;
        for (uint32_t k = 0; k < of->count; ++k) {
            length += lag_tape_result_length(parts->size, of, k);
        }
        double *results = numbers(length);
        give(&to, model, parts->size, mask, 1, model->workspace);
        CHECK(lag_prepare(model, &to.at) == LAG_OK);
        const lag_status status = lag_evaluate(model, (lag_function)i, &to.at, results);
        CHECK(status == LAG_OK || status == LAG_MISSING);
        take_back(&to);
        free(results);
    }
}

/* Several states together give the bits of each alone, where all that is read was written. */
static void run_states(const lag_model *model, const uint32_t *size, int same)
{
    const lag_states *states = lag_tape_states(model);
    enum { COUNT = 11 };
    if (states == NULL) {
        return;
    }
    const size_t n = model->nq, m = model->nc;
    given to;
    give(&to, model, size, 0x7f, COUNT, model->workspace);
    for (size_t i = 0; i < COUNT * n; ++i) {
        to.array[1][i] = 0.1 * (double)i - 1.0;
    }
    lag_batch batch = {.count = COUNT, .t = {to.array[0], 1}, .q = {to.at.q, n}, .qd = {to.at.qd, n}, .z = {to.at.z, model->nz},
        .u = {to.at.u, model->nu}, .w = {to.at.w, model->nw}, .p = {to.at.p, model->np}, .workspace = to.at.workspace};
    batch.memory = numbers(lag_dynamics_memory(model));
    batch.lanes = numbers(lag_batch_memory(model, states));
    double *const qdd = numbers(COUNT * n), *const lam = numbers(COUNT * m);
    double *const other_qdd = numbers(COUNT * n), *const other_lam = numbers(COUNT * m);
    size_t coordinate = 0;
    const lag_status together = lag_batch_forward_dynamics(model, states, &batch, qdd, lam, &coordinate);
    const lag_status alone = lag_batch_forward_dynamics(model, NULL, &batch, other_qdd, other_lam, &coordinate);
    CHECK(together == alone || !same);
    for (size_t i = 0; same && together == LAG_OK && i < COUNT * n; ++i) {
        CHECK(qdd[i] == other_qdd[i] || (isnan(qdd[i]) && isnan(other_qdd[i])));
    }
    double *const all[] = {qdd, lam, other_qdd, other_lam, batch.memory, batch.lanes};
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) {
        free(all[i]);
    }
    take_back(&to);
}

static void run_along(const lag_model *model, const uint32_t *size, int parameters)
{
    const lag_tangents *tangents = lag_tape_tangents(model, parameters);
    if (tangents == NULL) {
        return;
    }
    const size_t variables = 2 * model->nq + model->nz + model->nu + model->np;
    const lag_range all = {0, variables};
    given to;
    give(&to, model, size, 0x7f, 1, lag_jacobian_workspace(model, tangents));
    double *memory = numbers(lag_jacobian_memory(model, tangents));
    double *rates = numbers((2 * model->nq + model->nz) * variables);
    double *outputs = numbers(model->ny * variables);
    size_t coordinate = 0;
    CHECK(lag_prepare(model, &to.at) == LAG_OK);
    (void)lag_jacobian(model, tangents, &to.at, all, memory, rates, outputs, &coordinate);
    free(memory);
    free(rates);
    free(outputs);
    take_back(&to);
}

static void run_jacobian(const lag_model *model, const uint32_t *size)
{
    const lag_tangents *tangents = lag_tape_jacobian(model);
    if (tangents == NULL) {
        return;
    }
    const size_t equations = model->nq + model->nc + model->nz;
    given to;
    give(&to, model, size, 0x7f, 1, lag_jacobian_workspace(model, tangents));
    double *qdd = numbers(model->nq);
    double *lam = numbers(model->nc);
    double *pivot = numbers(1);
    double *response = numbers((model->nq + model->nz) * equations);
    double *by_state = numbers(equations * (2 * model->nq + model->nz + model->nu));
    double *by_parameter = numbers(equations * model->np);
    CHECK(lag_prepare(model, &to.at) == LAG_OK);
    CHECK(tangents->jacobian(&to.at, qdd, lam, pivot, response, by_state, by_parameter) == LAG_OK);
    double *const all[] = {qdd, lam, pivot, response, by_state, by_parameter};
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) {
        free(all[i]);
    }
    take_back(&to);
}

/* Everything that the tables say is there. */
static void read_tables(const lag_model *model, const lag_start *start)
{
    const lag_slot *const slots[] = {model->coordinates, model->states, model->inputs, model->discretes, model->parameters,
        model->constraints, model->outputs, model->invariants, model->definitions};
    const size_t counts[] = {
        model->nq, model->nz, model->nu, model->nw, model->np, model->nc, model->ny, model->ni, model->nd};
    const char *const *const texts[] = {model->assertions, model->resets, model->stops, model->failures};
    const size_t lengths[] = {model->na, model->nreset, model->nstop, model->nfail};
    volatile double sum = (double)strlen(model->name);
    for (size_t k = 0; k < sizeof counts / sizeof *counts; ++k) {
        for (size_t i = 0; i < counts[k]; ++i) {
            sum = sum + (double)(strlen(slots[k][i].name) + strlen(slots[k][i].unit));
            sum = sum + (slots[k][i].place == NULL ? 0.0 : (double)strlen(slots[k][i].place));
        }
    }
    for (size_t k = 0; k < sizeof lengths / sizeof *lengths; ++k) {
        for (size_t i = 0; i < lengths[k]; ++i) {
            sum = sum + (double)strlen(texts[k][i]);
        }
    }
    for (size_t i = 0; i < model->nk; ++i) {
        CHECK(model->kept_rows[i] < model->nc);
    }
    for (size_t i = 0; i < model->ncontact; ++i) {
        CHECK(model->contact_rows[i] < model->nc);
    }
    const lag_pattern *patterns[] = {model->patterns->jacobian, model->patterns->response, model->patterns->coupling};
    for (size_t k = 0; k < sizeof patterns / sizeof *patterns; ++k) {
        const lag_pattern *pattern = patterns[k];
        for (size_t i = 0; pattern != NULL && i < pattern->count; ++i) {
            CHECK(pattern->row[i] < pattern->rows && pattern->column[i] < pattern->columns);
        }
        for (size_t i = 0; pattern != NULL && i <= pattern->rows; ++i) {
            CHECK(pattern->first[i] <= pattern->count && (i == 0 || pattern->first[i - 1] <= pattern->first[i]));
        }
    }
    for (size_t i = 0; start != NULL && i < 2 * model->nq + model->nz; ++i) {
        sum = sum + start->x[i] + (start->nominal == NULL ? 0.0 : start->nominal[i]);
    }
}

/* True if the bytes are taken; then everything in them is used, and `whole` ones also compared. They stand in memory of exactly their length. */
static int taken(const unsigned char *bytes, size_t count, int whole)
{
    unsigned char *own = malloc(count + (count == 0));
    size_t needed = 0;
    CHECK(own != NULL);
    memcpy(own, bytes, count);
    const lag_status status = lag_tape_check(own, count, &needed);
    CHECK(status == LAG_OK || status == LAG_BAD_STATE_DATA);
    if (status == LAG_OK && needed < 1u << 22) {
        void *memory = malloc(needed);
        CHECK(memory != NULL);
        const lag_model *model = lag_tape_model(own, count, memory);
        lag_tape_parts parts;
        uint32_t *size = malloc(LAG_TAPE_NUMBER_OF_SIZES * sizeof *size);
        memset(&parts, 0, sizeof parts);
        CHECK(size != NULL);
        memcpy(size, own + HEAD_BYTES + 8 * LAG_TAPE_SECTIONS, LAG_TAPE_NUMBER_OF_SIZES * sizeof *size);
        parts.size = size;
        parts.part[LAG_TAPE_FUNCTIONS].bytes = (const void *)((const lag_tape *)model->context)->functions;
        read_tables(model, lag_tape_start(model));
        run_singly(model, &parts);
        run_states(model, size, whole);
        run_along(model, size, 0);
        run_along(model, size, 1);
        run_jacobian(model, size);
        free(size);
        free(memory);
    }
    free(own);
    return status == LAG_OK;
}

/* A few changes of any kind; where they are below `end` the checksum fits again. Returns the new length. */
static size_t change(unsigned long long *seed, unsigned char *bytes, size_t count)
{
    const uint32_t words = (uint32_t)(count / 4);
    for (uint32_t i = any(seed, 3); i < 4; ++i) {
        const uint32_t at = 4 * any(seed, words - 1);
        uint32_t word;
        memcpy(&word, bytes + at, sizeof word);
        switch (any(seed, 4)) {
        case 0: word = any(seed, 64); break;
        case 1: word ^= 1u << any(seed, 31); break;
        case 2: word += 1; break;
        case 3: word -= 1; break;
        default: word = 0xFFFFFFFFu - any(seed, 8); break;
        }
        memcpy(bytes + at, &word, sizeof word);
    }
    if (any(seed, 15) == 0) {
        count -= any(seed, 64);
    }
    return count;
}

/* Twelve random models, or as many as the argument says. */
int main(int count, char **arguments)
{
    const int models = count > 1 ? atoi(arguments[1]) : 12;
    static random_tape tape;
    unsigned long long seed = 7;
    unsigned char *changed = malloc(MOST_BYTES);
    size_t mended = 0;
    tape.bytes = calloc(MOST_BYTES, 1);
    tape.seed = 1;
    CHECK(tape.bytes != NULL && changed != NULL);
    CHECK(!taken(tape.bytes, 0, 0));
    for (int i = 0; i < models; ++i) {
        const size_t written = write_random_tape(&tape);
        CHECK(taken(tape.bytes, written, 1));
        for (int k = 0; k < CHANGES; ++k) {
            memcpy(changed, tape.bytes, written);
            const size_t length = change(&seed, changed, written);
            CHECK((length == written && memcmp(changed, tape.bytes, written) == 0) || !taken(changed, length, 0));
            memcpy(changed, tape.bytes, 8);
            seal(changed, length);
            mended += (size_t)taken(changed, length, 0);
        }
    }
    CHECK(mended > (size_t)models * CHANGES / 16 && mended < (size_t)models * CHANGES / 2); /* both happen */
    printf("tape: %d random models, %d damaged ones, of which %zu run with their checksum mended: ok\n", models, models * CHANGES, mended);
    free(changed);
    free(tape.bytes);
    return 0;
}
