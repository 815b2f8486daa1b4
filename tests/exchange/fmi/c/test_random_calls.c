/* Calls at random on a model with events, contacts and clocks: see random_calls.h. */
#include "machine_fmu.h"

static const double nominal[MACH_SIZE] = {1.0, 1.0, 1.0, 1.0, 1.0};
const lag_fmu lag_exported = {
    .model = &MACHINE,
    .token = "machine",
    .nvariable = MACH_VARIABLES,
    .variables = MACH_TABLE,
    .start = &MACH_START,
    .nominal = nominal,
    .experiment = {0.0, 2.0, 1e-6},
    .kinds = LAG_MODEL_EXCHANGE | LAG_CO_SIMULATION,
};

#include "random_calls.h"

enum { LIVES = 80 };

int main(void)
{
    for (int version = 2; version <= 3; ++version) {
        /* importers this bad still get something done */
        CHECK(visit_at_random(17, LIVES, version) > 20 * LIVES);
    }
    return 0;
}
