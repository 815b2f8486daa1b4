/* Generated: one unit of several files (lagdsl/engines/runtime/units.py). */
#include "lag/fmi2/fmi2.h"
#include <math.h>

#include "lag/fmi2/fmi2.c"

#include "lag/fmi2/fmi2_cosimulation.c"
#undef ASKABLE
#undef LAG_NO_STATUS

#include "lag/fmi2/fmi2_exchange.c"

#include "lag/fmi2/fmi2_variables.c"
#undef LAG_FMI_COUNT
#undef LAG_FMI_ROOM
