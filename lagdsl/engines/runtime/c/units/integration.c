/* Generated: one unit of several files (lagdsl/engines/runtime/units.py). */
#include "lag/columns.h"
#include "lag/derivatives.h"
#include "lag/dynamics.h"
#include "lag/equations/blocks.h"
#include "lag/equations/delassus.h"
#include "lag/equations/entries.h"
#include "lag/equations/feedback.h"
#include "lag/equations/jacobian.h"
#include "lag/equations/motion.h"
#include "lag/equations/projection.h"
#include "lag/equations/rank.h"
#include "lag/evaluate.h"
#include "lag/factorization/band.h"
#include "lag/factorization/complex.h"
#include "lag/factorization/lu.h"
#include "lag/fixed.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/disjoint_sets.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/linalg.h"
#include "lag/linalg/minimum.h"
#include "lag/linalg/order.h"
#include "lag/linalg/pivoted_cholesky.h"
#include "lag/linalg/root.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"
#include "lag/methods/accuracy.h"
#include "lag/methods/attempts.h"
#include "lag/methods/dop853.h"
#include "lag/methods/radau.h"
#include "lag/methods/step_control.h"
#include "lag/methods/stiffness.h"
#include "lag/optimization/friction_problem.h"
#include "lag/optimization/lemke.h"
#include "lag/optimization/levenberg_marquardt.h"
#include "lag/optimization/linear_program.h"
#include "lag/optimization/margins.h"
#include "lag/optimization/nnls.h"
#include "lag/stepper.h"
#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#define least band_least
#define multiply band_multiply
#define scale band_scale
#define size_of band_size_of
#define solve band_solve
#include "lag/factorization/band.c"
#undef least
#undef multiply
#undef scale
#undef size_of
#undef solve

#define swap_rows lu_swap_rows
#include "lag/factorization/lu.c"
#undef swap_rows

#define most_rows blocks_most_rows
#include "lag/equations/blocks.c"
#undef most_rows

#include "lag/equations/columns.c"

#include "lag/equations/correction.c"

#define along delassus_along
#define find_excess delassus_find_excess
#define form delassus_form
#define solve_rest delassus_solve_rest
#include "lag/equations/delassus.c"
#undef along
#undef find_excess
#undef form
#undef solve_rest

#define form derivatives_form
#define solve derivatives_solve
#define solve_with_loads derivatives_solve_with_loads
#define variables derivatives_variables
#include "lag/equations/derivatives.c"
#undef form
#undef solve
#undef solve_with_loads
#undef variables

#define eliminate dynamics_eliminate
#define pick dynamics_pick
#define place dynamics_place
#define places dynamics_places
#define solve_rest dynamics_solve_rest
#define solve_with_loads dynamics_solve_with_loads
#define solver dynamics_solver
#include "lag/equations/dynamics.c"
#undef eliminate
#undef pick
#undef place
#undef places
#undef solve_rest
#undef solve_with_loads
#undef solver

#include "lag/equations/evaluate.c"

#define MOST_STEPS feedback_MOST_STEPS
#define begin feedback_begin
#include "lag/equations/feedback.c"
#undef MOST_STEPS
#undef begin

#define along jacobian_along
#define functions jacobian_functions
#define pick jacobian_pick
#define place jacobian_place
#define places jacobian_places
#define put jacobian_put
#define set_directions jacobian_set_directions
#define solve jacobian_solve
#define solver jacobian_solver
#define variables jacobian_variables
#include "lag/equations/jacobian.c"
#undef along
#undef functions
#undef pick
#undef place
#undef places
#undef put
#undef set_directions
#undef solve
#undef solver
#undef variables

#define functions linearization_functions
#define place linearization_place
#define places linearization_places
#define set_directions linearization_set_directions
#define take linearization_take
#include "lag/equations/linearization.c"
#undef functions
#undef place
#undef places
#undef set_directions
#undef take

#define DIFFERENCE motion_DIFFERENCE
#define KINDS motion_KINDS
#include "lag/equations/motion.c"
#undef DIFFERENCE
#undef KINDS

#define find_components projection_find_components
#include "lag/equations/projection.c"
#undef find_components

#define entry_of rank_entry_of
#define multiply rank_multiply
#define scale rank_scale
#include "lag/equations/rank.c"
#undef entry_of
#undef multiply
#undef scale

#include "lag/equations/rank_order.c"

#define find_excess system_find_excess
#define least system_least
#include "lag/equations/system.c"
#undef find_excess
#undef least

#define find_components system_scales_find_components
#include "lag/equations/system_scales.c"
#undef find_components

