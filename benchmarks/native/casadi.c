/* A function f(q, qd) -> qdd that CasADi generated, in a C loop: casadi LIBRARY STATES N. */
#include "bench.h"

#include <dlfcn.h>

typedef int (*function)(const double **, double **, long long *, double *, int);
typedef int (*sizes)(long long *, long long *, long long *, long long *);

typedef struct context {
    function f;
    const double **arguments;
    double **results;
    long long *integers;
    double *work, *qdd;
    const double *states;
    int n;
} context;

static void call(void *given, int k)
{
    context *c = given;
    c->arguments[0] = c->states + 2 * c->n * k;
    c->arguments[1] = c->arguments[0] + c->n;
    c->results[0] = c->qdd;
    c->f(c->arguments, c->results, c->integers, c->work, 0);
}

int main(int count, char **arguments)
{
    void *library = count == 4 ? dlopen(arguments[1], RTLD_NOW) : NULL;
    if (library == NULL) {
        fprintf(stderr, "%s\n", dlerror());
        return 1;
    }
    context c;
    long long arg, res, iw, w;
    c.n = atoi(arguments[3]);
    c.states = read_states(arguments[2], STATES, 2 * c.n);
    *(void **)&c.f = dlsym(library, "f");
    sizes work;
    *(void **)&work = dlsym(library, "f_work");
    work(&arg, &res, &iw, &w);
    c.arguments = calloc((size_t)arg + 1, sizeof *c.arguments);
    c.results = calloc((size_t)res + 1, sizeof *c.results);
    c.integers = calloc((size_t)iw + 1, sizeof *c.integers);
    c.work = calloc((size_t)w + 1, sizeof *c.work);
    c.qdd = calloc((size_t)c.n, sizeof *c.qdd);
    for (int k = 0; k < STATES; ++k) {
        call(&c, k);
        show("forward", k, c.qdd, c.n);
    }
    bench("casadi", call, &c);
    return 0;
}
