/* Result codes of functions. */
#ifndef LAG_STATUS_H
#define LAG_STATUS_H

typedef enum lag_status {
    LAG_OK = 0,
    LAG_SINGULAR = 1,    /* M is singular on the null space of J: some accelerations are not determined */
    LAG_NOT_FINITE = 2,  /* a value is infinite or not a number; results hold what came out */
    LAG_MISSING = 3,     /* the model lacks this function */
    /* of integration */
    LAG_STEP_TOO_SMALL = 4,       /* the steps became as short as the round-off of time */
    LAG_TOO_LONG = 5,    /* more steps than allowed */
    LAG_PROJECTION_FAILED = 6,         /* the constraints cannot be reached from where a step led */
    LAG_ATTENTION = 7,   /* between the parts of a run: the constraints are about to lose rank, or turned by much in one step */
    LAG_VIOLATED = 8,    /* an assertion failed or an invariant left its tolerance */
    LAG_STOPPED = 9,     /* a callback or `terminate` asked for it */
    LAG_CHATTER = 10,    /* events follow each other without time passing */
    LAG_EVENT_PENDING = 11,    /* something happens now that the discretes do not know of yet */
    /* of what happens at instants */
    LAG_EVENT_ITERATION_FAILED = 12,  /* clauses trigger each other and never come to rest */
    LAG_CONFLICT = 13,   /* clauses reset one quantity to different values at one instant */
    LAG_ASSERTION_FAILED = 14,    /* an assertion of a clause failed */
    LAG_PENETRATION = 15,    /* a gap is negative at the start, or jumps to that */
    LAG_POSITION_JUMP = 16,       /* a constraint that discretes switch asks for other positions than there are */
    LAG_BRANCH_POINT = 17,     /* branches of the motion meet here, and which one it takes cannot be told */
    LAG_BAD_STATE_DATA = 18,    /* bytes that were not saved by this, or were changed since */
    LAG_BAD_CLOCK = 19,    /* a clock has no positive period, or no first instant */
    LAG_WAY_JUMP = 20,   /* the position of a mass would jump with what changes */
    LAG_MOMENTUM_UNREACHABLE = 21,    /* no rates have the momenta or the energy that an impulse leaves */
    LAG_NO_FORCES = 22,  /* no forces, or impulses, satisfy the law of friction, or sliding leaves them undetermined: wedging */
    LAG_BAD_DELAY = 23,    /* a delay is not positive and finite */
    LAG_LONG_PAST = 24,    /* the past of delayed values takes more pieces than the run keeps */
    LAG_GRAZING = 25,      /* a guard touches its border: the time of the instant has no derivative */
    LAG_NOT_SMOOTH = 26    /* neighbours of the motion end in other modes: what happens has no derivative */
} lag_status;

#endif
