/*
 * What follows is called now and then. With LAG_QUICK GCC takes half the time for
 * it, and gives code of nearly the same speed; other compilers do as always.
 */
#ifndef LAG_RARELY_H
#define LAG_RARELY_H

#if defined(LAG_QUICK) && defined(__GNUC__) && !defined(__clang__)
/* The second: without it registers that vectors were in are not cleared, which slows down what is no vector. */
#pragma GCC optimize("Og", "expensive-optimizations")
#endif

#endif
