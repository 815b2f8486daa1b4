"""Newton's method along a path: the residual of the start is let go by and by.

The sums of squares of stiff structures mislead a search: a slender beam has to stretch a little before it bends much,
and a step that decreases them is as short as that stretch. Whole steps of Newton's method do not care, as long as they
begin near the solution. So r(x) = (1 - s) r(x0) is solved for rising s, which is how loads are put on a structure: at
once if that converges, else in parts.
Source: E. L. Allgower and K. Georg, Introduction to Numerical Continuation Methods, SIAM 2003, chapters 1 and 2.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lagdsl.foundation.numerics.levenberg_marquardt import Equations, Minimizer
from lagdsl.foundation.numerics.rank import Floats

Independent = Callable[[Floats], Floats]

_STEPS = 12  # whole steps of Newton's method for a part of the path
_NEAR = 1e-6  # a step as short as this ends a part
_LEAST_PART = 1.0 / 128.0


def release(equations: Equations, independent: Independent, start: Floats) -> Minimizer:
    """The end of the path from `start`, a root of the equations; the start where no path leads there.

    `equations(x)` gives residual (m,) and Jacobian (m, n), as for `levenberg_marquardt.descend`; `independent(x)` is
    the matrix (k, m) that takes of them what does not follow from the rest. A row that follows at every x has a
    derivative of its own where the residual is not zero, which would bend the steps. Steps have minimum norm.
    """
    first = equations(start)[0]
    begun = _reached(start, first)
    point, done, part = start, 0.0, 1.0
    while np.isfinite(begun.size) and part >= _LEAST_PART:
        aim = min(done + part, 1.0)
        found = _solved(equations, independent, point, (1.0 - aim) * first)
        if found is None:
            part /= 2.0
        elif aim == 1.0:
            return settle(equations, independent, found)[0]
        else:
            point, done, part = found.point, aim, 2.0 * part
    return begun


def settle(equations: Equations, independent: Independent, found: Minimizer) -> tuple[Minimizer, float]:
    """`found` after whole steps, as long as each is less than half of one of the two before, and the length of the next
    step: how far the solution is, however stiff the equations are. A step may leave less of the residual, but be
    longer than the one before."""
    point = found.point
    step, length = _step(*equations(point), independent(point))
    for _ in range(_STEPS):
        ahead = point - step
        next_step, next_length = _step(*equations(ahead), independent(ahead))
        if not next_length < 0.5 * length:
            ahead = ahead - next_step
            next_step, next_length = _step(*equations(ahead), independent(ahead))
        if not next_length < 0.5 * length:
            break
        point, step, length = ahead, next_step, next_length
    return (found if point is found.point else _reached(point, equations(point)[0])), length


def _step(residual: Floats, jacobian: Floats, independent: Floats) -> tuple[Floats, float]:
    residual, jacobian = independent @ residual, independent @ jacobian
    if not (np.all(np.isfinite(residual)) and np.all(np.isfinite(jacobian))):
        return np.full(jacobian.shape[1], np.nan), np.inf
    step = np.asarray(np.linalg.lstsq(jacobian, residual, rcond=None)[0], dtype=np.float64)
    return step, float(np.linalg.norm(step))


def _reached(point: Floats, residual: Floats) -> Minimizer:
    size = float(np.linalg.norm(residual))
    return Minimizer(point=point, residual=residual, size=size if np.isfinite(size) else np.inf)


def _solved(equations: Equations, independent: Independent, start: Floats, rest: Floats) -> Minimizer | None:
    """Near the solution of r(x) = `rest`, by whole steps; None if not reached."""
    point = start
    for _ in range(_STEPS):
        residual, jacobian = equations(point)
        step, length = _step(residual - rest, jacobian, independent(point))
        if not np.isfinite(length):
            return None
        if length <= _NEAR:
            return _reached(point, residual - rest)
        point = point - step
    return None
