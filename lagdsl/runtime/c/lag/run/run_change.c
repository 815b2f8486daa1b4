#include "lag/run.h"

static int alike(const lag_model *a, const lag_model *b)
{
    return a->version == b->version && a->nq == b->nq && a->nz == b->nz && a->nu == b->nu && a->nw == b->nw && a->np == b->np &&
        a->nc == b->nc && a->ny == b->ny && a->ni == b->ni && a->na == b->na && a->nk == b->nk && a->nindicator == b->nindicator &&
        a->ncontact == b->ncontact && a->ngap == b->ngap && a->nclock == b->nclock && a->nreset == b->nreset &&
        a->ncorner == b->ncorner && a->nway == b->nway && a->ncollision == b->ncollision && a->nstop == b->nstop && a->nfail == b->nfail;
}

lag_status lag_run_change(lag_run *run, const lag_model *model, double *workspace)
{
    lag_motion *motion = &run->motion;
    if (!alike(motion->model, model)) {
        return LAG_BAD_STATE_DATA;
    }
    motion->model = model;
    motion->at.context = model->context;
    motion->at.workspace = workspace;
    return motion->at.p != NULL ? model->prepare(&motion->at) : LAG_OK;
}

int lag_run_is_changed(const lag_run *run)
{
    return run->motion.at.workspace != run->memory;
}
