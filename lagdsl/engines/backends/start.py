"""The start of a motion, as generated C and tapes are told of it."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from lagdsl.foundation.record import record, remembered
from lagdsl.language.flat.balanced import balanced
from lagdsl.language.flat.expression import Variable
from lagdsl.language.flat.model import FlatModel, Parameter
from lagdsl.language.flat.reached import reached
from lagdsl.language.flat.traversal import postorder
from lagdsl.language.flat.ways import held

# Flags of a start value: LAG_WRITTEN, LAG_QUATERNION of lag/model.h.
WRITTEN, QUATERNION = 1, 2
# Stands for no bound.
_LARGEST = 1.7976931348623157e308


@record(weak=True)
class Start:
    """A consistent state x = (q, qd, z) at time t [s], for the default parameters, and what the model says of its
    entries (`minimum` and `maximum`: of q; `free` and what begins with `parameter`: of p), as lag/model.h tells it.
    `written` adds WRITTEN and, at the first rate of a unit quaternion, QUATERNION. None: unknown."""

    t: float
    x: tuple[float, ...]
    fixed: tuple[bool, ...] = ()
    written: tuple[int, ...] = ()
    nominal: tuple[float, ...] = ()
    minimum: tuple[float, ...] = ()
    maximum: tuple[float, ...] = ()
    free: tuple[bool, ...] = ()
    parameter_nominal: tuple[float, ...] = ()
    parameter_minimum: tuple[float, ...] = ()
    parameter_maximum: tuple[float, ...] = ()


@remembered
def free_parameters(flat: FlatModel) -> tuple[Parameter, ...]:
    """Free parameters: initialization solves for them."""
    return tuple(parameter for parameter in flat.parameters if parameter.free)


def _quaternions(flat: FlatModel) -> list[str]:
    """The first of the four coordinates of each unit quaternion."""
    rows = [
        residual for constraint in flat.constraints if constraint.normalisation for residual in constraint.residuals
    ]
    parts = [{node.name for node in postorder(row) if isinstance(node, Variable)} for row in rows]
    names = [c.name for c in flat.coordinates]
    return [next(name for name in names if name in own) for own in parts]


def _beside_guesses(flat: FlatModel, written: Collection[str]) -> frozenset[str]:
    """Coordinates whose start values hold although nobody wrote them: balances of forces determine others, whose start
    values are guesses, and no constraint of the text ties them. None where such a guess is `written`."""
    balances = [each for each in flat.constraints if balanced(each) and each.level == "position"]
    guessed = {name for each in balances for name in balanced(each)}
    if not guessed.isdisjoint(written):
        return frozenset()
    tied = {x.name for x in reached(flat, held(flat)) if isinstance(x, Variable)}
    return frozenset({c.name for c in flat.coordinates} - guessed - tied if balances else ())


def start_of(flat: FlatModel, t: float, x: Sequence[float], changed: Collection[str] = ()) -> Start:
    """The state x = (q, qd, z) at time t with what `flat` says of it; start values of the names in `changed` count as
    written."""
    q, z = flat.coordinates, flat.states
    names = [*(c.name for c in q), *(f"der({c.name})" for c in q), *(s.name for s in z)]
    flags = [*(c.start_explicit for c in q), *(c.rate_start_explicit for c in q), *(s.start_explicit for s in z)]
    written = {name for name, flag in zip(names, flags, strict=True) if flag} | {*changed}
    written |= _beside_guesses(flat, written)
    turning = {f"der({first})" for first in _quaternions(flat)}
    nominal = [abs(c.nominal or 0.0) for c in q]
    independent = [p for p in flat.parameters if not p.structural] if free_parameters(flat) else []
    return Start(
        t,
        tuple(x),
        fixed=(*(c.fixed for c in q), *(c.rate_fixed for c in q), *(s.fixed for s in z)),
        written=tuple(WRITTEN * (name in written) + QUATERNION * (name in turning) for name in names),
        nominal=(*nominal, *nominal, *(abs(s.nominal or 0.0) for s in z)),
        minimum=tuple(-_LARGEST if c.minimum is None else c.minimum for c in q),
        maximum=tuple(_LARGEST if c.maximum is None else c.maximum for c in q),
        free=tuple(p.free for p in independent),
        parameter_nominal=tuple(abs(p.nominal or 0.0) for p in independent),
        parameter_minimum=tuple(-_LARGEST if p.minimum is None else p.minimum for p in independent),
        parameter_maximum=tuple(_LARGEST if p.maximum is None else p.maximum for p in independent),
    )
