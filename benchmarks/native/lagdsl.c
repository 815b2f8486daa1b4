/* A model that lagdsl compiled: LIBRARY SYMBOL STATES TANGENTS KINDS, the kinds as one word. */
#include "contest.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lag/batch.h"
#include "lag/dynamics.h"
#include "lag/equations/jacobian.h"

enum { MANY = 1024 };

typedef lag_status (*forward_dynamics)(const lag_model *, const lag_arguments *, double *, double *, double *, size_t *);
typedef lag_status (*any_jacobian)(
    const lag_model *, const lag_tangents *, const lag_arguments *, lag_range, double *, double *, double *, size_t *);
typedef lag_status (*batch_dynamics)(
    const lag_model *, const lag_states *, const lag_batch *, double *, double *, size_t *);
typedef size_t (*measure)(const lag_model *);
typedef size_t (*measure_states)(const lag_model *, const lag_states *);
typedef size_t (*measure_tangents)(const lag_model *, const lag_tangents *);

typedef struct context {
    const lag_model *model;
    const lag_states *several;
    const lag_tangents *tangents;
    forward_dynamics solve;
    any_jacobian differentiate;
    batch_dynamics solve_many;
    lag_arguments at;
    lag_batch many;
    double *memory, *jacobian_memory, *qdd, *lam, *jacobian, *many_qdd, *many_lam;
    const double *states;
    size_t coordinate;
    lag_status worst;
} context;

static void note(context *c, lag_status status)
{
    if (status != LAG_OK) {
        c->worst = status;
    }
}

static void place(context *c, int k)
{
    c->at.q = c->states + 2 * c->model->nq * (size_t)k;
    c->at.qd = c->at.q + c->model->nq;
}

static void forward(void *given, int k)
{
    context *c = given;
    place(c, k);
    note(c, c->solve(c->model, &c->at, c->memory, c->qdd, c->lam, &c->coordinate));
}

static void jacobian(void *given, int k)
{
    context *c = given;
    place(c, k);
    const lag_range state = {0, 2 * c->model->nq};
    note(
        c,
        c->differentiate(c->model, c->tangents, &c->at, state, c->jacobian_memory, c->jacobian, NULL, &c->coordinate));
}

static void batch(void *given, int k)
{
    context *c = given;
    (void)k;
    note(c, c->solve_many(c->model, c->several, &c->many, c->many_qdd, c->many_lam, &c->coordinate));
}

/* A state that could not be solved shows as one that disagrees. */
static void fetch(const context *c, const double *from, size_t count, double *results)
{
    for (size_t i = 0; i < count; ++i) {
        results[i] = c->worst == LAG_OK ? from[i] : 0.0 / 0.0;
    }
}

static void fetch_forward(void *given, int k, double *results)
{
    context *c = given;
    (void)k;
    fetch(c, c->qdd, c->model->nq, results);
}

/* Of d(qd, qdd)/d(q, qd) the rows of qdd. */
static void fetch_jacobian(void *given, int k, double *results)
{
    context *c = given;
    const size_t n = c->model->nq;
    (void)k;
    fetch(c, c->jacobian + 2 * n * n, 2 * n * n, results);
}

static void fetch_batch(void *given, int k, double *results)
{
    context *c = given;
    fetch(c, c->many_qdd + (size_t)k * c->model->nq, c->model->nq, results);
}

static double *doubles(size_t count)
{
    const size_t size = (count / 8 + 1) * 8 * sizeof(double);
    return memset(aligned_alloc(64, size), 0, size);
}

static void fill_batch(context *c, void *library, int rows)
{
    const size_t n = c->model->nq;
    measure_states lanes;
    *(void **)&lanes = dlsym(library, "lag_batch_memory");
    double *states = doubles(2 * n * MANY), *zeros = doubles(1);
    for (int i = 0; i < MANY; ++i) {
        memcpy(states + 2 * n * (size_t)i, c->states + 2 * n * (size_t)(i % rows), 2 * n * sizeof(double));
    }
    c->many = (lag_batch){.count = MANY, .t = {zeros, 0}, .q = {states, 2 * n}, .qd = {states + n, 2 * n}, .p = {c->at.p, 0}};
    c->many.z.first = c->at.z, c->many.u.first = c->at.u, c->many.w.first = c->at.w;
    c->many.workspace = c->at.workspace, c->many.memory = c->memory;
    c->many.lanes = doubles(lanes(c->model, c->several));
    c->many_qdd = doubles(n * MANY);
    c->many_lam = doubles(c->model->nc * MANY);
}

int enter(const field *of, int count, char **arguments)
{
    void *library = count == 5 ? dlopen(arguments[0], RTLD_NOW | RTLD_LOCAL) : NULL;
    if (library == NULL) {
        fprintf(stderr, "%s\n", dlerror());
        return 1;
    }
    context *c = calloc(1, sizeof *c);
    measure memory;
    measure_tangents workspace, jacobian_memory;
    c->model = dlsym(library, arguments[1]);
    c->several = dlsym(library, arguments[2]);
    c->tangents = dlsym(library, arguments[3]);
    *(void **)&c->solve = dlsym(library, "lag_forward_dynamics");
    *(void **)&c->differentiate = dlsym(library, "lag_jacobian");
    *(void **)&c->solve_many = dlsym(library, "lag_batch_forward_dynamics");
    *(void **)&memory = dlsym(library, "lag_dynamics_memory");
    *(void **)&workspace = dlsym(library, "lag_jacobian_workspace");
    *(void **)&jacobian_memory = dlsym(library, "lag_jacobian_memory");
    const size_t n = c->model->nq;
    if ((size_t)of->n != n || c->model->nz != 0) {
        fprintf(stderr, "%s has %zu coordinates, the states %d\n", c->model->name, n, of->n);
        return 1;
    }
    double *zeros = doubles(c->model->nu + c->model->nw);
    c->states = of->states;
    c->memory = doubles(memory(c->model));
    c->qdd = doubles(n);
    c->lam = doubles(c->model->nc);
    c->at.context = c->model->context;
    c->at.z = c->at.u = c->at.w = zeros;
    c->at.p = c->model->defaults;
    c->at.workspace = doubles(workspace(c->model, c->tangents));
    c->jacobian_memory = doubles(jacobian_memory(c->model, c->tangents));
    c->model->prepare(&c->at);
    if (strstr(arguments[4], "forward") != NULL) {
        of->add((contestant){"forward", "", forward, fetch_forward, c, (int)n, 1});
    }
    if (strstr(arguments[4], "jacobian") != NULL) {
        c->jacobian = doubles(4 * n * n);
        of->add((contestant){"jacobian", "", jacobian, fetch_jacobian, c, (int)(2 * n * n), 1});
    }
    if (strstr(arguments[4], "batch") != NULL) {
        fill_batch(c, library, of->rows);
        of->add((contestant){"batch", "", batch, fetch_batch, c, (int)n, MANY});
    }
    return 0;
}
