#include "lag/run/extremes.h"

#include <math.h>

#include "lag/equations/discretes.h"
#include "lag/linalg/arena.h"
#include "lag/run.h"

/* A number turns around where it goes back by this part of its range. */
static const double TURNED = 0.05;
/*
 * The cubic through both ends of a step and their slopes is off by this part of its own bulge at most, about: beyond what was seen
 * so far by less, a step is not worth its dense output. (Of an oscillation, with a step of three radians.)
 */
static const double DOUBT = 0.7;
/*
 * Five values at equal distances show a function if the polynomial through four of them is off at the fifth by this part of their range
 * at most. Of those that they do not show, as a peak that is narrower than the distances, extremes are searched whatever is expected.
 */
static const double SHOWN = 0.25;
/* Values whose range is this part of them are constant; what is left is round-off. */
static const double ROUNDING = 1e-12;
/* A search ends at this part of the bracket, or after so many states; all such searches take as many states as steps do, and a few. */
static const double CLOSE = 1e-8;
enum { SCREEN = 4, MOST = 48, SPARE = 256 };

size_t lag_extremes_memory(const lag_model *model)
{
    const size_t size = lag_motion_size(model);
    return 2 * (size + lag_places_of(model).contact + model->ny) + (3 + LAG_SAMPLES + 1) * size + (LAG_SAMPLES + 2) * model->ny;
}

void lag_extremes_place(lag_extremes *extremes, const lag_model *model, double *memory)
{
    const size_t size = lag_motion_size(model);
    extremes->size = size;
    extremes->count = size + lag_places_of(model).contact + model->ny;
    extremes->low = lag_take(&memory, extremes->count);
    extremes->high = lag_take(&memory, extremes->count);
    extremes->turns = lag_take(&memory, size);
    extremes->pivot = lag_take(&memory, size);
    extremes->way = lag_take(&memory, size);
    extremes->sample = lag_take(&memory, (LAG_SAMPLES + 1) * size);
    extremes->outputs = memory;
    lag_fill(extremes->count, (double)INFINITY, extremes->low);
    lag_fill(extremes->count, -(double)INFINITY, extremes->high);
    lag_fill(3 * size, 0.0, extremes->turns);
    extremes->searched = 0;
}

static void see(lag_extremes *extremes, size_t i, double value)
{
    if (value < extremes->low[i]) {
        extremes->low[i] = value;
    }
    if (value > extremes->high[i]) {
        extremes->high[i] = value;
    }
}

void lag_extremes_row(lag_extremes *extremes, const double *values)
{
    for (size_t i = 0; i < extremes->count; ++i) {
        see(extremes, i, values[i]);
    }
}

/* Counts where numbers turn around, from one state to the next. */
static void count_turns(lag_extremes *extremes, const double *x)
{
    for (size_t i = 0; i < extremes->size; ++i) {
        const double back = TURNED * (extremes->high[i] - extremes->low[i]);
        double *pivot = extremes->pivot + i;
        double *way = extremes->way + i;
        if (*way == 0.0) {
            *way = x[i] > extremes->low[i] ? 1.0 : -1.0;
            *pivot = x[i];
        } else if (*way * (x[i] - *pivot) >= 0.0) {
            *pivot = x[i];
        } else if (*way * (*pivot - x[i]) > back) {
            *way = -*way;
            *pivot = x[i];
            extremes->turns[i] += 1.0;
        }
    }
}

/* Distances by which the cubic with values a, b and slopes fa, fb (of the whole step) exceeds its ends: up and down. */
static void find_bulge(double a, double fa, double b, double fb, double *up, double *down)
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

/* True if the cubics show that some number exceeds its range so far. */
static int gets_beyond(const lag_extremes *extremes, const lag_stepper *s)
{
    const double h = s->t - s->t_before;
    for (size_t i = 0; i < extremes->size; ++i) {
        const double a = s->x_before[i];
        const double b = s->x[i];
        double up = 0.0;
        double down = 0.0;
        find_bulge(a, h * s->f_before[i], b, h * s->f[i], &up, &down);
        if ((up > 0.0 && fmax(a, b) + (1.0 + DOUBT) * up > extremes->high[i]) ||
            (down > 0.0 && fmin(a, b) - (1.0 + DOUBT) * down < extremes->low[i])) {
            return 1;
        }
    }
    return 0;
}

