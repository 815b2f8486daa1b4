/*
 * The part of <math.h> that the runtime and generated models use, for compilers that come without a C library
 * (-ffreestanding -Ifreestanding). The functions themselves, in double precision, are linked from any library of
 * mathematics.
 */
#ifndef LAG_FREESTANDING_MATH_H
#define LAG_FREESTANDING_MATH_H

#define INFINITY (__builtin_inff())
#define NAN (__builtin_nanf(""))
#define isfinite(x) (__builtin_isfinite(x))
#define isnan(x) (__builtin_isnan(x))

double acos(double x);
double asin(double x);
double atan(double x);
double atan2(double y, double x);
double ceil(double x);
double cos(double x);
double cosh(double x);
double exp(double x);
double fabs(double x);
double floor(double x);
double fma(double x, double y, double z);
double fmax(double x, double y);
double fmin(double x, double y);
double fmod(double x, double y);
double hypot(double x, double y);
double ldexp(double x, int exponent);
double log(double x);
double log2(double x);
double nearbyint(double x);
double pow(double x, double y);
double sin(double x);
double sinh(double x);
double sqrt(double x);
double tan(double x);
double tanh(double x);

#endif
