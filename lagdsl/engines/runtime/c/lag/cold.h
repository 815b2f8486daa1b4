/*
 * Settings for code that runs rarely, included by its sources. With LAG_QUICK, GCC compiles it in half the time and its code
 * is nearly as fast; for other compilers nothing changes.
 */
#ifndef LAG_COLD_H
#define LAG_COLD_H

#if defined(LAG_QUICK) && defined(__GNUC__) && !defined(__clang__)
/* The second: without it registers that vectors were in are not cleared, which slows down what is no vector. */
#pragma GCC optimize("Og", "expensive-optimizations")
#endif

#endif
