/* Generated: one unit of several files (lagdsl/engines/runtime/units.py). */
#include "lag/batch.h"
#include "lag/call.h"
#include "lag/dynamics.h"
#include "lag/ensemble.h"
#include "lag/equations/jacobian.h"
#include "lag/equations/motion.h"
#include "lag/factorization/lu.h"
#include "lag/fixed.h"
#include "lag/hold.h"
#include "lag/initial.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/linalg.h"
#include "lag/linalg/order.h"
#include "lag/linalg/record.h"
#include "lag/linalg/vector.h"
#include "lag/methods/step_control.h"
#include "lag/run.h"
#include "lag/run/scan.h"
#include "lag/sensitivities/differences.h"
#include "lag/sensitivities/run_sensitivities.h"
#include "lag/sensitivities/sensitivities.h"
#include "lag/session.h"
#include "lag/session/lane.h"
#include "lag/session/motions.h"
#include "lag/signals.h"
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#define prepare call_prepare
#define solve call_solve
#include "lag/session/call.c"
#undef prepare
#undef solve

#define crowd ensemble_crowd
#define place ensemble_place
#include "lag/session/ensemble.c"
#undef crowd
#undef place

#include "lag/session/hold.c"

#include "lag/session/lane.c"

#include "lag/session/motions.c"

#include "lag/session/session.c"

#define place_of signals_place_of
#include "lag/session/signals.c"
#undef place_of

#define crowd batch_crowd
#define place batch_place
#include "lag/equations/batch.c"
#undef crowd
#undef place

#include "lag/sensitivities/differences.c"

#define correct projection_tangent_correct
#define prepare projection_tangent_prepare
#include "lag/sensitivities/projection_tangent.c"
#undef correct
#undef prepare

#include "lag/sensitivities/run_sensitivities.c"

#define width_of sensitivities_width_of
#include "lag/sensitivities/sensitivities.c"
#undef width_of

#define correct sensitivity_collocation_correct
#include "lag/sensitivities/sensitivity_collocation.c"
#undef correct

#define place_of sensitivity_delays_place_of
#define set_sizes sensitivity_delays_set_sizes
#include "lag/sensitivities/sensitivity_delays.c"
#undef place_of
#undef set_sizes

#define solve sensitivity_fixed_solve
#include "lag/sensitivities/sensitivity_fixed.c"
#undef solve

#define set_sizes sensitivity_instants_set_sizes
#include "lag/sensitivities/sensitivity_instants.c"
#undef set_sizes

#include "lag/sensitivities/sensitivity_loads.c"

#include "lag/sensitivities/sensitivity_map.c"

#include "lag/sensitivities/sensitivity_rates.c"

#define width_of sensitivity_rows_width_of
#include "lag/sensitivities/sensitivity_rows.c"
#undef width_of

#include "lag/sensitivities/sensitivity_start.c"

#include "lag/sensitivities/sensitivity_state.c"

#include "lag/sensitivities/sensitivity_steps.c"
