"""Why a motion ends, in short, for who has its status and what is to blame, and not its state: the page and FMUs. The
header that FMUs read is generated from it (`generate.py`)."""

from __future__ import annotations

import re

from lagdsl.engines.runtime.structures import Status

WORDS = {
    Status.SINGULAR: "The equations do not determine all accelerations here: `{coordinates}` moves no mass.",
    Status.NOT_FINITE: "A value is infinite or not a number.",
    Status.MISSING: "A function is missing.",
    Status.STEP_TOO_SMALL: "The steps became as short as the round-off of time: the motion runs into a singularity.",
    Status.TOO_LONG: "This takes too many steps.",
    Status.PROJECTION_FAILED: "No state satisfies the constraints and start values: `{rows}` is farthest off.",
    Status.ATTENTION: "The constraints are about to lose rank.",
    Status.VIOLATED: "An assertion failed or an invariant left its tolerance: {conditions}.",
    Status.STOPPED: "The model ended the run.",
    Status.CHATTER: "Events of `{entries}` follow each other without time passing.",
    Status.EVENT_PENDING: "An event is left.",
    Status.EVENT_ITERATION_FAILED: "The clauses trigger each other and never come to rest: `{entries}`.",
    Status.CONFLICT: "Two clauses set `{resets}` to different values at one instant.",
    Status.ASSERTION_FAILED: "An assertion of a clause failed: {checks}.",
    Status.PENETRATION: "Two bodies that touch are inside each other at `{entries}`.",
    Status.POSITION_JUMP: "`{rows}`, which an event switches on, asks for other positions than there are.",
    Status.BRANCH_POINT: "Branches of the motion meet here by `{rows}`; the equations do not tell which one it takes.",
    Status.BAD_STATE_DATA: "These bytes are no state of this model.",
    Status.BAD_CLOCK: "A clock has no positive period.",
    Status.WAY_JUMP: "The position of a mass would jump by `{entries}`.",
    Status.MOMENTUM_UNREACHABLE: "No rates of `{coordinates}` have the momentum or the energy that an event leaves.",
    Status.NO_FORCES: "No forces satisfy the law of friction of `{frictions}`: it wedges.",
    Status.BAD_DELAY: "A delay is not positive.",
    Status.LONG_PAST: "The past of a delayed value has too many events.",
    Status.GRAZING: "Something only touches its border: its time has no derivative.",
    Status.NOT_SMOOTH: "Motions beside this one end in other modes: there is no derivative.",
}
"""By status, with the list of names in braces that has what is to blame: by its number in `lag_fault`, entries by
`lag_run_report.guilty`. Conditions are assertions, then invariants; checks are assertions of clauses."""

_LIST = re.compile(r"\{(\w+)\}")


def words_text() -> str:
    """The header with the same words, each with one `%s` for its names."""
    lists = sorted({name for words in WORDS.values() for name in _LIST.findall(words)})
    enumerators = ", ".join(_blamed(name) for name in ("nothing", *lists))
    rows = []
    for status, words in WORDS.items():
        (name,) = _LIST.findall(words) or ["nothing"]
        rows.append(f'    [LAG_{status.name}] = {{{_blamed(name)}, "{_LIST.sub("%s", words)}"}},\n')
    return (
        "/* Generated: why a motion ends, with the list that names what is to blame (runtime/words.py). */\n"
        '#ifndef LAG_WORDS_H\n#define LAG_WORDS_H\n\n#include "lag/status.h"\n\n'
        f"typedef enum lag_blamed {{\n    {enumerators}\n}} lag_blamed;\n\n"
        "static const struct {\n    lag_blamed blamed;\n    const char *words; /* with %s for the names */\n"
        f"}} LAG_WORDS[] = {{\n{''.join(rows)}}};\n\n#endif\n"
    )


def _blamed(name: str) -> str:
    return f"LAG_BLAMED_{name.upper()}"
