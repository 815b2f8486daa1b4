/* MuJoCo's forward dynamics in a C loop: mujoco MODEL.xml STATES. */
#include "bench.h"

#include <string.h>

#include <mujoco/mujoco.h>

typedef struct context {
    mjModel *model;
    mjData *data;
    const double *states;
} context;

static void forward(void *given, int k)
{
    context *c = given;
    const size_t n = (size_t)c->model->nv;
    memcpy(c->data->qpos, c->states + 2 * n * (size_t)k, n * sizeof(double));
    memcpy(c->data->qvel, c->states + 2 * n * (size_t)k + n, n * sizeof(double));
    mj_forward(c->model, c->data);
}

int main(int count, char **arguments)
{
    char error[500] = "two arguments, please";
    context c;
    c.model = count == 3 ? mj_loadXML(arguments[1], NULL, error, sizeof error) : NULL;
    if (c.model == NULL) {
        fprintf(stderr, "%s\n", error);
        return 1;
    }
    c.data = mj_makeData(c.model);
    c.states = read_states(arguments[2], STATES, 2 * (int)c.model->nv);
    for (int k = 0; k < STATES; ++k) {
        forward(&c, k);
        show("forward", k, c.data->qacc, (int)c.model->nv);
    }
    bench("mj_forward", forward, &c);
    return 0;
}
