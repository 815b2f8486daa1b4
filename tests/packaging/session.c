/* Rows of a motion as hexadecimal numbers, by a library that is loaded: session LIBRARY TAPE TOLERANCE STOP COUNT [ROWS] */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lag/session.h"
#include "lag/tape.h"

#ifdef _WIN32
#include <windows.h>
static void *opened(const char *path) { return (void *)LoadLibraryA(path); }
static void *found(void *library, const char *name) { return (void *)(uintptr_t)GetProcAddress((HMODULE)library, name); }
#else
#include <dlfcn.h>
static void *opened(const char *path) { return dlopen(path, RTLD_NOW); }
static void *found(void *library, const char *name) { return dlsym(library, name); }
#endif

#define FUNCTION(name) __typeof__(name) *const name##_ = (__typeof__(name) *)(uintptr_t)found(library, #name)

static void *aligned(size_t size)
{
    return (void *)(((uintptr_t)malloc(size + 16) + 15) / 16 * 16);
}

int main(int count, char **arguments)
{
    if (count < 6) {
        return 2;
    }
    void *library = opened(arguments[1]);
    FILE *file = fopen(arguments[2], "rb");
    if (library == NULL || file == NULL) {
        return 3;
    }
    FUNCTION(lag_tape_check);
    FUNCTION(lag_tape_model);
    FUNCTION(lag_tape_start);
    FUNCTION(lag_session_size);
    FUNCTION(lag_session_place);
    FUNCTION(lag_session_lasting);
    FUNCTION(lag_session_begin);
    FUNCTION(lag_session_to);
    FUNCTION(lag_session_row);
    FUNCTION(lag_session_width);
    static double bytes[1 << 17];
    const size_t size = fread(bytes, 1, sizeof bytes, file);
    size_t arena = 0;
    if (lag_tape_check_(bytes, size, &arena) != LAG_OK) {
        return 4;
    }
    const lag_model *model = lag_tape_model_(bytes, size, aligned(arena));
    const lag_start *start = lag_tape_start_(model);
    const double stop = atof(arguments[4]);
    const int rows = atoi(arguments[5]);
    lag_session *session =
        lag_session_place_(aligned(lag_session_size_(model, start)), model, start, atof(arguments[3]), stop);
    /* rows that come and go */
    for (char *row = count > 6 ? strtok(arguments[6], ",") : NULL; row != NULL; row = strtok(NULL, ",")) {
        lag_session_lasting_(session)[atoi(row)] = 0.0;
    }
    if (lag_session_begin_(session, 0.0) != LAG_OK) {
        return 5;
    }
    for (int k = 1; k <= rows; ++k) {
        if (lag_session_to_(session, stop * k / rows, 0) != LAG_OK) {
            return 6;
        }
        const double *row = lag_session_row_(session);
        for (size_t i = 0; i < lag_session_width_(session); ++i) {
            printf("%a ", row[i]);
        }
        printf("\n");
    }
    return 0;
}
