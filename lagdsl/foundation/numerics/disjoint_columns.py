"""Columns of a sparse matrix in groups that share no row: one product with a vector shows a group of columns.

Source: Curtis, Powell and Reid, On the estimation of sparse Jacobian matrices, J. Inst. Maths Applics 13 (1974) 117.
"""

from __future__ import annotations

import numpy as np

from lagdsl.foundation.numerics.connected_blocks import Indices


def disjoint_columns(rows: Indices, columns: Indices, shape: tuple[int, int]) -> Indices:
    """The number of the group of each column (n,) of a matrix (m, n) with these entries: the first one that is free."""
    m, n = shape
    widest = int(np.max(np.bincount(rows, minlength=m), initial=0))
    if 2 * widest > n:  # there are as many groups at least
        return np.arange(n)
    order = np.argsort(columns, kind="stable")
    starts = np.searchsorted(columns[order], np.arange(n + 1))
    taken = np.zeros((m, 2 * widest + 1), dtype=np.bool_)  # by row; it grows
    groups = np.zeros(n, dtype=np.intp)
    for column in range(n):
        own = rows[order[starts[column] : starts[column + 1]]]
        free = np.flatnonzero(~np.any(taken[own], axis=0))
        if not len(free):
            free = np.array([taken.shape[1]])
            taken = np.concatenate([taken, np.zeros_like(taken)], axis=1)
        groups[column] = free[0]
        taken[own, free[0]] = True
    return groups
