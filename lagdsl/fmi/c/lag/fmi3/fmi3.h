/* Declarations that the files of the shell for FMI 3 share. */
#ifndef LAG_FMI3_H
#define LAG_FMI3_H

#include "fmi3Functions.h"

#include "lag/shell/shell.h"

/* A shell of this handle that may be asked for this now, or the end of the function. */
#define LAG_ENTER(NAME, MODES)                                                   \
    lag_shell *shell = lag_shell_enter(instance, "fmi3" NAME, (unsigned)(MODES)); \
    if (shell == NULL) {                                                         \
        return fmi3Error;                                                        \
    }

#define LAG_NEEDS(ARGUMENT, WORDS)                            \
    if (lag_shell_lacks(shell, (ARGUMENT) == NULL, (WORDS))) { \
        return fmi3Error;                                     \
    }

/* Entry of functions that exist for one kind of instance only. */
#define LAG_ENTER_EXCHANGE(NAME, MODES)                                                                     \
    LAG_ENTER(NAME, MODES)                                                                                  \
    if (shell->now.kind != LAG_MODEL_EXCHANGE) {                                                            \
        return (fmi3Status)lag_shell_say(shell, LAG_ANSWER_ERROR, "the instance was made for co-simulation"); \
    }

#define LAG_ENTER_STEPS(NAME, MODES)                                                                        \
    LAG_ENTER(NAME, MODES)                                                                                  \
    if (shell->now.kind != LAG_CO_SIMULATION) {                                                             \
        return (fmi3Status)lag_shell_say(shell, LAG_ANSWER_ERROR, "the instance was made for model exchange"); \
    }

#endif