#define MOST_SWEEPS linalg_MOST_SWEEPS
#define rotate linalg_rotate
#define swap_rows linalg_swap_rows
#include "lag/linalg/linalg.c"
#undef MOST_SWEEPS
#undef rotate
#undef swap_rows

#define DIFFERENCE minimum_DIFFERENCE
#define LOWER minimum_LOWER
#define SAFETY minimum_SAFETY
#define put minimum_put
#include "lag/linalg/minimum.c"
#undef DIFFERENCE
#undef LOWER
#undef SAFETY
#undef put

#define eliminate pivoted_cholesky_eliminate
#define judge pivoted_cholesky_judge
#define put pivoted_cholesky_put
#include "lag/linalg/pivoted_cholesky.c"
#undef eliminate
#undef judge
#undef put

#include "lag/linalg/root.c"

#define MOST_SWEEPS svd_MOST_SWEEPS
#include "lag/linalg/svd.c"
#undef MOST_SWEEPS

#define place_of accuracy_place_of
#include "lag/methods/accuracy.c"
#undef place_of

#define accept dop853_accept
#define place dop853_place
#include "lag/methods/dop853.c"
#undef accept
#undef place

#include "lag/methods/dop853_tables.c"

#include "lag/methods/leapfrog.c"

#define LOWER radau_LOWER
#define SAFETY radau_SAFETY
#define STEADY radau_STEADY
#define accept radau_accept
#include "lag/methods/radau.c"
#undef LOWER
#undef RADAU
#undef SAFETY
#undef STEADY
#undef accept

#define AT_ONCE radau_effort_AT_ONCE
#define ITERATIONS radau_effort_ITERATIONS
#define SWEEPS radau_effort_SWEEPS
#include "lag/methods/radau_effort.c"
#undef AT_ONCE
#undef ITERATIONS
#undef SWEEPS

#define MOST radau_gmres_MOST
#define STAGES radau_gmres_STAGES
#define rotate radau_gmres_rotate
#include "lag/methods/radau_gmres.c"
#undef MOST
#undef STAGES
#undef rotate

#define STAGES radau_stages_STAGES
#define iterate radau_stages_iterate
#define prepare radau_stages_prepare
#include "lag/methods/radau_stages.c"
#undef STAGES
#undef iterate
#undef prepare

#define AT_ONCE radau_systems_AT_ONCE
#define KINDS radau_systems_KINDS
#define eliminate radau_systems_eliminate
#define entry_of radau_systems_entry_of
#define least radau_systems_least
#define multiply radau_systems_multiply
#define place_of radau_systems_place_of
#define solve radau_systems_solve
#include "lag/methods/radau_systems.c"
#undef AT_ONCE
#undef KINDS
#undef eliminate
#undef entry_of
#undef least
#undef multiply
#undef place_of
#undef solve

#include "lag/methods/radau_tables.c"

#include "lag/methods/rk4.c"

#include "lag/methods/ros2.c"

#include "lag/methods/stepper.c"

#define place steps_place
#define places steps_places
#include "lag/methods/steps.c"
#undef METHOD
#undef place
#undef places

#define FIRST stiffness_FIRST
#define ITERATIONS stiffness_ITERATIONS
#define STEADY stiffness_STEADY
#define iterate stiffness_iterate
#define multiply stiffness_multiply
#define prepare stiffness_prepare
#include "lag/methods/stiffness.c"
#undef FIRST
#undef ITERATIONS
#undef STEADY
#undef iterate
#undef multiply
#undef prepare

#define MOST_STEPS friction_problem_MOST_STEPS
#define MOST_SWEEPS friction_problem_MOST_SWEEPS
#define SWEEPS friction_problem_SWEEPS
#define begin friction_problem_begin
#define iterate friction_problem_iterate
#define size_of friction_problem_size_of
#include "lag/optimization/friction_problem.c"
#undef MOST_STEPS
#undef MOST_SWEEPS
#undef SWEEPS
#undef begin
#undef iterate
#undef size_of

#define MOST lemke_MOST
#define least lemke_least
#define place lemke_place
#include "lag/optimization/lemke.c"
#undef MOST
#undef least
#undef place

#define judge levenberg_marquardt_judge
#define take levenberg_marquardt_take
#include "lag/optimization/levenberg_marquardt.c"
#undef judge
#undef take

#include "lag/optimization/linear_program.c"

#define FIRST margins_FIRST
#define begin margins_begin
#define most_rows margins_most_rows
#include "lag/optimization/margins.c"
#undef FIRST
#undef begin
#undef most_rows

#define scale nnls_scale
#define solve nnls_solve
#include "lag/optimization/nnls.c"
#undef scale
#undef solve
