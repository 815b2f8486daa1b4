/*
 * Entry of the functions of both versions of FMI. A version includes this behind its own names: LAG_FMI(NAME) and LAG_FMI_TEXT begin a
 * function, LAG_FMI_STATE(BEFORE, AFTER) and LAG_FMI_STATE_TEXT are the state of an FMU, which each version spells in its way, lag_fmi_handle and
 * lag_fmi_real are its types. A function calls its handle `instance`; afterwards it has the `shell`.
 */
#ifndef LAG_ENTRY_H
#define LAG_ENTRY_H

#include "lag/shell/shell.h"

/* A shell of this handle that may be asked for this now, or the end of the function. */
#define LAG_ENTER(NAME, MODES)                                                           \
    lag_shell *shell = lag_shell_enter(instance, LAG_FMI_TEXT NAME, (unsigned)(MODES)); \
    if (shell == NULL) {                                                                \
        return LAG_FMI(Error);                                                          \
    }

#define LAG_NEEDS(ARGUMENT, WORDS)                             \
    if (lag_shell_lacks(shell, (ARGUMENT) == NULL, (WORDS))) { \
        return LAG_FMI(Error);                                 \
    }

/* Entry of functions that exist for one kind of instance only. */
#define LAG_ENTER_EXCHANGE(NAME, MODES)                                                                               \
    LAG_ENTER(NAME, MODES)                                                                                            \
    if (shell->now.kind != LAG_MODEL_EXCHANGE) {                                                                      \
        return (LAG_FMI(Status))lag_shell_say(shell, LAG_ANSWER_ERROR, "the instance was made for co-simulation"); \
    }

#define LAG_ENTER_STEPS(NAME, MODES)                                                                                   \
    LAG_ENTER(NAME, MODES)                                                                                             \
    if (shell->now.kind != LAG_CO_SIMULATION) {                                                                        \
        return (LAG_FMI(Status))lag_shell_say(shell, LAG_ANSWER_ERROR, "the instance was made for model exchange"); \
    }

#endif
