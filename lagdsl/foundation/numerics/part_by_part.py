"""Linear problems whose independent parts are solved each for itself."""

from __future__ import annotations

import numpy as np

from lagdsl.foundation.numerics.connected_blocks import Partition, connected_blocks, entries
from lagdsl.foundation.numerics.rank import Floats, minimum_norms, null_space
from lagdsl.foundation.numerics.sparse_matrix import SparseMatrix, stack

# Eigenvalues, of a matrix with a unit diagonal, that are surely not zero.
_SAFE = 1e-6


def is_positive_definite(matrix: SparseMatrix, rows: SparseMatrix | None = None) -> bool:
    """True if no eigenvalue of a symmetric matrix (n, n), scaled to a unit diagonal, is below 1e-6; with `rows` (m, n),
    of the sum with A' A, A being these rows, scaled to unit length."""
    diagonal = matrix.diagonal()
    if not np.all(diagonal > 0.0):
        return False
    scale = 1.0 / np.sqrt(diagonal)
    scaled = matrix.with_values(matrix.values * scale[matrix.rows] * scale[matrix.columns]).nonzero()
    stacked = scaled if rows is None else stack(scaled, _of_unit_length(rows, scale))
    for parts in sorted(connected_blocks(stacked).parts, key=lambda parts: parts.columns.shape[1]):
        n = parts.columns.shape[1]
        blocks = entries(stacked, parts)
        own, beside = blocks[:, :n], blocks[:, n:]
        try:
            np.linalg.cholesky(own + beside.transpose(0, 2, 1) @ beside - _SAFE * np.eye(n))
        except np.linalg.LinAlgError:
            return False
    return True


def _of_unit_length(rows: SparseMatrix, scale: Floats) -> SparseMatrix:
    """Columns by their scale (n,), then rows."""
    scaled = rows.with_values(rows.values * scale[rows.columns]).nonzero()
    return scaled.with_values(scaled.values / scaled.lengths()[scaled.rows])


def solved(matrix: SparseMatrix, right: Floats, split: Partition) -> Floats:
    """The least-squares solution of smallest norm, part by part."""
    result = np.zeros(matrix.shape[1])
    for parts in split.parts:
        moving = parts.only(np.any(right[parts.rows] != 0.0, axis=1))
        result[moving.columns] = minimum_norms(entries(matrix, moving), right[moving.rows])
    return result


def free_directions(matrix: SparseMatrix, split: Partition) -> Floats:
    """Orthonormal columns that span the null space, part by part; columns without rows are free."""
    n = matrix.shape[1]
    bound = np.zeros(n, dtype=np.bool_)
    found: list[Floats] = []
    for parts in split.parts:
        for block, columns in zip(entries(matrix, parts), parts.columns, strict=True):
            bound[columns] = True
            inner = null_space(block)
            wide = np.zeros((n, inner.shape[1]))
            wide[columns] = inner
            found.append(wide)
    return np.hstack([np.eye(n)[:, ~bound], *found])
