#include "lag/equations/entries.h"
#include "lag/initial/initial_scaling.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/methods/accuracy.h"
#include "lag/equations/motion.h"
#include "lag/linalg/arena.h"

/* A written start value that cannot be held weighs 100 times another: the square of this. */
static const double SHARP = 10.0;

size_t lag_initialization_rows(const lag_model *model)
{
    size_t rows = 0;
    for (size_t i = 0; i < model->nc; ++i) {
        rows += model->position_level[i] != 0;
    }
    return rows;
}

size_t lag_initialization_memory(const lag_model *model)
{
    return 5 * lag_motion_size(model) + 3 * model->nc + 2 * model->nq + model->nz + model->nu + model->nw + model->nq +
           model->nc + lag_initialization_lengths(model) + lag_entries_count(model);
}

void lag_initialization_place(lag_initialization *b, lag_motion *motion, double *memory)
{
    const lag_model *model = motion->model;
    const size_t size = lag_motion_size(model);
    memset(b, 0, sizeof *b);
    b->motion = motion;
    b->row = lag_take(&memory, model->nc);
    b->starts.x = lag_take(&memory, size);
    b->sizes = lag_take(&memory, size);
    b->row_sizes = lag_take(&memory, model->nc);
    b->starts.widths = lag_take(&memory, size);
    b->starts.written = lag_take(&memory, size);
    b->starts.fixed = lag_take(&memory, size);
    b->phi = lag_take(&memory, model->nc);
    b->jacobian = motion->written.rows[1];
    b->q = lag_take(&memory, model->nq);
    b->qd = lag_take(&memory, model->nq);
    b->z = lag_take(&memory, model->nz);
    b->aside.u = lag_take(&memory, model->nu);
    b->aside.w = lag_take(&memory, model->nw);
    b->still = lag_take(&memory, model->nq + model->nc);
    b->lengths = lag_take(&memory, lag_initialization_lengths(model));
    b->largest = lag_take(&memory, lag_entries_count(model));
    b->memory = memory;
    for (size_t i = 0; i < model->nc; ++i) {
        if (model->position_level[i]) {
            b->row[b->rows++] = (double)i;
        }
    }
}

/* ---- what is asked ---- */

static void ask(lag_initialization *b, lag_status (*function)(const lag_arguments *, double *, double *), double *jacobian)
{
    lag_arguments *at = &b->motion->at;
    const lag_model *model = b->motion->model;
    at->q = b->q;
    at->qd = b->qd;
    at->z = b->z;
    b->jacobian = jacobian;
    if (function(at, b->phi, b->jacobian) != LAG_OK) {
        lag_fill(model->nc, (double)NAN, b->phi);
        for (size_t i = 0; i < model->nc; ++i) { /* only what the model writes, too */
            const lag_entries entries = lag_entries_of(model, i);
            for (size_t k = entries.first; k < entries.end; ++k) {
                b->jacobian[i * model->nq + lag_entry_column(&entries, k)] = (double)NAN;
            }
        }
    }
}

void lag_initialization_positions(lag_initialization *b)
{
    ask(b, b->motion->model->position_constraint, b->motion->written.rows[0]);
}

void lag_initialization_velocities(lag_initialization *b)
{
    ask(b, b->motion->model->velocity_constraint, b->motion->written.rows[1]);
}

double lag_initialization_draw(unsigned long long *seed)
{
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) {
        *seed = *seed * 6364136223846793005ULL + 1442695040888963407ULL;
        sum += (double)(*seed >> 11) / 9007199254740992.0;
    }
    return sum;
}

void lag_initialization_point(const lag_initialization *b, unsigned long long *seed, size_t which, const double *q, double *point)
{
    const lag_start *start = b->start;
    const double width = 0.4 * pow(1.2, (double)(which < 12 ? which : 12));
    for (size_t j = 0; j < b->motion->model->nq; ++j) {
        point[j] = q[j] + width * b->sizes[j] * lag_initialization_draw(seed);
        if (start != NULL && start->minimum != NULL) {
            point[j] = fmax(point[j], start->minimum[j]);
        }
        if (start != NULL && start->maximum != NULL) {
            point[j] = fmin(point[j], start->maximum[j]);
        }
    }
}

/* ---- sizes ---- */

