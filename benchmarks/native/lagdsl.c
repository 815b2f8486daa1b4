/* A model that lagdsl compiled, in a C loop: lagdsl LIBRARY SYMBOL STATES [COUNT]. With a count, the results at
   so many states, and no times. */
#include "bench.h"

#include <dlfcn.h>

#include "lag/dynamics.h"

typedef lag_status (*forward_dynamics)(const lag_model *, const lag_arguments *, double *, double *, double *, size_t *);
typedef lag_status (*state_jacobian)(const lag_model *, const lag_arguments *, double *, double *, size_t *);
typedef size_t (*dynamics_memory)(const lag_model *);

typedef struct context {
    const lag_model *model;
    forward_dynamics solve;
    state_jacobian differentiate;
    lag_arguments at;
    double *memory, *qdd, *lam, *jacobian;
    const double *states;
    size_t coordinate;
} context;

static void place(context *c, int k)
{
    c->at.q = c->states + 2 * c->model->nq * (size_t)k;
    c->at.qd = c->at.q + c->model->nq;
}

static void forward(void *given, int k)
{
    context *c = given;
    place(c, k);
    c->solve(c->model, &c->at, c->memory, c->qdd, c->lam, &c->coordinate);
}

static void jacobian(void *given, int k)
{
    context *c = given;
    place(c, k);
    c->differentiate(c->model, &c->at, c->memory, c->jacobian, &c->coordinate);
}

static double *doubles(size_t count)
{
    return calloc(count + 1, sizeof(double));
}

int main(int count, char **arguments)
{
    void *library = count >= 4 ? dlopen(arguments[1], RTLD_NOW) : NULL;
    if (library == NULL) {
        fprintf(stderr, "%s\n", dlerror());
        return 1;
    }
    context c = {0};
    dynamics_memory measure;
    c.model = dlsym(library, arguments[2]);
    *(void **)&c.solve = dlsym(library, "lag_forward_dynamics");
    *(void **)&c.differentiate = dlsym(library, "lag_state_jacobian");
    *(void **)&measure = dlsym(library, "lag_dynamics_memory");
    const size_t n = c.model->nq;
    double *zeros = doubles(c.model->nz + c.model->nu + c.model->nw);
    const int rows = count > 4 ? atoi(arguments[4]) : STATES;
    c.states = read_states(arguments[3], rows, (int)(2 * n));
    c.memory = doubles(measure(c.model));
    c.qdd = doubles(n);
    c.lam = doubles(c.model->nc);
    c.jacobian = doubles((2 * n + c.model->nz) * (2 * n + c.model->nz));
    c.at.z = c.at.u = c.at.w = zeros;
    c.at.p = c.model->defaults;
    c.at.workspace = doubles(c.model->workspace);
    c.model->prepare(c.at.p, c.at.workspace);
    for (int k = 0; k < rows; ++k) {
        forward(&c, k);
        show("forward", k, c.qdd, (int)n);
    }
    if (count > 4) {
        return 0;
    }
    bench("forward", forward, &c);
    if (n <= 20) {
        bench("jacobian", jacobian, &c);
    }
    return 0;
}
