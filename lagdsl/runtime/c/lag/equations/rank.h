/*
 * Are the constraints about to lose rank, or has J turned so far in one step that they might have lost it on the way? A cheap look
 * that says yes too often rather than too seldom.
 */
#ifndef LAG_RANK_H
#define LAG_RANK_H

#include "lag/model.h"

typedef struct lag_look {
    size_t m, n, most;        /* rows, columns, independent rows */
    size_t rank;              /* at the state looked at last; 0: none */
    const double *sizes;      /* (n) natural sizes of the coordinates */
    const double *row_sizes;  /* (m) */
    const double *lasting;    /* (m) 0: this row comes and goes and is not looked at; null: all are */
    double *rows, *now;       /* (m, n) J in these sizes, at the last state and now */
    double *factors;          /* (m, n) of the last one, by lag_qr */
    double *tau, *diagonal;   /* (m) */
    double *pivot, *part;     /* (m) (n) */
} lag_look;

/* Doubles for a look at J (m, n). */
size_t lag_look_memory(size_t m, size_t n);

void lag_look_place(lag_look *look, const lag_model *model, const double *sizes, const double *row_sizes, double *arena);

/* LAG_ATTENTION, or LAG_OK: then this is the state that the next look starts from. */
lag_status lag_look_at(lag_look *look, const double *jacobian);

#endif
