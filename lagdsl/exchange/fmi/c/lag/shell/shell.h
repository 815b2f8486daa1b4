/*
 * Declarations that the shells of both versions of FMI share: handles, modes, messages, checks of arguments, snapshots.
 * Nothing here calls an exported function: where several FMUs are loaded, these names may be those of another one.
 */
#ifndef LAG_SHELL_H
#define LAG_SHELL_H

#include <stdint.h>

#include "lag/shell/handle.h"
#include "lag/instance/instance.h"

/* The exported model of this binary. */
extern const lag_fmu lag_exported;

/* The statuses of both versions, with their numbers. */
typedef enum lag_answer {
    LAG_ANSWER_OK,
    LAG_ANSWER_WARNING,
    LAG_ANSWER_DISCARD,
    LAG_ANSWER_ERROR,
    LAG_ANSWER_FATAL
} lag_answer;

/* Modes of both state machines; sums of them tell when a function may be called. */
typedef enum lag_mode {
    LAG_MODE_INSTANTIATED = 1,
    LAG_MODE_INITIALIZATION = 2,
    LAG_MODE_EVENT = 4,
    LAG_MODE_CONTINUOUS = 8,
    LAG_MODE_STEP = 16,         /* FMI 2: stepComplete */
    LAG_MODE_INTERMEDIATE = 32,
    LAG_MODE_STEP_FAILED = 64,  /* a step was discarded */
    LAG_MODE_TERMINATED = 128,
    LAG_MODE_FAILED = 256       /* after an error nothing but reset, a snapshot and the end help */
} lag_mode;

enum {
    LAG_MODES_ALL = 511,
    LAG_MODES_LASTING = LAG_MODES_ALL & ~LAG_MODE_INTERMEDIATE, /* between calls of an importer that is not in a callback */
    LAG_MODES_KNOWN = LAG_MODES_ALL & ~LAG_MODE_INSTANTIATED    /* there are values to look at */
};

typedef enum lag_category {
    LAG_CATEGORY_EVENTS = 1,
    LAG_CATEGORY_WARNING = 2,
    LAG_CATEGORY_DISCARD = 4,
    LAG_CATEGORY_ERROR = 8,
    LAG_CATEGORY_FATAL = 16,
    LAG_CATEGORY_STATUS = 30 /* what comes with a status: told unless switched off by name */
} lag_category;


typedef struct lag_shell lag_shell;
typedef struct lag_fmu_state lag_fmu_state;

/* Pointers from the importer; the shell of its FMI version knows the types of the callbacks. */
typedef struct lag_host {
    void *environment;
    void (*tell)(const lag_shell *shell, lag_answer answer, const char *category, const char *message);
    void (*logger)(void);
    void (*update)(void); /* null: no intermediate update */
    void *(*allocate)(size_t count, size_t size);
    void (*release)(void *memory);
} lag_host;

/* The part of a shell that belongs to a snapshot. */
typedef struct lag_course_of_calls {
    double time;                   /* [s] the present, as the importer counts */
    double reached;                /* the same as the instance counts: they may differ by round-off */
    double start, stop, tolerance; /* of the experiment; infinite stop, zero tolerance: none given */
    uint32_t kind, mode;
    uint32_t pending;              /* event mode: an update is needed */
    uint32_t due;                  /* co-simulation: event mode must be entered */
    uint32_t ended;                /* the model has ended the simulation */
    uint32_t event_mode, early_return; /* FMI 3: what the importer uses */
} lag_course_of_calls;

struct lag_shell {
    lag_handle handle;
    const lag_fmu *fmu;
    lag_instance *instance;
    lag_host host;
    const char *name;
    const char *call;    /* the function that was called */
    lag_course_of_calls now;
    unsigned categories; /* lag_category: what is told */
    int busy;            /* in a callback that may not call back */
    int kept;            /* it was told that inputs are set at events */
    double *scratch;     /* as many as the longest variable has */
    lag_known *known;    /* (capacity) */
    size_t capacity;
    lag_fmu_state *states;
};

/* ---- shell.c ---- */

typedef struct lag_birth {
    const char *name, *token;
    lag_kinds kind;
    int logging, event_mode, early_return;
    lag_host host;
} lag_birth;

/* Null, and told why, where it cannot be. */
lag_shell *lag_shell_create(const char *call, const lag_birth *birth);
/* Frees it with all its snapshots. */
void lag_shell_free(void *handle, const char *call);
/* The shell of a handle if `call` may be called in its present mode; null, and told why, if not. */
lag_shell *lag_shell_enter(void *handle, const char *call, unsigned modes);
lag_answer lag_shell_reset(lag_shell *shell);
/* Memory from the callbacks of the host; null if it has none to give. */
void *lag_shell_allocate(const lag_shell *shell, size_t size);
void lag_shell_release(const lag_shell *shell, void *memory);

/* ---- messages.c ---- */

/* Tells and returns the answer; `format` as that of printf. */
lag_answer lag_shell_say(lag_shell *shell, lag_answer answer, const char *format, ...);
/* Tells assertions that warn, and began to since the last call. */
void lag_shell_warn(lag_shell *shell);

