/*
 * Snapshots: everything of an instance that its importer can go back to. In memory they are what they are as bytes: a head without
 * pointers, then what lag_instance_save() wrote.
 */
#include "lag/shell/shell.h"

#include <string.h>

#include "lag/serialization.h"

#define FORMAT UINT64_C(3)

typedef struct head {
    uint64_t format, size, token, check; /* the check is that of all bytes with itself zero */
    double one;                          /* its bytes tell how numbers are written */
    lag_course_of_calls now;
} head;

struct lag_fmu_state {
    lag_handle handle;
    lag_shell *owner;
    lag_fmu_state *next, *previous;
    head head;
};

/* Bytes of the instance; they follow the snapshot. */
static unsigned char *bytes_of(lag_fmu_state *state)
{
    return (unsigned char *)state + sizeof *state;
}

static uint64_t check_of(const head *given, const unsigned char *bytes, size_t count)
{
    head copy;
    memcpy(&copy, given, sizeof copy);
    copy.check = 0;
    unsigned char first[sizeof copy];
    memcpy(first, &copy, sizeof copy);
    return lag_record_sum(first, sizeof first) ^ lag_record_sum(bytes, count);
}

static uint64_t token_of(const lag_shell *shell)
{
    return lag_record_sum((const unsigned char *)shell->fmu->token, strlen(shell->fmu->token));
}

static size_t serialized(const lag_shell *shell)
{
    return sizeof(head) + lag_instance_saved_size(shell->instance);
}

static lag_fmu_state *living(lag_shell *shell, void *state)
{
    if (!lag_handle_lives(state, LAG_MARK_SNAPSHOT)) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, state == NULL ? "the FMU state is a null pointer" : "this is not an FMU state");
        return NULL;
    }
    lag_fmu_state *found = state;
    if (found->head.token != token_of(shell) || found->head.size != serialized(shell)) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "this FMU state belongs to another FMU");
        return NULL;
    }
    return found;
}

static lag_fmu_state *create(lag_shell *shell)
{
    lag_fmu_state *state = lag_shell_allocate(shell, sizeof *state + lag_instance_saved_size(shell->instance));
    if (state == NULL || (uintptr_t)state % _Alignof(lag_fmu_state) != 0) {
        lag_shell_release(shell, state);
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "no memory for the FMU state");
        return NULL;
    }
    memset(state, 0, sizeof *state);
    state->owner = shell;
    state->next = shell->states;
    if (state->next != NULL) {
        state->next->previous = state;
    }
    shell->states = state;
    lag_handle_begin(&state->handle, LAG_MARK_SNAPSHOT);
    return state;
}

static void destroy(lag_fmu_state *state)
{
    lag_shell *owner = state->owner;
    if (state->previous != NULL) {
        state->previous->next = state->next;
    } else {
        owner->states = state->next;
    }
    if (state->next != NULL) {
        state->next->previous = state->previous;
    }
    lag_handle_end(&state->handle);
    lag_shell_release(owner, state);
}

lag_answer lag_shell_save(lag_shell *shell, void **state)
{
    if (lag_shell_lacks(shell, state == NULL, "the place for the FMU state")) {
        return LAG_ANSWER_ERROR;
    }
    lag_fmu_state *saved = *state == NULL ? create(shell) : living(shell, *state);
    if (saved == NULL) {
        return LAG_ANSWER_ERROR;
    }
    memset(&saved->head, 0, sizeof saved->head);
    saved->head.format = FORMAT;
    saved->head.size = serialized(shell);
    saved->head.token = token_of(shell);
    saved->head.one = 1.0;
    saved->head.now = shell->now;
    lag_instance_save(shell->instance, bytes_of(saved));
    *state = saved;
    return LAG_ANSWER_OK;
}

