/* Generated: one unit of several files (lagdsl/engines/runtime/units.py). */
#include "lag/delays/delays.h"
#include "lag/delays/pieces.h"
#include "lag/equations/entries.h"
#include "lag/equations/motion.h"
#include "lag/evaluate.h"
#include "lag/event_notice.h"
#include "lag/events/clock.h"
#include "lag/events/guards.h"
#include "lag/events/instant.h"
#include "lag/events/noise.h"
#include "lag/events/refraction.h"
#include "lag/events/timed.h"
#include "lag/factorization/lu.h"
#include "lag/fixed.h"
#include "lag/initial.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/minimum.h"
#include "lag/linalg/order.h"
#include "lag/linalg/root.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"
#include "lag/methods/radau.h"
#include "lag/run.h"
#include "lag/run/conditions.h"
#include "lag/run/course.h"
#include "lag/run/extremes.h"
#include "lag/run/results.h"
#include "lag/run/scan.h"
#include "lag/run/singular_crossing.h"
#include "lag/run/turns.h"
#include "lag/serialization.h"
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#define MOST_STEPS delays_MOST_STEPS
#include "lag/delays/delays.c"
#undef MOST_STEPS

#include "lag/delays/pieces.c"

#define PART clock_PART
#include "lag/events/clock.c"
#undef PART

#include "lag/events/event_contacts.c"

#define ULPS event_iteration_ULPS
#define pass event_iteration_pass
#include "lag/events/event_iteration.c"
#undef ULPS
#undef pass

#include "lag/events/event_notice.c"

#include "lag/events/event_sides.c"

#define evaluate guards_evaluate
#define size_of guards_size_of
#define take_values guards_take_values
#include "lag/events/guards.c"
#undef evaluate
#undef size_of
#undef take_values

#define remember instant_remember
#include "lag/events/instant.c"
#undef remember

#define count_of noise_count_of
#include "lag/events/noise.c"
#undef count_of

#define MOST_STEPS refraction_MOST_STEPS
#define NEAR refraction_NEAR
#define find_rates refraction_find_rates
#include "lag/events/refraction.c"
#undef MOST_STEPS
#undef NEAR
#undef find_rates

#define HALVES timed_HALVES
#define ULPS timed_ULPS
#define evaluate timed_evaluate
#define is_known timed_is_known
#define value_of timed_value_of
#include "lag/events/timed.c"
#undef HALVES
#undef ULPS
#undef evaluate
#undef is_known
#undef value_of

#define FIRST collocation_FIRST
#define HALVINGS collocation_HALVINGS
#define LEAST collocation_LEAST
#define NODES collocation_NODES
#include "lag/run/collocation.c"
#undef FIRST
#undef HALVINGS
#undef LEAST
#undef NODES

#define evaluate conditions_evaluate
#define is_known conditions_is_known
#define size_of conditions_size_of
#define take conditions_take
#include "lag/run/conditions.c"
#undef evaluate
#undef is_known
#undef size_of
#undef take

#include "lag/run/course.c"

#include "lag/run/extremes.c"

#define take_values output_extremes_take_values
#include "lag/run/output_extremes.c"
#undef take_values

#include "lag/run/results.c"

#define PART run_PART
#define pass run_pass
#include "lag/run/run.c"
#undef PART
#undef pass

#include "lag/run/run_begin.c"

#include "lag/run/run_corners.c"

#define find_rates run_fault_find_rates
#include "lag/run/run_fault.c"
#undef find_rates

#define step_once run_fixed_step_once
#include "lag/run/run_fixed.c"
#undef step_once

#define carry_out run_instants_carry_out
#include "lag/run/run_instants.c"
#undef carry_out

#define LEAST run_rows_LEAST
#include "lag/run/run_rows.c"
#undef LEAST

#define FIRST run_scan_FIRST
#define count_of run_scan_count_of
#define place_of run_scan_place_of
#define remember run_scan_remember
#include "lag/run/run_scan.c"
#undef FIRST
#undef count_of
#undef place_of
#undef remember

#define SHORTER run_steps_SHORTER
#define ULPS run_steps_ULPS
#define carry_out run_steps_carry_out
#define step_once run_steps_step_once
#include "lag/run/run_steps.c"
#undef SHORTER
#undef ULPS
#undef carry_out
#undef step_once

#define HALVES run_zero_crossings_HALVES
#define value_of run_zero_crossings_value_of
#include "lag/run/run_zero_crossings.c"
#undef HALVES
#undef value_of

#define HALVINGS singular_crossing_HALVINGS
#define NEAR singular_crossing_NEAR
#define NODES singular_crossing_NODES
#define SHORTER singular_crossing_SHORTER
#define SMALL singular_crossing_SMALL
#define take singular_crossing_take
#include "lag/run/singular_crossing.c"
#undef HALVINGS
#undef NEAR
#undef NODES
#undef SHORTER
#undef SMALL
#undef take

#define NEAR turns_NEAR
#define SMALL turns_SMALL
#define evaluate turns_evaluate
#define take turns_take
#include "lag/run/turns.c"
#undef NEAR
#undef SMALL
#undef evaluate
#undef take

#define place_of serialization_place_of
#include "lag/session/serialization.c"
#undef RECORD
#undef place_of
