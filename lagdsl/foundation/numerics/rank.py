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
_SMALL = 1e-100
RANK_TOLERANCE = 1e-9


def rank(matrix: Floats, tolerance: float = RANK_TOLERANCE) -> int:
    """Number of singular values above `tolerance` times the largest."""
    if not np.any(matrix):
        return 0
    values = np.linalg.svd(matrix, compute_uv=False)
    return int(np.count_nonzero(values > tolerance * values[0])) if values[0] > 0.0 else 0


def null_space(matrix: Floats, tolerance: float = RANK_TOLERANCE) -> Floats:
    """Orthonormal columns that span {v: matrix v = 0}; shape (n, n - rank)."""
    n = matrix.shape[1]
    if not np.any(matrix):
        return np.eye(n)
    _, values, rows = np.linalg.svd(matrix, full_matrices=True)
    count = int(np.count_nonzero(values > tolerance * values[0])) if values[0] > 0.0 else 0
    return np.ascontiguousarray(rows[count:].T)


def minimum_norm(matrix: Floats, right: Floats, tolerance: float = RANK_TOLERANCE) -> Floats:
    """The least-squares solution of smallest norm."""
    return np.asarray(minimum_norms(matrix[None], right[None], tolerance)[0])


def minimum_norms(
    matrices: Floats, rights: Floats, tolerance: float = RANK_TOLERANCE, damping: Floats | float = 0.0
) -> Floats:
    """The least-squares solutions (k, n) of smallest norm for matrices (k, m, n) and right-hand sides (k, m).

    `damping` (k,), relative to the largest singular value, shortens them.
    """
    count, _, n = matrices.shape
    if not matrices.size:
        return np.zeros((count, n))
    left, values, rows = np.linalg.svd(matrices, full_matrices=False)
    largest = values[:, :1]
    kept = values > tolerance * largest
    unit = np.where((largest > 0.0) & ((largest < _SMALL) | (largest > 1.0 / _SMALL)), largest, 1.0)
    values, largest = values / unit, largest / unit  # squares of sizes that no square has
    shift = (np.broadcast_to(damping, (count,))[:, None] * largest) ** 2
    inverse = np.where(kept, values, 0.0) / np.where(kept, values**2 + shift, 1.0)
    projected = np.einsum("kij,ki->kj", left, rights)
    return np.asarray(np.einsum("kij,ki->kj", rows, inverse * (projected / unit)))


def independent_rows(matrix: Floats, order: list[int], count: int) -> list[bool]:
    """Flags of `count` independent rows: rows are taken in `order`, and a row that depends on those kept is left out.

    With the right number known, by singular values, no tolerance of its own decides: it is lowered until so many rows
    are found.
    """
    if count == len(matrix):
        return [True] * count
    tolerance = 1e-6
    while True:
        kept = _independent(matrix, order, tolerance, count)
        if sum(kept) >= count or tolerance < 1e-13:
            return kept
        tolerance *= 0.1


def _independent(matrix: Floats, order: list[int], tolerance: float, count: int) -> list[bool]:
    kept = [False] * len(matrix)
    basis = np.zeros((0, matrix.shape[1]))
    lengths = np.linalg.norm(matrix, axis=1)
    least = 1e-12 * float(np.max(lengths, initial=0.0))
    for row in order:
        if lengths[row] <= least or len(basis) == count:
            continue
        rest = matrix[row] - basis.T @ (basis @ matrix[row])
        rest = rest - basis.T @ (basis @ rest)
        length = float(np.linalg.norm(rest))
        if length > tolerance * lengths[row]:
            kept[row] = True
            basis = np.vstack([basis, rest / length])
    return kept
