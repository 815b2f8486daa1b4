/*
 * Checks that a pointer from an importer is one that it received and has not freed. A mark is enough in most cases. With
 * LAG_DEBUG_HANDLES a list holds all living handles and detects freed and invented pointers without reading through them.
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
