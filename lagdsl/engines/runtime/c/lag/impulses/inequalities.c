#include "lag/impulses/inequalities.h"

#include <string.h>

#include "lag/linalg/arena.h"

size_t lag_inequalities_memory(const lag_model *model)
{
    const size_t most = model->ngap + model->nslip;
    return most * (2 * model->nq + 7) + model->ngap + 2 * model->nfriction + model->nfriction * model->ngap;
}

void lag_inequalities_place(lag_inequalities *inequalities, const lag_model *model, double *memory)
{
    const size_t most = model->ngap + model->nslip;
    inequalities->rows = lag_take(&memory, most * model->nq);
    inequalities->columns = lag_take(&memory, most * model->nq);
    lag_take_all(&memory, most, (double **const[]){&inequalities->speed, &inequalities->force, &inequalities->after, &inequalities->scale,
        &inequalities->compliance, &inequalities->start, &inequalities->first, NULL});
    inequalities->restitution = lag_take(&memory, model->ngap);
    inequalities->components = lag_take(&memory, model->nfriction);
    inequalities->limits = lag_take(&memory, model->nfriction);
    inequalities->coefficients = memory;
    lag_inequalities_clear(inequalities);
}

void lag_inequalities_clear(lag_inequalities *inequalities)
{
    inequalities->normals = inequalities->frictions = inequalities->size = 0;
}

static void add(lag_inequalities *inequalities, size_t nq, const double *row, double speed)
{
    const size_t i = inequalities->size++;
    memcpy(inequalities->rows + i * nq, row, nq * sizeof(double));
    memcpy(inequalities->columns + i * nq, row, nq * sizeof(double));
    inequalities->speed[i] = speed;
    inequalities->force[i] = 0.0;
}

size_t lag_inequalities_add_normal(lag_inequalities *inequalities, size_t nq, const double *row, double speed, double restitution)
{
    add(inequalities, nq, row, speed);
    inequalities->restitution[inequalities->normals] = restitution;
    return inequalities->normals++;
}

size_t lag_inequalities_add_friction(lag_inequalities *inequalities, size_t nq, size_t components, const double *rows, const double *speed)
{
    const size_t k = inequalities->frictions++;
    for (size_t a = 0; a < components; ++a) {
        add(inequalities, nq, rows + a * nq, speed[a]);
    }
    inequalities->components[k] = (double)components;
    inequalities->limits[k] = 0.0;
    lag_fill(inequalities->normals, 0.0, inequalities->coefficients + k * inequalities->normals);
    return k;
}
