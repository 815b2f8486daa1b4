/* Functions of model exchange, the same in both versions of FMI: a version includes them once. */

#define EXCHANGE (LAG_MODE_EVENT | LAG_MODE_CONTINUOUS)
#define EVALUABLE (EXCHANGE | LAG_MODE_INITIALIZATION | LAG_MODE_TERMINATED | LAG_MODE_FAILED)

LAG_FMI(Status) LAG_FMI(EnterContinuousTimeMode)(lag_fmi_handle instance)
{
    LAG_ENTER_EXCHANGE("EnterContinuousTimeMode", LAG_MODE_EVENT)
    return (LAG_FMI(Status))lag_shell_leave_events(shell, LAG_MODE_CONTINUOUS);
}

LAG_FMI(Status) LAG_FMI(CompletedIntegratorStep)(lag_fmi_handle instance, LAG_FMI(Boolean) noSetFMUStatePriorToCurrentPoint,
    LAG_FMI(Boolean) *enterEventMode, LAG_FMI(Boolean) *terminateSimulation)
{
    LAG_ENTER_EXCHANGE("CompletedIntegratorStep", LAG_MODE_CONTINUOUS)
    (void)noSetFMUStatePriorToCurrentPoint;
    LAG_NEEDS(enterEventMode, "enterEventMode")
    LAG_NEEDS(terminateSimulation, "terminateSimulation")
    int events = 0;
    const lag_answer answer = lag_shell_completed(shell, &events);
    *enterEventMode = events ? LAG_FMI(True) : LAG_FMI(False);
    *terminateSimulation = LAG_FMI(False); /* a model ends in event mode */
    return (LAG_FMI(Status))answer;
}

LAG_FMI(Status) LAG_FMI(SetTime)(lag_fmi_handle instance, lag_fmi_real time)
{
    LAG_ENTER_EXCHANGE("SetTime", EXCHANGE)
    return (LAG_FMI(Status))lag_shell_set_time(shell, time);
}

LAG_FMI(Status) LAG_FMI(SetContinuousStates)(lag_fmi_handle instance, const lag_fmi_real x[], size_t nx)
{
    LAG_ENTER_EXCHANGE("SetContinuousStates", LAG_MODE_CONTINUOUS)
    return (LAG_FMI(Status))lag_shell_set_states(shell, x, nx);
}

LAG_FMI(Status) LAG_FMI(GetContinuousStates)(lag_fmi_handle instance, lag_fmi_real x[], size_t nx)
{
    LAG_ENTER_EXCHANGE("GetContinuousStates", EVALUABLE)
    return (LAG_FMI(Status))lag_shell_get_vector(shell, LAG_ROLE_STATE, x, nx);
}

LAG_FMI(Status) LAG_FMI(GetNominalsOfContinuousStates)(lag_fmi_handle instance, lag_fmi_real nominals[], size_t nx)
{
    LAG_ENTER_EXCHANGE("GetNominalsOfContinuousStates", EVALUABLE | LAG_MODE_INSTANTIATED)
    return (LAG_FMI(Status))lag_shell_get_nominals(shell, nominals, nx);
}

LAG_FMI(Status) LAG_FMI(GetEventIndicators)(lag_fmi_handle instance, lag_fmi_real indicators[], size_t count)
{
    LAG_ENTER_EXCHANGE("GetEventIndicators", EVALUABLE)
    return (LAG_FMI(Status))lag_shell_get_vector(shell, LAG_ROLE_INDICATOR, indicators, count);
}
