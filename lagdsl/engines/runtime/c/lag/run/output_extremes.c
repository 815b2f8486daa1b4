/* The lowest and the highest value of outputs along the last step. */
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/run.h"
#include "lag/run/course.h"

/* A search ends at this part of the bracket, or after so many states; all such searches take as many states as steps do, and a few. */
static const double CLOSE = 1e-8;
enum { SCREEN = LAG_PASSED_END, MOST = 48, SPARE = 256 };

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

/* True if values with a sign may reach beyond a record beside some place, by less than a bulge, or only some of them are numbers. */
static int some_reach(const lag_course *c, double sign, double bulge, double record)
{
    double y[SCREEN + 1];
    const lag_course signed_course = {c->place, y, c->count};
    for (size_t k = 0; k <= c->count; ++k) {
        y[k] = sign * c->y[k];
    }
    for (size_t k = 0; k <= c->count; ++k) {
        const int may = !(y[k] + bulge <= record) && lag_course_peaks(&signed_course, k);
        if ((isnan(y[k]) && !isnan(y[c->count])) || (may && lag_course_reach(&signed_course, k) > record)) {
            return 1;
        }
    }
    return 0;
}

/* Values of output i among `outputs` at `count` + 1 places, with a sign. */
static void take_values(const double *outputs, size_t ny, size_t i, size_t count, double sign, double *y)
{
    for (size_t k = 0; k <= count; ++k) {
        y[k] = sign * outputs[k * ny + i];
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
static void include_outputs(lag_extremes *extremes, const lag_run *run, const double *y, int at_end)
{
    const size_t ny = run->motion.model->ny;
    for (size_t i = 0; i < ny; ++i) {
        if (at_end || !is_counted(run, i)) {
            lag_extremes_include(extremes, extremes->count - ny + i, y[i]);
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
    include_outputs(extremes, run, y, 0);
}

void lag_extremes_pass(lag_extremes *extremes, lag_run *run, unsigned place, double t)
{
    const lag_model *model = run->motion.model;
    double *y = extremes->passed + place * model->ny;
    if (place == LAG_PASSED_BEGIN) {
        lag_fill(LAG_PASSED, (double)NAN, extremes->when);
    }
    extremes->when[place] = t;
    if (model->output(&run->motion.at, y) != LAG_OK) {
        lag_fill(model->ny, (double)NAN, y);
    }
}

/* Outputs along the last step up to time t: where the method has passed before that, else at states on the cubic. */
static void pass_step(lag_extremes *extremes, lag_run *run, double t)
{
    const lag_stepper *s = &run->stepper;
    const size_t ny = run->motion.model->ny;
    double *when = extremes->when;
    const int ends = when[LAG_PASSED_END] == t;
    size_t known = 0;
    if (when[LAG_PASSED_BEGIN] == s->t_before) {
        known = 1;
        while (known < SCREEN && when[known] > when[known - 1] && when[known] < t) {
            ++known;
        }
    }
    const double from = known > 1 ? when[known - 1] : s->t_before;
    const size_t last = known > 1 ? known - 1 : 0;
    for (size_t k = known; k <= SCREEN - (size_t)ends; ++k) {
        when[k] = k < SCREEN ? from + (t - from) * (double)(k - last) / (double)(SCREEN - last) : t;
        find_cubic_state(s, extremes->size, when[k], extremes->sample);
        find_outputs(run, when[k], extremes->sample, extremes->passed + k * ny);
    }
}

/* The next step begins where the last one ended. */
static void pass_on(lag_extremes *extremes, size_t ny)
{
    double *when = extremes->when;
    const double end = when[LAG_PASSED_END];
    memcpy(extremes->passed, extremes->passed + LAG_PASSED_END * ny, ny * sizeof(double));
    lag_fill(LAG_PASSED, (double)NAN, when);
    when[LAG_PASSED_BEGIN] = end;
}

/* True if outputs along the last step show that some may exceed its range so far, or hide what is between them. */
static int outputs_exceed_range(const lag_extremes *extremes, const lag_run *run)
{
    const size_t ny = run->motion.model->ny;
    double y[SCREEN + 1];
    double weight[LAG_WINDOW];
    const lag_course c = {extremes->when, y, SCREEN};
    lag_spread_weights(extremes->when, weight);
    for (size_t i = 0; i < ny; ++i) {
        take_values(extremes->passed, ny, i, SCREEN, 1.0, y);
        const lag_spread all = lag_spread_of(y, weight);
        const double bulge = (1.0 + LAG_DOUBT) * (all.high - all.low); /* at such places no cubic exceeds values by their range */
        if (is_counted(run, i)) {
            continue;
        }
        if (lag_spread_hides(&all)) {
            return 1;
        }
        for (int side = 0; side < 2; ++side) {
            const double sign = side ? -1.0 : 1.0;
            const double record = record_of(extremes, ny, i, sign);
            const double most = side ? -all.low : all.high;
            if ((isnan(all.off) || most + bulge > record) && some_reach(&c, sign, bulge, record)) {
                return 1;
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
    static const double places[LAG_SAMPLES + 1] = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0};
    double y[LAG_SAMPLES + 1];
    double weight[LAG_WINDOW];
    const lag_course c = {places, y, LAG_SAMPLES};
    lag_spread_weights(places, weight);
    for (size_t i = 0; i < ny; ++i) {
        for (int side = 0; side < 2 && !is_counted(run, i); ++side) {
            const double sign = side ? -1.0 : 1.0;
            take_values(extremes->outputs, ny, i, LAG_SAMPLES, sign, y);
            for (size_t k = 0; k <= LAG_SAMPLES; ++k) {
                if (!lag_course_peaks(&c, k)) {
                    continue;
                }
                const size_t first = k < 2 ? 0 : k + 2 > LAG_SAMPLES ? LAG_SAMPLES + 1 - LAG_WINDOW : k - 2;
                const double reach = lag_course_reach(&c, k);
                const lag_spread around = lag_spread_of(y + first, weight);
                const int worth = extremes->searched < s->counts.evaluations + SPARE && lag_spread_hides(&around);
                if (reach > record_of(extremes, ny, i, sign) || worth) {
                    const double a = s->t_before + part * (double)(k > 0 ? k - 1 : 0);
                    const double b = k < LAG_SAMPLES ? s->t_before + part * (double)(k + 1) : t;
                    search(extremes, run, i, sign, a, b, s->t_before + part * (double)k, y[k]);
                }
            }
        }
    }
}

void lag_extremes_outputs(lag_extremes *extremes, lag_run *run, double t)
{
    const lag_stepper *s = &run->stepper;
    const size_t ny = run->motion.model->ny;
    pass_step(extremes, run, t);
    if (t == s->t) { /* the end is no approximation */
        double *end = extremes->passed + LAG_PASSED_END * ny;
        lag_run_unwind(run, end);
        include_outputs(extremes, run, end, 1);
    }
    const int beyond = outputs_exceed_range(extremes, run);
    const int last = LAG_SAMPLES - (t == s->t); /* outputs at the ends are known */
    memcpy(extremes->outputs, extremes->passed, ny * sizeof(double));
    memcpy(extremes->outputs + LAG_SAMPLES * ny, extremes->passed + LAG_PASSED_END * ny, ny * sizeof(double));
    pass_on(extremes, ny);
    if (!beyond) {
        return;
    }
    for (int k = 1; k <= last; ++k) {
        const double at = s->t_before + (t - s->t_before) * (double)k / LAG_SAMPLES;
        find_outputs_inside(extremes, run, at, extremes->outputs + (size_t)k * ny);
    }
    search_outputs(extremes, run, t);
}
