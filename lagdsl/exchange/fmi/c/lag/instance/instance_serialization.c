/* The state of an instance as bytes, without pointers: what it holds itself, then its run. */
#include "lag/instance/instance_internal.h"

#include "lag/serialization.h"

/* All but the state of the run, with its settings; `instance` is changed only where the record is read from. */
static void walk(lag_instance *instance, lag_record *record)
{
    lag_run_options *options = &instance->run->options;
    lag_record_bytes(record, &instance->held, sizeof instance->held);
    lag_record_doubles(record, instance->kept_count, instance->kept);
    lag_record_doubles(record, 1, &options->tolerance);
    lag_record_doubles(record, 1, &options->length);
}

static size_t own_bytes(const lag_instance *instance)
{
    return sizeof(lag_held) + (instance->kept_count + 2) * sizeof(double);
}

size_t lag_instance_saved_size(const lag_instance *instance)
{
    return own_bytes(instance) + lag_run_saved_size(instance->fmu->model, &instance->run->options);
}

void lag_instance_save(const lag_instance *instance, unsigned char *bytes)
{
    walk((lag_instance *)instance, &(lag_record){bytes, NULL, 0});
    lag_run_save(instance->run, bytes + own_bytes(instance));
}

lag_status lag_instance_load(lag_instance *instance, const unsigned char *bytes)
{
    lag_motion *motion = &instance->run->motion;
    lag_status status = lag_run_load(instance->run, bytes + own_bytes(instance));
    if (status == LAG_OK) {
        walk(instance, &(lag_record){NULL, bytes, 0});
        status = motion->at.p != NULL ? lag_motion_parameters(motion, motion->at.p) : LAG_OK;
        instance->values.known = 0;
        lag_instance_set_run_inputs(instance);
    }
    return lag_instance_judge(instance, status);
}
