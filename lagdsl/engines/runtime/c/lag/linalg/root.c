/*
 * The method ITP: regula falsi, truncated towards the middle and projected so that it is never much slower than bisection.
 *
 * Source: Oliveira and Takahashi, ACM Trans. Math. Softw. 47 (2021) 5, with kappa1 = 0.2/(b - a), kappa2 = 2, n0 = 1.
 */
#include "lag/linalg/root.h"

#include <math.h>

double lag_root(lag_scalar *f, void *context, double a, double fa, double b, double fb, double tolerance)
{
    const int side = lag_root_sign(fb);
    const double half = 0.5 * tolerance;
    const double kappa = 0.2 / (b - a);
    const int most = (int)ceil(log2(fmax((b - a) / tolerance, 1.0))) + 1;
    for (int k = 0; b - a > tolerance && k < most + 2; ++k) {
        const double middle = a + 0.5 * (b - a);
        const double radius = half * ldexp(1.0, most - k) - 0.5 * (b - a);
        const double chord = (fb * a - fa * b) / (fb - fa);
        const double toward = middle >= chord ? 1.0 : -1.0;
        const double shift = fmin(kappa * (b - a) * (b - a), fabs(middle - chord));
        double x = chord + toward * shift;
        if (!(fabs(x - middle) <= radius)) {
            x = middle - toward * fmax(radius, 0.0);
        }
        if (!(x > a && x < b)) {
            x = middle;
        }
        if (!(x > a && x < b)) {
            return b;
        }
        const double value = f(context, x);
        if (lag_root_sign(value) == side) {
            b = x;
            fb = value;
        } else {
            a = x;
            fa = value;
        }
    }
    return b;
}
