/*
 * Without arguments: the accelerations of the model at its start values. With a stop time and a step: its motion by the
 * classical Runge-Kutta method of order four, as CSV. Constraints are held on the level of accelerations only, so they drift.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "lag/dynamics.h"

typedef struct run {
    const lag_model *model;
    lag_arguments at;
    double *memory, *qdd, *lam;
} run;

/* x = (q, qd, z) -> (qd, qdd, zd) */
static lag_status rates(run *r, double t, const double *x, double *xd)
{
    const size_t n = r->model->nq;
    size_t coordinate = 0;
    r->at.t = t;
    r->at.q = x;
    r->at.qd = x + n;
    r->at.z = x + 2 * n;
    const lag_status status = lag_forward_dynamics(r->model, &r->at, r->memory, r->qdd, r->lam, &coordinate);
    if (status == LAG_SINGULAR) {
        (void)fprintf(stderr, "t = %g: the acceleration of %s is not determined\n", t, r->model->coordinates[coordinate].name);
    }
    if (status != LAG_OK) {
        return status;
    }
    for (size_t i = 0; i < n; ++i) {
        xd[i] = x[n + i];
        xd[n + i] = r->qdd[i];
    }
    return r->model->state_derivative(&r->at, xd + 2 * n);
}

/* One step of length h; `k` has room for five states. */
static lag_status step(run *r, double t, double h, double *x, double *k)
{
    static const double node[4] = {0.0, 0.5, 0.5, 1.0};
    static const double weight[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    const size_t size = 2 * r->model->nq + r->model->nz;
    double *at = k + 4 * size;
    for (size_t s = 0; s < 4; ++s) {
        for (size_t i = 0; i < size; ++i) {
            at[i] = s == 0 ? x[i] : x[i] + node[s] * h * k[(s - 1) * size + i];
        }
        const lag_status status = rates(r, t + node[s] * h, at, k + s * size);
        if (status != LAG_OK) {
            return status;
        }
    }
    for (size_t s = 0; s < 4; ++s) {
        for (size_t i = 0; i < size; ++i) {
            x[i] += weight[s] * h * k[s * size + i];
        }
    }
    return LAG_OK;
}

static void print_names(const lag_model *model)
{
    (void)printf("time");
    for (size_t i = 0; i < model->nq; ++i) {
        (void)printf(",%s", model->coordinates[i].name);
    }
    for (size_t i = 0; i < model->nq; ++i) {
        (void)printf(",der(%s)", model->coordinates[i].name);
    }
    for (size_t i = 0; i < model->nz; ++i) {
        (void)printf(",%s", model->states[i].name);
    }
    (void)printf("\n");
}

static void print_row(size_t size, double t, const double *x)
{
    (void)printf("%.17g", t);
    for (size_t i = 0; i < size; ++i) {
        (void)printf(",%.17g", x[i]);
    }
    (void)printf("\n");
}

static lag_status print_accelerations(run *r, const double *x, double *xd)
{
    const lag_status status = rates(r, 0.0, x, xd);
    for (size_t i = 0; i < r->model->nq && status == LAG_OK; ++i) {
        const lag_slot *slot = &r->model->coordinates[i];
        (void)printf("der(der(%s)) = %.17g (%s)/s2\n", slot->name, xd[r->model->nq + i], slot->unit);
    }
    return status;
}

static lag_status print_motion(run *r, double stop, double h, double *x, double *k)
{
    const size_t size = 2 * r->model->nq + r->model->nz;
    const long steps = lround(stop / h);
    lag_status status = LAG_OK;
    print_names(r->model);
    print_row(size, 0.0, x);
    for (long i = 0; i < steps && status == LAG_OK; ++i) {
        status = step(r, (double)i * h, h, x, k);
        if (status == LAG_OK) {
            print_row(size, (double)(i + 1) * h, x);
        }
    }
    return status;
}

int main(int argc, char **argv)
{
    const lag_model *model = &MODEL;
    const size_t n = model->nq;
    const size_t size = 2 * n + model->nz;
    const size_t count =
        model->workspace + lag_dynamics_memory(model) + n + model->nc + 6 * size + model->nu + model->nw + 1;
    double *all = calloc(count, sizeof(double));
    if (all == NULL) {
        return EXIT_FAILURE;
    }
    run r = {.model = model};
    r.at.workspace = all;
    r.memory = r.at.workspace + model->workspace;
    r.qdd = r.memory + lag_dynamics_memory(model);
    r.lam = r.qdd + n;
    double *x = r.lam + model->nc;
    double *k = x + size;
    double *u = k + 5 * size;
    r.at.p = model->defaults;
    r.at.qdd = r.qdd;
    r.at.lam = r.lam;
    r.at.u = u;
    r.at.w = u + model->nu;
    lag_status status = model->prepare(r.at.p, r.at.workspace);
    if (status == LAG_OK) {
        status = model->start(&r.at, x, x + n, x + 2 * n, u);
    }
    if (status == LAG_OK) {
        status = argc == 3 ? print_motion(&r, strtod(argv[1], NULL), strtod(argv[2], NULL), x, k)
                           : print_accelerations(&r, x, k);
    }
    free(all);
    return status == LAG_OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
