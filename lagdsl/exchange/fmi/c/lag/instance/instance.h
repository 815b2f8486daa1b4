/*
 * One instance of an exported model, for both versions of FMI: everything but the standard's own names, argument checks and
 * the order of calls, which are in fmi2.c and fmi3.c.
 *
 * All state lies in the one block that the caller gives; copying it (lag_instance_save) is rollback. No function allocates or
 * calls back. A status other than LAG_OK comes with `message`.
 */
#ifndef LAG_INSTANCE_H
#define LAG_INSTANCE_H

#include "lag/fmu.h"
#include "lag/status.h"

/* Nobody waits for more steps of the integrator than these from one communication point to the next. */
#ifndef LAG_MOST_STEPS
#define LAG_MOST_STEPS 1e6
#endif

typedef struct lag_instance lag_instance;

/* Results of newDiscreteStates. */
typedef struct lag_update {
    int terminate;      /* the model ends the simulation; `message` tells why */
    int states_changed;
    double next;        /* time of the next time event; infinite: none */
} lag_update;

/* Results of a communication step. */
typedef struct lag_progress {
    double t;        /* reached */
    int event;       /* an event of the model is there, which event mode would carry out (only where asked to stop for them) */
    int terminate;
    int early;       /* t is before the end of the step */
} lag_progress;

typedef struct lag_known {
    size_t variable, element; /* of lag_fmu.variables, and entry of an array */
} lag_known;

size_t lag_instance_size(const lag_fmu *fmu);
lag_instance *lag_instance_place(void *block, const lag_fmu *fmu);
const char *lag_instance_message(const lag_instance *instance);
/* Says a failure in the words of the runtime and returns it; LAG_OK and LAG_STOPPED stay. */
lag_status lag_instance_judge(lag_instance *instance, lag_status status);
/* The next message of an assertion that warns, each once; null: there is none. */
const char *lag_instance_warning(lag_instance *instance);

/* ---- variables: values of one variable, (count) of it; Booleans are 0 and 1, Integers whole numbers ---- */

lag_status lag_instance_get(lag_instance *instance, size_t variable, double *values);
/* Finite values of the type of the variable and within its range, where the moment allows that: all this is the caller's to check. */
lag_status lag_instance_set(lag_instance *instance, size_t variable, const double *values);
/* Inputs become polynomials in time about the present: `order` 1 is the first derivative (co-simulation, FMI 2), 0 the value. */
lag_status lag_instance_set_input(lag_instance *instance, size_t variable, int order, const double *values);

/* ---- initialization ---- */

/* From `start` to a later `stop`. `tolerance` 0: that of the experiment. In co-simulation the run keeps to a part of one that is coarser. */
void lag_instance_setup(lag_instance *instance, lag_kinds kind, double start, double stop, double tolerance);
/*
 * States that were not set follow the parameters. All move to the nearest values that satisfy constraints and initial
 * equations; then the events of the start are carried out. A value that is set before lag_instance_begin() starts this anew;
 * reading a value does the same.
 */
lag_status lag_instance_ready(lag_instance *instance);
/* Initialization is over, in event mode; the first update or step says so, too. */
lag_status lag_instance_begin(lag_instance *instance);
/* The end: ticks that are due, then what `terminal()` wants. Values are those afterwards. */
lag_status lag_instance_terminate(lag_instance *instance);

/* ---- model exchange ---- */

void lag_instance_set_time(lag_instance *instance, double t);
void lag_instance_set_states(lag_instance *instance, const double *x);
/* The states, their derivatives, or all event indicators. */
lag_status lag_instance_vector(lag_instance *instance, lag_role role, double *values);
/* Event mode: what has changed since the last event is found anew and carried out, with what follows from it. */
lag_status lag_instance_update(lag_instance *instance, lag_update *told);
/* After an accepted step of the importer: *events 1: the constraints are off by more than the tolerance. */
lag_status lag_instance_completed(lag_instance *instance, int *events);

/* ---- co-simulation ---- */

/* Reasons for a step to end early. */
enum {
    LAG_STOP_EVENTS = 1, /* at the first event, which is left to lag_instance_update */
    LAG_STOP_STEPS = 2   /* after every step of the integrator */
};

/* From the present time over `h`; `stops`: a sum of these. */
lag_status lag_instance_step(lag_instance *instance, double h, int stops, lag_progress *told);

/* ---- clocks ---- */

/* Period [s] of a clock, and its first tick from time t on, but for round-off. It ticks by itself. */
lag_status lag_instance_clock(lag_instance *instance, size_t which, double t, double *period, double *tick);

/* ---- derivatives ---- */

/*
 * sensitivity = d unknown / d known * seed, or the adjoint seed' * d unknown / d known, exact, of the functions above as they stand (relations and
 * contacts held). Unknowns: outputs, derivatives, locals, multipliers, energies; knowns: states, inputs, tunable parameters, time; in initialization
 * whatever depends. The other one is that of a variable in time, along the motion, of order 1.
 */
lag_status lag_instance_slopes(lag_instance *instance, int adjoint, const lag_known *unknown, size_t unknowns, const lag_known *known,
    size_t knowns, const double *seed, double *sensitivity);
lag_status lag_instance_get_output_derivative(lag_instance *instance, size_t variable, int order, double *values);

/* ---- state ---- */

/* Copies that lag_instance_load takes back bit by bit, also into another instance of the same FMU, in another process. */
size_t lag_instance_saved_size(const lag_instance *instance);
void lag_instance_save(const lag_instance *instance, unsigned char *bytes);
lag_status lag_instance_load(lag_instance *instance, const unsigned char *bytes);

#endif
