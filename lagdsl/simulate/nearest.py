"""The point of a constraint set nearest to the origin: Newton's method on the set, with a retraction after every step.

Lengths fall monotonically, so a far or badly curved start still ends in a local minimum.
Source: Nocedal and Wright, Numerical Optimization, 2nd ed., sections 18.3 (reduced Hessian) and 3.1 (line search).
"""

from __future__ import annotations

import numpy as np

from lagdsl.mechanics.rank import Floats, minimum_norm, null_space
from lagdsl.mechanics.structure_newton import Equations, descend

_DIFFERENCE = 1e-6
_STATIONARY = 1e-11


def nearest(equations: Equations, start: Floats, *, holds: float, iterations: int = 40) -> Floats:
    """Minimise |y| subject to equations(y) = 0 from a point `start` where they hold."""
    point = start
    for _ in range(iterations):
        jacobian = equations(point)[1]
        free = null_space(jacobian)
        slope = free.T @ point
        if float(np.linalg.norm(slope)) <= _STATIONARY * (1.0 + float(np.linalg.norm(point))):
            break
        direction = -free @ np.linalg.solve(_curvature(equations, point, jacobian, free), slope)
        shorter = _shorter(equations, point, direction, holds)
        if shorter is None:
            break
        point = shorter
    return point


def _curvature(equations: Equations, point: Floats, jacobian: Floats, free: Floats) -> Floats:
    """Reduced Hessian of the Lagrangian, made positive definite."""
    weights = -minimum_norm(jacobian.T, point)
    bend = np.empty_like(free)
    for column in range(free.shape[1]):
        step = _DIFFERENCE * free[:, column]
        ahead, behind = equations(point + step)[1], equations(point - step)[1]
        bend[:, column] = (ahead - behind).T @ weights / (2.0 * _DIFFERENCE)
    reduced = np.eye(free.shape[1]) + free.T @ bend
    values, vectors = np.linalg.eigh(0.5 * (reduced + reduced.T))
    return np.asarray((vectors * np.maximum(np.abs(values), 0.05)) @ vectors.T)


def _shorter(equations: Equations, point: Floats, direction: Floats, holds: float) -> Floats | None:
    """A point of the set on the way along `direction` that is closer to the origin."""
    factor = 1.0
    while factor > 1e-6:
        found = descend(equations, point + factor * direction)
        if found.size <= holds and float(np.linalg.norm(found.point)) < float(np.linalg.norm(point)):
            return found.point
        factor *= 0.5
    return None
