"""Linear problems whose independent parts are solved each for itself."""

from __future__ import annotations

import numpy as np

from lagdsl.foundation.numerics.connected_blocks import Partition, connected_blocks, entries
from lagdsl.foundation.numerics.rank import Floats, minimum_norms, null_space
from lagdsl.foundation.numerics.sparse_matrix import SparseMatrix

# Eigenvalues, of a matrix with a unit diagonal, that are surely not zero.
_SAFE = 1e-6


def is_positive_definite(matrix: SparseMatrix) -> bool:
    """True if no eigenvalue of a symmetric matrix (n, n), scaled to a unit diagonal, is below 1e-6."""
    diagonal = matrix.diagonal()
    if not np.all(diagonal > 0.0):
        return False
    scale = 1.0 / np.sqrt(diagonal)
    scaled = matrix.with_values(matrix.values * scale[matrix.rows] * scale[matrix.columns]).nonzero()
    for parts in connected_blocks(scaled).parts:
        try:
            np.linalg.cholesky(entries(scaled, parts) - _SAFE * np.eye(parts.rows.shape[1]))
        except np.linalg.LinAlgError:
            return False
    return True


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
