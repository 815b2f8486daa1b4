#include "lag/equations/feedback.h"

#include <math.h>
#include <string.h>

#include "lag/equations/motion.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/factorization/lu.h"
#include "lag/linalg/vector.h"

/* Steps of Newton's method: one where loads are affine in what they depend on. */
enum { MOST_STEPS = 25 };
/* Steps with derivatives of an earlier state: those that contract find loads in fewer. So many times FOUND may be round-off. */
enum { MOST_CHORDS = 12, ROUNDINGS = 10 };
/* Loads are found when they change by less than this part of the largest of each, and of what the others add to it. */
static const double FOUND = 1e-14;
/* A determinant below this is zero. */
static const double WEDGED = 1e-9;

void lag_loads_place(lag_loads *loads, const lag_model *model, lag_layout *layout)
{
    const size_t count = model->nload;
    loads->value = lag_lay(layout, count);
    loads->by_acceleration = lag_lay(layout, count * model->nq);
    loads->by_multiplier = lag_lay(layout, count * model->nc);
    loads->motion = lag_lay(layout, model->nq * count);
    loads->by_load = lag_lay(layout, count * count);
    loads->unused = lag_lay(layout, count * (model->nz + model->ny));
}

size_t lag_loads_memory(const lag_model *model)
{
    lag_layout layout = {NULL, 0};
    lag_loads loads;
    lag_loads_place(&loads, model, &layout);
    return layout.count;
}

lag_status lag_loads_evaluate(lag_loads *loads, const lag_model *model, const lag_arguments *at)
{
    return model->nload > 0 ? model->load(at, loads->value, loads->by_acceleration, loads->by_multiplier) : LAG_OK;
}

lag_status lag_loads_gain(lag_loads *loads, const lag_model *model, const lag_arguments *at)
{
    double *outputs = loads->unused + model->nz * model->nload;
    return model->nload > 0 ? model->load_gain(at, loads->motion, loads->unused, outputs, loads->by_load) : LAG_OK;
}

void lag_loads_add_to_force(const lag_loads *loads, const lag_model *model, size_t row, double *force)
{
    for (size_t k = 0; k < model->nload; ++k) {
        const double part = loads->by_multiplier[k * model->nc + row];
        for (size_t j = 0; j < model->nq && part != 0.0; ++j) { /* a force is the negative of how M qdd - f changes */
            force[j] -= part * loads->motion[j * model->nload + k];
        }
    }
}

typedef struct feedback {
    const lag_model *model;
    lag_arguments at;        /* with w, qdd and lam of its own */
    double *load;            /* (nload) entries of that w */
    lag_loads loads;         /* L there */
    double *size;            /* (nload) the largest magnitude of each, and of its terms */
    double *slope;           /* (nload, nload) of s - L(s), decomposed */
    double *pivot;           /* (nload) */
    double *residual;        /* (nload) L(s) - s */
    double passed;           /* the largest change of a load by the last changes of all, as a part of its size */
    double *qdd_change, *lam_change; /* (nload, nq) (nload, nc) of qdd and lam for a unit load */
    double *qdd, *lam;       /* (nq) (nc) */
    lag_solve_with_loads *solve;
    void *context;
    int again;
    int wedged;              /* the determinant has passed zero */
} feedback;

size_t lag_feedback_memory(const lag_model *model)
{
    const size_t each = model->nq + model->nc;
    return model->nload == 0 ? 0 : model->nw + model->nload * (3 + each + model->nload) + lag_loads_memory(model) + each;
}

size_t lag_feedback_chord_memory(const lag_model *model)
{
    return model->nload > 0 ? 1 + model->nload * (1 + model->nload) : 0;
}

