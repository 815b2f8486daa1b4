"""Ranks, null spaces and minimum-norm solutions of small dense matrices, all by singular values with one tolerance.

Callers scale first: columns by the natural size of the coordinates, rows to unit length, so that a ratio of singular
values is a statement about the mechanism and not about its units.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# Singular values below this part of the largest count as zero. Far above round-off of a derived Jacobian (1e-13),
# far below what a mechanism a hundredth of a degree away from a singular position shows (1e-4).
RANK_TOLERANCE = 1e-9


def rank(matrix: Floats, tolerance: float = RANK_TOLERANCE) -> int:
    """Number of singular values above `tolerance` times the largest."""
    if not matrix.size:
        return 0
    values = np.linalg.svd(matrix, compute_uv=False)
    return int(np.count_nonzero(values > tolerance * values[0])) if values[0] > 0.0 else 0


def null_space(matrix: Floats, tolerance: float = RANK_TOLERANCE) -> Floats:
    """Orthonormal columns that span {v: matrix v = 0}; shape (n, n - rank)."""
    n = matrix.shape[1]
    if not matrix.size:
        return np.eye(n)
    _, values, rows = np.linalg.svd(matrix, full_matrices=True)
    count = int(np.count_nonzero(values > tolerance * values[0])) if values[0] > 0.0 else 0
    return np.ascontiguousarray(rows[count:].T)


def minimum_norm(matrix: Floats, right: Floats, tolerance: float = RANK_TOLERANCE, damping: float = 0.0) -> Floats:
    """The least-squares solution of smallest norm; `damping` (relative to the largest singular value) shortens it."""
    if not matrix.size:
        return np.zeros(matrix.shape[1])
    left, values, rows = np.linalg.svd(matrix, full_matrices=False)
    if values[0] == 0.0:
        return np.zeros(matrix.shape[1])
    kept = values > tolerance * values[0]
    values = values[kept]
    inverse = values / (values**2 + (damping * values[0]) ** 2)
    return np.asarray(rows[kept].T @ (inverse * (left[:, kept].T @ right)))


def independent_rows(samples: list[Floats], order: list[int], tolerance: float = 1e-8) -> list[bool]:
    """Which rows are kept when rows are taken in `order` and one is left out if it depends on those kept at every
    sample.

    `samples` are the same matrix at several points; dependence is the relative distance of a row from the span of
    the others.
    """
    rows = samples[0].shape[0] if samples else 0
    kept = [False] * rows
    bases: list[list[Floats]] = [[] for _ in samples]
    largest = [float(np.max(np.linalg.norm(sample, axis=1), initial=0.0)) for sample in samples]
    for row in order:
        rests: list[Floats | None] = []
        for sample, basis, size in zip(samples, bases, largest, strict=True):
            vector = sample[row]
            length = float(np.linalg.norm(vector))
            remainder = _without(_without(vector, basis), basis)
            independent = length > 1e-12 * size and float(np.linalg.norm(remainder)) > tolerance * length
            rests.append(remainder if independent else None)
        kept[row] = any(rest is not None for rest in rests)
        for rest, basis in zip(rests, bases, strict=True):
            if rest is not None:
                basis.append(rest / np.linalg.norm(rest))
    return kept


def _without(vector: Floats, basis: list[Floats]) -> Floats:
    for direction in basis:
        vector = vector - direction * float(direction @ vector)
    return vector


def augmented_mass(mass: Floats, jacobian: Floats) -> Floats:
    """M + c J'J: the same metric for every displacement with given J dq, and positive definite wherever the
    constrained system is, even if M alone is singular (quaternions, massless links)."""
    if not jacobian.size:
        return mass
    outer = jacobian.T @ jacobian
    weight = float(np.trace(outer))
    return np.asarray(mass + (float(np.trace(mass)) / weight if weight > 0.0 else 0.0) * outer)
