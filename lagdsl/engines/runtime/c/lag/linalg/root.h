/* The zero of a function of one variable between two points of different sign. */
#ifndef LAG_ROOT_H
#define LAG_ROOT_H

/* f(x), with a context of the caller's. */
typedef double lag_scalar(void *context, double x);

/*
 * With f(a) f(b) <= 0 (their signs, as lag_root_sign tells them, differ): a point x in (a, b] on b's side of a sign change, at most
 * `tolerance` beyond it. At most a few more evaluations than bisection would need, most often far fewer.
 */
double lag_root(lag_scalar *f, void *context, double a, double fa, double b, double fb, double tolerance);

/* 1 for what is not negative, -1 for what is, and for what is no number. */
static inline int lag_root_sign(double value)
{
    return value >= 0.0 ? 1 : -1;
}

#endif
