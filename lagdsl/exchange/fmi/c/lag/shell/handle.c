#include "lag/shell/handle.h"

#include <stddef.h>

static int aligned(const void *pointer)
{
    return pointer != NULL && (uintptr_t)pointer % _Alignof(lag_handle) == 0;
}

#ifdef LAG_DEBUG_HANDLES

#include <stdatomic.h>

/* The only state outside of instances, and in debug builds only. */
static atomic_flag taken = ATOMIC_FLAG_INIT;
static lag_handle *first;

static void take(void)
{
    while (atomic_flag_test_and_set_explicit(&taken, memory_order_acquire)) {
    }
}

static void give(void)
{
    atomic_flag_clear_explicit(&taken, memory_order_release);
}

void lag_handle_begin(lag_handle *handle, uint64_t mark)
{
    handle->mark = mark;
    take();
    handle->next = first;
    first = handle;
    give();
}

void lag_handle_end(lag_handle *handle)
{
    take();
    lag_handle **place = &first;
    while (*place != NULL && *place != handle) {
        place = &(*place)->next;
    }
    if (*place != NULL) {
        *place = handle->next;
    }
    give();
    handle->mark = 0;
}

int lag_handle_lives(const void *pointer, uint64_t mark)
{
    take();
    const lag_handle *handle = first;
    while (handle != NULL && (const void *)handle != pointer) {
        handle = handle->next;
    }
    const int lives = handle != NULL && handle->mark == mark;
    give();
    return lives && aligned(pointer);
}

#else

void lag_handle_begin(lag_handle *handle, uint64_t mark)
{
    handle->mark = mark;
}

void lag_handle_end(lag_handle *handle)
{
    /* volatile: compilers leave out what is written just before memory is freed */
    *(volatile uint64_t *)&handle->mark = 0;
}

int lag_handle_lives(const void *pointer, uint64_t mark)
{
    return aligned(pointer) && ((const lag_handle *)pointer)->mark == mark;
}

#endif
