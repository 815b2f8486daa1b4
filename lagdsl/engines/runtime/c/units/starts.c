/* Generated: one unit of several files (lagdsl/engines/runtime/units.py). */
#include "lag/contacts/contact.h"
#include "lag/contacts/friction.h"
#include "lag/contacts/modes.h"
#include "lag/contacts/reserve.h"
#include "lag/equations/blocks.h"
#include "lag/equations/entries.h"
#include "lag/equations/motion.h"
#include "lag/equations/rank.h"
#include "lag/impulses/impulse.h"
#include "lag/impulses/inequalities.h"
#include "lag/impulses/position_maps.h"
#include "lag/initial.h"
#include "lag/initial/initial_equations.h"
#include "lag/initial/initial_equations_rows.h"
#include "lag/initial/initial_rates.h"
#include "lag/initial/initial_scaling.h"
#include "lag/initial/nearest_configuration.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/disjoint_sets.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/linalg.h"
#include "lag/linalg/order.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"
#include "lag/methods/accuracy.h"
#include "lag/optimization/friction_problem.h"
#include "lag/optimization/margins.h"
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#define size_of accumulation_size_of
#include "lag/contacts/accumulation.c"
#undef size_of

#include "lag/contacts/contact.c"

#define NOTHING contact_impacts_NOTHING
#define add_frictions contact_impacts_add_frictions
#define gather contact_impacts_gather
#include "lag/contacts/contact_impacts.c"
#undef NOTHING
#undef add_frictions
#undef gather

#define NO_FORCE contact_scale_NO_FORCE
#define ROUNDING contact_scale_ROUNDING
#include "lag/contacts/contact_scale.c"
#undef NO_FORCE
#undef ROUNDING

#define NO_FORCE friction_NO_FORCE
#define ROUNDING friction_ROUNDING
#define row_of friction_row_of
#include "lag/contacts/friction.c"
#undef NO_FORCE
#undef ROUNDING
#undef row_of

#define add_frictions modes_add_frictions
#define find_rows modes_find_rows
#define solve modes_solve
#include "lag/contacts/modes.c"
#undef add_frictions
#undef find_rows
#undef solve

#define NOTHING reserve_NOTHING
#define row_of reserve_row_of
#define size_of reserve_size_of
#include "lag/contacts/reserve.c"
#undef NOTHING
#undef row_of
#undef size_of

#define NOTHING impulse_NOTHING
#define ROUNDING impulse_ROUNDING
#define find_sizes impulse_find_sizes
#include "lag/impulses/impulse.c"
#undef NOTHING
#undef ROUNDING
#undef find_sizes

#include "lag/impulses/impulse_step.c"

#include "lag/impulses/inequalities.c"

#include "lag/impulses/position_maps.c"

#define copy initial_copy
#include "lag/initial/initial.c"
#undef copy

#define find_rows initial_count_find_rows
#include "lag/initial/initial_count.c"
#undef find_rows

#define open_parts initial_equations_open_parts
#define place initial_equations_place
#include "lag/initial/initial_equations.c"
#undef open_parts
#undef place

#include "lag/initial/initial_equations_fault.c"

#include "lag/initial/initial_equations_rates.c"

#include "lag/initial/initial_equations_rows.c"

#define TRIES initial_equations_search_TRIES
#define descend initial_equations_search_descend
#include "lag/initial/initial_equations_search.c"
#undef TRIES
#undef descend

#define find_parts initial_positions_find_parts
#define gather initial_positions_gather
#define open_parts initial_positions_open_parts
#include "lag/initial/initial_positions.c"
#undef find_parts
#undef gather
#undef open_parts

#define TRIES initial_ranks_TRIES
#define find_parts initial_ranks_find_parts
#define place initial_ranks_place
#include "lag/initial/initial_ranks.c"
#undef TRIES
#undef find_parts
#undef place

#include "lag/initial/initial_rates.c"

#define find_parts initial_rates_branch_find_parts
#include "lag/initial/initial_rates_branch.c"
#undef find_parts

#include "lag/initial/initial_rates_conditions.c"

#define solve initial_rates_energy_solve
#include "lag/initial/initial_rates_energy.c"
#undef solve

#include "lag/initial/initial_row_sizes.c"

#define find_sizes initial_scaling_find_sizes
#include "lag/initial/initial_scaling.c"
#undef find_sizes

#define gather nearest_along_path_gather
#include "lag/initial/nearest_along_path.c"
#undef gather

#define copy nearest_configuration_copy
#define descend nearest_configuration_descend
#include "lag/initial/nearest_configuration.c"
#undef copy
#undef descend
