"""Names, units, defaults and what happens at instants, as Python data in the order of the arrays."""

from __future__ import annotations

import math
from collections.abc import Sequence

from lagdsl.derivation.program.program import Layout, Program, Slot
from lagdsl.engines.backends.python.body import number

_OF_INSTANTS = """\
# Entries of w, in this order: values of discrete variables (Booleans are 0 and 1); whether each contact is
# closed, and how often it closed or bounced; truths of relations, frozen between events; conditions of clauses as they
# were when last looked at; clocks and the instants initial() and terminal(), 1 in the first pass at their time.
# With A = (t, q, qd, z, u, w, p) and S = (*A, qdd, lam), lam being `multipliers`:
#   discrete_start(t, p)  w before anything happened
#   indicator(*S)   one number per relation, which holds where it is positive, or zero and not STRICT
#   indicator_rate(*S, dz, du, dqdd, dlam)  their first and second derivatives along the motion
#   standing(*S)    w with the truths of relations as they stand
#   contact(*A)     gap, its rate, dgap/dq of contacts, then of what clauses let collide; of contacts the restitution,
#                   and the speed and the time below which they close, negative where the language's defaults hold
#   clock(t, p)     first instants and periods
#   event(*S)       one pass over the clauses: w after it; resets that act, and their values; collisions that act, and
#                   their restitutions; which STOPS and which FAILURES act"""


def tables(program: Program) -> str:
    """The text of all tables."""
    layout = program.layout
    return "\n".join(
        [
            f"NAME = {program.name!a}",
            "# (name, SI unit) by index: q and qd; z; u; w; p; rows of constraints and lam; y",
            _table("COORDINATES", layout.coordinates),
            f"# other names of coordinates\nALIASES: dict[str, str] = {dict(layout.aliases)!a}",
            _table("STATES", layout.states),
            _table("INPUTS", layout.inputs),
            _table("DISCRETES", layout.discretes),
            _table("PARAMETERS", layout.parameters),
            _table("CONSTRAINTS", layout.constraints),
            _table("OUTPUTS", layout.outputs),
            f"FRAMES: tuple[str, ...] = {layout.frames!a}",
            f"POINTS: tuple[str, ...] = {layout.points!a}",
            *([_table("INERTIAL_PARAMETERS", layout.inertial)] if layout.inertial else ()),
            f"DEFAULTS = {_tuple([_number(value) for value in layout.defaults])}",
            f"REDUNDANT = {layout.redundant!r}",
            *(_instants(layout) if layout.discretes else ()),
            "",
        ]
    )


def _instants(layout: Layout) -> list[str]:
    instants = layout.instants
    texts = {"RESETS": instants.resets, "STOPS": instants.stops, "FAILURES": instants.failures}
    return [
        _OF_INSTANTS,
        f"KINDS = {_tuple([repr(kind) for kind in layout.kinds])}",
        f"STRICT = {instants.strict!r}",
        f"CONTACT_ROWS = {instants.contact_rows!r}  # of constraints",
        f"SWITCHED_ROWS = {instants.switched_rows!r}  # of constraints, of position level",
        f"RESET_PLACES = {instants.reset_places!r}  # in (q, qd, z)",
        *(f"{name} = {_tuple([f'{text!a}' for text in rows])}" for name, rows in texts.items()),
    ]


def _table(title: str, slots: Sequence[Slot]) -> str:
    if not slots:
        return f"{title}: tuple[tuple[str, str], ...] = ()"
    rows = "".join(f"    ({slot.name!a}, {slot.unit!a}),\n" for slot in slots)
    return f"{title} = (\n{rows})"


def _tuple(items: list[str]) -> str:
    return f"({', '.join(items)}{',' if len(items) == 1 else ''})"


def _number(value: float) -> str:
    return "float('nan')" if math.isnan(value) else number(value)
