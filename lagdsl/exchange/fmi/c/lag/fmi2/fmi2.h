/* Names and types of FMI 2 for the functions that both versions have. */
#ifndef LAG_FMI2_H
#define LAG_FMI2_H

#include "fmi2Functions.h"

#define LAG_FMI(NAME) fmi2##NAME
#define LAG_FMI_TEXT "fmi2"
#define LAG_FMI_STATE(BEFORE, AFTER) fmi2##BEFORE##FMUstate##AFTER
#define LAG_FMI_STATE_TEXT "FMUstate"

typedef fmi2Component lag_fmi_handle;
typedef fmi2Real lag_fmi_real;

#include "lag/shell/entry.h"

#endif
