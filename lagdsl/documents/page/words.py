"""Why a run ended, in short: the page has the status of the runtime, the time and what is to blame, by
name for braces, not the state to explain it by."""

from lagdsl.engines.runtime.structures import Status

WORDS = {
    Status.SINGULAR: "The equations do not determine all accelerations here: `{coordinates}` moves no mass.",
    Status.NOT_FINITE: "A value is infinite or not a number.",
    Status.STEP_TOO_SMALL: "The steps became as short as the round-off of time: the motion runs into a singularity.",
    Status.PROJECTION_FAILED: "No state satisfies the constraints and start values: `{rows}` is farthest off.",
    Status.VIOLATED: "An assertion failed or an invariant left its tolerance.",
    Status.STOPPED: "The model ended the run.",
    Status.CHATTER: "Events of `{entries}` follow each other without time passing.",
    Status.EVENT_ITERATION_FAILED: "The clauses trigger each other and never come to rest: `{entries}`.",
    Status.CONFLICT: "Two clauses set one quantity to different values at one instant.",
    Status.ASSERTION_FAILED: "An assertion of a clause failed.",
    Status.PENETRATION: "Two bodies that touch are inside each other at `{entries}`.",
    Status.POSITION_JUMP: "`{rows}`, which an event switches on, asks for other positions than there are.",
    Status.WAY_JUMP: "The position of a mass would jump by `{entries}`.",
    Status.NO_FORCES: "No forces satisfy the law of friction: it wedges.",
    Status.MOMENTUM_UNREACHABLE: "No rates of `{coordinates}` have the momentum or the energy that an event leaves.",
    Status.BRANCH_POINT: "Branches of the motion meet here by `{rows}`; the equations do not tell which one it takes.",
    Status.BAD_CLOCK: "A clock has no positive period.",
    Status.BAD_DELAY: "A delay is not positive.",
    Status.GRAZING: "Something only touches its border: its time has no derivative.",
    Status.NOT_SMOOTH: "Motions beside this one end in other modes: there is no derivative.",
    Status.LONG_PAST: "The past of a delayed value has too many events.",
}
