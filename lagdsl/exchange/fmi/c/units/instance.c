/* Generated: one unit of several files (lagdsl/engines/runtime/units.py). */
#include "lag/derivatives.h"
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
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lag/instance/clocks.c"

#define begin cosimulation_begin
#include "lag/instance/cosimulation.c"
#undef begin

#include "lag/instance/dependent_coordinates.c"

#define find directional_find
#define lay_out directional_lay_out
#define residuals directional_residuals
#include "lag/instance/directional.c"
#undef find
#undef lay_out
#undef residuals

#include "lag/instance/event_indicators.c"

#include "lag/instance/event_mode.c"

#include "lag/instance/exchange.c"

#define refuse input_paths_refuse
#include "lag/instance/input_paths.c"
#undef refuse

#include "lag/instance/input_polynomials.c"

#define lay_out instance_lay_out
#include "lag/instance/instance.c"
#undef lay_out

#define name_of instance_messages_name_of
#include "lag/instance/instance_messages.c"
#undef name_of

#define token_of instance_serialization_token_of
#include "lag/instance/instance_serialization.c"
#undef token_of

#define find instance_start_find
#include "lag/instance/instance_start.c"
#undef find

#define find lazy_evaluation_find
#define residuals lazy_evaluation_residuals
#include "lag/instance/lazy_evaluation.c"
#undef find
#undef residuals

#include "lag/instance/output_rates.c"

#include "lag/instance/start_derivatives.c"

#include "lag/instance/variables.c"

#define acceptable access_acceptable
#define refuse access_refuse
#include "lag/shell/access.c"
#undef acceptable
#undef refuse

#include "lag/shell/directional_derivatives.c"

#define fault fmu_state_fault
#define token_of fmu_state_token_of
#include "lag/shell/fmu_state.c"
#undef FORMAT
#undef HASH_BEGIN
#undef fault
#undef token_of

#include "lag/shell/handle.c"

#include "lag/shell/lifecycle.c"

#include "lag/shell/messages.c"

#define begin shell_begin
#define fault shell_fault
#define name_of shell_name_of
#define refuse shell_refuse
#include "lag/shell/shell.c"
#undef begin
#undef fault
#undef name_of
#undef refuse

#include "lag/shell/states.c"

#define acceptable stepping_acceptable
#include "lag/shell/stepping.c"
#undef acceptable
