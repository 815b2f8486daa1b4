/*
 * Tests events/event_sides.c: a relation lies on the side of its value; at its border on that of its rate, else of its acceleration; one that
 * shows neither keeps its truth; one that a clause puts on its border has the truth of a zero.
 */
#include "law.h"

/* The truth of q > 0, or of q >= 0, just behind the start. */
static int truth_of(double q, double rate, double acceleration, int strict)
{
    const unsigned char is_strict[1] = {(unsigned char)strict};
    law_clear(1);
    law.relations = 1;
    law.relation[0][0] = 1.0;
    law.q[0] = q;
    law.qd[0] = rate;
    law.force[0] = acceleration;
    lag_model model = law_model();
    model.strict = is_strict;
    lag_run *run = law_begin(&model, LAG_OK);
    const int truth = run->motion.w[law_at.relation] != 0.0;
    free(run);
    return truth;
}

static void a_value_that_is_not_zero_decides(void)
{
    CHECK(truth_of(0.1, -1.0, -1.0, 1) == 1);
    CHECK(truth_of(-0.1, 1.0, 1.0, 1) == 0);
}

static void at_the_border_the_rate_decides(void)
{
    for (int strict = 0; strict < 2; ++strict) {
        CHECK(truth_of(0.0, 1.0, -5.0, strict) == 1);
        CHECK(truth_of(0.0, -1.0, 5.0, strict) == 0);
    }
}

static void without_a_rate_the_acceleration_decides(void)
{
    for (int strict = 0; strict < 2; ++strict) {
        CHECK(truth_of(0.0, 0.0, 1.0, strict) == 1);
        CHECK(truth_of(0.0, 0.0, -1.0, strict) == 0);
    }
}

static void without_both_it_is_what_it_was(void)
{
    CHECK(truth_of(0.0, 0.0, 0.0, 1) == 0);
    CHECK(truth_of(0.0, 0.0, 0.0, 0) == 1);
}

/* ---- clauses ---- */

/* In the first pass q becomes zero. */
static void put_on_border(const lag_arguments *at, double *next, double *reset, double *value)
{
    reset[0] = at->w[0] == 0.0;
    value[0] = 0.0;
    next[0] = 1.0;
}

/* The truth behind a clause that puts q, which was 1 or -1, on the border. */
static int truth_behind(double q, double rate, int strict)
{
    const unsigned char is_strict[1] = {(unsigned char)strict};
    law_clear(1);
    law.relations = law.variables = law.resets = 1;
    law.relation[0][0] = 1.0;
    law.q[0] = q;
    law.qd[0] = rate;
    law.pass = put_on_border;
    lag_model model = law_model();
    model.strict = is_strict;
    lag_run *run = law_begin(&model, LAG_OK);
    CHECK_NEAR(run->stepper.x[0], 0.0, 0.0);
    const int truth = run->motion.w[law_at.relation] != 0.0;
    free(run);
    return truth;
}

static void behind_a_clause_a_zero_has_its_own_truth(void)
{
    for (int side = -1; side < 2; side += 2) {
        CHECK(truth_behind((double)side, 0.0, 1) == 0);
        CHECK(truth_behind((double)side, 0.0, 0) == 1);
        CHECK(truth_behind((double)side, 1.0, 1) == 1);
        CHECK(truth_behind((double)side, -1.0, 0) == 0);
    }
}

/* ---- located ---- */

/* q = t - t^2/2 - 1/2 touches zero at 1 s and turns back: x > 0 never holds; with a rise of 1e-3 it holds for a while. */
static void a_motion_that_turns_back_at_the_border_does_not_turn_the_relation(void)
{
    law_clear(1);
    law.relations = 1;
    law.relation[0][0] = 1.0;
    law.q[0] = -0.5 - 1e-9;
    law.qd[0] = 1.0;
    law.force[0] = -1.0;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    double first = 0.0;
    CHECK(lag_run_to(run, 2.0, 0) == LAG_OK);
    CHECK(law_count(LAG_TRUE, &first) == 0 && law_count(LAG_FALSE, &first) == 0);
    free(run);
}

int main(void)
{
    a_value_that_is_not_zero_decides();
    at_the_border_the_rate_decides();
    without_a_rate_the_acceleration_decides();
    without_both_it_is_what_it_was();
    behind_a_clause_a_zero_has_its_own_truth();
    a_motion_that_turns_back_at_the_border_does_not_turn_the_relation();
    (void)printf("sides: ok\n");
    return EXIT_SUCCESS;
}
