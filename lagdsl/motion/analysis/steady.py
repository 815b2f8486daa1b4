"""Is a point an equilibrium, or does a steady motion pass through it?

The rule: a motion is steady if everything that influences anything keeps its value; what runs influences nothing but
what runs itself. Coordinates of the minimal state without influence are found from zero columns of A, again and again
without those found before: the travel of a wheel, then its heading. That they have no influence anywhere, nor the
time, is tried at other values of them. A then is constant along the motion, and its eigenvalues decide. A body that
turns steadily in a quaternion is judged in axes that move along with it (`turning.py`).
Source of the notion (relative equilibria, ignorable coordinates): Routh, Advanced Rigid Dynamics, 6th ed., chapter III.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.linearize import Reduced, reduce, state_names
from lagdsl.motion.analysis.point import Point, System
from lagdsl.motion.analysis.turning import Turning, in_chart, turnings

# Parts of the natural size per natural time that count as rest, and as the same derivative elsewhere.
RESTS = 1e-9
_SAME = 1e-7
_TURN = 0.7
_SHIFTS = (0.6180339887, -0.4142135623)
_STEPS = 4
_MOST_TOLD = 4


@dataclass(frozen=True, slots=True, kw_only=True)
class Steadiness:
    """`no freedom`: the minimal state has no entry, so that there is no motion to judge. `running` are names of what
    changes at a constant rate; `unbalanced` names what keeps a point from being steady, with its rate of change in SI
    units; where that is zero, the row of A changes along the motion. `turning` is given where bodies turn steadily in
    quaternions: then A - X is constant."""

    kind: Literal["equilibrium", "steady motion", "neither", "no freedom"]
    running: tuple[str, ...]
    unbalanced: tuple[tuple[str, float], ...]
    turning: Turning | None = None


def pace(a: Floats, speeds: Floats) -> float:
    """The natural rate of change [1/s]: of the fastest mode, or of the fastest coordinate."""
    fastest = float(np.max(np.abs(np.linalg.eigvals(a)), initial=0.0)) if a.size else 0.0
    fastest = max(fastest, float(np.max(speeds, initial=0.0)))
    return fastest if fastest > 0.0 else 1.0


def state_sizes(system: System, at: Reduced) -> tuple[Floats, float]:
    """Natural sizes of the entries of the minimal state, and the pace."""
    chosen = at.partition
    omega = pace(at.a, np.abs(at.flow.point.qd) / chosen.sizes)
    nominal = first_order_sizes(system, at.flow.point)
    y, v = chosen.sizes[list(chosen.position)], chosen.sizes[list(chosen.rate)] * omega
    return np.concatenate([y, v, nominal]), omega


def first_order_sizes(system: System, point: Point) -> Floats:
    """Natural sizes of the first-order states: `nominal`, else their values, at least one unit."""
    pairs = zip(system.flat.states, point.z.tolist(), strict=True)
    return np.array([abs(state.nominal) if state.nominal else max(abs(value), 1.0) for state, value in pairs])


def without_influence(a: Floats, sizes: Floats, omega: float, candidates: Sequence[int]) -> list[int]:
    """Entries of the minimal state that influence nothing but each other, in the order in which they are found."""
    scaled = np.abs(a) * sizes / sizes[:, None] / omega
    found: list[int] = []
    while True:
        rest = [i for i in range(len(a)) if i not in found]
        new = [j for j in candidates if j not in found and float(np.max(scaled[rest, j], initial=0.0)) <= RESTS]
        if not new:
            return found
        found += new


def steadiness(system: System, at: Reduced) -> Steadiness:
    """Kind of the point `at`. `at` is reduced by the rows of position level alone."""
    if not len(at.value):
        return Steadiness(kind="no freedom", running=(), unbalanced=())
    plain = _judged(system, at, None)
    if plain.kind != "neither":
        return plain
    turned = (_judged(system, turning.relative(at), turning) for turning in turnings(system, at))
    return next((found for found in turned if found.kind != "neither"), plain)


def in_turning_axes(system: System, at: Reduced) -> Reduced:
    """`at` with the matrix that is constant where bodies turn steadily in quaternions; `at` itself elsewhere."""
    if next(turnings(system, at), None) is None:
        return at
    turning = steadiness(system, at).turning
    return at if turning is None else turning.relative(at)


def _judged(system: System, at: Reduced, turning: Turning | None) -> Steadiness:
    """The kind of a point where `at` tells deviations from a steady rotation, if there is one."""
    sizes, omega = state_sizes(system, at)
    places = len(at.partition.position)
    first_state = places + len(at.partition.rate)
    candidates = [*range(places), *range(first_state, len(at.value))]
    idle = without_influence(at.a, sizes, omega, candidates)
    kept = [i for i in range(len(at.value)) if i not in idle]
    names = [named.name for named in state_names(system, at.partition)]
    moving = np.abs(at.value) / sizes / omega > RESTS
    unbalanced = [(_rate_name(names[i]), float(at.value[i])) for i in kept if moving[i]]
    if not unbalanced:
        running_entries = [i for i in idle if moving[i]]
        wrong = _elsewhere(system, at, turning, sizes, omega, running_entries, kept)
        still = all(abs(rate) <= RESTS * sizes[i] * omega for i, rate in wrong)
        unbalanced = [(_rate_name(names[i]), 0.0 if still else rate) for i, rate in wrong]
    running = [names[i] for i in idle if moving[i]]
    speeds = np.abs(at.flow.point.qd) / at.partition.sizes / omega
    coordinates = [c.name for c in system.flat.coordinates]
    running += [n for n, speed in zip(coordinates, speeds, strict=True) if speed > RESTS and n not in running]
    if unbalanced:
        return Steadiness(kind="neither", running=tuple(running), unbalanced=tuple(unbalanced))
    kind: Literal["equilibrium", "steady motion"] = "steady motion" if running else "equilibrium"
    return Steadiness(kind=kind, running=tuple(running), unbalanced=(), turning=turning)


def imbalance(found: Steadiness) -> str:
    """Why a point is neither an equilibrium nor part of a steady motion, in words."""
    first = found.unbalanced[:_MOST_TOLD]
    if any(value for _, value in found.unbalanced):
        return f"{', '.join(f'{name} = {value:.4g}' for name, value in first)} (SI units)"
    names = ", ".join(name for name, _ in first)
    return f"nothing accelerates, but the linear equations of {names} change along the motion"


def _rate_name(name: str) -> str:
    return f"der({name})"


def _elsewhere(
    system: System,
    at: Reduced,
    turning: Turning | None,
    sizes: Floats,
    omega: float,
    running: Sequence[int],
    kept: Sequence[int],
) -> list[tuple[int, float]]:
    """Entries that change when the running entries, the time and what turns take other values, with their rates."""
    for shift in _SHIFTS:
        other = _shifted(system, at, sizes, running, shift, abs(shift) / omega)
        group = np.eye(len(at.flow.point.q))
        if turning is not None and other is not None:
            other, group = turning.turned(other, _TURN * shift / omega)
            if not _holds(system, other, at):
                return [(i, float(at.flow.point.qd[place])) for i, place in enumerate(at.partition.position[:1])]
        found = None if other is None else reduce(system, other, at.partition.held, Sink(), at.partition, outputs=False)
        if found is None:
            return []  # the chart ends there: nothing is known against it
        if turning is not None:
            found = turning.relative(found)
        states = len(at.value)
        along = at.along
        moved = in_chart(at, along.q[:states] @ group.T, along.qd[:states] @ group.T, along.z[:states]).T
        expected = moved @ at.a @ np.linalg.inv(moved)
        drift = np.abs(found.value[list(kept)]) / sizes[list(kept)] / omega
        change = np.abs(found.a - expected) * sizes / sizes[:, None] / omega
        block = np.max(change[np.ix_(list(kept), list(kept))], axis=1, initial=0.0)
        wrong = [k for k in range(len(kept)) if drift[k] > _SAME or block[k] > _SAME]
        if wrong:
            return [(kept[k], float(found.value[kept[k]])) for k in wrong]
    return []


def _holds(system: System, point: Point, at: Reduced) -> bool:
    """True if the position rows hold at the point as at any other."""
    rows = list(at.partition.held)
    if not rows:
        return True
    phi, jacobian = system.engine.evaluate("position_constraint", *point.arguments)
    sizes = np.linalg.norm(jacobian[rows] * at.partition.sizes, axis=1)
    return bool(np.all(np.abs(phi[rows]) <= _SAME * sizes))


def _shifted(
    system: System, at: Reduced, sizes: Floats, running: Sequence[int], shift: float, later: float
) -> Point | None:
    """The point with other values of the running entries, a little later, on the constraints."""
    point, chosen = at.flow.point, at.partition
    places = len(chosen.position)
    first_state = places + len(chosen.rate)
    rows = list(chosen.held)
    q, z = point.q.copy(), point.z.copy()
    for i in running:
        if i >= first_state:
            z[i - first_state] += shift * sizes[i]
    for step in range(_STEPS):
        t = point.t + later * (step + 1) / _STEPS
        for i in running:
            if i < places:
                q[chosen.position[i]] += shift * sizes[i] / _STEPS
        for _ in range(30 if rows else 0):
            phi, jacobian = system.engine.evaluate("position_constraint", t, q, point.qd, z, point.u, point.w, point.p)
            there = replace(chosen, jacobian=jacobian)
            correction = there.position_following(-phi[rows][:, None])[:, 0]
            q = q + correction
            if not float(np.max(np.abs(correction) / chosen.sizes, initial=0.0)) > 1e-13:
                break
    drift, jacobian = system.engine.evaluate("velocity_constraint", t, q, point.qd, z, point.u, point.w, point.p)
    qd = point.qd + replace(chosen, jacobian=jacobian).rate_following(-drift[:, None])[:, 0]
    if not np.all(np.isfinite(q)) or not np.all(np.isfinite(qd)):
        return None
    return replace(point, t=t, q=q, qd=qd, z=z)
