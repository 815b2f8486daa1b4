/* Many states and directions of the model STEM, with lanes and without: the same. */
#include "STEM.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lag/batch.h"
#include "lag/dynamics.h"

enum { COUNT = 37 };

static double *numbers(size_t count)
{
    double *array = malloc((count + 1) * sizeof(double));
    static unsigned long long seed = 1;
    for (size_t i = 0; i < count; ++i) {
        seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
        array[i] = (double)(seed >> 11) / 9007199254740992.0;
    }
    return array;
}

static lag_status jacobians(const lag_model *m, const lag_tangents *tangents, lag_range x, lag_batch batch,
    double *rates)
{
    size_t coordinate;
    batch.workspace = numbers(lag_jacobian_workspace(m, tangents));
    batch.memory = numbers(lag_jacobian_memory(m, tangents));
    return lag_batch_jacobian(m, tangents, &batch, x, rates, NULL, &coordinate);
}

int main(void)
{
    const lag_model *m = &STEM_model;
    const size_t size = 2 * m->nq + m->nz;
    size_t coordinate;
    double *qdd[2] = {numbers(COUNT * m->nq), numbers(COUNT * m->nq)};
    double *lam[2] = {numbers(COUNT * m->nc), numbers(COUNT * m->nc)};
    lag_batch batch = {.count = COUNT, .t = {numbers(COUNT), 1}, .q = {numbers(COUNT * m->nq), m->nq},
        .qd = {numbers(COUNT * m->nq), m->nq}, .z = {numbers(COUNT * m->nz), m->nz}, .u = {numbers(m->nu), 0},
        .w = {numbers(m->nw), 0}, .p = {m->defaults, 0}, .workspace = numbers(m->workspace),
        .memory = numbers(lag_dynamics_memory(m)), .lanes = numbers(lag_batch_memory(m, &STEM_states))};
    if (lag_batch_forward_dynamics(m, NULL, &batch, qdd[0], lam[0], &coordinate) != LAG_OK ||
        lag_batch_forward_dynamics(m, &STEM_states, &batch, qdd[1], lam[1], &coordinate) != LAG_OK) {
        return 1;
    }
    if (memcmp(qdd[0], qdd[1], COUNT * m->nq * sizeof(double)) != 0 || memcmp(lam[0], lam[1], COUNT * m->nc * sizeof(double)) != 0) {
        return 2;
    }
    const lag_range state = {0, size};
    const lag_range parameters = {size + m->nu, m->np};
    const lag_tangents *tangents[2] = {&STEM_tangents, &STEM_parameter_tangents};
    for (int k = 0; k < 2; ++k) {
        const lag_range x = k == 0 ? state : parameters;
        double *rates[2] = {numbers(COUNT * size * x.count), numbers(COUNT * size * x.count)};
        if (jacobians(m, NULL, x, batch, rates[0]) != LAG_OK || jacobians(m, tangents[k], x, batch, rates[1]) != LAG_OK) {
            return 3;
        }
        double largest = 0.0, worst = 0.0;
        for (size_t i = 0; i < COUNT * size * x.count; ++i) {
            const double difference = rates[0][i] - rates[1][i];
            worst = difference > worst ? difference : -difference > worst ? -difference : worst;
            largest = rates[0][i] > largest ? rates[0][i] : largest;
        }
        if (!(worst <= 1e-11 * largest)) {
            return 4;
        }
    }
    return tangents[0]->lanes > 1 && STEM_states.lanes > 1 ? 0 : 5;
}
