"""The point of a constraint set nearest to the origin, which is the declared start.

Found by following the problem from the start (`|y|^2 e + |equations(y)|^2` with e to 0) and by the root finder alone,
each made stationary by Newton's method on the set. Where the set bends more than half the distance, at the start or
at the point found, there may be nearer points: then further beginnings inside the ball of that distance are tried.
Independent parts of the equations are searched at the same time, each as if it were alone.
Source: Nocedal and Wright, Numerical Optimization, 2nd ed., sections 17.1 (penalty), 18.3 (reduced Hessian) and 3.1
(line search).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from lagdsl.mechanics.partition import Flags, Partition, entries, labelled, whole
from lagdsl.mechanics.rank import Floats, minimum_norm, null_space
from lagdsl.mechanics.structure_newton import Descent, Equations, descend

_DIFFERENCE = 1e-6
_STATIONARY = 1e-11
_PENALTIES = (1.0, 0.3, 0.1, 0.03, 0.01, 1e-3)
# Distances that differ by less are the same; the point that is reached from the start then stays.
_TIE = 1e-9
# How many of the points that further beginnings lead to are made stationary.
_REFINED = 6


@dataclass(frozen=True, slots=True)
class _Found:
    """A point with residuals and distances from the origin of each part."""

    point: Floats
    sizes: Floats
    distances: Floats


@dataclass(frozen=True, slots=True)
class _Search:
    equations: Equations
    split: Partition
    holds: float

    def found(self, point: Floats) -> _Found:
        return _Found(point, self.split.sizes(self.equations(point)[0]), self.split.distances(point))

    def descended(self, start: Floats) -> _Found:
        found = descend(self.equations, start, partition=self.split)
        return _Found(found.point, self.split.sizes(found.residual), self.split.distances(found.point))

    def better(self, chosen: Flags, one: _Found, other: _Found) -> _Found:
        """`one` in the chosen parts, `other` in the rest."""
        return _Found(
            self.split.mixed(chosen, one.point, other.point),
            np.where(chosen, one.sizes, other.sizes),
            np.where(chosen, one.distances, other.distances),
        )


def search(
    equations: Equations,
    size: int,
    others: Sequence[Floats],
    *,
    holds: float,
    partition: Partition | None = None,
) -> Descent:
    """Minimise |y| subject to equations(y) = 0, y of shape (size,).

    `others` are further beginnings, used as directions once a point is known. Where no beginning leads to residuals
    below `holds`, the result is the point of the smallest ones. `partition` says which equations are independent.
    """
    origin = np.zeros(size)
    split = partition or whole(len(equations(origin)[0]), size)
    task = _Search(equations, split, holds)
    found = [task.descended(origin), task.descended(_followed(equations, origin, split))]
    best = task.better(found[1].sizes < found[0].sizes, found[1], found[0])
    if np.any(best.sizes > holds):
        for other in others:
            tried = task.descended(split.mixed(best.sizes > holds, other, best.point))
            found.append(tried)
            best = task.better(tried.sizes < best.sizes, tried, best)
    feasible = best.sizes <= holds
    if np.any(feasible):
        best = task.better(feasible, _best(task, None, found), best)
    if np.all(feasible):
        best = _beyond_bends(task, best, others)
    residual = equations(best.point)[0]
    return Descent(point=best.point, residual=residual, size=float(np.max(best.sizes, initial=0.0)))


def _beyond_bends(task: _Search, best: _Found, others: Sequence[Floats]) -> _Found:
    """Nearer points of parts that bend."""
    bending = (best.distances > 0.0) & _bends(task, best.point)
    if not np.any(bending):
        return best
    found = []
    for index, other in enumerate(others):
        lengths = task.split.distances(other)
        part = best.distances * (index + 1) / len(others) / np.where(lengths > 0.0, lengths, 1.0)
        for sign in (1.0, -1.0):
            beginning = sign * part[task.split.column_labels] * other
            found.append(task.descended(task.split.mixed(bending, beginning, best.point)))
    return _best(task, best, found)


def nearest(
    equations: Equations,
    start: Floats,
    *,
    holds: Floats | float,
    partition: Partition | None = None,
    iterations: int = 60,
) -> Floats:
    """A local minimum of |y| subject to equations(y) = 0 from a point `start` where they hold; lengths fall
    monotonically."""
    split = partition or whole(len(equations(start)[0]), len(start))
    limits = np.broadcast_to(np.asarray(holds, dtype=np.float64), (split.count,))
    moving = np.zeros(split.count, dtype=np.bool_)
    for parts in split.parts:
        moving[parts.labels] = True
    point = split.mixed(moving, start, np.zeros_like(start))  # what nothing restricts stays at the origin
    for _ in range(iterations):
        steps, ways = _steps(equations, point, split, moving)
        shorter, moved = _shorter(equations, point, steps, split, limits, moving)
        if np.any(ways):  # from a saddle down on either side: the shorter one
            other, also = _shorter(
                equations, point, np.where(ways[split.column_labels], -steps, 0.0), split, limits, ways
            )
            chosen = also & (~moved | (split.distances(other) < split.distances(shorter)))
            shorter, moved = split.mixed(chosen, other, shorter), moved | also
        point, moving = shorter, moved
        if not np.any(moving):
            break
    return point


def _steps(equations: Equations, point: Floats, split: Partition, moving: Flags) -> tuple[Floats, Flags]:
    """Newton steps along the set of the moving parts, and which of them leave a saddle; parts that are stationary
    become still."""
    jacobian = equations(point)[1]
    steps, ways = np.zeros_like(point), np.zeros(split.count, dtype=np.bool_)
    tangents: dict[int, tuple[Floats, Floats, np.ndarray, np.ndarray]] = {}
    for parts in split.parts:
        for label, block, rows, columns in zip(
            parts.labels.tolist(), entries(jacobian, parts), parts.rows, parts.columns, strict=True
        ):
            if moving[label]:
                tangents[label] = (null_space(block), -minimum_norm(block.T, point[columns]), rows, columns)
    bends = _bend(equations, point, tangents)
    lengths = 1.0 + split.distances(point)
    for label, (free, _, _, columns) in tangents.items():
        slope = free.T @ point[columns]
        hessian = np.eye(free.shape[1]) + free.T @ bends[label]
        values, vectors = np.linalg.eigh(0.5 * (hessian + hessian.T))
        if float(np.linalg.norm(slope)) > _STATIONARY * lengths[label]:
            steps[columns] = -free @ (vectors @ ((vectors.T @ slope) / np.maximum(np.abs(values), 0.05)))
        elif len(values) and values[0] < -1e-6:  # a maximum or a saddle: down on either side
            steps[columns] = 0.1 * lengths[label] * (free @ vectors[:, 0])
            ways[label] = True
        else:
            moving[label] = False
    return steps, ways


def _followed(equations: Equations, origin: Floats, split: Partition) -> Floats:
    """Minima of e |y|^2 + |equations(y)|^2 for ever smaller e, each from the last, the first from the origin."""
    point, identity = origin, np.eye(len(origin))
    labels = np.concatenate([split.row_labels, split.column_labels])
    widened = labelled(labels, split.column_labels, split.count)
    for penalty in _PENALTIES:

        def relaxed(y: Floats, penalty: float = penalty) -> tuple[Floats, Floats]:
            residual, jacobian = equations(y)
            return np.concatenate([residual, penalty * y]), np.vstack([jacobian, penalty * identity])

        point = descend(relaxed, point, iterations=20, partition=widened).point
    return point


def _best(task: _Search, best: _Found | None, found: Sequence[_Found]) -> _Found:
    """For each part the nearest of `best` and the stationary points reached from those of `found` that are nearest; of
    mirrored ones that with the larger coordinates, so that the order of `found` does not matter."""
    distances = np.array([np.where(each.sizes <= task.holds, each.distances, np.inf) for each in found])
    order = np.argsort(distances, axis=0, kind="stable")
    refined: list[_Found] = []
    for rank_ in range(min(_REFINED, len(found))):
        chosen = found[0]
        for index, each in enumerate(found):
            chosen = task.better(order[rank_] == index, each, chosen)
        # where fewer are feasible the nearest one stands in
        infeasible = np.take_along_axis(distances, order[rank_][None, :], axis=0)[0] == np.inf
        if np.all(infeasible):
            break
        refined.append(_refined(task, chosen if not refined else task.better(infeasible, refined[0], chosen)))
    limit = np.min([each.distances for each in [*refined, *([] if best is None else [best])]], axis=0) * (1.0 + _TIE)
    result = refined[0]
    keys = [_keys(task.split, each.point, limit) for each in refined]
    for label in range(task.split.count):
        alike = [index for index, each in enumerate(refined) if each.distances[label] <= limit[label]]
        if alike and alike != [0]:
            winner = max(alike, key=lambda index: keys[index][label])
            only = np.arange(task.split.count) == label
            result = task.better(only, refined[winner], result)
    if best is None:
        return result
    return task.better(best.distances <= limit, best, result)


def _keys(split: Partition, point: Floats, limit: Floats) -> list[tuple[float, ...]]:
    """The coordinates of each part, in its distance and rounded."""
    keys: list[list[float]] = [[] for _ in range(split.count)]
    scaled = np.round(point / np.where(limit > 0.0, limit, 1.0)[split.column_labels], 6)
    for label, value in zip(split.column_labels.tolist(), scaled.tolist(), strict=True):
        keys[label].append(value)
    return [tuple(key) for key in keys]


def _refined(task: _Search, found: _Found) -> _Found:
    limits = np.maximum(1e-12, found.sizes)
    return task.found(nearest(task.equations, found.point, holds=limits, partition=task.split))


def _bends(task: _Search, point: Floats) -> Flags:
    """Which parts bend by more than half the distance, at the origin or at the point."""
    split = task.split
    jacobian = task.equations(point)[1]
    every: dict[int, tuple[Floats, Floats, np.ndarray, np.ndarray]] = {}
    for parts in split.parts:
        for label, block, rows, columns in zip(
            parts.labels.tolist(), entries(jacobian, parts), parts.rows, parts.columns, strict=True
        ):
            every[label] = (np.eye(len(columns)), -minimum_norm(block.T, point[columns]), rows, columns)
    result = np.zeros(split.count, dtype=np.bool_)
    for place in (np.zeros_like(point), point):
        for label, bend in _bend(task.equations, place, every).items():
            result[label] |= not np.all(np.isfinite(bend)) or float(np.linalg.norm(bend, 2)) > 0.5
    return result


def _bend(
    equations: Equations, point: Floats, parts: dict[int, tuple[Floats, Floats, np.ndarray, np.ndarray]]
) -> dict[int, Floats]:
    """Second derivatives of weights.equations along directions (columns) for each part, given as (directions, weights,
    rows, columns): by central differences of the Jacobian, one direction of all parts at once."""
    bends = {label: np.empty_like(directions) for label, (directions, _, _, _) in parts.items()}
    for index in range(max((bend.shape[1] for bend in bends.values()), default=0)):
        step = np.zeros_like(point)
        for directions, _, _, columns in parts.values():
            if index < directions.shape[1]:
                step[columns] = _DIFFERENCE * directions[:, index]
        change = (equations(point + step)[1] - equations(point - step)[1]) / (2.0 * _DIFFERENCE)
        for label, (directions, weights, rows, columns) in parts.items():
            if index < directions.shape[1]:
                bends[label][:, index] = change[np.ix_(rows, columns)].T @ weights
    return bends


def _shorter(
    equations: Equations, point: Floats, direction: Floats, split: Partition, holds: Floats, moving: Flags
) -> tuple[Floats, Flags]:
    """Points of the set on the way along `direction` that are closer to the origin, and for which of the moving parts
    there is one."""
    result, done = point, np.zeros(split.count, dtype=np.bool_)
    before = split.distances(point)
    factor = 1.0
    while factor > 1e-6 and np.any(moving & ~done):
        trial = split.mixed(moving & ~done, point + factor * direction, result)
        found = descend(equations, trial, partition=split)
        fits = (split.sizes(found.residual) <= holds) & (split.distances(found.point) < before) & moving & ~done
        result, done = split.mixed(fits, found.point, result), done | fits
        factor *= 0.5
    return result, done