/* The vertex of the parabola through three values at equal distances, if it lies between them. */
static void see_vertex(lag_extremes *extremes, size_t i, double a, double b, double c)
{
    const double bend = a - 2.0 * b + c;
    if (bend != 0.0 && fabs(a - c) <= 2.0 * fabs(bend)) {
        see(extremes, i, b - 0.125 * (a - c) * (a - c) / bend);
    }
}

static lag_status look_inside(lag_extremes *extremes, lag_stepper *s, double t)
{
    const size_t n = extremes->size;
    double *x = extremes->sample;
    for (size_t k = 0; k <= LAG_SAMPLES; ++k) {
        const lag_status status = lag_stepper_dense(s, s->t_before + (t - s->t_before) * (double)k / LAG_SAMPLES, x + k * n);
        if (status != LAG_OK) {
            return status;
        }
    }
    for (size_t i = 0; i < n; ++i) {
        for (size_t k = 1; k < LAG_SAMPLES; ++k) {
            see_vertex(extremes, i, x[(k - 1) * n + i], x[k * n + i], x[(k + 1) * n + i]);
        }
    }
    return LAG_OK;
}

/* Outputs of the state x within the last step, no numbers where there are none. */
static void find_outputs(lag_run *run, double t, const double *x, double *y)
{
    const lag_model *model = run->motion.model;
    if (lag_motion_solve(&run->motion, t, x) != LAG_OK || model->output(&run->motion.at, y) != LAG_OK) {
        lag_fill(model->ny, (double)NAN, y);
    }
}

/* The cubic through both ends of a step and their slopes: it costs no evaluation, and tells where outputs are to be looked at. */
static void find_cubic_state(const lag_stepper *s, size_t size, double t, double *x)
{
    const double h = s->t - s->t_before;
    const double r = (t - s->t_before) / h;
    const double late = r * r * (3.0 - 2.0 * r);
    for (size_t i = 0; i < size; ++i) {
        x[i] = (1.0 - late) * s->x_before[i] + late * s->x[i] + h * r * (1.0 - r) * ((1.0 - r) * s->f_before[i] - r * s->f[i]);
    }
}

/* Among `count` + 1 values at equal distances: the slope over one distance at value k, by the parabola through three of them. */
static double slope_at(const double *y, size_t count, size_t k)
{
    if (k == 0) {
        return 0.5 * (4.0 * y[1] - 3.0 * y[0] - y[2]);
    }
    return k == count ? 0.5 * (3.0 * y[k] - 4.0 * y[k - 1] + y[k - 2]) : 0.5 * (y[k + 1] - y[k - 1]);
}

/* True if the five values around value k do not show what is between them. */
static int is_hidden(const double *y, size_t count, size_t k)
{
    const size_t first = k < 2 ? 0 : k + 2 > count ? count - 4 : k - 2;
    const double *v = y + first;
    double low = v[0];
    double high = v[0];
    for (size_t i = 1; i < 5; ++i) {
        low = fmin(low, v[i]);
        high = fmax(high, v[i]);
    }
    const double off = fabs(v[0] - 4.0 * v[1] + 6.0 * v[2] - 4.0 * v[3] + v[4]) / 6.0;
    return high - low > ROUNDING * fmax(fabs(low), fabs(high)) && off > SHOWN * (high - low);
}

