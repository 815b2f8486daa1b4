"""Motion out of and across singular positions, where several branches of the constraint set meet.

There the accelerations of the system of equations need not belong to any branch: the lost rows leave them free. So the
motion is not integrated from there but fitted, for a short time: derivatives are polynomials in time that agree with
the equations at collocation points behind the start, whose states are projected onto the constraints. From rest the
branch is the one nearest, in the metric of M, to where the free accelerations lead (Gauss's principle of least
constraint); later the motion is smooth and the branch is kept.
Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., section II.7.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from lagdsl.mechanics.rank import Floats
from lagdsl.simulate.projection import Projection
from lagdsl.simulate.right_hand_side import RightHandSide, finite

# Not too near the start, where positions are hardly told apart from the singular one.
_NODES = np.linspace(0.3, 1.0, 7)
# Part of the time in which a coordinate moves by its natural size: long enough to leave the singular position, short
# enough for so many points. Halved where the motion has shorter times of its own.
_PART = 0.1
_HALVINGS = 4
_ITERATIONS = 30
_CONVERGED = 1e-11
# Changes that do not shrink any more are round-off, magnified by the nearness of the singular position.
_SETTLED = 1e-4
# Estimated errors, as a part of the change of state: good enough at once, and not good enough at all.
_ACCURATE = 1e-6
_USELESS = 1e-4
# A crossing, in distances to the singular position: how far (shorter where the motion bends, longer where round-off is
# magnified), at least how far, and where in between constraints are looked at; by how much, as a part of the natural
# size of the rows, they may be missed.
_ACROSS = (8.0, 32.0, 4.0, 128.0)
_LEAST_ACROSS = 4.0
_BETWEEN = np.array([0.06, 0.125, 0.19, 0.25, 0.6])
_KEPT = 1e-9


@dataclass(frozen=True, slots=True)
class Departure:
    """The motion from `start` (time `t`) on for `length` seconds; `y` is the state then."""

    t: float
    length: float
    start: Floats
    slopes: Floats
    rates: int
    y: Floats

    def at(self, time: float) -> Floats:
        """The state at a time inside, not projected."""
        part = np.array([(time - self.t) / self.length])
        return np.asarray(_states(self.start, self.slopes, self.rates, self.length, part)[0])


def depart(
    system: RightHandSide, projection: Projection, sizes: Floats, t: float, y: Floats, end: float
) -> Departure | None:
    """The motion just behind the singular state `y`, within the time to `end`; None where it stays or none is found.

    `projection` is to be as exact as the arithmetic allows. Where the rates decide on the branch, and not the
    accelerations, there is nothing to do: None as well.
    """
    length = min(_PART * _pace(system, sizes, t, y), 0.5 * (end - t))
    if not length < np.inf:
        return None
    best, smallest = None, _USELESS
    for _ in range(_HALVINGS):
        slopes = _collocated(system, projection, t, y, length)
        error = np.inf if slopes is None else _error(slopes)
        reached = None
        if slopes is not None and error < smallest:
            reached = projection(t + length, _states(y, slopes, system.n, length, _NODES[-1:])[0])
        if slopes is not None and reached is not None:
            best, smallest = Departure(t, length, y, slopes, system.n, reached), error
        if smallest <= _ACCURATE or (best is not None and error > smallest):
            break
        length *= 0.5
    return best


def cross(
    system: RightHandSide,
    projection: Projection,
    t: float,
    y: Floats,
    distance: float,
    end: float,
    *,
    meets: Callable[[float, Floats], bool],
    tolerances: Floats,
) -> Departure | None:
    """The motion across a singular position that lies `distance` seconds ahead; None if this one has to be looked at
    closer, or if branches do not meet there, by `meets(time, state)`.

    Accelerations are wild there, the motion along a branch is not: the nodes lie beyond. The fitted motion must be
    smooth, to these `tolerances` of rates and states, and keep to the constraints all the way.
    """
    for across in _ACROSS:
        length = min(across * distance, 0.999 * (end - t))
        slopes = _collocated(system, projection, t, y, length) if length >= _LEAST_ACROSS * distance else None
        if slopes is None or not np.all(length * _doubt(slopes) <= tolerances):
            continue
        parts = np.array([*_BETWEEN, distance / length, 1.0])
        states = _states(y, slopes, system.n, length, parts)
        times = (t + length * parts).tolist()
        off = [projection.distance(time, state) for time, state in zip(times[:-1], states[:-1], strict=True)]
        reached = projection(times[-1], states[-1])
        if reached is not None and max(off) <= _KEPT and meets(times[-2], states[-2]):
            return Departure(t, length, y, slopes, system.n, reached)
    return None


def _collocated(system: RightHandSide, projection: Projection, t: float, y: Floats, length: float) -> Floats | None:
    """Derivatives of rates and states at the nodes, (nodes, nq + nz), by fixed-point iteration; None without."""
    slopes = np.tile(system(t, y)[system.n :], (len(_NODES), 1))
    change = np.inf
    for _ in range(_ITERATIONS):
        before, slopes = slopes, np.empty_like(slopes)
        states = _states(y, before, system.n, length, _NODES)
        for index, time in enumerate((t + length * _NODES).tolist()):
            state = projection(time, states[index])
            derivative = None if state is None else system(time, state)
            if derivative is None or not finite(derivative):
                return None
            slopes[index] = derivative[system.n :]
        previous, change = change, float(np.max(np.abs(slopes - before) / (1.0 + np.abs(slopes))))
        if change <= _CONVERGED or (change <= _SETTLED and change > 0.2 * previous):
            return slopes
    return None


def _error(slopes: Floats) -> float:
    """The doubt about the change of rates and states, as a part of it."""
    change = _integrals(_NODES, slopes, np.ones(1))[0]
    return float(np.max(_doubt(slopes)) / (np.max(np.abs(change)) or 1.0))


def _doubt(slopes: Floats) -> Floats:
    """What leaving out the first node changes, per second: far more than the error of all nodes."""
    end = np.ones(1)
    return np.asarray(np.abs(_integrals(_NODES, slopes, end)[0] - _integrals(_NODES[1:], slopes[1:], end)[0]))


def _pace(system: RightHandSide, sizes: Floats, t: float, y: Floats) -> float:
    """Time in which the accelerations move a coordinate by its natural size; infinite where rates do that sooner, or
    without acceleration."""
    _, qd, _ = system.split(y)
    qdd = system(t, y)[system.n : 2 * system.n]
    speed = float(np.max(np.abs(qd) / sizes, initial=0.0))
    urge = float(np.max(np.abs(qdd) / sizes, initial=0.0))
    pace = float(np.sqrt(2.0 / urge)) if urge > 0.0 else np.inf
    return pace if speed * pace < 1.0 else np.inf


def _states(start: Floats, slopes: Floats, n: int, length: float, at: Floats) -> Floats:
    """States at parts `at` of the interval, (len(at), len(start)): qd and z as integrals of the polynomials through
    `slopes` at the nodes, q as double integrals."""
    once, twice = _integrals(_NODES, slopes, at)
    q = start[:n] + length * at[:, None] * start[n : 2 * n] + length**2 * twice[:, :n]
    return np.hstack([q, start[n:] + length * once])


def _integrals(nodes: Floats, values: Floats, at: Floats) -> tuple[Floats, Floats]:
    """Integral and double integral from 0 to each of `at` of the polynomials that have `values` at `nodes`."""
    powers = np.arange(len(nodes))
    coefficients = np.linalg.solve(nodes[:, None] ** powers, values)
    once = at[:, None] ** (powers + 1) / (powers + 1)
    twice = at[:, None] ** (powers + 2) / ((powers + 1) * (powers + 2))
    return once @ coefficients, twice @ coefficients
