/*
 * Values of variables, the same in both versions of FMI: a version includes this once, and has a line for each of its types. LAG_FMI_ROOM is the
 * argument of a version that tells how many values there is room for, and LAG_FMI_COUNT the number of values.
 */

#define READABLE LAG_MODES_ALL
#define WRITABLE (LAG_MODE_INSTANTIATED | LAG_MODE_INITIALIZATION | LAG_MODE_EVENT | LAG_MODE_CONTINUOUS | LAG_MODE_STEP)

static void store_integer(void *values, size_t index, double value)
{
    ((int32_t *)values)[index] = lag_shell_integer(value);
}

static double fetch_integer(const void *values, size_t index)
{
    return (double)((const int32_t *)values)[index];
}

static void store_boolean(void *values, size_t index, double value)
{
    ((LAG_FMI(Boolean) *)values)[index] = value != 0.0;
}

/* Values of importers need not be 0 or 1. */
static double fetch_boolean(const void *values, size_t index)
{
    return ((const lag_fmi_boolean_bits *)values)[index] != 0 ? 1.0 : 0.0;
}

#define LAG_VALUES(NAME, TYPE, STORE, FETCH)                                                                                         \
    LAG_FMI(Status) LAG_FMI(Get##NAME)(                                                                                              \
        lag_fmi_handle instance, const LAG_FMI(ValueReference) references[], size_t n, LAG_FMI(NAME) values[] LAG_FMI_ROOM)          \
    {                                                                                                                                \
        LAG_ENTER("Get" #NAME, READABLE)                                                                                             \
        return (LAG_FMI(Status))lag_shell_get(shell, TYPE, references, n, values, LAG_FMI_COUNT, STORE);                             \
    }                                                                                                                                \
                                                                                                                                     \
    LAG_FMI(Status) LAG_FMI(Set##NAME)(                                                                                              \
        lag_fmi_handle instance, const LAG_FMI(ValueReference) references[], size_t n, const LAG_FMI(NAME) values[] LAG_FMI_ROOM)    \
    {                                                                                                                                \
        LAG_ENTER("Set" #NAME, WRITABLE)                                                                                             \
        return (LAG_FMI(Status))lag_shell_set(shell, TYPE, references, n, values, LAG_FMI_COUNT, FETCH);                             \
    }

LAG_VALUES(Boolean, LAG_TYPE_BOOLEAN, store_boolean, fetch_boolean)

LAG_FMI(Status) LAG_FMI(GetString)(
    lag_fmi_handle instance, const LAG_FMI(ValueReference) references[], size_t n, LAG_FMI(String) values[] LAG_FMI_ROOM)
{
    LAG_ENTER("GetString", READABLE)
    return (LAG_FMI(Status))lag_shell_get_texts(shell, references, n, values, LAG_FMI_COUNT);
}

LAG_FMI(Status) LAG_FMI(SetString)(
    lag_fmi_handle instance, const LAG_FMI(ValueReference) references[], size_t n, const LAG_FMI(String) values[] LAG_FMI_ROOM)
{
    LAG_ENTER("SetString", WRITABLE)
    (void)references;
    (void)values;
    return n == 0 && LAG_FMI_COUNT == 0 ?
        LAG_FMI(OK) :
        (LAG_FMI(Status))lag_shell_say(shell, LAG_ANSWER_ERROR, "texts are constants of this FMU and cannot be set");
}
