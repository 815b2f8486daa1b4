/* For the system of accelerations and multipliers: its own files. */
#ifndef LAG_SYSTEM_SCALES_H
#define LAG_SYSTEM_SCALES_H

#include "lag/dynamics.h"

/* `column_scale`, `row_scale` and the scaled `rows` for the mass and the Jacobian that were set; `dependent`: some rows follow from others. */
void lag_system_scale(lag_system *system, int dependent);

#endif