static feedback begin(const lag_model *model, const lag_arguments *at, double *memory)
{
    feedback f = {.model = model, .at = *at};
    const size_t n = model->nq;
    const size_t count = model->nload;
    double *w = lag_take(&memory, model->nw);
    lag_layout layout = {lag_take(&memory, lag_loads_memory(model)), 0};
    lag_loads_place(&f.loads, model, &layout);
    f.size = lag_take(&memory, count);
    f.pivot = lag_take(&memory, count);
    f.residual = lag_take(&memory, count);
    f.qdd_change = lag_take(&memory, count * n);
    f.lam_change = lag_take(&memory, count * model->nc);
    f.slope = lag_take(&memory, count * count);
    f.qdd = lag_take(&memory, n);
    f.lam = memory;
    memcpy(w, at->w, model->nw * sizeof(double));
    f.load = w + lag_places_of(model).load;
    f.at.w = w;
    lag_fill(count, 0.0, f.load);
    lag_fill(count, 0.0, f.size);
    return f;
}

/* Accelerations and multipliers at the present loads into qdd, lam; L there. */
static lag_status evaluate_loads(feedback *f, double *qdd, double *lam)
{
    lag_status status = f->solve(f->context, &f->at, f->again, qdd, lam);
    f->again = 1;
    f->at.qdd = qdd;
    f->at.lam = lam;
    status = status == LAG_OK ? lag_loads_evaluate(&f->loads, f->model, &f->at) : status;
    return status == LAG_OK ? lag_loads_gain(&f->loads, f->model, &f->at) : status;
}

/* Changes of qdd and lam with each of the loads: they are affine in them, and a load so large that other forces are its rounding errors shows them alone. */
static lag_status find_changes(feedback *f, const double *qdd, const double *lam)
{
    const size_t n = f->model->nq;
    const double by = 1.0 / FOUND;
    lag_status status = LAG_OK;
    for (size_t k = 0; k < f->model->nload && status == LAG_OK; ++k) {
        const double kept = f->load[k];
        f->load[k] = kept + by;
        status = f->solve(f->context, &f->at, f->again, f->qdd, f->lam);
        f->load[k] = kept;
        for (size_t j = 0; j < n; ++j) {
            f->qdd_change[k * n + j] = (f->qdd[j] - qdd[j]) / by;
        }
        for (size_t j = 0; j < f->model->nc; ++j) {
            f->lam_change[k * f->model->nc + j] = (f->lam[j] - lam[j]) / by;
        }
    }
    return status;
}

/* ds - dL at the present loads, decomposed. LAG_NO_FORCES: its determinant is zero. */
static lag_status factor(feedback *f)
{
    const size_t n = f->model->nq;
    const size_t count = f->model->nload;
    double determinant = 1.0;
    double size = 1.0;
    for (size_t i = 0; i < count; ++i) {
        double largest = 0.0;
        for (size_t k = 0; k < count; ++k) {
            const double change = f->loads.by_load[i * count + k] + lag_dot(n, f->loads.by_acceleration + i * n, f->qdd_change + k * n) +
                lag_dot(f->model->nc, f->loads.by_multiplier + i * f->model->nc, f->lam_change + k * f->model->nc);
            f->slope[i * count + k] = (i == k ? 1.0 : 0.0) - change;
            largest = fmax(largest, fabs(f->slope[i * count + k]));
            f->size[i] = fmax(f->size[i], fabs(change * f->load[k]));
        }
        size *= fmax(largest, 1.0);
    }
    if (!lag_finite(count * count, f->slope) || !lag_lu(count, f->slope, f->pivot)) {
        return LAG_NO_FORCES;
    }
    for (size_t i = 0; i < count; ++i) {
        determinant *= f->slope[i * count + i];
        determinant = (size_t)f->pivot[i] == i ? determinant : -determinant;
    }
    f->wedged = !(determinant > WEDGED * size);
    return LAG_OK;
}

