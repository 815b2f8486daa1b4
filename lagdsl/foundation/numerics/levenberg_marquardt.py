"""Damped Gauss-Newton for equations with more, fewer or dependent rows: the one root finder of the house.

Levenberg's damping with steps of minimum norm, so that dependent rows and singular positions pass. Independent parts
of the equations are damped, accepted and finished each for itself. Bounds hold at every point: steps end at them, and
what stands at a bound takes no part in a step that would lead it out.
Source: Nocedal and Wright, Numerical Optimization, 2nd ed., section 10.3; of bounds Kanzow, Yamashita and Fukushima,
J. Computational and Applied Mathematics 172 (2004) 375-397.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from lagdsl.foundation.numerics.connected_blocks import Partition, entries, whole
from lagdsl.foundation.numerics.rank import Floats, minimum_norms
from lagdsl.foundation.numerics.sparse_matrix import Flags, SparseMatrix
from lagdsl.foundation.record import record

Jacobian = Floats | SparseMatrix
Equations = Callable[[Floats], tuple[Floats, Floats]]
Bounds = tuple[Floats, Floats]  # lower, upper, both (n,)

_SMALLEST_DAMPING = 1e-3
_LARGEST_DAMPING = 1e8
_STIFFNESSES = (1.0, 0.3, 0.1, 0.03, 0.01)


@record(kw_only=True)
class Minimizer:
    """Result of the search: the point, the residuals there and their Euclidean norm (infinite if they are not
    numbers)."""

    point: Floats
    residual: Floats
    size: float


def descend(
    equations: Callable[[Floats], tuple[Floats, Jacobian]],
    start: Floats,
    *,
    target: float = 1e-13,
    iterations: int = 100,
    connected_blocks: Partition | None = None,
    bounds: Bounds | None = None,
) -> Minimizer:
    """Reduce |residual| from `start` until it is below `target`, stalls or `iterations` are used up.

    `equations(x)` gives residual (m,) and Jacobian (m, n), both scaled to be of order one; the entries of a sparse one
    stand at the same places everywhere. Once below `target` it
    goes on as long as whole steps still halve the residual, so the result is as exact as the arithmetic allows.
    `connected_blocks` says which of them are independent. The points stay within `bounds`.
    """
    point = start if bounds is None else np.clip(start, *bounds)
    residual, jacobian = equations(point)
    split = connected_blocks or whole(len(residual), len(point))
    sizes = split.sizes(residual)
    damping = np.zeros(split.count)
    active = np.zeros(split.count, dtype=np.bool_)
    for parts in split.parts:
        active[parts.labels] = True
    for _ in range(iterations):
        active &= (sizes > 0.0) & np.isfinite(sizes)
        step_of = partial(_step, split, residual, damping, active)
        aim = point - step_of(jacobian) if bounds is None else _within(bounds, point, step_of, jacobian)
        if not np.any(active):
            break
        trial = split.mixed(active, aim, point)
        new_residual, new_jacobian = equations(trial)
        new_sizes = split.sizes(new_residual)
        better = active & (new_sizes < sizes)
        settled = (sizes <= target) & (new_sizes > 0.5 * sizes)
        stalled = (damping == 0.0) & (new_sizes > (1.0 - 1e-9) * sizes)
        hopeless = ~better & ((sizes <= target) | (damping > _LARGEST_DAMPING))
        active &= ~hopeless & ~(better & (settled | stalled))
        point = split.mixed(better, trial, point)
        rows = better[split.row_labels]
        residual = np.where(rows, new_residual, residual)
        jacobian = _rows_of(rows, new_jacobian, jacobian)
        sizes = np.where(better, new_sizes, sizes)
        relaxed = np.where(damping > _SMALLEST_DAMPING, damping / 3.0, 0.0)
        damping = np.where(better, relaxed, np.maximum(4.0 * damping, _SMALLEST_DAMPING))
    size = float(np.linalg.norm(residual))
    return Minimizer(point=point, residual=residual, size=size if np.isfinite(size) else np.inf)


def _rows_of(chosen: Flags, new: Jacobian, old: Jacobian) -> Jacobian:
    """The chosen rows of `new`, the others of `old`."""
    if isinstance(new, SparseMatrix):
        assert isinstance(old, SparseMatrix), "it has one form everywhere"
        return new.with_values(np.where(chosen[new.rows], new.values, old.values))
    assert not isinstance(old, SparseMatrix), "it has one form everywhere"
    return np.where(chosen[:, None], new, old)


def _held_at(bounds: Flags, jacobian: Jacobian) -> Jacobian:
    """Without the columns of unknowns that stay."""
    if isinstance(jacobian, SparseMatrix):
        return jacobian.with_values(np.where(bounds[jacobian.columns], 0.0, jacobian.values))
    return np.where(bounds, 0.0, jacobian)


def sprung(equations: Equations, origin: Floats) -> Floats:
    """The least (n,) of |equations(y)|^2 + e |y|^2 for ever smaller e, each from the last: it stays near `origin`."""
    point, identity = origin, np.eye(len(origin))
    for stiffness in _STIFFNESSES:

        def held(y: Floats, stiffness: float = stiffness) -> tuple[Floats, Floats]:
            residual, jacobian = equations(y)
            return np.concatenate([residual, stiffness * y]), np.vstack([jacobian, stiffness * identity])

        point = descend(held, point, iterations=10).point
    return point


def _within(bounds: Bounds, point: Floats, step_of: Callable[[Jacobian], Floats], jacobian: Jacobian) -> Floats:
    """End of the step that leads no unknown out of a bound at which it stands."""
    lower, upper = bounds
    held = np.zeros(len(point), dtype=np.bool_)
    while True:
        step = step_of(_held_at(held, jacobian))
        leaving = ~held & (((point <= lower) & (step > 0.0)) | ((point >= upper) & (step < 0.0)))
        if not np.any(leaving):
            return np.clip(point - step, lower, upper)
        held |= leaving


def _step(split: Partition, residual: Floats, damping: Floats, active: np.ndarray, jacobian: Jacobian) -> Floats:
    """Steps of the active parts; one whose Jacobian is no number becomes inactive."""
    step = np.zeros(jacobian.shape[1])
    for parts in split.parts:
        here = parts.only(active[parts.labels])
        if not len(here.labels):
            continue
        blocks = entries(jacobian, here)
        finite = np.all(np.isfinite(blocks), axis=(1, 2))
        active[here.labels] = finite
        rows, columns, damped = here.rows[finite], here.columns[finite], damping[here.labels[finite]]
        step[columns] = minimum_norms(blocks[finite], residual[rows], damping=damped)
    return step
