#include "lag/linalg/record.h"

#include <string.h>

void lag_record_bytes(lag_record *record, void *data, size_t size)
{
    if (size > 0 && record->bytes != NULL) {
        memcpy(record->bytes + record->count, data, size);
    } else if (size > 0 && record->saved != NULL) {
        memcpy(data, record->saved + record->count, size);
    }
    record->count += size;
}

void lag_record_doubles(lag_record *record, size_t count, double *data)
{
    lag_record_bytes(record, data, count * sizeof(double));
}
