"""Pseudo-transient continuation: the root of equations at which a slow flow comes to rest.

Equations have many roots where a potential has many stationary points, as a stiff rope has with kinks. From far away
Newton's method arrives at any of them, the flow x' = r(x) only at those that it is drawn to: along forces that have a
potential it descends, so its ends are minima. Steps of implicit Euler pass stiff directions at once; they grow as
long as Newton's method solves them soon, and end as whole steps of Newton's method. Where the flow leaves a saddle
they stay shorter than the time in which it does: longer ones lead into it.
Source: C. T. Kelley and D. E. Keyes, SIAM J. Numer. Anal. 35 (1998) 508.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lagdsl.foundation.numerics.rank import Floats

# Residual (m,) of a step of this length from a point, and its Jacobian (m, n).
Implicit = Callable[[Floats, Floats, float], tuple[Floats, Floats]]
Growth = Callable[[Floats], float]

_STEPS = 200
_CORRECTIONS = 8
_LONGEST = 0.5  # a step, in the sizes of the unknowns
_NEAR = 1e-6  # a correction as short as this ends a step
_GROWS, _SHRINKS = 4.0, 4.0
_LEAVES = 0.5  # the longest step by the time in which a deviation grows e-fold
_RANGE = 1e12  # of the lengths of steps, either way


def fall(implicit: Implicit, growth: Growth, start: Floats, length: float) -> Floats | None:
    """The end of the flow from `start`; None if it does not come to rest.

    `implicit(x, before, step)` gives the equations of a step of implicit Euler from `before` to x and their Jacobian;
    `growth(x)` is the largest real part of the eigenvalues of the flow there, `length` the first step.
    """
    point, step = start, length
    for _ in range(_STEPS):
        found = _end_of_step(implicit, point, step)
        if found is None:
            step /= _SHRINKS
            if step * _RANGE < length:
                return None
            continue
        resting = float(np.linalg.norm(found - point)) <= _NEAR
        point = found
        if resting and step > _RANGE * length:
            return point
        rate = growth(point)
        step = min(_GROWS * step, _LEAVES / rate if rate > 0.0 else np.inf)
    return None


def _end_of_step(implicit: Implicit, before: Floats, step: float) -> Floats | None:
    """By whole steps of Newton's method, each less than half of the one before; None if they do not arrive."""
    point, last = before, np.inf
    for _ in range(_CORRECTIONS):
        residual, jacobian = implicit(point, before, step)
        if not (np.all(np.isfinite(residual)) and np.all(np.isfinite(jacobian))):
            return None
        change = np.asarray(np.linalg.lstsq(jacobian, residual, rcond=None)[0], dtype=np.float64)
        length = float(np.linalg.norm(change))
        if not length < 0.5 * last or float(np.linalg.norm(point - change - before)) > _LONGEST:
            return None
        point, last = point - change, length
        if last <= _NEAR:
            return point
    return None
