/* Messages to the importer, and the FMI status of each failure. */
#include "lag/shell/shell.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { MESSAGE = 768 };

static const struct {
    const char *name;
    unsigned categories;
} CATEGORIES[] = {
    {"logAll", LAG_CATEGORY_EVENTS | LAG_CATEGORY_STATUS},
    {"logEvents", LAG_CATEGORY_EVENTS},
    {"logStatusWarning", LAG_CATEGORY_WARNING},
    {"logStatusDiscard", LAG_CATEGORY_DISCARD},
    {"logStatusError", LAG_CATEGORY_ERROR},
    {"logStatusFatal", LAG_CATEGORY_FATAL},
    /* known to the standards, and never used here */
    {"logStatusPending", 0},
    {"logSingularLinearSystems", 0},
    {"logNonlinearSystems", 0},
    {"logDynamicStateSelection", 0},
};

enum { CATEGORY_COUNT = sizeof CATEGORIES / sizeof CATEGORIES[0] };

static void log_message(lag_shell *shell, lag_answer answer, unsigned category, const char *format, va_list arguments)
{
    if ((shell->categories & category) == 0 || shell->host.tell == NULL) {
        return;
    }
    char text[MESSAGE];
    const int prefix = snprintf(text, sizeof text, "%s: ", shell->call);
    if (prefix < 0 || (size_t)prefix >= sizeof text) {
        return;
    }
    (void)vsnprintf(text + prefix, sizeof text - (size_t)prefix, format, arguments);
    const char *name = "logAll";
    for (size_t i = 0; i < CATEGORY_COUNT; ++i) {
        name = CATEGORIES[i].categories == category ? CATEGORIES[i].name : name;
    }
    shell->busy = 1;
    shell->host.tell(shell, answer, name, text);
    shell->busy = 0;
}

lag_answer lag_shell_say(lag_shell *shell, lag_answer answer, const char *format, ...)
{
    static const unsigned category[] = {
        LAG_CATEGORY_EVENTS, LAG_CATEGORY_WARNING, LAG_CATEGORY_DISCARD, LAG_CATEGORY_ERROR, LAG_CATEGORY_FATAL};
    va_list arguments;
    va_start(arguments, format);
    log_message(shell, answer, category[answer], format, arguments);
    va_end(arguments);
    return answer;
}

void lag_shell_note(lag_shell *shell, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    log_message(shell, LAG_ANSWER_OK, LAG_CATEGORY_EVENTS, format, arguments);
    va_end(arguments);
}

void lag_shell_warn(lag_shell *shell)
{
    for (const char *text = lag_instance_warning(shell->instance); text != NULL; text = lag_instance_warning(shell->instance)) {
        (void)lag_shell_say(shell, LAG_ANSWER_WARNING, "t = %.10g s: %s", shell->now.time, text);
    }
}

int lag_shell_lacks(lag_shell *shell, int missing, const char *argument)
{
    if (missing) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "%s is a null pointer", argument);
    }
    return missing;
}

lag_answer lag_shell_refused(lag_shell *shell, lag_status status)
{
    return status == LAG_OK ? LAG_ANSWER_OK : lag_shell_say(shell, LAG_ANSWER_ERROR, "%s", lag_instance_message(shell->instance));
}

lag_answer lag_shell_failed(lag_shell *shell, lag_status status)
{
    if (status == LAG_OK) {
        return LAG_ANSWER_OK;
    }
    shell->now.mode = LAG_MODE_FAILED;
    return lag_shell_refused(shell, status);
}

lag_answer lag_shell_judge(lag_shell *shell, lag_status status)
{
    switch (status) {
    case LAG_OK:
        return LAG_ANSWER_OK;
    case LAG_SINGULAR:
    case LAG_NOT_FINITE:
    case LAG_STEP_TOO_SMALL:
    case LAG_TOO_LONG:
    case LAG_PROJECTION_FAILED:
    case LAG_ATTENTION:
        return lag_shell_say(shell, LAG_ANSWER_DISCARD, "%s", lag_instance_message(shell->instance));
    case LAG_MISSING:
        return lag_shell_refused(shell, status);
    default:
        return lag_shell_failed(shell, status);
    }
}

/* The bits of a name; negative: there is no such category. */
static int bits_of(const char *name)
{
    for (size_t i = 0; i < CATEGORY_COUNT && name != NULL; ++i) {
        if (strcmp(CATEGORIES[i].name, name) == 0) {
            return (int)CATEGORIES[i].categories;
        }
    }
    return -1;
}

lag_answer lag_shell_set_logging(lag_shell *shell, int on, size_t count, const char *const *categories)
{
    if (lag_shell_lacks(shell, count > 0 && categories == NULL, "categories")) {
        return LAG_ANSWER_ERROR;
    }
    /* without names, debug logging is meant: reasons of errors are told in any case */
    unsigned bits = LAG_CATEGORY_EVENTS | (on ? LAG_CATEGORY_STATUS : 0);
    for (size_t i = 0; i < count; ++i) {
        const int more = bits_of(categories[i]);
        if (more < 0) {
            return lag_shell_say(shell, LAG_ANSWER_ERROR, "there is no log category %.80s", categories[i] != NULL ? categories[i] : "(null)");
        }
        bits = (i > 0 ? bits : 0) | (unsigned)more;
    }
    shell->categories = on ? shell->categories | bits : shell->categories & ~bits;
    return LAG_ANSWER_OK;
}
