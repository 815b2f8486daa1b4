/* Generated: one unit of several files (lagdsl/engines/runtime/units.py). */
#include "lag/events/clock.h"
#include "lag/fmi3/fmi3.h"
#include <math.h>

#include "lag/fmi3/fmi3.c"

#include "lag/fmi3/fmi3_absent.c"
#undef LAG_NO_FRACTIONS
#undef LAG_SETTLED

#include "lag/fmi3/fmi3_clocks.c"

#include "lag/fmi3/fmi3_cosimulation.c"

#include "lag/fmi3/fmi3_derivatives.c"
#undef LAG_DERIVATIVES_BY

#include "lag/fmi3/fmi3_exchange.c"

#include "lag/fmi3/fmi3_fmu_state.c"

#include "lag/fmi3/fmi3_variables.c"
#undef LAG_FMI_COUNT
#undef LAG_FMI_ROOM
#undef LAG_NO_VARIABLES
