/* MuJoCo's forward dynamics: MODEL.xml. `parts` are the functions that qdd needs, without contacts and sensors. */
#include "contest.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <mujoco/mujoco.h>

typedef struct context {
    mjModel *model;
    mjData *data;
    const double *states;
} context;

static void place(context *c, int k)
{
    const size_t n = (size_t)c->model->nv;
    memcpy(c->data->qpos, c->states + 2 * n * (size_t)k, n * sizeof(double));
    memcpy(c->data->qvel, c->states + 2 * n * (size_t)k + n, n * sizeof(double));
}

static void forward(void *given, int k)
{
    context *c = given;
    place(c, k);
    mj_forward(c->model, c->data);
}

static void parts(void *given, int k)
{
    context *c = given;
    mjModel *m = c->model;
    mjData *d = c->data;
    place(c, k);
    mj_kinematics(m, d);
    mj_comPos(m, d);
    mj_makeM(m, d);
    mj_factorM(m, d);
    mj_comVel(m, d);
    mj_rne(m, d, 0, d->qfrc_bias);
    mj_fwdAcceleration(m, d);
}

static void fetch_forward(void *given, int k, double *results)
{
    context *c = given;
    (void)k;
    memcpy(results, c->data->qacc, (size_t)c->model->nv * sizeof(double));
}

static void fetch_parts(void *given, int k, double *results)
{
    context *c = given;
    (void)k;
    memcpy(results, c->data->qacc_smooth, (size_t)c->model->nv * sizeof(double));
}

int enter(const field *of, int count, char **arguments)
{
    char error[500] = "one argument, please";
    context *c = calloc(1, sizeof *c);
    c->model = count == 1 ? mj_loadXML(arguments[0], NULL, error, sizeof error) : NULL;
    if (c->model == NULL || c->model->nv != of->n) {
        fprintf(stderr, "%s\n", error);
        return 1;
    }
    c->data = mj_makeData(c->model);
    c->states = of->states;
    of->add((contestant){"forward", "_forward", forward, fetch_forward, c, of->n, 1});
    of->add((contestant){"forward", "_parts", parts, fetch_parts, c, of->n, 1});
    return 0;
}
