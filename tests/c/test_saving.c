/* A run that is saved and taken back goes on as the one it was, to the bit: in the same block, in another one, in another process. */
#include <string.h>

#include "check.h"
#include "lag/methods/radau.h"
#include "lag/serialization.h"
#include "machine.h"
#include "oscillator.h"

enum { MOST = 512 };

static lag_run *place(const lag_model *model, const lag_run_options *options)
{
    const size_t size = lag_run_size(model, options);
    void *block = malloc(size);
    CHECK(block != NULL);
    memset(block, 0xa5, size);
    return lag_run_place(block, model, options);
}

/* All that there is to know of a run, `odd` bytes off the alignment of memory; to be freed as it comes. */
static unsigned char *saved(const lag_run *run, size_t odd)
{
    const size_t size = lag_run_saved_size(run->motion.model, &run->options);
    unsigned char *bytes = malloc(size + odd);
    CHECK(bytes != NULL);
    lag_run_save(run, bytes + odd);
    return bytes;
}

static int alike(const lag_run *one, const lag_run *other)
{
    const lag_model *model = one->motion.model;
    const size_t states = lag_motion_size(model) * sizeof(double);
    return memcmp(one->stepper.x, other->stepper.x, states) == 0 && memcmp(one->stepper.f, other->stepper.f, states) == 0 &&
           memcmp(one->motion.w, other->motion.w, model->nw * sizeof(double)) == 0 && one->stepper.t == other->stepper.t &&
           one->stepper.h == other->stepper.h && one->stepper.method == other->stepper.method &&
           one->stepper.counts.steps == other->stepper.counts.steps && one->stepper.counts.evaluations == other->stepper.counts.evaluations &&
           one->stepper.counts.jacobians == other->stepper.counts.jacobians && one->stepper.counts.decompositions == other->stepper.counts.decompositions &&
           one->stepper.counts.rejections == other->stepper.counts.rejections && one->counts.events == other->counts.events && one->methods.changes == other->methods.changes &&
           one->counts.row == other->counts.row && one->projection.count == other->projection.count;
}

/* One call of a caller who lets a run go so many steps at a time. */
static int goes_on(lag_run *run, double stop, size_t steps)
{
    const lag_status status = lag_run_to(run, stop, steps);
    CHECK(status == LAG_OK || status == LAG_TOO_LONG);
    return status == LAG_TOO_LONG;
}

/*
 * A run is saved before every call. From each of these places a second one goes on, which has been somewhere else before; after two calls and
 * inside of the last step it is where the first one was.
 */
static size_t every_place_is_taken_back(const lag_model *model, const lag_run_options *options, double stop, size_t steps)
{
    lag_run *one = place(model, options);
    lag_run *other = place(model, options);
    const size_t states = lag_motion_size(model) * sizeof(double);
    size_t places = 0;
    int going = 1;
    CHECK(lag_run_begin(one, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_begin(other, 0.0, NULL) == LAG_OK);
    (void)goes_on(other, 0.31 * stop, 0);
    while (going) {
        unsigned char *bytes = saved(one, places % 3);
        double before[MOST];
        double after[MOST];
        CHECK(states <= sizeof before);
        going = goes_on(one, stop, steps) && goes_on(one, stop, steps);
        CHECK(lag_run_load(other, bytes + places % 3) == LAG_OK);
        CHECK((goes_on(other, stop, steps) && goes_on(other, stop, steps)) == going);
        CHECK(alike(one, other));
        const double inside = one->stepper.t_before + 0.37 * (one->stepper.t - one->stepper.t_before);
        if (one->stepper.t_before < one->stepper.t) {
            CHECK(lag_run_inside(one, inside, before) == LAG_OK);
            CHECK(lag_run_inside(other, inside, after) == LAG_OK);
            CHECK(memcmp(before, after, states) == 0);
        }
        free(bytes);
        ++places;
    }
    CHECK(model->event == NULL || one->counts.events > 10);
    CHECK(model->event != NULL || options->method != NULL || one->methods.changes > 1);
    free(one);
    free(other);
    return places;
}

/* Back and forth in one run, as a master algorithm does whose steps are too long at first. */
static void rollback(void)
{
    const lag_run_options options = {.tolerance = 1e-8, .length = 1.0};
    lag_run *run = place(&MACHINE, &options);
    lag_run *straight = place(&MACHINE, &options);
    double ends[2][5];
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_begin(straight, 0.0, NULL) == LAG_OK);
    for (int i = 1; i <= 40; ++i) {
        unsigned char *bytes = saved(run, 0);
        (void)goes_on(run, 0.025 * i + 0.1, 0);
        memcpy(ends[0], run->stepper.x, sizeof ends[0]);
        CHECK(lag_run_load(run, bytes) == LAG_OK);
        (void)goes_on(run, 0.025 * i + 0.1, 0);
        memcpy(ends[1], run->stepper.x, sizeof ends[1]);
        CHECK(memcmp(ends[0], ends[1], sizeof ends[0]) == 0);
        CHECK(lag_run_load(run, bytes) == LAG_OK);
        (void)goes_on(run, 0.025 * i, 0);
        (void)goes_on(straight, 0.025 * i, 0);
        CHECK(alike(run, straight));
        free(bytes);
    }
    CHECK(run->counts.events > 10);
    free(run);
    free(straight);
}

