#include "lag/impulses/inequalities.h"

#include <string.h>

#include "lag/linalg/arena.h"

void lag_inequalities_place(lag_inequalities *inequalities, const lag_model *model, lag_layout *layout)
{
    const size_t most = model->ngap + model->nslip;
    lag_lay_all(layout, most * model->nq, (double **const[]){&inequalities->rows, &inequalities->columns, NULL});
    lag_lay_all(layout, most, (double **const[]){&inequalities->speed, &inequalities->force, &inequalities->after, &inequalities->scale,
        &inequalities->compliance, &inequalities->start, &inequalities->first, NULL});
    lag_lay_all(layout, model->ngap, (double **const[]){&inequalities->gap, &inequalities->restitution, NULL});
    lag_lay_all(layout, model->nfriction, (double **const[]){&inequalities->friction, &inequalities->components, &inequalities->slip,
        &inequalities->limits, NULL});
    inequalities->coefficients = lag_lay(layout, model->nfriction * model->ngap);
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

void lag_inequalities_add_normal(lag_inequalities *inequalities, size_t nq, size_t gap, const double *row, double speed, double restitution)
{
    add(inequalities, nq, row, speed);
    inequalities->gap[inequalities->normals] = (double)gap;
    inequalities->restitution[inequalities->normals++] = restitution;
}

void lag_inequalities_add_friction(lag_inequalities *inequalities, size_t nq, size_t friction, size_t components, const double *rows, const double *speed)
{
    const size_t k = inequalities->frictions++;
    inequalities->slip[k] = (double)inequalities->size;
    for (size_t a = 0; a < components; ++a) {
        add(inequalities, nq, rows + a * nq, speed[a]);
    }
    inequalities->friction[k] = (double)friction;
    inequalities->components[k] = (double)components;
    inequalities->limits[k] = 0.0;
    lag_fill(inequalities->normals, 0.0, inequalities->coefficients + k * inequalities->normals);
}
