/* The state of an instance as bytes, without pointers: what it holds itself, then its run. */
#include "lag/instance/instance_internal.h"

#include <string.h>

#include "lag/serialization.h"

/* Header of the bytes: signature of the model and checksum. */
typedef struct lag_instance_head {
    unsigned long long token, sum;
} lag_instance_head;

/* Settings of the experiment, which are no part of the state of a run. */
typedef struct lag_instance_terms {
    double tolerance, length;
} lag_instance_terms;

static unsigned long long token_of(const lag_fmu *fmu)
{
    return lag_record_sum((const unsigned char *)fmu->token, strlen(fmu->token));
}

/* All but the run; `instance` is changed only where the record is read from. */
static void walk(lag_instance *instance, lag_record *record)
{
    lag_run_options *options = &instance->run->options;
    lag_instance_terms terms = {options->tolerance, options->length};
    lag_record_bytes(record, &instance->held, sizeof instance->held);
    lag_record_bytes(record, instance->kept, instance->kept_count * sizeof(double));
    lag_record_bytes(record, &terms, sizeof terms);
    if (record->saved != NULL) {
        options->tolerance = terms.tolerance;
        options->length = terms.length;
    }
}

static size_t own_size(size_t kept_count)
{
    return sizeof(lag_held) + kept_count * sizeof(double) + sizeof(lag_instance_terms);
}

size_t lag_instance_saved_size(const lag_fmu *fmu)
{
    const lag_run_options options = lag_instance_plan();
    return sizeof(lag_instance_head) + own_size(lag_instance_kept(fmu)) + lag_run_saved_size(fmu->model, &options);
}

void lag_instance_save(const lag_instance *instance, unsigned char *bytes)
{
    const size_t size = own_size(instance->kept_count);
    unsigned char *own = bytes + sizeof(lag_instance_head);
    lag_record record = {own, NULL, 0};
    walk((lag_instance *)instance, &record);
    const lag_instance_head head = {token_of(instance->fmu), lag_record_sum(own, size)};
    memcpy(bytes, &head, sizeof head);
    lag_run_save(instance->run, own + size);
}

lag_status lag_instance_load(lag_instance *instance, const unsigned char *bytes)
{
    const size_t size = own_size(instance->kept_count);
    const unsigned char *own = bytes + sizeof(lag_instance_head);
    lag_record record = {NULL, own, 0};
    lag_instance_head head;
    memcpy(&head, bytes, sizeof head);
    lag_status status = head.token == token_of(instance->fmu) && head.sum == lag_record_sum(own, size) ? LAG_OK : LAG_BAD_STATE_DATA;
    status = status == LAG_OK ? lag_run_load(instance->run, own + size) : status;
    if (status != LAG_OK) {
        return lag_instance_fail(instance, status, "this is no saved state of this model");
    }
    walk(instance, &record);
    lag_motion *motion = &instance->run->motion;
    status = motion->at.p != NULL ? lag_motion_parameters(motion, motion->at.p) : LAG_OK;
    instance->values.known = 0;
    lag_instance_set_run_inputs(instance);
    return status;
}
