/* Generated: why a motion ends, with the list that names what is to blame (runtime/words.py). */
#ifndef LAG_WORDS_H
#define LAG_WORDS_H

#include "lag/status.h"

typedef enum lag_blamed {
    LAG_BLAMED_NOTHING, LAG_BLAMED_CHECKS, LAG_BLAMED_CONDITIONS, LAG_BLAMED_COORDINATES, LAG_BLAMED_ENTRIES, LAG_BLAMED_FRICTIONS, LAG_BLAMED_RESETS, LAG_BLAMED_ROWS
} lag_blamed;

static const struct {
    lag_blamed blamed;
    const char *words; /* with %s for the names */
} LAG_WORDS[] = {
    [LAG_SINGULAR] = {LAG_BLAMED_COORDINATES, "The equations do not determine all accelerations here: `%s` moves no mass."},
    [LAG_NOT_FINITE] = {LAG_BLAMED_NOTHING, "A value is infinite or not a number."},
    [LAG_MISSING] = {LAG_BLAMED_NOTHING, "A function is missing."},
    [LAG_STEP_TOO_SMALL] = {LAG_BLAMED_NOTHING, "The steps became as short as the round-off of time: the motion runs into a singularity."},
    [LAG_TOO_LONG] = {LAG_BLAMED_NOTHING, "This takes too many steps."},
    [LAG_PROJECTION_FAILED] = {LAG_BLAMED_ROWS, "No state satisfies the constraints and start values: `%s` is farthest off."},
    [LAG_ATTENTION] = {LAG_BLAMED_NOTHING, "The constraints are about to lose rank."},
    [LAG_VIOLATED] = {LAG_BLAMED_CONDITIONS, "An assertion failed or an invariant left its tolerance: %s."},
    [LAG_STOPPED] = {LAG_BLAMED_NOTHING, "The model ended the run."},
    [LAG_CHATTER] = {LAG_BLAMED_ENTRIES, "Events of `%s` follow each other without time passing."},
    [LAG_EVENT_PENDING] = {LAG_BLAMED_NOTHING, "An event is left."},
    [LAG_EVENT_ITERATION_FAILED] = {LAG_BLAMED_ENTRIES, "The clauses trigger each other and never come to rest: `%s`."},
    [LAG_CONFLICT] = {LAG_BLAMED_RESETS, "Two clauses set `%s` to different values at one instant."},
    [LAG_ASSERTION_FAILED] = {LAG_BLAMED_CHECKS, "An assertion of a clause failed: %s."},
    [LAG_PENETRATION] = {LAG_BLAMED_ENTRIES, "Two bodies that touch are inside each other at `%s`."},
    [LAG_POSITION_JUMP] = {LAG_BLAMED_ROWS, "`%s`, which an event switches on, asks for other positions than there are."},
    [LAG_BRANCH_POINT] = {LAG_BLAMED_ROWS, "Branches of the motion meet here by `%s`; the equations do not tell which one it takes."},
    [LAG_BAD_STATE_DATA] = {LAG_BLAMED_NOTHING, "These bytes are no state of this model."},
    [LAG_BAD_CLOCK] = {LAG_BLAMED_NOTHING, "A clock has no positive period."},
    [LAG_WAY_JUMP] = {LAG_BLAMED_ENTRIES, "The position of a mass would jump by `%s`."},
    [LAG_MOMENTUM_UNREACHABLE] = {LAG_BLAMED_COORDINATES, "No rates of `%s` have the momentum or the energy that an event leaves."},
    [LAG_NO_FORCES] = {LAG_BLAMED_FRICTIONS, "No forces satisfy the law of friction of `%s`: it wedges."},
    [LAG_BAD_DELAY] = {LAG_BLAMED_NOTHING, "A delay is not positive."},
    [LAG_LONG_PAST] = {LAG_BLAMED_NOTHING, "The past of a delayed value has too many events."},
    [LAG_GRAZING] = {LAG_BLAMED_NOTHING, "Something only touches its border: its time has no derivative."},
    [LAG_NOT_SMOOTH] = {LAG_BLAMED_NOTHING, "Motions beside this one end in other modes: there is no derivative."},
};

#endif