/* The loads change as these decomposed derivatives tell; *left: the largest change of a load, as a part of its size. */
static lag_status change_loads(feedback *f, const double *slope, const double *pivot, double *left)
{
    const size_t count = f->model->nload;
    *left = 0.0;
    for (size_t i = 0; i < count; ++i) {
        f->loads.value[i] -= f->load[i];
    }
    memcpy(f->residual, f->loads.value, count * sizeof(double));
    f->passed = 0.0;
    lag_lu_solve(count, slope, pivot, f->loads.value);
    for (size_t i = 0; i < count; ++i) {
        f->load[i] += f->loads.value[i];
        f->size[i] = fmax(f->size[i], fabs(f->load[i]));
        const double size = f->size[i] > 0.0 ? f->size[i] : 1.0;
        *left = fmax(*left, fabs(f->loads.value[i]) / size);
        f->passed = fmax(f->passed, fabs(f->loads.value[i] - f->residual[i]) / size);
    }
    return lag_finite(count, f->load) ? LAG_OK : LAG_NO_FORCES;
}

/* From no loads, for which qdd, lam and L are found. */
static lag_status start(feedback *f, double *qdd, double *lam)
{
    lag_fill(f->model->nload, 0.0, f->load);
    const lag_status status = evaluate_loads(f, qdd, lam);
    for (size_t i = 0; i < f->model->nload; ++i) {
        f->size[i] = fabs(f->loads.value[i]);
    }
    return status;
}

/* Steps with the derivatives of an earlier state. LAG_MISSING: they do not contract, or there are none. */
static lag_status follow_chord(feedback *f, const double *chord, double *qdd, double *lam)
{
    const double *pivot = chord + 1;
    const double *slope = pivot + f->model->nload;
    double left = 0.0;
    double before = (double)INFINITY;
    lag_status status = *chord != 0.0 ? LAG_OK : LAG_MISSING;
    for (int k = 0; k < MOST_CHORDS && status == LAG_OK; ++k) {
        status = change_loads(f, slope, pivot, &left);
        status = status == LAG_OK ? evaluate_loads(f, qdd, lam) : status;
        if (status == LAG_OK && (left <= FOUND || (left >= before && before <= ROUNDINGS * FOUND))) {
            return LAG_OK;
        }
        status = left < before ? status : LAG_MISSING;
        before = left;
    }
    return LAG_MISSING;
}

/* Newton's method. */
static lag_status find_loads(feedback *f, double *qdd, double *lam)
{
    lag_status status = find_changes(f, qdd, lam);
    double left = (double)INFINITY;
    double before = (double)INFINITY;
    for (int k = 0; k < MOST_STEPS && status == LAG_OK; ++k) {
        status = factor(f);
        status = status == LAG_OK ? change_loads(f, f->slope, f->pivot, &left) : status;
        status = status == LAG_OK ? evaluate_loads(f, qdd, lam) : status;
        const int ends = k > 0 && (f->passed <= FOUND || (left >= before && before < sqrt(FOUND))); /* loads of rounding errors change no others */
        if (status == LAG_OK && (left <= FOUND || ends)) {
            return f->wedged ? LAG_NO_FORCES : LAG_OK;
        }
        before = left;
    }
    return status == LAG_OK ? LAG_NO_FORCES : status;
}

lag_status lag_feedback_solve(
    const lag_model *model, const lag_arguments *at, lag_solve_with_loads *solve, void *context, double *memory, double *chord, double *qdd,
    double *lam)
{
    const size_t count = model->nload;
    feedback f = begin(model, at, memory);
    f.solve = solve;
    f.context = context;
    lag_status status = start(&f, qdd, lam);
    if (status != LAG_OK || chord == NULL) {
        return status == LAG_OK ? find_loads(&f, qdd, lam) : status;
    }
    if (follow_chord(&f, chord, qdd, lam) == LAG_OK) {
        return LAG_OK;
    }
    status = *chord != 0.0 ? start(&f, qdd, lam) : LAG_OK;
    status = status == LAG_OK ? find_loads(&f, qdd, lam) : status;
    *chord = status == LAG_OK ? 1.0 : 0.0;
    memcpy(chord + 1, f.pivot, count * sizeof(double));
    memcpy(chord + 1 + count, f.slope, count * count * sizeof(double));
    return status;
}
