#include "lag/equations/discretes.h"

/* The first entry of this kind or of a later one. */
static size_t first(const lag_model *model, lag_kind kind)
{
    size_t i = 0;
    while (i < model->nw && model->kinds != NULL && model->kinds[i] < (unsigned char)kind) {
        ++i;
    }
    return i;
}

/* The one entry of a kind; nw where the model has none. */
static size_t only(const lag_model *model, lag_kind kind)
{
    const size_t i = first(model, kind);
    return i < model->nw && model->kinds[i] == (unsigned char)kind ? i : model->nw;
}

lag_places lag_places_of(const lag_model *model)
{
    return (lag_places){
        .contact = first(model, LAG_KIND_CONTACT),
        .impacts = first(model, LAG_KIND_IMPACTS),
        .sticks = first(model, LAG_KIND_STICKS),
        .direction = first(model, LAG_KIND_DIRECTION),
        .relation = first(model, LAG_KIND_RELATION),
        .timed = first(model, LAG_KIND_TIMED),
        .condition = first(model, LAG_KIND_CONDITION),
        .clock = first(model, LAG_KIND_CLOCK),
        .initial = only(model, LAG_KIND_INITIAL),
        .terminal = only(model, LAG_KIND_TERMINAL),
        .load = first(model, LAG_KIND_LOAD),
    };
}

void lag_places_clear(const lag_places *places, double *w)
{
    for (size_t i = places->clock; i < places->load; ++i) {
        w[i] = 0.0;
    }
}
