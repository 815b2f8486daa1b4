/*
 * Whether a pointer that an importer gives is one it got and did not free. A mark tells in most cases. With LAG_DEBUG_HANDLES all
 * living handles are listed, so that freed and invented ones are told apart without looking into them.
 */
#ifndef LAG_HANDLE_H
#define LAG_HANDLE_H

#include <stdint.h>

typedef struct lag_handle {
    uint64_t mark;
#ifdef LAG_DEBUG_HANDLES
    struct lag_handle *next;
#endif
} lag_handle;

#define LAG_MARK_INSTANCE UINT64_C(0x4c41474d4f444553)
#define LAG_MARK_SNAPSHOT UINT64_C(0x4c41474d4f4d4e54)

void lag_handle_begin(lag_handle *handle, uint64_t mark);
void lag_handle_end(lag_handle *handle);
int lag_handle_lives(const void *pointer, uint64_t mark);

#endif
