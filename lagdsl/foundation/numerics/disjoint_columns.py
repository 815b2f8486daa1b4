"""Columns of a sparse matrix in groups that share no row: one product with a vector shows a group of columns.

Source: Curtis, Powell and Reid, On the estimation of sparse Jacobian matrices, J. Inst. Maths Applics 13 (1974) 117.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from lagdsl.foundation.numerics.connected_blocks import Indices


def disjoint_columns(rows: Indices, columns: Indices, shape: tuple[int, int]) -> Indices:
    """The number of the group of each column (n,) of a matrix (m, n) with these entries: the first one that is free."""
    m, n = shape
    widest = int(np.max(np.bincount(rows, minlength=m), initial=0))
    if 2 * widest > n:  # there are as many groups at least
        return np.arange(n)
    order = np.argsort(columns, kind="stable")
    starts = np.searchsorted(columns[order], np.arange(n + 1)).tolist()
    of_columns = rows[order].tolist()
    taken = [0] * m  # groups by row, as bits
    groups = []
    for start, end in pairwise(starts):
        own = of_columns[start:end]
        met = 0
        for row in own:
            met |= taken[row]
        free = ~met & met + 1  # the lowest bit that is not set
        groups.append(free.bit_length() - 1)
        for row in own:
            taken[row] |= free
    return np.array(groups, dtype=np.intp)
