/* Generated: one unit of several files (lagdsl/engines/runtime/units.py). */
#include "lag/fixed.h"
#include "lag/initial.h"
#include "lag/instance/instance_internal.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/linalg.h"
#include "lag/linalg/vector.h"
#include "lag/serialization.h"
#include "lag/shell/handle.h"
#include "lag/shell/shell.h"
#include "lag/words.h"
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lag/instance/cosimulation.c"

#define lay_out directional_lay_out
#include "lag/instance/directional.c"
#undef lay_out

#include "lag/instance/events.c"

#include "lag/instance/exchange.c"

#include "lag/instance/inputs.c"

#define lay_out instance_lay_out
#include "lag/instance/instance.c"
#undef lay_out

#define name_of instance_messages_name_of
#include "lag/instance/instance_messages.c"
#undef name_of

#include "lag/instance/instance_start.c"

#include "lag/instance/variables.c"

#define acceptable access_acceptable
#define refuse access_refuse
#include "lag/shell/access.c"
#undef acceptable
#undef refuse

#include "lag/shell/directional_derivatives.c"

#define fault fmu_state_fault
#include "lag/shell/fmu_state.c"
#undef FORMAT
#undef fault

#include "lag/shell/handle.c"

#include "lag/shell/lifecycle.c"

#include "lag/shell/messages.c"

#define fault shell_fault
#define name_of shell_name_of
#define refuse shell_refuse
#include "lag/shell/shell.c"
#undef fault
#undef name_of
#undef refuse

#include "lag/shell/states.c"

#define acceptable stepping_acceptable
#include "lag/shell/stepping.c"
#undef acceptable