/* A state that was changed, or is another model's, is not taken, and does no harm. */
static void foreign_bytes(void)
{
    const lag_run_options options = {.tolerance = 1e-8, .length = 1.0};
    const lag_run_options others = {.tolerance = 1e-8, .length = 1.0, .count = 3};
    lag_run *run = place(&MACHINE, &options);
    lag_run *of_others = place(&MACHINE, &others);
    lag_run *of_another = place(&OSCILLATOR, &options);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    (void)goes_on(run, 0.2, 0);
    const size_t size = lag_run_saved_size(&MACHINE, &options);
    unsigned char *bytes = saved(run, 0);
    unsigned char *before = saved(run, 0);
    CHECK(lag_run_saved_size(&OSCILLATOR, &options) <= size);
    CHECK(lag_run_load(of_another, bytes) == LAG_BAD_STATE_DATA);
    CHECK(lag_run_load(of_others, bytes) == LAG_BAD_STATE_DATA);
    for (size_t i = 0; i < size; i += 1 + size / 997) {
        bytes[i] = (unsigned char)(bytes[i] ^ (1U << i % 8));
        CHECK(lag_run_load(run, bytes) == LAG_BAD_STATE_DATA);
        bytes[i] = before[i];
    }
    unsigned char *after = saved(run, 0);
    CHECK(memcmp(before, after, size) == 0);
    CHECK(lag_run_load(run, bytes) == LAG_OK);
    free(after);
    free(before);
    free(bytes);
    free(run);
    free(of_others);
    free(of_another);
}

/* A run whose model was filled anew in the middle goes on as before, and takes the bytes of one that was not, as that one takes its. */
static void another_filling(void)
{
    const lag_run_options options = {.tolerance = 1e-8, .length = 1.0};
    lag_run *straight = place(&MACHINE, &options);
    lag_run *run = place(&MACHINE, &options);
    const lag_model filling = MACHINE;
    double *workspace = malloc((filling.workspace + 1) * sizeof *workspace);
    CHECK(workspace != NULL);
    CHECK(lag_run_begin(straight, 0.0, NULL) == LAG_OK && lag_run_begin(run, 0.0, NULL) == LAG_OK);
    (void)goes_on(straight, 1.0, 7);
    (void)goes_on(run, 1.0, 7);
    unsigned char *good = saved(run, 0);
    CHECK(lag_run_change(run, &OSCILLATOR, workspace) == LAG_BAD_STATE_DATA);
    CHECK(lag_run_change(run, &filling, workspace) == LAG_OK);
    (void)goes_on(straight, 1.0, 0);
    (void)goes_on(run, 1.0, 0);
    CHECK(alike(run, straight));
    unsigned char *bytes = saved(run, 0);
    CHECK(lag_run_load(run, good) == LAG_OK && run->stepper.t < straight->stepper.t);
    (void)goes_on(run, 1.0, 0);
    CHECK(alike(run, straight));
    CHECK(lag_run_load(straight, good) == LAG_OK);
    (void)goes_on(straight, 1.0, 0);
    CHECK(alike(run, straight) && lag_run_load(straight, bytes) == LAG_OK && alike(run, straight));
    free(bytes);
    free(good);
    free(workspace);
    free(run);
    free(straight);
}

