/* Rows are as large as their derivatives usually come out, at the start and at points about it. */
#include "lag/equations/motion.h"
#include "lag/equations/entries.h"
#include "lag/initial/initial_scaling.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"

#include <math.h>
#include <string.h>

/* Errors of the numbers that enter, and the part by which round-off changes with them. */
static const double ERROR = 0x1p-50;
static const double CHANGED = 1e-3;
/* Beside the start, rows are measured at so many points: the median of their lengths hardly depends on which they are. */
enum { SIZED_AT = 9 };

/* By row: sizes at each point, then lengths of the rows of J. */
size_t lag_initialization_lengths(const lag_model *model)
{
    return 2 * SIZED_AT * model->nc + model->nc;
}

size_t lag_initialization_row_sizes_memory(const lag_model *model)
{
    return model->np + lag_entries_count(model);
}

int lag_initialization_has_defaults(const lag_initialization *b)
{
    const lag_model *model = b->motion->model;
    size_t i = 0;
    while (i < model->np && b->motion->at.p[i] == model->defaults[i]) {
        ++i;
    }
    return i == model->np;
}

static double *sizes_of(const lag_initialization *b, size_t row)
{
    return b->lengths + row * SIZED_AT;
}

static double *lengths_of(const lag_initialization *b, size_t row)
{
    return sizes_of(b, b->motion->model->nc + row);
}

/* The median of the lengths, of those that are not zero; the lower one of two. */
static double usual(double *lengths)
{
    size_t some = 0;
    for (size_t i = 0; i < SIZED_AT; ++i) {
        if (isfinite(lengths[i]) && lengths[i] > 0.0) {
            size_t place = some++;
            const double length = lengths[i];
            for (; place > 0 && lengths[place - 1] > length; --place) {
                lengths[place] = lengths[place - 1];
            }
            lengths[place] = length;
        }
    }
    return some > 0 ? lengths[(some - 1) / 2] : 0.0;
}

/* Point k. */
static void set_point(lag_initialization *b, size_t k, unsigned long long *seed, const double *q)
{
    if (k > 0) {
        lag_initialization_point(b, seed, k - 1, q, b->q);
    } else {
        memcpy(b->q, q, b->motion->model->nq * sizeof(double));
    }
}

/* Lengths of the rows of J as it was evaluated last, less the entries `less` (or null), which is number k; sizes of entries into `largest`. */
static void measure(lag_initialization *b, size_t k, const double *less)
{
    const lag_model *model = b->motion->model;
    for (size_t i = 0; i < model->nc; ++i) {
        const lag_entries entries = lag_entries_of(model, i);
        double size = 0.0;
        double length = 0.0;
        for (size_t e = entries.first; e < entries.end; ++e) {
            const size_t j = lag_entry_column(&entries, e);
            const double plain = b->jacobian[i * model->nq + j] - (less != NULL ? less[entries.before + e] : 0.0);
            const double entry = plain * b->sizes[j];
            double *seen = b->largest + entries.before + e;
            size += entry * entry;
            length += plain * plain;
            *seen = fabs(entry) <= *seen ? *seen : isfinite(entry) ? fabs(entry) : (double)INFINITY;
        }
        sizes_of(b, i)[k] = sqrt(size);
        lengths_of(b, i)[k] = sqrt(length);
    }
}

/* The entries of J as it was evaluated last. */
static void keep(const lag_initialization *b, double *kept)
{
    const lag_model *model = b->motion->model;
    for (size_t i = 0; i < model->nc; ++i) {
        const lag_entries entries = lag_entries_of(model, i);
        for (size_t e = entries.first; e < entries.end; ++e) {
            kept[entries.before + e] = b->jacobian[i * model->nq + lag_entry_column(&entries, e)];
        }
    }
}

/* Other truths of relations and Booleans. */
static void turn_discretes(lag_initialization *b, unsigned long long *seed)
{
    const lag_model *model = b->motion->model;
    const lag_places places = lag_places_of(model);
    for (size_t i = 0; i < model->nw; ++i) {
        const int relation = i >= places.relation && i < places.relation + model->nindicator;
        const int timed = i >= places.timed && i < places.timed + model->ntimed;
        const int truth = model->kinds[i] == LAG_KIND_VARIABLE && (b->aside.w[i] == 0.0 || b->aside.w[i] == 1.0);
        b->motion->w[i] = relation || timed || truth ? (double)(lag_initialization_draw(seed) > 0.0) : b->aside.w[i];
    }
}

/* Rows that are zero at all points: a discrete may be their switch. */
static void measure_branches(lag_initialization *b, const double *q)
{
    const lag_model *model = b->motion->model;
    unsigned long long seed = 20021;
    memcpy(b->q, q, model->nq * sizeof(double));
    memcpy(b->aside.w, b->motion->w, model->nw * sizeof(double));
    for (size_t k = 0; k < SIZED_AT; ++k) {
        turn_discretes(b, &seed);
        lag_initialization_velocities(b);
        measure(b, k, NULL);
    }
    memcpy(b->motion->w, b->aside.w, model->nw * sizeof(double));
}

