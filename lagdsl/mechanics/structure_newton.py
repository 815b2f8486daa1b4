"""Damped Gauss-Newton for a handful of equations with more, fewer or dependent rows: the one root finder of the
house.

Levenberg's damping with steps of minimum norm, so that dependent rows and singular positions pass.
Source: Nocedal and Wright, Numerical Optimization, 2nd ed., section 10.3.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from lagdsl.mechanics.rank import Floats, minimum_norm

Equations = Callable[[Floats], tuple[Floats, Floats]]

_SMALLEST_DAMPING = 1e-3
_LARGEST_DAMPING = 1e8


@dataclass(frozen=True, slots=True, kw_only=True)
class Descent:
    """Where the search ended: the point, the residuals there and their Euclidean norm (infinite where nothing is a
    number)."""

    point: Floats
    residual: Floats
    size: float


def descend(equations: Equations, start: Floats, *, target: float = 1e-13, iterations: int = 100) -> Descent:
    """Reduce |residual| from `start` until it is below `target`, stalls or `iterations` are used up.

    `equations(x)` gives residual (m,) and Jacobian (m, n), both scaled to be of order one. Once below `target` it
    goes on as long as whole steps still halve the residual, so the result is as exact as the arithmetic allows.
    """
    point = start
    residual, jacobian = equations(point)
    size = _norm(residual)
    damping = 0.0
    for _ in range(iterations):
        if size == 0.0 or not np.isfinite(size) or not np.all(np.isfinite(jacobian)):
            break
        trial = point - minimum_norm(jacobian, residual, damping=damping)
        new_residual, new_jacobian = equations(trial)
        new_size = _norm(new_residual)
        if new_size < size:
            settled = size <= target and new_size > 0.5 * size
            stalled = damping == 0.0 and new_size > (1.0 - 1e-9) * size
            point, residual, jacobian, size = trial, new_residual, new_jacobian, new_size
            damping = damping / 3.0 if damping > _SMALLEST_DAMPING else 0.0
            if settled or stalled:
                break
        elif size <= target or damping > _LARGEST_DAMPING:
            break
        else:
            damping = max(4.0 * damping, _SMALLEST_DAMPING)
    return Descent(point=point, residual=residual, size=size)


def _norm(residual: Floats) -> float:
    size = float(np.linalg.norm(residual))
    return size if np.isfinite(size) else np.inf