/* ---- another process ---- */

static const double SAVED = 0.21;
static const double STOP = 0.9;

static int in_another_process(const char *path)
{
    const lag_run_options options = {.tolerance = 1e-8, .length = 1.0};
    const size_t size = lag_run_saved_size(&MACHINE, &options);
    unsigned char *bytes = malloc(size);
    double *end = malloc(5 * sizeof *end);
    lag_run *run = place(&MACHINE, &options);
    FILE *file = fopen(path, "rb");
    CHECK(file != NULL && bytes != NULL && end != NULL);
    CHECK(fread(bytes, 1, size, file) == size && fread(end, sizeof *end, 5, file) == 5);
    CHECK(fclose(file) == 0);
    CHECK(lag_run_load(run, bytes) == LAG_OK);
    (void)goes_on(run, STOP, 0);
    CHECK(memcmp(run->stepper.x, end, 5 * sizeof *end) == 0);
    free(bytes);
    free(end);
    free(run);
    return EXIT_SUCCESS;
}

static void another_process(const char *program)
{
    const lag_run_options options = {.tolerance = 1e-8, .length = 1.0};
    const size_t size = lag_run_saved_size(&MACHINE, &options);
    lag_run *run = place(&MACHINE, &options);
    char path[1000];
    char command[2100];
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    (void)goes_on(run, SAVED, 0);
    unsigned char *bytes = saved(run, 0);
    (void)goes_on(run, STOP, 0);
    CHECK((size_t)snprintf(path, sizeof path, "%s.state", program) < sizeof path);
    CHECK((size_t)snprintf(command, sizeof command, "%s %s", program, path) < sizeof command);
    FILE *file = fopen(path, "wb");
    CHECK(file != NULL);
    CHECK(fwrite(bytes, 1, size, file) == size && fwrite(run->stepper.x, sizeof(double), 5, file) == 5);
    CHECK(fclose(file) == 0);
    CHECK(system(command) == 0);
    CHECK(remove(path) == 0);
    free(bytes);
    free(run);
}

int main(int count, char **arguments)
{
    if (count > 1) {
        return in_another_process(arguments[1]);
    }
    const double p[1] = {1e-4};
    double times[40];
    double rows[40 * 5];
    for (int i = 0; i < 40; ++i) {
        times[i] = 0.025 * i;
    }
    const lag_run_options machine = {.tolerance = 1e-8, .length = 1.0, .count = 40, .times = times, .rows = rows};
    CHECK(every_place_is_taken_back(&MACHINE, &machine, 1.0, 1) > 20);
    const lag_run_options stiff = {.p = p, .tolerance = 1e-7};
    CHECK(every_place_is_taken_back(&OSCILLATOR, &stiff, 2.0, 3) > 20);
    const lag_method *const methods[] = {&lag_dop853, &lag_radau, &lag_radau5, &lag_radau13};
    for (size_t i = 0; i < 4; ++i) {
        const lag_run_options fixed = {.p = p, .tolerance = 1e-6, .method = methods[i]};
        CHECK(every_place_is_taken_back(&OSCILLATOR, &fixed, i == 0 ? 0.01 : 2.0, 2) > 3);
    }
    rollback();
    foreign_bytes();
    another_filling();
    another_process(arguments[0]);
    (void)printf("saving: ok\n");
    return EXIT_SUCCESS;
}
