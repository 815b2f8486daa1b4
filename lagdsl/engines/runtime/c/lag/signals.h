/*
 * Inputs that tables tell: functions of time in pieces. They are only read, so runs in any number of threads share them.
 *
 *     lag_run_options options = {.callbacks = {.inputs = lag_signals_tell, .context = &signals}, .u = constants};
 */
#ifndef LAG_SIGNALS_H
#define LAG_SIGNALS_H

#include <stddef.h>

typedef enum lag_signal_kind {
    LAG_SIGNAL_HELD,      /* no table: the input stays as it is */
    LAG_SIGNAL_STEPS,     /* each value from its time on */
    LAG_SIGNAL_LINES,     /* straight lines between the values, and through the outer two beyond them */
    LAG_SIGNAL_POLYNOMIAL /* of the time since the beginning of the piece */
} lag_signal_kind;

typedef struct lag_signal {
    lag_signal_kind kind;
    size_t count;        /* times, two at least */
    size_t terms;        /* of a polynomial */
    const double *time;  /* (count) ascending; the value jumps where two are equal */
    const double *value; /* (count), of polynomials (count - 1, terms), the highest power first */
} lag_signal;

typedef struct lag_signals {
    size_t count;             /* inputs */
    const lag_signal *signal; /* (count) */
} lag_signals;

/* The value at time t; `before`: where it jumps, the value before. */
double lag_signal_at(const lag_signal *signal, double t, int before);

/* A lag_inputs; its context is a lag_signals. */
void lag_signals_tell(void *context, double t, int before, double *u);

#endif
