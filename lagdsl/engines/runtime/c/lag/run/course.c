#include "lag/run/course.h"

#include <math.h>

/*
 * Five values show a function if the polynomial through four of them is off at the fifth by this part of their range at most. Of those that
 * they do not show, as a peak that is narrower than their distances, extremes are searched whatever is expected.
 */
static const double SHOWN = 0.25;
/* Values whose range is this part of them are constant; what is left is round-off. */
static const double ROUNDING = 1e-12;

void lag_bulge_find(double a, double fa, double b, double fb, double *up, double *down)
{
    const double change = b - a;
    const double most = 3.0 * fabs(change);
    *up = *down = 0.0;
    if (fa * change > 0.0 && fb * change > 0.0 && fabs(fa) < most && fabs(fb) < most) {
        return; /* Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980) 238: it is monotone */
    }
    const double linear = 3.0 * change - 2.0 * fa - fb; /* the derivative is fa + 2 linear s + square s^2 */
    const double square = 3.0 * (fa + fb - 2.0 * change);
    const double root = linear * linear - fa * square;
    if (root < 0.0) {
        return;
    }
    const double sum = -(linear + (linear < 0.0 ? -sqrt(root) : sqrt(root)));
    const double places[2] = {sum != 0.0 ? fa / sum : -1.0, square != 0.0 ? sum / square : -1.0};
    for (int k = 0; k < 2; ++k) {
        const double s = places[k];
        if (s > 0.0 && s < 1.0) {
            const double value = a + s * (fa + s * (linear + s * square / 3.0));
            *up = fmax(*up, value - fmax(a, b));
            *down = fmax(*down, fmin(a, b) - value);
        }
    }
}

/* The slope at value k, by the parabola through three of them. */
static double slope_at(const lag_course *c, size_t k)
{
    const size_t first = k == 0 ? 0 : k == c->count ? k - 2 : k - 1;
    const double *x = c->place + first;
    const double *y = c->y + first;
    const double before = (y[1] - y[0]) / (x[1] - x[0]);
    const double after = (y[2] - y[1]) / (x[2] - x[1]);
    const double bend = (after - before) / (x[2] - x[0]);
    return k == c->count ? after + bend * (x[2] - x[1]) : before + (k == 0 ? -bend : bend) * (x[1] - x[0]);
}

void lag_spread_weights(const double *place, double *weight)
{
    double most = 0.0;
    for (size_t i = 0; i < LAG_WINDOW; ++i) {
        double product = 1.0;
        for (size_t j = 0; j < LAG_WINDOW; ++j) {
            product *= j == i ? 1.0 : place[i] - place[j];
        }
        weight[i] = 1.0 / product;
        most = fabs(weight[i]) > most ? fabs(weight[i]) : most;
    }
    for (size_t i = 0; i < LAG_WINDOW; ++i) {
        weight[i] /= most;
    }
}

lag_spread lag_spread_of(const double *v, const double *weight)
{
    lag_spread s = {v[0], v[0], weight[0] * v[0]};
    for (size_t i = 1; i < LAG_WINDOW; ++i) {
        s.low = v[i] < s.low ? v[i] : s.low;
        s.high = v[i] > s.high ? v[i] : s.high;
        s.off += weight[i] * v[i];
    }
    s.off = fabs(s.off);
    return s;
}

int lag_spread_hides(const lag_spread *s)
{
    const double range = s->high - s->low;
    return s->off > SHOWN * range && range > ROUNDING * fmax(fabs(s->low), fabs(s->high));
}

int lag_course_peaks(const lag_course *c, size_t k)
{
    return (k == 0 || c->y[k] >= c->y[k - 1]) && (k == c->count || c->y[k] >= c->y[k + 1]);
}

double lag_course_reach(const lag_course *c, size_t k)
{
    const double *y = c->y;
    double bulge = 0.0;
    for (size_t i = k > 0 ? k - 1 : 0; i <= k && i < c->count; ++i) {
        const double width = c->place[i + 1] - c->place[i];
        double up = 0.0;
        double down = 0.0;
        lag_bulge_find(y[i], width * slope_at(c, i), y[i + 1], width * slope_at(c, i + 1), &up, &down);
        bulge = fmax(bulge, fmax(y[i], y[i + 1]) + (1.0 + LAG_DOUBT) * up - y[k]);
    }
    return y[k] + bulge;
}