/* The component of the coordinate that enters a row most; all are one where nobody tells. */
static size_t component_of(const lag_initialization *b, size_t row)
{
    const lag_model *model = b->motion->model;
    const lag_entries entries = lag_entries_of(model, row);
    double largest = 0.0;
    size_t most = 0;
    for (size_t k = entries.first; k < entries.end; ++k) {
        most = b->largest[entries.before + k] > largest ? lag_entry_column(&entries, k) : most;
        largest = fmax(largest, b->largest[entries.before + k]);
    }
    return model->components != NULL && model->nq > 0 ? model->components[most] : 0;
}

/* The largest of `values` (nc) in each component, into `most`. */
static void find_most(lag_initialization *b, const double *values, double *most)
{
    lag_fill(lag_motion_size(b->motion->model), 0.0, most);
    for (size_t i = 0; i < b->motion->model->nc && b->motion->model->nq > 0; ++i) {
        const size_t component = component_of(b, i);
        most[component] = fmax(most[component], values[i]);
    }
}

/* Changes of the rows with errors of the numbers that enter, in place of their lengths. */
static void measure_changes(lag_initialization *b, const double *q)
{
    lag_motion *motion = b->motion;
    const lag_model *model = motion->model;
    const double *p = motion->at.p;
    double *off = b->memory;
    double *before = off + model->np;
    unsigned long long seed = 20011;
    unsigned long long signs = 20023;
    for (size_t i = 0; i < model->np; ++i) {
        off[i] = p[i] * (1.0 + (lag_initialization_draw(&signs) > 0.0 ? ERROR : -ERROR));
    }
    for (size_t k = 0; k < SIZED_AT; ++k) {
        set_point(b, k, &seed, q);
        lag_initialization_velocities(b);
        keep(b, before);
        for (size_t j = 0; j < model->nq; ++j) {
            b->q[j] *= 1.0 + (lag_initialization_draw(&signs) > 0.0 ? ERROR : -ERROR);
        }
        (void)lag_motion_parameters(motion, off);
        lag_initialization_velocities(b);
        (void)lag_motion_parameters(motion, p);
        measure(b, k, before);
    }
}

/* LAG_INITIAL_SIZES for a row that is short, as `length` (nc) tells, and no round-off. */
static void find_short(lag_initialization *b, const double *q, const double *length)
{
    const lag_model *model = b->motion->model;
    int any = 0;
    if (lag_initialization_has_defaults(b)) {
        return;
    }
    find_most(b, length, b->starts.widths);
    for (size_t i = 0; i < model->nc; ++i) {
        any = any || (length[i] > 0.0 && length[i] < LAG_ROUGH_RANK * b->starts.widths[component_of(b, i)]);
    }
    if (!any) {
        return;
    }
    measure_changes(b, q);
    for (size_t i = 0; i < model->nc && b->told.fault == LAG_INITIAL_NONE; ++i) {
        const double part = length[i] / b->starts.widths[component_of(b, i)];
        if (length[i] > 0.0 && part < LAG_ROUGH_RANK && usual(lengths_of(b, i)) <= CHANGED * length[i]) {
            b->told.fault = LAG_INITIAL_SIZES;
            b->told.which = i;
            b->told.residual = part;
        }
    }
}

/* Rows that are zero but for the round-off of others of their component have the size of the largest of these. */
static void leave_out_round_off(lag_initialization *b)
{
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    double *most = b->starts.widths;
    find_most(b, b->row_sizes, most);
    for (size_t i = 0; i < model->nc && n > 0; ++i) {
        const size_t component = component_of(b, i);
        if (!(b->row_sizes[i] > LAG_NO_ROW * most[component])) {
            b->row_sizes[i] = b->row_sizes[i] > 0.0 ? most[component] : 1.0;
        }
    }
}

void lag_initialization_find_row_sizes(lag_initialization *b, const double *q)
{
    const lag_model *model = b->motion->model;
    double *length = b->lengths + 2 * SIZED_AT * model->nc;
    unsigned long long seed = 20011;
    int any = 0;
    lag_fill(lag_entries_count(model), 0.0, b->largest);
    for (size_t k = 0; k < SIZED_AT; ++k) {
        set_point(b, k, &seed, q);
        lag_initialization_velocities(b);
        measure(b, k, NULL);
    }
    for (size_t i = 0; i < model->nc; ++i) {
        b->row_sizes[i] = usual(sizes_of(b, i));
        length[i] = usual(lengths_of(b, i));
        any = any || length[i] == 0.0;
    }
    if (any && model->nw > 0) {
        measure_branches(b, q);
        for (size_t i = 0; i < model->nc; ++i) {
            b->row_sizes[i] = length[i] > 0.0 ? b->row_sizes[i] : usual(sizes_of(b, i));
            length[i] = length[i] > 0.0 ? length[i] : usual(lengths_of(b, i));
        }
    }
    find_short(b, q, length);
    leave_out_round_off(b);
}
