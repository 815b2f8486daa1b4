"""The point of a constraint set nearest to the origin, which is the declared start.

Found by following the problem from the start (`|y|^2 e + |equations(y)|^2` with e to 0) and by the root finder alone,
each made stationary by Newton's method on the set. Where the set bends more than half the distance, at the start or
at the point found, there may be nearer points: then further beginnings inside the ball of that distance are tried.
Source: Nocedal and Wright, Numerical Optimization, 2nd ed., sections 17.1 (penalty), 18.3 (reduced Hessian) and 3.1
(line search).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.mechanics.rank import Floats, minimum_norm, null_space
from lagdsl.mechanics.structure_newton import Descent, Equations, descend

_DIFFERENCE = 1e-6
_STATIONARY = 1e-11
_PENALTIES = (1.0, 0.3, 0.1, 0.03, 0.01, 1e-3)
# Distances that differ by less are the same; the point that is reached from the start then stays.
_TIE = 1e-9
# How many of the points that further beginnings lead to are made stationary.
_REFINED = 6


def search(equations: Equations, size: int, others: Sequence[Floats], *, holds: float) -> Descent:
    """Minimise |y| subject to equations(y) = 0, y of shape (size,).

    `others` are further beginnings, used as directions once a point is known. Where no beginning leads to residuals
    below `holds`, the result is the point of the smallest ones.
    """
    origin = np.zeros(size)
    found = [descend(equations, origin), descend(equations, _followed(equations, origin))]
    if not any(each.size <= holds for each in found):
        found += [descend(equations, other) for other in others]
    best = min(found, key=lambda each: each.size)
    if best.size > holds:
        return best
    best = _best(equations, None, found, holds)
    distance = _distance(best)
    if distance > 0.0 and _bends(equations, best.point):
        beginnings = [
            sign * distance * (index + 1) / len(others) * other / (float(np.linalg.norm(other)) or 1.0)
            for index, other in enumerate(others)
            for sign in (1.0, -1.0)
        ]
        best = _best(equations, best, [descend(equations, beginning) for beginning in beginnings], holds)
    return best


def nearest(equations: Equations, start: Floats, *, holds: float, iterations: int = 60) -> Floats:
    """A local minimum of |y| subject to equations(y) = 0 from a point `start` where they hold; lengths fall
    monotonically."""
    point = start
    for _ in range(iterations):
        jacobian = equations(point)[1]
        free = null_space(jacobian)
        slope = free.T @ point
        values, vectors = np.linalg.eigh(_reduced_hessian(equations, point, jacobian, free))
        length = 1.0 + float(np.linalg.norm(point))
        if float(np.linalg.norm(slope)) > _STATIONARY * length:
            step = -free @ (vectors @ ((vectors.T @ slope) / np.maximum(np.abs(values), 0.05)))
            shorter = _shorter(equations, point, step, holds)
        elif len(values) and values[0] < -1e-6:  # a maximum or a saddle: down on either side
            step = 0.1 * length * (free @ vectors[:, 0])
            ways = [_shorter(equations, point, way, holds) for way in (step, -step)]
            shorter = min((way for way in ways if way is not None), key=np.linalg.norm, default=None)
        else:
            break
        if shorter is None:
            break
        point = shorter
    return point


def _followed(equations: Equations, origin: Floats) -> Floats:
    """Minima of e |y|^2 + |equations(y)|^2 for ever smaller e, each from the last, the first from the origin."""
    point, identity = origin, np.eye(len(origin))
    for penalty in _PENALTIES:

        def relaxed(y: Floats, penalty: float = penalty) -> tuple[Floats, Floats]:
            residual, jacobian = equations(y)
            return np.concatenate([residual, penalty * y]), np.vstack([jacobian, penalty * identity])

        point = descend(relaxed, point, iterations=20).point
    return point


def _best(equations: Equations, best: Descent | None, found: Sequence[Descent], holds: float) -> Descent:
    """The nearest of `best` and the stationary points reached from those of `found` that are nearest; of mirrored ones
    that with the larger coordinates, so that the order of `found` does not matter."""
    feasible = sorted((each for each in found if each.size <= holds), key=_distance)
    refined = [_refined(equations, each, holds) for each in feasible[:_REFINED]]
    nearest_of_all = min([*refined, *([] if best is None else [best])], key=_distance)
    limit = (1.0 + _TIE) * _distance(nearest_of_all)
    if best is not None and _distance(best) <= limit:
        return best
    alike = [each for each in refined if _distance(each) <= limit]
    return max(alike, key=lambda each: tuple(np.round(each.point / (limit or 1.0), 6).tolist()))


def _distance(found: Descent) -> float:
    return float(np.linalg.norm(found.point))


def _refined(equations: Equations, found: Descent, holds: float) -> Descent:
    point = nearest(equations, found.point, holds=max(1e-12, found.size))
    residual = equations(point)[0]
    return Descent(point=point, residual=residual, size=float(np.linalg.norm(residual)))


def _bends(equations: Equations, point: Floats) -> bool:
    """Whether the set bends by more than half the distance, at the origin or at the point."""
    jacobian = equations(point)[1]
    weights = -minimum_norm(jacobian.T, point)
    every = np.eye(len(point))
    bends = [_bend(equations, place, weights, every) for place in (np.zeros_like(point), point)]
    return any(not np.all(np.isfinite(bend)) or float(np.linalg.norm(bend, 2)) > 0.5 for bend in bends)


def _bend(equations: Equations, point: Floats, weights: Floats, directions: Floats) -> Floats:
    """Second derivatives of weights.equations along `directions` (columns), by central differences of the Jacobian."""
    bend = np.empty_like(directions)
    for column in range(directions.shape[1]):
        step = _DIFFERENCE * directions[:, column]
        ahead, behind = equations(point + step)[1], equations(point - step)[1]
        bend[:, column] = (ahead - behind).T @ weights / (2.0 * _DIFFERENCE)
    return bend


def _reduced_hessian(equations: Equations, point: Floats, jacobian: Floats, free: Floats) -> Floats:
    """Second derivatives of the Lagrangian |y|^2/2 + weights.equations along the set."""
    weights = -minimum_norm(jacobian.T, point)
    reduced = np.eye(free.shape[1]) + free.T @ _bend(equations, point, weights, free)
    return np.asarray(0.5 * (reduced + reduced.T))


def _shorter(equations: Equations, point: Floats, direction: Floats, holds: float) -> Floats | None:
    """A point of the set on the way along `direction` that is closer to the origin."""
    factor = 1.0
    while factor > 1e-6:
        found = descend(equations, point + factor * direction)
        if found.size <= holds and float(np.linalg.norm(found.point)) < float(np.linalg.norm(point)):
            return found.point
        factor *= 0.5
    return None
