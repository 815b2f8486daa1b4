"""The instant of a tick: passes over the clauses, and how their results move with the state and the discretes.

The passes are those of the runtime (docs/explanation/hybrid_model.md): clocks are true in the first, w takes its new
values, resets act, momenta are balanced where constraints or masses depend on what was set; until nothing changes.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.python.sizes import motion_sizes
from lagdsl.engines.backends.python.support.linear import factorize
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.point import Directions, Explicit, Flow, Point, System, changes, flow
from lagdsl.motion.analysis.sampled.held_flow import by_signals, values_at
from lagdsl.motion.analysis.sampled.moved import Borders, Moved, Place, moved

_MOST_PASSES = 100
# Changes of rates below this part of their derivatives are round-off.
_ROUNDING = 1e-9
_EVENT = ("next", "reset", "value", "collision")


@dataclass(frozen=True, slots=True, kw_only=True)
class Deviations:
    """A point and how it moves along k directions: q, qd, z and u in `along`, w (k, nw); the borders on which entries
    of w and of (q, qd, z) depend, by their places; `leaks`: see `Place`."""

    point: Point
    along: Directions
    w: Floats
    borders: dict[int, Borders]
    reset_borders: Borders = frozenset()
    leaks: bool = False

    @property
    def tangents(self) -> dict[Group, Floats]:
        return {
            Group.Q: self.along.q,
            Group.QD: self.along.qd,
            Group.Z: self.along.z,
            Group.U: self.along.u,
            Group.W: self.w,
        }


def tick(system: System, at: Deviations, clocks: tuple[int, ...], sink: Sink) -> Deviations | None:
    """`at` behind the instant at which these clocks tick; None after errors, and where a clause lets bodies collide
    (E0866)."""
    kinds = system.program.layout.kinds
    own = [place for place, kind in enumerate(kinds) if kind == "clock"]
    lasting = np.array([kind not in ("clock", "instant") for kind in kinds])
    w = at.point.w.copy()
    w[[own[clock] for clock in clocks]] = 1.0
    at = replace(at, point=replace(at.point, w=w))
    for _ in range(_MOST_PASSES):
        found = _pass(system, at, sink)
        if found is None:
            return None
        following, acted = found
        w = following.point.w * lasting
        rests = not acted and np.array_equal(w, at.point.w * lasting)
        first = np.any(at.point.w[own])
        at = replace(following, point=replace(following.point, w=w))
        if rests and not first:
            return at
    sink.report("E0866", None, reason="its passes over the clauses do not end")
    return None


def _pass(system: System, at: Deviations, sink: Sink) -> tuple[Deviations, bool] | None:
    """The state behind one pass; True if it did more than to change w."""
    program = system.program
    here = flow(system, at.point, sink)
    if here is None:
        return None
    blocks = [block.elements for block in program.function("event").results[: len(_EVENT)]]
    nodes = [node for block in blocks for node in block]
    place = Place(
        values=values_at(at.point, here.qdd, here.lam), tangents=at.tangents, borders=at.borders, leaks=at.leaks
    )
    if any(program.graph.depends(node, Group.QDD, Group.LAMBDA) for node in nodes):
        place = replace(place, tangents={**place.tangents, **_solved(system, here, at)})
    found = moved(program.graph, nodes, place)
    ends = np.cumsum([len(block) for block in blocks])
    if np.any(found.values[ends[2] : ends[3]]):
        sink.report("E0866", None, reason="a clause lets bodies collide at it")
        return None
    count = len(at.point.w)
    borders = {k: each for k, each in enumerate(found.borders[:count]) if each}
    w, moves = found.values[:count], found.tangents[:, :count]
    loads = [k for k, kind in enumerate(program.layout.kinds) if kind == "load"]
    w[loads] = here.point.w[loads]
    set_ = replace(at, point=replace(at.point, w=w), w=moves, borders=borders)
    acts = found.values[ends[0] : ends[1]] != 0.0
    after = _reset(program, set_, found, int(ends[0]))
    balanced = _balanced(system, at, after)
    moves = np.max(np.abs(balanced.along.qd - after.along.qd), initial=0.0)
    rates = np.array(program.layout.instants.reset_places, dtype=np.intp) < 2 * len(at.point.q)
    if np.any(acts & rates) and moves > _ROUNDING * np.max(np.abs(after.along.qd), initial=0.0):
        sink.report("E0866", None, reason="constraints move rates that a clause sets")
        return None
    return balanced, bool(np.any(acts))


def _solved(system: System, here: Flow, at: Deviations) -> dict[Group, Floats]:
    """Derivatives of accelerations and multipliers along the directions."""
    _, _, motion, rows, zd, y, load = by_signals(system, here, at.w)[0]
    found = changes(system, here, at.along, Explicit(motion=motion, rows=rows, zd=zd, y=y, load=load))
    return {Group.QDD: found.qdd, Group.LAMBDA: found.lam}


def _reset(program: Program, at: Deviations, found: Moved, first: int) -> Deviations:
    """Rates and states that the clauses set."""
    places = program.layout.instants.reset_places
    count = len(places)
    n = len(at.point.q)
    x = np.concatenate([at.point.q, at.point.qd, at.point.z])
    moves = np.hstack([at.along.q, at.along.qd, at.along.z])
    borders = at.reset_borders
    for k, place in enumerate(places):
        flag, value = first + k, first + count + k
        borders |= found.borders[flag]
        if found.values[flag]:
            x[place], moves[:, place] = found.values[value], found.tangents[:, value]
            borders |= found.borders[value]
    q, qd, z = np.split(x, [n, 2 * n])
    dq, dqd, dz = np.split(moves, [n, 2 * n], axis=1)
    along = replace(at.along, q=dq, qd=dqd, z=dz)
    return replace(at, point=replace(at.point, q=q, qd=qd, z=z), along=along, reset_borders=borders)


def _balanced(system: System, before: Deviations, after: Deviations) -> Deviations:
    """With rates that satisfy the constraints behind what was set: momenta change by impulses of the rows only.

    M dqd' - J' dP = M dqd + p(w', z') - p(w, z) and J dqd' + dc = 0, with p(w, z) how momenta move with w and z.
    """
    program = system.program
    nodes = [
        node
        for name in ("velocity_constraint", "momenta")
        for node in program.function(name).results[0].elements
    ]  # fmt: skip
    places = program.layout.instants.reset_places
    rows = len(program.layout.constraints)
    states = any(place >= 2 * len(after.point.q) for place in places)
    groups = (Group.W, Group.Z) if states else (Group.W,)
    if not any(program.graph.depends(node, *groups) for node in nodes) and not (places and rows):
        return after
    none = np.zeros(len(after.point.q)), np.zeros(rows)

    def momenta(w: Floats, z: Floats) -> tuple[Floats, Floats]:
        tangents = after.tangents | {Group.W: w, Group.Z: z}
        found = moved(program.graph, nodes, Place(values=values_at(after.point, *none), tangents=tangents))
        return found.tangents[:, :rows], found.tangents[:, rows:]

    drift, momentum = momenta(after.w, after.along.z)
    change = momentum - momenta(before.w, before.along.z)[1]
    mass, _, jacobian, _ = system.engine.evaluate("dynamics", *after.point.arguments)
    factors, _ = factorize(mass, jacobian, motion_sizes(program).rank)
    rates = factors.solve(-change.T, -drift.T)[0].T
    return replace(after, along=replace(after.along, qd=after.along.qd + rates))
