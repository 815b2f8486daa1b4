/* Instances of tests: placed, set up, begun, stepped; whatever fails ends the test with what the instance said. */
#ifndef INSTANCES_H
#define INSTANCES_H

#include <string.h>

#include "../../../c/check.h"
#include "lag/instance/instance.h"

#define CHECK_OK(instance, call)                                                                                       \
    do {                                                                                                               \
        const lag_status check_status = (call);                                                                        \
        if (check_status != LAG_OK) {                                                                                  \
            (void)fprintf(stderr, "%s:%d: status %d: %s\n", __FILE__, __LINE__, check_status, lag_instance_message(instance)); \
            exit(EXIT_FAILURE);                                                                                        \
        }                                                                                                              \
    } while (0)

static inline lag_instance *placed(const lag_fmu *fmu, double start, double stop, double tolerance)
{
    lag_instance *one = lag_instance_place(malloc(lag_instance_size(fmu)), fmu);
    lag_instance_setup(one, LAG_CO_SIMULATION, start, stop, tolerance);
    return one;
}

/* From initialization into the motion. */
static inline void begin(lag_instance *one)
{
    lag_update told;
    CHECK_OK(one, lag_instance_ready(one));
    CHECK_OK(one, lag_instance_begin(one));
    CHECK_OK(one, lag_instance_update(one, &told));
}

static inline lag_instance *begun(const lag_fmu *fmu, double start, double stop, double tolerance)
{
    lag_instance *one = placed(fmu, start, stop, tolerance);
    begin(one);
    return one;
}

static inline double get(lag_instance *one, size_t variable)
{
    double value = 0.0;
    CHECK_OK(one, lag_instance_get(one, variable, &value));
    return value;
}

static inline void set(lag_instance *one, size_t variable, double value)
{
    CHECK_OK(one, lag_instance_set(one, variable, &value));
}

/* To time t in so many steps. */
static inline void step_to(lag_instance *one, double t, unsigned count)
{
    lag_progress told;
    double from = 0.0;
    CHECK_OK(one, lag_instance_get(one, 0, &from));
    for (unsigned k = 1; k <= count; ++k) {
        const double to = k == count ? t : from + (t - from) * k / count;
        CHECK_OK(one, lag_instance_step(one, to - get(one, 0), 0, &told));
        CHECK(!told.early && !told.terminate);
    }
}

#endif