/* The value that may be reached beside value k, if none beside it is larger; else minus infinity, as where some are no numbers. */
static double reach_at(const double *y, size_t count, size_t k)
{
    const double before = k > 0 ? y[k - 1] : -(double)INFINITY;
    const double after = k < count ? y[k + 1] : -(double)INFINITY;
    double bulge = 0.0;
    if (!(y[k] >= before && y[k] >= after)) {
        return -(double)INFINITY;
    }
    for (size_t i = k > 0 ? k - 1 : 0; i <= k && i < count; ++i) {
        double up = 0.0;
        double down = 0.0;
        find_bulge(y[i], slope_at(y, count, i), y[i + 1], slope_at(y, count, i + 1), &up, &down);
        bulge = fmax(bulge, fmax(y[i], y[i + 1]) + (1.0 + DOUBT) * up - y[k]);
    }
    return y[k] + bulge;
}

/* Values of output i at `count` + 1 places, with a sign. */
static void take_values(const lag_extremes *extremes, size_t ny, size_t i, size_t count, double sign, double *y)
{
    for (size_t k = 0; k <= count; ++k) {
        y[k] = sign * extremes->outputs[k * ny + i];
    }
}

static double record_of(const lag_extremes *extremes, size_t ny, size_t i, double sign)
{
    const size_t place = extremes->count - ny + i;
    return sign > 0.0 ? extremes->high[place] : -extremes->low[place];
}

/* True if output i is known up to whole turns. */
static int is_counted(const lag_run *run, size_t i)
{
    return run->turns.counted != NULL && run->turns.counted[i] != 0.0;
}

/* Outputs within the last step, or at its end, up to which turns are counted. */
static void see_outputs(lag_extremes *extremes, const lag_run *run, const double *y, int at_end)
{
    const size_t ny = run->motion.model->ny;
    for (size_t i = 0; i < ny; ++i) {
        if (at_end || !is_counted(run, i)) {
            see(extremes, extremes->count - ny + i, y[i]);
        }
    }
}

/* Outputs on the dense output, which are seen; no numbers where the method has none: that does not end the run. */
static void find_outputs_inside(lag_extremes *extremes, lag_run *run, double t, double *y)
{
    const size_t ny = run->motion.model->ny;
    if (lag_stepper_dense(&run->stepper, t, extremes->sample) == LAG_OK) {
        find_outputs(run, t, extremes->sample, y);
    } else {
        lag_fill(ny, (double)NAN, y);
    }
    see_outputs(extremes, run, y, 0);
}

/* True if states on the cubics show that some output may exceed its range so far, or hide what is between them. */
static int outputs_get_beyond(lag_extremes *extremes, lag_run *run, double t)
{
    const lag_stepper *s = &run->stepper;
    const size_t ny = run->motion.model->ny;
    double y[SCREEN + 1];
    for (size_t k = 0; k <= SCREEN; ++k) {
        const double at = s->t_before + (t - s->t_before) * (double)k / SCREEN;
        find_cubic_state(s, extremes->size, at, extremes->sample);
        find_outputs(run, at, extremes->sample, extremes->outputs + k * ny);
    }
    if (t == s->t) { /* the end is no approximation */
        lag_run_unwind(run, extremes->outputs + SCREEN * ny);
        see_outputs(extremes, run, extremes->outputs + SCREEN * ny, 1);
    }
    for (size_t i = 0; i < ny; ++i) {
        for (int side = 0; side < 2 && !is_counted(run, i); ++side) {
            const double sign = side ? -1.0 : 1.0;
            take_values(extremes, ny, i, SCREEN, sign, y);
            for (size_t k = 0; k <= SCREEN; ++k) {
                if ((isnan(y[k]) && !isnan(y[SCREEN])) || is_hidden(y, SCREEN, k) || reach_at(y, SCREEN, k) > record_of(extremes, ny, i, sign)) {
                    return 1;
                }
            }
        }
    }
    return 0;
}

/*
 * The largest value of sign times output i between two times, of which `known` at `at` is the largest so far: by parabolas, else the golden
 * section (Brent, Algorithms for minimization without derivatives, 1973, chapter 5). Every output is seen on the way.
 */
