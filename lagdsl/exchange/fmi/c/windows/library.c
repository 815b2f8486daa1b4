/*
 * The functions of C's library that an FMU for Windows calls and the system's own, the Universal C Runtime, does not have:
 * linked in place of MinGW's, which ziglang would compile first, in two minutes. Compiled with -fno-builtin, so that no function
 * becomes a call of itself. Importers that compile the sources have a library of their own.
 */
#include <math.h>
#include <stdarg.h>
#include <stddef.h>

/* corecrt_stdio_config.h of the Universal C Runtime: the length without a limit is returned, and a zero ends the text. */
#define AS_THE_STANDARD_SAYS 2ull

int __stdio_common_vsprintf(unsigned long long options, char *text, size_t size, const char *form, void *locale, va_list values);
int vsnprintf(char *text, size_t size, const char *form, va_list values);
int snprintf(char *text, size_t size, const char *form, ...);
int DllMainCRTStartup(void *library, unsigned reason, void *reserved);

/* There is nothing to begin nor to end: no constructors, no memory of threads. */
int DllMainCRTStartup(void *library, unsigned reason, void *reserved)
{
    (void)library, (void)reason, (void)reserved;
    return 1;
}

int vsnprintf(char *text, size_t size, const char *form, va_list values)
{
    return __stdio_common_vsprintf(AS_THE_STANDARD_SAYS, text, size, form, NULL, values);
}

int snprintf(char *text, size_t size, const char *form, ...)
{
    va_list values;
    va_start(values, form);
    const int length = vsnprintf(text, size, form, values);
    va_end(values);
    return length;
}

int __fpclassify(double x)
{
    return __builtin_fpclassify(FP_NAN, FP_INFINITE, FP_NORMAL, FP_SUBNORMAL, FP_ZERO, x);
}

int __isnan(double x)
{
    return __builtin_isnan(x);
}

void sincos(double x, double *sine, double *cosine)
{
    *sine = sin(x);
    *cosine = cos(x);
}

void *memcpy(void *restrict to, const void *restrict from, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        ((char *)to)[i] = ((const char *)from)[i];
    }
    return to;
}

void *memmove(void *to, const void *from, size_t size)
{
    if ((const char *)to <= (const char *)from) {
        for (size_t i = 0; i < size; i++) {
            ((char *)to)[i] = ((const char *)from)[i];
        }
    } else {
        for (size_t i = size; i-- > 0;) {
            ((char *)to)[i] = ((const char *)from)[i];
        }
    }
    return to;
}

void *memset(void *at, int value, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        ((char *)at)[i] = (char)value;
    }
    return at;
}

int memcmp(const void *one, const void *other, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        const int difference = ((const unsigned char *)one)[i] - ((const unsigned char *)other)[i];
        if (difference != 0) {
            return difference;
        }
    }
    return 0;
}

/* Called at the begin of functions with more than a page of local variables, of rax bytes: the system adds one page at a time to
 * a stack, when it is touched. All registers are kept. */
__asm__(".globl ___chkstk_ms\n"
        "___chkstk_ms:\n"
        "    push %rcx\n"
        "    push %rax\n"
        "    lea 24(%rsp), %rcx\n"
        "1:  cmp $4096, %rax\n"
        "    jb 2f\n"
        "    sub $4096, %rcx\n"
        "    testq %rcx, (%rcx)\n"
        "    sub $4096, %rax\n"
        "    jmp 1b\n"
        "2:  sub %rax, %rcx\n"
        "    testq %rcx, (%rcx)\n"
        "    pop %rax\n"
        "    pop %rcx\n"
        "    ret\n");
