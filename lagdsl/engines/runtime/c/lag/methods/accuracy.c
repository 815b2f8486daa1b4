#include "lag/methods/accuracy.h"

#include <math.h>
#include <stddef.h>

#include "lag/linalg/order.h"

/* Numbers of groups are small: a signed conversion needs no jump. */
static size_t place_of(double group)
{
    return (size_t)(ptrdiff_t)group;
}

void lag_accuracy_after(lag_accuracy *accuracy, const double *x, double *tolerance)
{
    for (size_t i = 0; i < accuracy->size;) { /* neighbours of one group together: what was written just now is slow to read */
        const double group = accuracy->group[i];
        double largest = accuracy->largest[place_of(group)];
        for (; i < accuracy->size && accuracy->group[i] == group; ++i) {
            largest = lag_higher(largest, fabs(x[i]));
        }
        accuracy->largest[place_of(group)] = largest;
    }
    for (size_t i = 0; i < accuracy->size; ++i) {
        const double largest = accuracy->largest[place_of(accuracy->group[i])];
        tolerance[i] = LAG_ACCURACY_TOLERANCE(lag_lower, lag_higher, accuracy->relative, largest, lag_accuracy_floor(accuracy, i),
            lag_accuracy_most(accuracy, i), lag_accuracy_least(accuracy, i), fabs(x[i]));
    }
}

static int same(const char *a, const char *b)
{
    while (*a != '\0' && *a == *b) {
        ++a;
        ++b;
    }
    return *a == *b;
}

/* Coordinates of one component and unit. */
static int alike(const lag_model *model, size_t i, size_t j)
{
    return (model->components == NULL || model->components[i] == model->components[j]) &&
           same(model->coordinates[i].unit, model->coordinates[j].unit);
}

static int is_angle(const lag_model *model, size_t i)
{
    return same(model->coordinates[i].unit, "rad") || same(model->coordinates[i].unit, "1");
}

void lag_accuracy_groups(const lag_model *model, const double *start, double *group, double *natural, double *cap)
{
    const size_t n = model->nq;
    for (size_t i = 0; i < n; ++i) {
        size_t first = 0;
        while (first < i && !(group[first] == (double)first && alike(model, first, i))) {
            ++first;
        }
        group[i] = (double)first;
        group[n + i] = (double)(n + first);
        natural[i] = 0.0;
        natural[first] = isfinite(start[i]) ? fmax(natural[first], fabs(start[i])) : natural[first];
    }
    for (size_t i = n; i-- > 0;) { /* the first of a group last */
        const double most = natural[(size_t)group[i]];
        const int angle = is_angle(model, i);
        natural[i] = natural[n + i] = angle || most == 0.0 ? 1.0 : most;
        cap[i] = angle ? 1.0 : (double)INFINITY;
        cap[n + i] = (double)INFINITY;
    }
    for (size_t i = 2 * n; i < 2 * n + model->nz; ++i) {
        group[i] = (double)i;
        natural[i] = 1.0;
        cap[i] = (double)INFINITY;
    }
}
