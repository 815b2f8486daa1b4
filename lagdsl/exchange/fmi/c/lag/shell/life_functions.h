/* Functions of the life of an instance, the same in both versions of FMI: a version includes them once. */

void LAG_FMI(FreeInstance)(lag_fmi_handle instance)
{
    lag_shell_free(instance, LAG_FMI_TEXT "FreeInstance");
}

LAG_FMI(Status) LAG_FMI(SetDebugLogging)(
    lag_fmi_handle instance, LAG_FMI(Boolean) loggingOn, size_t nCategories, const LAG_FMI(String) categories[])
{
    LAG_ENTER("SetDebugLogging", LAG_MODES_ALL)
    return (LAG_FMI(Status))lag_shell_set_logging(shell, loggingOn != LAG_FMI(False), nCategories, categories);
}

LAG_FMI(Status) LAG_FMI(ExitInitializationMode)(lag_fmi_handle instance)
{
    LAG_ENTER("ExitInitializationMode", LAG_MODE_INITIALIZATION)
    return (LAG_FMI(Status))lag_shell_exit_initialization(shell);
}

LAG_FMI(Status) LAG_FMI(Terminate)(lag_fmi_handle instance)
{
    LAG_ENTER("Terminate", LAG_MODE_EVENT | LAG_MODE_CONTINUOUS | LAG_MODE_STEP | LAG_MODE_STEP_FAILED)
    return (LAG_FMI(Status))lag_shell_terminate(shell);
}

LAG_FMI(Status) LAG_FMI(Reset)(lag_fmi_handle instance)
{
    LAG_ENTER("Reset", LAG_MODES_LASTING)
    return (LAG_FMI(Status))lag_shell_reset(shell);
}
