/* The machine of the tests of the runtime, exported: a hopping ball, pushed by a sampled controller and thrown back. */
#ifndef MACHINE_FMU_H
#define MACHINE_FMU_H

#include <math.h>

#include "../../../c/machine.h"
#include "lag/fmu.h"

enum { MACH_TIME, MACH_H, MACH_X, MACH_HD, MACH_XD, MACH_A, MACH_PUSH, MACH_CLOSED, MACH_BLOWS, MACH_FORCE, MACH_OFF, MACH_VARIABLES };
enum { MACH_SIZE = 5 };

static const lag_variable MACH_TABLE[MACH_VARIABLES] = {
    {LAG_ROLE_TIME, LAG_TYPE_REAL, LAG_SET_NEVER, 0, 1, "v0"},
    {LAG_ROLE_STATE, LAG_TYPE_REAL, LAG_SET_START, 0, 1, "v1"},
    {LAG_ROLE_STATE, LAG_TYPE_REAL, LAG_SET_START, 1, 1, "v2"},
    {LAG_ROLE_STATE, LAG_TYPE_REAL, LAG_SET_START, 2, 1, "v3"},
    {LAG_ROLE_STATE, LAG_TYPE_REAL, LAG_SET_START, 3, 1, "v4"},
    {LAG_ROLE_STATE, LAG_TYPE_REAL, LAG_SET_START, 4, 1, "v5"},
    {LAG_ROLE_DISCRETE, LAG_TYPE_REAL, LAG_SET_NEVER, PUSH, 1, "v6"},
    {LAG_ROLE_DISCRETE, LAG_TYPE_BOOLEAN, LAG_SET_NEVER, FLOOR, 1, "v7"},
    {LAG_ROLE_DISCRETE, LAG_TYPE_INTEGER, LAG_SET_NEVER, BLOWS, 1, "v8"},
    {LAG_ROLE_MULTIPLIER, LAG_TYPE_REAL, LAG_SET_NEVER, 0, 1, "v9"},
    {LAG_ROLE_RESIDUAL, LAG_TYPE_REAL, LAG_SET_NEVER, 0, 1, "v10"},
};
static const double MACH_SIZES[MACH_SIZE] = {1.0, 1.0, 1.0, 1.0, 1.0};
static const double MACH_GROUP[MACH_SIZE] = {0.0, 0.0, 1.0, 1.0, 2.0};
static const double MACH_CAPS[MACH_SIZE] = {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
static const double MACH_ROWS[1] = {1.0};
static const double MACH_LASTING[1] = {0.0}; /* the contact comes and goes */
static const size_t MACH_ENTRIES[MACH_SIZE] = {0, 1, 2, 3, 4};
static const lag_start MACH_START = {.t = 0.0};

static const lag_fmu MACH_FMU = {
    .model = &MACHINE,
    .token = "machine",
    .nvariable = MACH_VARIABLES,
    .variables = MACH_TABLE,
    .start = &MACH_START,
    .experiment = {0.0, 2.0, 1e-9},
    .sizes = {MACH_GROUP, MACH_SIZES, MACH_CAPS, MACH_ROWS},
    .lasting.rows = MACH_LASTING,
    .indicators = {2, MACH_ENTRIES},
    .states = {MACH_SIZE, MACH_ENTRIES},
    .kinds = LAG_MODEL_EXCHANGE | LAG_CO_SIMULATION,
};

#endif
