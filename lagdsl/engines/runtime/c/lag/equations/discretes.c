#include "lag/equations/discretes.h"

enum { KINDS = LAG_KIND_LOAD + 1 };

/* The first entry of each kind or of a later one. */
static void find_first(const lag_model *model, size_t *first)
{
    size_t i = 0;
    for (unsigned kind = 0; kind < KINDS; ++kind) {
        while (i < model->nw && model->kinds != NULL && model->kinds[i] < kind) {
            ++i;
        }
        first[kind] = i;
    }
}

/* The one entry of a kind, if it is this one; nw where the model has none. */
static size_t only(const lag_model *model, lag_kind kind, size_t i)
{
    return i < model->nw && model->kinds[i] == (unsigned char)kind ? i : model->nw;
}

lag_places lag_places_of(const lag_model *model)
{
    size_t first[KINDS];
    find_first(model, first);
    return (lag_places){
        .contact = first[LAG_KIND_CONTACT],
        .impacts = first[LAG_KIND_IMPACTS],
        .sticks = first[LAG_KIND_STICKS],
        .direction = first[LAG_KIND_DIRECTION],
        .relation = first[LAG_KIND_RELATION],
        .timed = first[LAG_KIND_TIMED],
        .delay = first[LAG_KIND_DELAY],
        .delay_rate = first[LAG_KIND_DELAY_RATE],
        .condition = first[LAG_KIND_CONDITION],
        .clock = first[LAG_KIND_CLOCK],
        .initial = only(model, LAG_KIND_INITIAL, first[LAG_KIND_INITIAL]),
        .terminal = only(model, LAG_KIND_TERMINAL, first[LAG_KIND_TERMINAL]),
        .load = first[LAG_KIND_LOAD],
    };
}

void lag_places_clear(const lag_places *places, double *w)
{
    for (size_t i = places->clock; i < places->load; ++i) {
        w[i] = 0.0;
    }
}
