"""A fixed point of the sampled loop: states at rest between ticks, and signals that each tick sets to what they are.

Newton's method in states and signals together: F(x, w) = 0 and U(x, w) - w = 0, with U all ticks of a period at once.
Coordinates that run without an influence may go on running: then it is a steady motion of the loop.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.linearize import Reduced
from lagdsl.motion.analysis.point import Point, System, flow
from lagdsl.motion.analysis.sampled.held_flow import held_flow
from lagdsl.motion.analysis.sampled.loop import Loop, loop_at
from lagdsl.motion.analysis.sampled.schedule import Schedule
from lagdsl.motion.analysis.sampled.verdict import deviation_sizes
from lagdsl.motion.analysis.steady import without_influence

_MOST_STEPS = 60
_REACHED = 1e-13
_HOLDS = 1e-9
_MOST_TOLD = 4


def fixed_point(system: System, guess: Point, schedule: Schedule, sink: Sink) -> Point | None:
    """The one that Newton's method leads to from `guess`; None after E0864 and errors of linearizations."""
    point, ticks = guess, schedule.at_once()
    for step in range(_MOST_STEPS):
        loop = loop_at(system, point, ticks, sink, with_outputs=False, leaks=True)
        if loop is None:
            return None
        residual, jacobian, sizes = _equations(system, loop)
        rests = np.max(np.abs(residual), initial=0.0)
        if (step and rests <= _REACHED) or not np.isfinite(rests):
            break
        change = np.linalg.lstsq(jacobian * sizes, -residual, rcond=1e-12)[0] * sizes
        if step and np.max(np.abs(change) / sizes, initial=0.0) <= _REACHED:
            break
        point = _moved(system, loop, change)
    if rests <= _HOLDS:
        return point
    assert loop is not None
    names = [*(f"der({each.name})" for each in loop.names[: len(loop.still)]), *(e.name for e in loop.signals.names)]
    worst = np.argsort(-np.abs(residual))[:_MOST_TOLD]
    left = ", ".join(f"`{names[k]}`" for k in sorted(worst) if abs(residual[k]) > _HOLDS)
    sink.report("E0864", None, left=f"{left} cannot rest")
    return None


def _equations(system: System, loop: Loop) -> tuple[Floats, Floats, Floats]:
    """Residuals in natural sizes, their derivatives by states and signals, and the natural sizes of these."""
    states = len(loop.still)
    sizes = deviation_sizes(system, loop)
    flow = held_flow(system, loop.at, loop.signals)
    count = states + len(loop.signals)
    ticks = loop.matrix[states:, :count]
    jacobian = np.vstack([flow.rates[:, :count], ticks])
    jacobian[states:, states:] -= np.eye(count - states)
    residual = np.concatenate([loop.still, loop.matrix[states:, -1]])
    first = len(loop.at.partition.position)
    idle = without_influence(jacobian, sizes, 1.0, range(first))
    residual[idle], jacobian[idle] = 0.0, 0.0
    rows = np.max(np.abs(jacobian * sizes), axis=1)
    rows = np.where(rows > 0.0, rows, 1.0)
    return residual / rows, jacobian / rows[:, None], sizes


def _moved(system: System, loop: Loop, change: Floats) -> Point:
    """The point with other states and signals, on the constraints."""
    point, states = loop.point, len(loop.still)
    along = held_flow(system, loop.at, loop.signals).along
    count = len(change)
    w = point.w.copy()
    modes = list(loop.signals.modes)
    w[modes] = loop.w[modes]
    w[list(loop.signals.places)] += change[states:]
    q = point.q + change @ along.q[:count]
    qd = point.qd + change @ along.qd[:count]
    z = point.z + change @ along.z[:count]
    return _as_it_stands(system, _on_constraints(system, replace(point, q=q, qd=qd, z=z, w=w), loop.at))


def _as_it_stands(system: System, point: Point) -> Point:
    """With the relations that hold there."""
    kinds = np.array(system.program.layout.kinds)
    here = flow(system, point, Sink()) if np.any(kinds == "relation") else None
    if here is None:
        return point
    (stands,) = system.engine.evaluate("standing", *point.arguments, here.qdd, here.lam)
    return replace(point, w=np.where(kinds == "relation", stands, point.w))


def _on_constraints(system: System, point: Point, at: Reduced) -> Point:
    """With dependent coordinates and rates that follow the independent ones."""
    chosen, rows = at.partition, list(at.partition.held)
    for _ in range(_MOST_STEPS if rows else 0):
        phi, jacobian = system.engine.evaluate("position_constraint", *point.arguments)
        step = replace(chosen, jacobian=jacobian).position_following(-phi[rows][:, None])[:, 0]
        point = replace(point, q=point.q + step)
        if not np.max(np.abs(step) / chosen.sizes, initial=0.0) > _REACHED:
            break
    drift, jacobian = system.engine.evaluate("velocity_constraint", *point.arguments)
    step = replace(chosen, jacobian=jacobian).rate_following(-drift[:, None])[:, 0]
    return replace(point, qd=point.qd + step)
