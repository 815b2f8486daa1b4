/* First entry of each group in the discretes w of a model; the counts are those of lag_model. */
#ifndef LAG_DISCRETES_H
#define LAG_DISCRETES_H

#include "lag/model.h"

typedef struct lag_places {
    size_t contact, impacts; /* (ncontact) each */
    size_t sticks, direction; /* (nfriction) (nslip) */
    size_t relation;         /* (nindicator) truths. Turned by event_sides.c; carried over by event_iteration.c, event_contacts.c, refraction.c */
    size_t timed;            /* (ntimed) */
    size_t delay, delay_rate; /* (ndelay) each */
    size_t condition, clock; /* up to `clock`; (nclock) */
    size_t initial, terminal; /* one entry each; nw where the model has none */
    size_t load;             /* (nload) up to the end */
} lag_places;

lag_places lag_places_of(const lag_model *model);

/* Clears what lasts for one pass only: clocks and instants. */
void lag_places_clear(const lag_places *places, double *w);

/* 1: relation i holds with this value of its indicator. */
static inline int lag_relation_holds(const lag_model *model, size_t i, double g)
{
    return g > 0.0 || (g == 0.0 && model->strict[i] == 0);
}

#endif