lag_answer lag_shell_load(lag_shell *shell, void *state)
{
    lag_fmu_state *saved = living(shell, state);
    if (saved == NULL) {
        return LAG_ANSWER_ERROR;
    }
    const lag_course_of_calls *then = &saved->head.now;
    if (then->kind != shell->now.kind || then->event_mode != shell->now.event_mode) {
        return lag_shell_say(shell, LAG_ANSWER_ERROR, "this FMU state is of an instance of another kind");
    }
    const lag_status status = lag_instance_load(shell->instance, bytes_of(saved));
    if (status != LAG_OK) {
        return lag_shell_refused(shell, status);
    }
    const uint32_t early_return = shell->now.early_return;
    shell->now = *then;
    shell->now.early_return = early_return;
    return LAG_ANSWER_OK;
}

lag_answer lag_shell_forget(lag_shell *shell, void **state)
{
    if (state == NULL || *state == NULL) {
        return LAG_ANSWER_OK;
    }
    lag_fmu_state *saved = living(shell, *state);
    if (saved == NULL) {
        return LAG_ANSWER_ERROR;
    }
    destroy(saved);
    *state = NULL;
    return LAG_ANSWER_OK;
}

void lag_shell_forget_all(lag_shell *shell)
{
    while (shell->states != NULL) {
        destroy(shell->states);
    }
}

lag_answer lag_shell_serialized_size(lag_shell *shell, void *state, size_t *size)
{
    if (lag_shell_lacks(shell, size == NULL, "the place for the size") || living(shell, state) == NULL) {
        return LAG_ANSWER_ERROR;
    }
    *size = serialized(shell);
    return LAG_ANSWER_OK;
}

lag_answer lag_shell_serialize(lag_shell *shell, void *state, unsigned char *bytes, size_t size)
{
    lag_fmu_state *saved = living(shell, state);
    if (saved == NULL || lag_shell_lacks(shell, bytes == NULL, "the array of bytes")) {
        return LAG_ANSWER_ERROR;
    }
    if (size != serialized(shell)) {
        return lag_shell_say(shell, LAG_ANSWER_ERROR, "room for %lu bytes, where the FMU state has %lu", (unsigned long)size,
            (unsigned long)serialized(shell));
    }
    head written;
    memcpy(&written, &saved->head, sizeof written);
    written.check = check_of(&saved->head, bytes_of(saved), size - sizeof(head));
    memcpy(bytes, &written, sizeof written);
    memcpy(bytes + sizeof(head), bytes_of(saved), size - sizeof(head));
    return LAG_ANSWER_OK;
}

/* Fault of these bytes; null if there is none. */
static const char *fault(const lag_shell *shell, const unsigned char *bytes, size_t size, head *read)
{
    if (size != serialized(shell)) {
        return "the bytes are too few or too many for a state of this FMU";
    }
    memcpy(read, bytes, sizeof *read);
    if (read->format != FORMAT || read->size != size || read->one != 1.0) {
        return "the bytes are not an FMU state, or one from another kind of machine";
    }
    if (read->token != token_of(shell)) {
        return "the bytes are a state of another FMU";
    }
    return read->check == check_of(read, bytes + sizeof *read, size - sizeof *read) ? NULL : "the bytes of the FMU state have been changed";
}

lag_answer lag_shell_deserialize(lag_shell *shell, const unsigned char *bytes, size_t size, void **state)
{
    if (lag_shell_lacks(shell, bytes == NULL, "the array of bytes") || lag_shell_lacks(shell, state == NULL, "the place for the FMU state")) {
        return LAG_ANSWER_ERROR;
    }
    head read;
    const char *wrong = fault(shell, bytes, size, &read);
    if (wrong != NULL) {
        return lag_shell_say(shell, LAG_ANSWER_ERROR, "%s", wrong);
    }
    lag_fmu_state *saved = *state == NULL ? create(shell) : living(shell, *state);
    if (saved == NULL) {
        return LAG_ANSWER_ERROR;
    }
    memcpy(&saved->head, &read, sizeof read);
    memcpy(bytes_of(saved), bytes + sizeof read, size - sizeof read);
    *state = saved;
    return LAG_ANSWER_OK;
}
