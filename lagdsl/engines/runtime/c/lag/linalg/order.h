/*
 * The larger and the smaller of two numbers. fmax() and fmin() are calls where compilers must heed what these do for nan; here the second one
 * is taken then.
 */
#ifndef LAG_ORDER_H
#define LAG_ORDER_H

static inline double lag_higher(double a, double b)
{
    return a > b ? a : b;
}

static inline double lag_lower(double a, double b)
{
    return a < b ? a : b;
}

#endif
