/* Names and types of FMI 3 for the functions that both versions have. */
#ifndef LAG_FMI3_H
#define LAG_FMI3_H

#include "fmi3Functions.h"

#define LAG_FMI(NAME) fmi3##NAME
#define LAG_FMI_TEXT "fmi3"
#define LAG_FMI_STATE(BEFORE, AFTER) fmi3##BEFORE##FMUState##AFTER
#define LAG_FMI_STATE_TEXT "FMUState"

typedef fmi3Instance lag_fmi_handle;
typedef fmi3Float64 lag_fmi_real;

#include "lag/shell/entry.h"

#endif
