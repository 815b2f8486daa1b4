"""Borders: points at which a linearization is that of one side only.

A relation, or the corner or jump of a function, is zero at the point, and the small motions on its two sides are
different ones. The rule: at points beside it, a ten-thousand-millionth of the natural sizes away along the chart, the
flow and its derivatives are compared. Where they differ by far more than they change on one side, what has another sign
there is a border. `max(x, 0)^2` is none, as its derivative is zero on both sides.

A contact that is closed without a force is a border, too: small motions press on it and leave it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.discretes import opened
from lagdsl.motion.analysis.linearize import Reduced, reduce, state_names
from lagdsl.motion.analysis.point import Flow, System, flow
from lagdsl.motion.analysis.steady import RESTS, state_sizes
from lagdsl.motion.analysis.switches import Signs, Switch, places, signs, switches

# Parts of the natural sizes: distance of the points, and differences of derivatives that round-off may make.
_BESIDE = 1e-10
_ROUNDING = 1e-8
# A difference between the sides is so many times what twice the distance changes.
_JUMPS = 20.0
_DIRECTIONS = 6
_ON_EACH_SIDE = 2
_SEED = 3
_MOST_TOLD = 3
_FUNCTIONS = ("residual", "state_derivative", "output")


@dataclass(frozen=True, slots=True)
class _Beside:
    """A point beside the one in question: its side of each switch, and the linearization there."""

    side: Signs
    at: Reduced

    @property
    def matrix(self) -> Floats:
        """(F, A, B; y, C, D) in SI units."""
        return _matrix(self.at)


@dataclass(frozen=True, slots=True)
class _Difference:
    """Entry of the matrices that differs most, and the points on both sides."""

    one: _Beside
    other: _Beside
    row: int
    column: int


def on_both_sides(system: System, at: Reduced, sink: Sink, *, of_modes: bool = False) -> Reduced | None:
    """The linearization `at`, if it is that of all sides; None after E0860. For modes only F and A have to be: `at` is
    without outputs.

    Corners may cancel, as those of `max(x, 0) + min(x, 0)`: then it is the one beside them.
    """
    if _refuse_touching(system, at, sink):
        return None
    found = switches(system.program, _FUNCTIONS[:2] if of_modes else _FUNCTIONS)
    if not found:
        return at
    inputs = np.maximum(np.abs(at.flow.point.u), 1.0)
    sizes = np.concatenate([state_sizes(system, at)[0], np.zeros_like(inputs) if of_modes else inputs])
    pairs = _around(system, at, found, sizes)
    if not pairs:
        return at
    columns = np.concatenate([[1.0], sizes])
    scaled = [(near.matrix * columns, far.matrix * columns) for near, far in pairs]
    rows = np.max(np.abs([near for near, _ in scaled]), axis=(0, 2))[:, None]
    permitted = _ROUNDING * rows + _JUMPS * np.max([np.abs(far - near) for near, far in scaled], axis=0)
    difference = _difference([near for near, _ in pairs], columns, rows, permitted)
    if difference is not None:
        _report(system, at, found, difference, sink)
        return None
    near = pairs[0][0]
    if np.all(np.abs(_matrix(at) - near.matrix) * columns <= permitted):
        return at
    return replace(at, a=near.at.a, b=near.at.b, c=near.at.c, d=near.at.d)


def _matrix(at: Reduced) -> Floats:
    return np.block([[at.value[:, None], at.a, at.b], [at.flow.y[:, None], at.c, at.d]])


def _report(system: System, at: Reduced, found: Sequence[Switch], difference: _Difference, sink: Sink) -> None:
    one, other = difference.one, difference.other
    texts = places(system, found, (one.at.flow, other.at.flow), one.side * other.side < 0)
    names = ", ".join(f"`{text}`" for text in list(texts)[:_MOST_TOLD]) or "a function"
    span = next((spans[0] for spans in texts.values() if spans), None)
    values = np.array([each.matrix[difference.row, difference.column] for each in (one, other)])
    values[np.abs(values) <= _ROUNDING * np.max(np.abs(values))] = 0.0
    told = " and ".join(f"{value:.6g}" for value in np.sort(values))
    sink.report("E0860", span, names=names, what=_name(system, at, difference), values=told)


def _refuse_touching(system: System, at: Reduced, sink: Sink) -> bool:
    """True after E0860 at a closed contact without which nothing accelerates otherwise, but more can move."""
    point, kinds = at.flow.point, system.engine.layout.kinds
    entries = [place for place, kind in enumerate(kinds) if kind == "contact"]
    for contact, entry in zip(system.flat.events.contacts, entries, strict=True):
        if not point.w[entry]:
            continue
        beside = reduce(system, opened(system, point, contact.name), at.partition.held, Sink(), outputs=False)
        if beside is None or len(beside.value) == len(at.value):
            continue
        _, omega = state_sizes(system, beside)
        if np.all(np.abs(beside.flow.qdd - at.flow.qdd) <= RESTS * at.partition.sizes * omega**2):
            values = f"{len(at.value)} and {len(beside.value)}"
            name = f"contact `{contact.name}`, which carries no force"
            sink.report("E0860", contact.spans[0], names=name, what="the number of states", values=values)
            return True
    return False


def _difference(points: Sequence[_Beside], columns: Floats, rows: Floats, permitted: Floats) -> _Difference | None:
    """Between the sides of as few switches as possible."""
    best: _Difference | None = None
    fewest = float("inf")
    for one, other in combinations(points, 2):
        count = float(np.count_nonzero(one.side * other.side < 0))
        if not 0 < count < fewest:
            continue
        apart = np.abs(one.matrix - other.matrix) * columns
        exceeding = np.where(apart > permitted, apart / np.where(rows > 0.0, rows, 1.0), 0.0)
        if np.any(exceeding):
            row, column = np.unravel_index(int(np.argmax(exceeding)), exceeding.shape)
            best, fewest = _Difference(one, other, int(row), int(column)), count
    return best


def _around(system: System, at: Reduced, found: Sequence[Switch], sizes: Floats) -> list[tuple[_Beside, _Beside]]:
    """Points around `at`, each with one on the same side that is twice as far away; none where no switch turns. `sizes`
    are those of states and inputs, zero for what is held."""
    random = np.random.default_rng(_SEED)
    halves = random.uniform(0.5, 1.0, (_DIRECTIONS, len(sizes))) * random.choice([-1.0, 1.0], (_DIRECTIONS, len(sizes)))
    steps = _BESIDE * sizes * np.concatenate([halves, -halves])
    flows = [_moved(system, at, step) for step in (*steps, *(2.0 * steps))]
    sound = [each for each in flows if each is not None]
    if len(sound) < len(flows):
        return []
    near, far = np.split(signs(system, found, [at.flow, *sound])[1:], 2)
    turning = np.any(near > 0, axis=0) & np.any(near < 0, axis=0)
    pairs: list[tuple[_Beside, _Beside]] = []
    told: Counter[bytes] = Counter()
    for i in np.flatnonzero(np.any(turning) & np.all(near == far, axis=1)):
        pattern = near[i, turning].tobytes()
        told[pattern] += 1
        if told[pattern] <= _ON_EACH_SIDE:
            pair = [_looked_at(system, at, found, near[i], sound[k]) for k in (i, i + len(steps))]
            pairs += [(pair[0], pair[1])] if pair[0] and pair[1] else []
    return pairs


def _moved(system: System, at: Reduced, step: Floats) -> Flow | None:
    """The flow at a point that is `step` of the states and inputs away, with the discretes of `at`."""
    point, along = at.flow.point, at.along
    q, qd, z, u = (
        point.q + step @ along.q,
        point.qd + step @ along.qd,
        point.z + step @ along.z,
        point.u + step @ along.u,
    )
    return flow(system, replace(point, q=q, qd=qd, z=z, u=u), Sink())


def _looked_at(system: System, at: Reduced, found: Sequence[Switch], side: Signs, there: Flow) -> _Beside | None:
    """The linearization at a point with the relations that hold there."""
    w = there.point.w.copy()
    for switch, sign in zip(found, side, strict=True):
        if switch.entry is not None and sign:
            w[switch.entry] = float(sign > 0)
    own = reduce(system, replace(there.point, w=w), at.partition.held, Sink(), at.partition, outputs=len(at.flow.y) > 0)
    return None if own is None else _Beside(side, own)


def _name(system: System, at: Reduced, difference: _Difference) -> str:
    """The entry in words: `der(x)` by `x`."""
    states = [named.name for named in state_names(system, at.partition)]
    rows = [*(f"der({name})" for name in states), *(slot.name for slot in system.engine.layout.outputs)]
    columns = [*states, *(slot.name for slot in system.engine.layout.inputs)]
    name = f"`{rows[difference.row]}`"
    return name if difference.column == 0 else f"the derivative of {name} by `{columns[difference.column - 1]}`"
