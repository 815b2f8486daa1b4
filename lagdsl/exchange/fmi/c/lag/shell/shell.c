/* Shells of instances: their blocks, the order of calls. */
#include "lag/shell/shell.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lag/linalg/arena.h"

static size_t widest(const lag_fmu *fmu)
{
    size_t most = 1;
    for (size_t i = 0; i < fmu->nvariable; ++i) {
        most = fmu->variables[i].count > most ? fmu->variables[i].count : most;
    }
    return most;
}

/* Before there is a shell: one on the stack, only to tell. */
static lag_shell *refuse(lag_shell *shell, const char *reason)
{
    (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "%s", reason);
    return NULL;
}

static const char *fault(const lag_fmu *fmu, const lag_birth *birth)
{
    if (birth->name == NULL || birth->name[0] == '\0') {
        return "the instance needs a name";
    }
    if (birth->token == NULL || strcmp(birth->token, fmu->token) != 0) {
        return "the GUID or token is not that of this FMU: its modelDescription.xml belongs to another version of the model";
    }
    if (birth->kind != LAG_MODEL_EXCHANGE && birth->kind != LAG_CO_SIMULATION) {
        return "there are only model exchange and co-simulation";
    }
    if (((unsigned)birth->kind & fmu->kinds) == 0) {
        return birth->kind == LAG_MODEL_EXCHANGE ? "this FMU was exported without model exchange" :
                                                   "this FMU was exported without co-simulation";
    }
    return NULL;
}

static void begin(lag_shell *shell)
{
    const lag_course_of_calls *now = &shell->now;
    shell->now = (lag_course_of_calls){
        .kind = now->kind,
        .event_mode = now->event_mode,
        .early_return = now->early_return,
        .mode = LAG_MODE_INSTANTIATED,
        .time = shell->fmu->experiment.start,
        .reached = shell->fmu->experiment.start,
        .start = shell->fmu->experiment.start,
        .stop = (double)INFINITY,
    };
}

lag_shell *lag_shell_create(const char *call, const lag_birth *birth)
{
    const lag_fmu *fmu = &lag_exported;
    lag_shell first = {
        .fmu = fmu,
        .host = birth->host,
        .name = birth->name != NULL ? birth->name : "",
        .call = call,
        .categories = LAG_CATEGORY_STATUS | (birth->logging ? LAG_CATEGORY_EVENTS : 0),
        .now = {.kind = (uint32_t)birth->kind, .event_mode = birth->event_mode != 0, .early_return = birth->early_return != 0},
    };
    const char *reason = fault(fmu, birth);
    if (reason != NULL) {
        return refuse(&first, reason);
    }
    const size_t length = strlen(birth->name) + 1;
    const size_t name = lag_padded(sizeof(lag_shell));
    const size_t scratch = name + lag_padded(length);
    const size_t instance = scratch + lag_padded(widest(fmu) * sizeof(double));
    const size_t size = instance + lag_instance_size(fmu);
    unsigned char *block = lag_shell_allocate(&first, size);
    if (block == NULL) {
        return refuse(&first, "no memory for the instance");
    }
    if ((uintptr_t)block % _Alignof(lag_shell) != 0) {
        lag_shell_release(&first, block);
        return refuse(&first, "the memory of the importer is not aligned");
    }
    memset(block, 0, size);
    memcpy(block + name, birth->name, length);
    lag_shell *shell = (lag_shell *)(void *)block;
    *shell = first;
    shell->name = (const char *)(block + name);
    shell->scratch = (double *)(void *)(block + scratch);
    shell->instance = lag_instance_place(block + instance, fmu);
    begin(shell);
    lag_handle_begin(&shell->handle, LAG_MARK_INSTANCE);
    return shell;
}

void lag_shell_free(void *handle, const char *call)
{
    if (handle == NULL) {
        return;
    }
    lag_shell *shell = lag_shell_enter(handle, call, LAG_MODES_LASTING);
    if (shell == NULL) {
        return;
    }
    lag_shell_forget_all(shell);
    lag_shell_release(shell, shell->known);
    lag_handle_end(&shell->handle);
    lag_shell_release(shell, shell);
}

void *lag_shell_allocate(const lag_shell *shell, size_t size)
{
    return shell->host.allocate != NULL ? shell->host.allocate(1, size) : calloc(1, size);
}

void lag_shell_release(const lag_shell *shell, void *memory)
{
    void (*release)(void *) = shell->host.release;
    if (memory != NULL && release != NULL) {
        release(memory);
    } else {
        free(memory);
    }
}

static const struct {
    unsigned mode;
    const char *name;
} MODES[] = {
    {LAG_MODE_INSTANTIATED, "before initialization"},
    {LAG_MODE_INITIALIZATION, "in initialization mode"},
    {LAG_MODE_EVENT, "in event mode"},
    {LAG_MODE_CONTINUOUS, "in continuous-time mode"},
    {LAG_MODE_STEP, "in step mode"},
    {LAG_MODE_INTERMEDIATE, "in intermediate update mode"},
    {LAG_MODE_STEP_FAILED, "after a discarded step"},
    {LAG_MODE_TERMINATED, "after the end"},
    {LAG_MODE_FAILED, "after an error"},
};

enum { MODE_COUNT = sizeof MODES / sizeof MODES[0] };

static const char *name_of(unsigned mode)
{
    for (size_t i = 0; i < MODE_COUNT; ++i) {
        if (MODES[i].mode == mode) {
            return MODES[i].name;
        }
    }
    return "?";
}

static void out_of_order(lag_shell *shell, unsigned modes)
{
    char where[256] = "";
    size_t length = 0;
    for (size_t i = 0; i < MODE_COUNT; ++i) {
        const size_t more = strlen(MODES[i].name);
        if ((modes & MODES[i].mode) != 0 && length + more + 3 < sizeof where) {
            memcpy(where + length, length > 0 ? ", " : "", length > 0 ? 2 : 0);
            length += length > 0 ? 2 : 0;
            memcpy(where + length, MODES[i].name, more + 1);
            length += more;
        }
    }
    (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "not allowed %s, only %s", name_of(shell->now.mode), where);
}

lag_shell *lag_shell_enter(void *handle, const char *call, unsigned modes)
{
    if (!lag_handle_lives(handle, LAG_MARK_INSTANCE)) {
        return NULL;
    }
    lag_shell *shell = handle;
    if (shell->busy) {
        return NULL;
    }
    shell->call = call;
    if ((modes & shell->now.mode) == 0) {
        out_of_order(shell, modes);
        return NULL;
    }
    return shell;
}

lag_answer lag_shell_reset(lag_shell *shell)
{
    shell->instance = lag_instance_place(shell->instance, shell->fmu);
    begin(shell);
    return LAG_ANSWER_OK;
}