static void search(lag_extremes *extremes, lag_run *run, size_t i, double sign, double a, double b,
    double at, double known)
{
    static const double GOLD = 0.3819660112501051;
    const size_t ny = run->motion.model->ny;
    const double close = CLOSE * (b - a);
    double *y = extremes->outputs + (LAG_SAMPLES + 1) * ny;
    double x = at, second = at, third = at;
    double fx = known, f2 = known, f3 = known;
    double step = 0.0, earlier = 0.0;
    for (unsigned n = 0; n < MOST && b - a > 4.0 * close; ++n) {
        const double r = (x - second) * (fx - f3);
        const double q = (x - third) * (fx - f2);
        const double below = 2.0 * (q - r);
        const double try = below != 0.0 ? ((x - second) * r - (x - third) * q) / below : (double)INFINITY;
        if (fabs(try) < 0.5 * fabs(earlier) && x + try > a + close && x + try < b - close) {
            earlier = step;
            step = try;
        } else {
            earlier = x < 0.5 * (a + b) ? b - x : a - x;
            step = GOLD * earlier;
        }
        const double u = x + (fabs(step) >= close ? step : step > 0.0 ? close : -close);
        find_outputs_inside(extremes, run, u, y);
        ++extremes->searched;
        const double fu = sign * y[i];
        if (isnan(fu)) {
            return;
        }
        if (fu >= fx) {
            *(u < x ? &b : &a) = x;
            third = second, f3 = f2;
            second = x, f2 = fx;
            x = u, fx = fu;
        } else {
            *(u < x ? &a : &b) = u;
            if (fu >= f2 || second == x) {
                third = second, f3 = f2;
                second = u, f2 = fu;
            } else {
                third = u, f3 = fu;
            }
        }
    }
}

/* Searches where values of outputs at equal distances show that there may be more beside them, or hide what is there. */
static void search_outputs(lag_extremes *extremes, lag_run *run, double t)
{
    const lag_stepper *s = &run->stepper;
    const size_t ny = run->motion.model->ny;
    const double part = (t - s->t_before) / LAG_SAMPLES;
    double y[LAG_SAMPLES + 1];
    for (size_t i = 0; i < ny; ++i) {
        for (int side = 0; side < 2 && !is_counted(run, i); ++side) {
            const double sign = side ? -1.0 : 1.0;
            take_values(extremes, ny, i, LAG_SAMPLES, sign, y);
            for (size_t k = 0; k <= LAG_SAMPLES; ++k) {
                const double reach = reach_at(y, LAG_SAMPLES, k);
                const int worth = extremes->searched < s->counts.evaluations + SPARE && is_hidden(y, LAG_SAMPLES, k);
                if (reach > record_of(extremes, ny, i, sign) || (reach > -(double)INFINITY && worth)) {
                    const double a = s->t_before + part * (double)(k > 0 ? k - 1 : 0);
                    const double b = k < LAG_SAMPLES ? s->t_before + part * (double)(k + 1) : t;
                    search(extremes, run, i, sign, a, b, s->t_before + part * (double)k, y[k]);
                }
            }
        }
    }
}

static void look_at_outputs(lag_extremes *extremes, lag_run *run, double t)
{
    const lag_stepper *s = &run->stepper;
    const size_t ny = run->motion.model->ny;
    if (!outputs_get_beyond(extremes, run, t)) {
        return;
    }
    for (size_t k = 0; k <= LAG_SAMPLES; ++k) {
        const double at = s->t_before + (t - s->t_before) * (double)k / LAG_SAMPLES;
        find_outputs_inside(extremes, run, at, extremes->outputs + k * ny);
    }
    search_outputs(extremes, run, t);
}

lag_status lag_extremes_step(lag_extremes *extremes, lag_run *run, double t)
{
    lag_stepper *s = &run->stepper;
    const int whole = t == s->t;
    lag_status status = LAG_OK;
    if (t > s->t_before && gets_beyond(extremes, s)) {
        status = look_inside(extremes, s, t);
    }
    if (t > s->t_before && run->motion.model->ny > 0 && status == LAG_OK) {
        look_at_outputs(extremes, run, t);
    }
    if (whole && status == LAG_OK) {
        for (size_t i = 0; i < extremes->size; ++i) {
            see(extremes, i, s->x[i]);
        }
        count_turns(extremes, s->x);
    }
    return status;
}
