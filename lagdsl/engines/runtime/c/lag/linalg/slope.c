#include "lag/linalg/slope.h"

#include <math.h>

/* Part of the unit with which steps begin, and the factor from one step to the next. */
static const double PART = 1e-3;
static const double FACTOR = 8.0;
/* Steps end where the derivative is known to this part. */
static const double EXACT = 1e-11;
/* Changes of the function by so many round-offs are none. */
static const double MANY = 1e3;
enum { MOST_STEPS = 400 };

/* One estimate. */
typedef struct estimate {
    double value, change; /* the derivative; the change of the function in the step */
    double order, noise;  /* errors, as parts of it: of the order, of round-off */
} estimate;

static estimate difference(double (*g)(void *context, double by), void *context, double h, double noise)
{
    const double one = (g(context, h) - g(context, -h)) / (2.0 * h);
    const double two = (g(context, 2.0 * h) - g(context, -2.0 * h)) / (4.0 * h);
    const double three = (g(context, 3.0 * h) - g(context, -3.0 * h)) / (6.0 * h);
    const double fourth = (4.0 * one - two) / 3.0;
    const double sixth = (15.0 * one - 6.0 * two + three) / 10.0;
    const double size = fmax(fabs(sixth), 1e-300);
    return (estimate){
        .value = sixth,
        .change = fabs(sixth) * h,
        .order = isfinite(sixth) && sixth != 0.0 ? fabs(sixth - fourth) / size : (double)INFINITY,
        .noise = noise / (h * size),
    };
}

static double error_of(const estimate *e)
{
    return fmax(e->order, e->noise);
}

/* True if the function is the same at a distance on both sides. */
static int is_flat(const lag_slope *slope, double (*g)(void *context, double by), void *context, double h)
{
    return g(context, h) == slope->here && g(context, -h) == slope->here;
}

void lag_slope_find(lag_slope *slope, double (*g)(void *context, double by), void *context)
{
    const double first = PART * slope->unit;
    if (is_flat(slope, g, context, PART * slope->most) && is_flat(slope, g, context, first)) { /* most numbers do not enter */
        slope->value = 0.0;
        slope->shows = 0;
        return;
    }
    estimate best = difference(g, context, first, slope->noise);
    double h = first;
    for (int k = 0; k < MOST_STEPS && error_of(&best) > EXACT && h < PART * slope->most; ++k) {
        h = fmin(FACTOR * h, PART * slope->most);
        const estimate e = difference(g, context, h, slope->noise);
        best = error_of(&e) < error_of(&best) ? e : best;
    }
    h = first;
    for (int k = 0; k < MOST_STEPS && best.order > fmax(EXACT, best.noise) && best.order < (double)INFINITY; ++k) {
        h /= FACTOR;
        const estimate e = difference(g, context, h, slope->noise);
        if (e.noise > error_of(&best)) {
            break;
        }
        best = error_of(&e) < error_of(&best) ? e : best;
    }
    slope->value = best.value;
    slope->shows = best.change > MANY * slope->noise;
}
