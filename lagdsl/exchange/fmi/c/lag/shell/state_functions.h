/* States of FMUs as handles and as bytes, the same in both versions of FMI: a version includes them once. */

LAG_FMI(Status) LAG_FMI_STATE(Get, )(lag_fmi_handle instance, LAG_FMI_STATE(, ) *state)
{
    LAG_ENTER("Get" LAG_FMI_STATE_TEXT, LAG_MODES_LASTING)
    return (LAG_FMI(Status))lag_shell_save(shell, state);
}

LAG_FMI(Status) LAG_FMI_STATE(Set, )(lag_fmi_handle instance, LAG_FMI_STATE(, ) state)
{
    LAG_ENTER("Set" LAG_FMI_STATE_TEXT, LAG_MODES_LASTING)
    return (LAG_FMI(Status))lag_shell_load(shell, state);
}

LAG_FMI(Status) LAG_FMI_STATE(Free, )(lag_fmi_handle instance, LAG_FMI_STATE(, ) *state)
{
    LAG_ENTER("Free" LAG_FMI_STATE_TEXT, LAG_MODES_LASTING)
    return (LAG_FMI(Status))lag_shell_forget(shell, state);
}

LAG_FMI(Status) LAG_FMI_STATE(Serialized, Size)(lag_fmi_handle instance, LAG_FMI_STATE(, ) state, size_t *size)
{
    LAG_ENTER("Serialized" LAG_FMI_STATE_TEXT "Size", LAG_MODES_LASTING)
    return (LAG_FMI(Status))lag_shell_serialized_size(shell, state, size);
}

LAG_FMI(Status) LAG_FMI_STATE(Serialize, )(lag_fmi_handle instance, LAG_FMI_STATE(, ) state, LAG_FMI(Byte) bytes[], size_t size)
{
    LAG_ENTER("Serialize" LAG_FMI_STATE_TEXT, LAG_MODES_LASTING)
    return (LAG_FMI(Status))lag_shell_serialize(shell, state, (unsigned char *)bytes, size);
}
