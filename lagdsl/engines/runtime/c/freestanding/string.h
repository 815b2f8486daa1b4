/* The part of <string.h> that the runtime uses; see math.h beside it. Compilers call these functions by themselves, too. */
#ifndef LAG_FREESTANDING_STRING_H
#define LAG_FREESTANDING_STRING_H

#include <stddef.h>

void *memcpy(void *restrict to, const void *restrict from, size_t size);
void *memmove(void *to, const void *from, size_t size);
void *memset(void *to, int byte, size_t size);

#endif
