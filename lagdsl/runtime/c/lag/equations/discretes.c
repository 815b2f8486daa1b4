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

lag_places lag_places_of(const lag_model *model)
{
    lag_places places = {
        .contact = first(model, LAG_KIND_CONTACT),
        .impacts = first(model, LAG_KIND_IMPACTS),
        .relation = first(model, LAG_KIND_RELATION),
        .timed = first(model, LAG_KIND_TIMED),
        .condition = first(model, LAG_KIND_CONDITION),
        .clock = first(model, LAG_KIND_CLOCK),
        .initial = first(model, LAG_KIND_INITIAL),
        .terminal = first(model, LAG_KIND_TERMINAL),
    };
    if (places.initial == places.terminal) {
        places.initial = model->nw;
    }
    return places;
}

void lag_places_clear(const lag_model *model, const lag_places *places, double *w)
{
    for (size_t i = places->clock; i < model->nw; ++i) {
        w[i] = 0.0;
    }
}
