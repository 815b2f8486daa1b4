/* A walk over numbers that are to be saved. */
#ifndef LAG_RECORD_H
#define LAG_RECORD_H

#include <stddef.h>
#include <string.h>

/*
 * One walk over everything that is to be saved, for all three purposes: how much it is, out of it, and back into it. Both
 * pointers null: only counted.
 */
typedef struct lag_record {
    unsigned char *bytes;       /* written to, or null */
    const unsigned char *saved; /* read from, or null */
    size_t count;               /* so many so far */
} lag_record;

/* `size` bytes at `data`, without pointers. */
static inline void lag_record_bytes(lag_record *record, void *data, size_t size)
{
    if (size > 0 && record->bytes != NULL) {
        memcpy(record->bytes + record->count, data, size);
    } else if (size > 0 && record->saved != NULL) {
        memcpy(data, record->saved + record->count, size);
    }
    record->count += size;
}

/* So many numbers. */
static inline void lag_record_doubles(lag_record *record, size_t count, double *data)
{
    lag_record_bytes(record, data, count * sizeof(double));
}

#endif