static void find_sizes(lag_initialization *b, const double *q)
{
    const size_t n = b->motion->model->nq;
    const double *nominal = b->start != NULL ? b->start->nominal : NULL;
    lag_accuracy_groups(b->motion->model, q, b->starts.widths, b->sizes, b->starts.written); /* groups, sizes and caps */
    for (size_t i = 0; i < lag_motion_size(b->motion->model) && nominal != NULL; ++i) {
        const double own = nominal[i >= n && i < 2 * n ? i - n : i];
        b->sizes[i] = own != 0.0 ? fabs(own) : b->sizes[i];
    }
}

static void find_widths(lag_initialization *b, const unsigned char *set)
{
    const lag_start *start = b->start;
    for (size_t i = 0; i < lag_motion_size(b->motion->model); ++i) {
        const int written = (start != NULL && start->written != NULL && (start->written[i] & LAG_WRITTEN) != 0) || (set != NULL && set[i]);
        b->starts.written[i] = written;
        b->starts.fixed[i] = start != NULL && start->fixed != NULL && start->fixed[i];
        b->starts.widths[i] = written ? b->sizes[i] / SHARP : b->sizes[i];
    }
}

/* ---- discretes ---- */

/* Discretes of the start, with the truths of relations in the state (q, qd, z). */
static lag_status find_discretes(lag_initialization *b, const double *q, const double *qd, const double *z)
{
    lag_motion *motion = b->motion;
    const lag_model *model = motion->model;
    lag_arguments at = motion->at;
    if (model->discrete_start == NULL) {
        return LAG_OK;
    }
    lag_status status = model->discrete_start(&at, motion->w);
    at.q = q;
    at.qd = qd;
    at.z = z;
    at.qdd = b->still;
    at.lam = b->still + model->nq;
    int settled = model->standing == NULL;
    for (size_t k = 0; k <= model->nindicator && status == LAG_OK && !settled; ++k) { /* relations may be between what others decide */
        status = model->standing(&at, b->aside.w);
        settled = 1;
        for (size_t i = 0; i < model->nw; ++i) {
            settled = settled && motion->w[i] == b->aside.w[i];
            motion->w[i] = b->aside.w[i];
        }
    }
    return status;
}

/* Contacts closed and slips held, or none of them. */
static void close_contacts(lag_initialization *b, double closed)
{
    const lag_model *model = b->motion->model;
    const lag_places places = lag_places_of(model);
    for (size_t i = 0; i < model->ncontact; ++i) {
        b->motion->w[places.contact + i] = closed;
    }
    for (size_t i = 0; i < model->nfriction; ++i) {
        b->motion->w[places.sticks + i] = closed;
    }
}

void lag_initialization_parameters(lag_initialization *b)
{
    const size_t n = b->motion->model->nq;
    (void)lag_motion_parameters(b->motion, b->told.p);
    (void)find_discretes(b, b->starts.x, b->starts.x + n, b->starts.x + 2 * n);
    close_contacts(b, 0.0);
}

lag_status lag_initialization_at(lag_initialization *b, const lag_start *start, const unsigned char *set, double t, const double *x)
{
    lag_motion *motion = b->motion;
    const lag_model *model = motion->model;
    const size_t n = model->nq;
    double *own = b->starts.widths; /* the start values of the model, */
    b->start = start;
    b->t = t;
    lag_fill(n + model->nc, 0.0, b->still);
    lag_motion_set_state(motion, t, x); /* and the inputs of the motion, which stay */
    memcpy(b->starts.x, x, lag_motion_size(model) * sizeof(double));
    lag_status status = model->start(&motion->at, own, own + n, own + 2 * n, b->aside.u);
    if (status != LAG_OK) {
        return status;
    }
    memcpy(b->starts.fixed, own, n * sizeof(double));
    memcpy(b->q, own, n * sizeof(double));
    memcpy(b->qd, own + n, n * sizeof(double));
    memcpy(b->z, own + 2 * n, model->nz * sizeof(double));
    status = find_discretes(b, b->q, b->qd, b->z);
    if (status != LAG_OK) {
        return status;
    }
    close_contacts(b, 1.0);
    find_sizes(b, b->starts.fixed);
    lag_initialization_find_row_sizes(b, b->starts.fixed);
    close_contacts(b, 0.0);
    find_widths(b, set);
    memcpy(b->q, x, n * sizeof(double));
    memcpy(b->qd, x + n, n * sizeof(double));
    memcpy(b->z, x + 2 * n, model->nz * sizeof(double));
    return LAG_OK;
}
