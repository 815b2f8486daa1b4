#include "lag/contacts/reserve_program.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"

/* Unit rows are dependent where a singular value is below this part of the largest, and share forces by more than this. */
static const double RANK = 1e-9;

static size_t work_memory(const lag_model *model)
{
    const size_t program = lag_reserve_program_memory(model);
    const size_t svd = model->nq * model->nc + lag_svd_memory(model->nq, model->nc);
    return lag_larger(program, svd);
}

size_t lag_reserve_memory(const lag_model *model)
{
    const size_t m = model->nc;
    return model->nfriction == 0 ? 0 : m * (model->nq + 5 + m) + 3 * (model->ncontact + model->nfriction) + lag_loads_memory(model) + work_memory(model);
}

void lag_reserve_place(lag_reserve *reserve, lag_frictions *frictions, double *memory)
{
    const lag_model *model = frictions->motion->model;
    const size_t sides = model->ncontact + model->nfriction;
    *reserve = (lag_reserve){.motion = frictions->motion, .frictions = frictions};
    if (model->nfriction == 0) {
        return;
    }
    reserve->jacobian = lag_take(&memory, model->nc * model->nq);
    lag_take_all(&memory, model->nc, (double **const[]){&reserve->residual, &reserve->active, &reserve->length, &reserve->group, &reserve->force, NULL});
    reserve->shared = lag_take(&memory, model->nc * model->nc);
    lag_take_all(&memory, sides, (double **const[]){&reserve->slack, &reserve->size, &reserve->member, NULL});
    lag_loads_place(&reserve->loads, model, lag_take(&memory, lag_loads_memory(model)));
    reserve->work = memory;
}

/* ---- groups ---- */

/* Rows that act, and their lengths. */
static lag_status find_active(lag_reserve *r)
{
    const lag_model *model = r->motion->model;
    const size_t n = model->nq;
    const lag_status status = model->velocity_constraint(&r->motion->at, r->residual, r->jacobian);
    r->count = 0;
    for (size_t i = 0; i < model->nc && status == LAG_OK; ++i) {
        const double length = sqrt(lag_dot(n, r->jacobian + i * n, r->jacobian + i * n));
        if (length > 0.0) {
            r->length[r->count] = length;
            r->active[r->count++] = (double)i;
        }
    }
    return status;
}

/* The projection onto forces of unit rows without effect, with the loads that they bring along; 1: there are some. */
static int find_shared(lag_reserve *r)
{
    const lag_model *model = r->motion->model;
    const size_t n = model->nq;
    const size_t m = r->count;
    double *memory = r->work;
    double *columns = lag_take(&memory, n * m);
    for (size_t k = 0; k < m; ++k) {
        for (size_t j = 0; j < n; ++j) {
            const size_t row = (size_t)r->active[k];
            double force = r->jacobian[row * n + j];
            for (size_t l = 0; l < model->nload; ++l) { /* a force is the negative of how M qdd - f changes */
                force -= r->loads.motion[j * model->nload + l] * r->loads.by_multiplier[l * model->nc + row];
            }
            columns[j * m + k] = force / r->length[k];
        }
    }
    const lag_svd svd = lag_svd_of(n, m, columns, memory);
    const size_t rank = lag_svd_rank(&svd, RANK);
    lag_fill(m * m, 0.0, r->shared);
    for (size_t v = rank; v < m; ++v) {
        for (size_t i = 0; i < m; ++i) {
            lag_axpy(m, svd.v[v * m + i], svd.v + v * m, r->shared + i * m);
        }
    }
    return rank < m;
}

/* Rows that share forces have one number. */
static void find_groups(lag_reserve *r)
{
    const size_t m = r->count;
    double next = 1.0;
    lag_fill(m, 0.0, r->group);
    for (size_t i = 0; i < m; ++i) {
        if (r->group[i] != 0.0 || !(r->shared[i * m + i] > RANK)) {
            continue;
        }
        int grew = 1;
        r->group[i] = next;
        while (grew) {
            grew = 0;
            for (size_t a = 0; a < m; ++a) {
                for (size_t b = 0; b < m && r->group[a] == next; ++b) {
                    if (r->group[b] == 0.0 && fabs(r->shared[a * m + b]) > RANK) {
                        r->group[b] = next;
                        grew = 1;
                    }
                }
            }
        }
        next += 1.0;
    }
}

/* The group of a row of the constraints; zero: it shares nothing, or does not act. */
static double group_of(const lag_reserve *r, size_t row)
{
    for (size_t k = 0; k < r->count; ++k) {
        if ((size_t)r->active[k] == row) {
            return r->group[k];
        }
    }
    return 0.0;
}

/* Friction that sticks joins the group of its force with those of the forces that its limit follows. */
static void join_groups(lag_reserve *r)
{
    const lag_frictions *frictions = r->frictions;
    const lag_model *model = r->motion->model;
    for (size_t k = 0; k < model->nfriction; ++k) {
        const double *gain = frictions->sticking_gain + k * model->nc;
        for (size_t a = 0; a < lag_frictions_components(frictions, k) && *lag_frictions_sticks(frictions, k) != 0.0; ++a) {
            for (size_t i = 0; i < model->nc; ++i) {
                const double own = group_of(r, model->friction_rows[(size_t)frictions->first[k] + a]);
                const double other = gain[i] != 0.0 ? group_of(r, i) : 0.0;
                for (size_t j = 0; j < r->count && own > 0.0 && other > 0.0; ++j) {
                    r->group[j] = r->group[j] == other ? own : r->group[j];
                }
            }
        }
    }
}

lag_status lag_reserve_evaluate(lag_reserve *r)
{
    const lag_model *model = r->motion->model;
    if (model->nfriction == 0) {
        return LAG_OK;
    }
    memcpy(r->force, r->motion->lam, model->nc * sizeof(double));
    lag_fill(model->ncontact + model->nfriction, (double)NAN, r->frictions->reserve);
    if (!lag_any(model->nfriction, r->motion->w + r->frictions->places.sticks)) {
        return LAG_OK;
    }
    lag_status status = find_active(r);
    status = status == LAG_OK ? lag_loads_evaluate(&r->loads, model, &r->motion->at) : status;
    status = status == LAG_OK ? lag_loads_gain(&r->loads, model, &r->motion->at) : status;
    if (status != LAG_OK || r->count == 0 || !find_shared(r)) {
        return status;
    }
    find_groups(r);
    join_groups(r);
    double groups = 0.0;
    for (size_t k = 0; k < r->count; ++k) {
        groups = fmax(groups, r->group[k]);
    }
    for (double group = 1.0; group <= groups; group += 1.0) {
        lag_reserve_find(r, group);
    }
    return LAG_OK;
}