/* For debug logging. */
void lag_shell_note(lag_shell *shell, const char *format, ...);
/* Reports an error that names the argument if `missing` is true. */
int lag_shell_lacks(lag_shell *shell, int missing, const char *argument);
/* An error that leaves the instance as it was. */
lag_answer lag_shell_refused(lag_shell *shell, lag_status status);
/* Of an evaluation or a step that may be tried again elsewhere: discarded; of all others the end. */
lag_answer lag_shell_judge(lag_shell *shell, lag_status status);
/* The end. */
lag_answer lag_shell_failed(lag_shell *shell, lag_status status);
lag_answer lag_shell_set_logging(lag_shell *shell, int on, size_t count, const char *const *categories);

/* ---- access.c ---- */

typedef void lag_store(void *values, size_t index, double value);
typedef double lag_fetch(const void *values, size_t index);

lag_answer lag_shell_get(lag_shell *shell, lag_type type, const uint32_t *references, size_t n, void *values, size_t count, lag_store *store);
/* All or nothing. */
lag_answer lag_shell_set(
    lag_shell *shell, lag_type type, const uint32_t *references, size_t n, const void *values, size_t count, lag_fetch *fetch);
/* The variable of a reference; null, and told why: there is none. */
const lag_variable *lag_shell_variable(lag_shell *shell, uint32_t reference);
/* Counts the values of these variables; 0, and told why: they are not all of this type. */
int lag_shell_count(lag_shell *shell, lag_type type, const uint32_t *references, size_t n, size_t *count);
/* True if all references name clocks, and `values` is no null pointer. */
int lag_shell_clocks(lag_shell *shell, const uint32_t *references, size_t n, const void *values);
lag_answer lag_shell_get_texts(lag_shell *shell, const uint32_t *references, size_t n, const char **values, size_t count);
/* The nearest that Integers of importers can be. */
int32_t lag_shell_integer(double value);
/* Of variables of a type that no model has. */
lag_answer lag_shell_none(lag_shell *shell, size_t n, const char *type);
/* In initialization: the state that follows from what was set. */
lag_answer lag_shell_initialized(lag_shell *shell);
/* True if all references name variables of this type with `count` values in all, and no array is null. */
int lag_shell_consistent(lag_shell *shell, lag_type type, const uint32_t *references, size_t n, const void *values, size_t count);
/* Of real variables, with an order each. */
lag_answer lag_shell_set_input_derivatives(lag_shell *shell, const uint32_t *references, size_t n, const int *orders, const double *values);

/* ---- directional_derivatives.c ---- */

/* Sizes are those of the arguments, entry by entry. */
lag_answer lag_shell_slopes(lag_shell *shell, int adjoint, const uint32_t *unknowns, size_t nunknown, const uint32_t *knowns,
    size_t nknown, const double *seed, size_t nseed, double *sensitivity, size_t nsensitivity);
/* Of real variables, in time, with an order each. */
lag_answer lag_shell_get_output_derivatives(
    lag_shell *shell, const uint32_t *references, size_t n, const int32_t *orders, double *values, size_t count);

/* ---- lifecycle.c ---- */

/* True if t is a time that round-off permits; otherwise reports an error that calls it `what`. */
int lag_shell_is_time(lag_shell *shell, double t, const char *what);
lag_answer lag_shell_set_experiment(lag_shell *shell, int tolerance_defined, double tolerance, double start, int stop_defined, double stop);
lag_answer lag_shell_enter_initialization(lag_shell *shell);
lag_answer lag_shell_exit_initialization(lag_shell *shell);
lag_answer lag_shell_enter_events(lag_shell *shell);
lag_answer lag_shell_update(lag_shell *shell, lag_update *told);
/* To continuous-time mode or step mode. */
lag_answer lag_shell_leave_events(lag_shell *shell, lag_mode mode);
lag_answer lag_shell_terminate(lag_shell *shell);

/* ---- states.c ---- */

lag_answer lag_shell_set_time(lag_shell *shell, double time);
lag_answer lag_shell_set_states(lag_shell *shell, const double *x, size_t n);
/* The states, their derivatives, or all event indicators. */
lag_answer lag_shell_get_vector(lag_shell *shell, lag_role role, double *values, size_t n);
lag_answer lag_shell_get_nominals(lag_shell *shell, double *nominal, size_t n);
lag_answer lag_shell_completed(lag_shell *shell, int *events);

/* ---- stepping.c ---- */

/* Told of an accepted step inside a communication step at `t`; *until: not further than that. 0: it must not go on at all. */
typedef int lag_between(lag_shell *shell, double t, int may_return, double *until);

/* *told: `early` only where the importer allows that; one that does not sees it in t alone. */
lag_answer lag_shell_step(lag_shell *shell, double t, double h, lag_between *between, lag_progress *told);

/* ---- fmu_state.c ---- */

lag_answer lag_shell_save(lag_shell *shell, void **state);
lag_answer lag_shell_load(lag_shell *shell, void *state);
lag_answer lag_shell_forget(lag_shell *shell, void **state);
lag_answer lag_shell_serialized_size(lag_shell *shell, void *state, size_t *size);
lag_answer lag_shell_serialize(lag_shell *shell, void *state, unsigned char *bytes, size_t size);
lag_answer lag_shell_deserialize(lag_shell *shell, const unsigned char *bytes, size_t size, void **state);
void lag_shell_forget_all(lag_shell *shell);

#endif
