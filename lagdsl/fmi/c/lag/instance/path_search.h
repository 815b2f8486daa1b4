/* A step of an importer, which is looked along. */
#ifndef LAG_PATH_SEARCH_H
#define LAG_PATH_SEARCH_H

#include "lag/instance/instance_internal.h"
#include "lag/linalg/minimum.h"

typedef struct lag_path_node {
    double *t, *x, *f, *u, *passed; /* (1) (size) (size) (nu) (watched) 1: this one has changed on the way here; -1: it shows so */
} lag_path_node;

/* The step that ends at the present state. */
typedef struct lag_path_step {
    lag_instance *instance;
    lag_path_node base, tip;
    double *seen[LAG_LOOKS]; /* (watched) room, at the looks of a piece */
    int searched;            /* the importer asks again before a change that was shown: pieces become no longer, and none is too short */
} lag_path_step;

/* The inputs at part s of the step of length h: by their rates where these are inputs, too, else in a straight line. */
void lag_path_set_inputs(const lag_path_step *in, double s, double h);

/* Looks along the step, up to the first change, which `passed` of the tip tells. */
lag_status lag_path_search(const lag_path_step *in);

#endif
