"""Independent rows of large sparse matrices, shown by elimination: singular values cost the cube of their number.

The pivot of the least product of other entries in its row and its column comes first, of those that are not small in
their row. Source: Duff, Erisman and Reid, *Direct Methods for Sparse Matrices*, 2nd ed., 2017, chapters 5 and 7.
"""

from __future__ import annotations

from heapq import heapify, heappop, heappush

import numpy as np

from lagdsl.foundation.numerics.sparse_matrix import SparseMatrix

# Singular values of fewer rows take no longer.
FEW = 50
# A pivot is no smaller than this part of the largest entry of its row.
_NOT_SMALL = 0.1
# A row, of size one at first, of which less is left may depend on others.
_LEFT = 1e-3
# Entries that elimination may make, by those that there are.
_FILL = 20


def independent(matrix: SparseMatrix) -> bool:
    """True if elimination shows that the rows of (m, n) are independent; False where it does not tell.

    A part of 1e-3 of each row is left by the others, and the fill is bounded.
    """
    m, n = matrix.shape
    sizes = matrix.largest()
    if m > n or not np.all(np.isfinite(sizes)) or not np.all(sizes > 0.0):
        return False
    rows: list[dict[int, float]] = [{} for _ in range(m)]
    columns: list[set[int]] = [set() for _ in range(n)]
    there = matrix.nonzero()
    values = there.values / sizes[there.rows]
    for i, j, value in zip(there.rows.tolist(), there.columns.tolist(), values.tolist(), strict=True):
        rows[i][j] = value
        columns[j].add(i)

    def pivot(i: int) -> tuple[int, int]:
        least = _NOT_SMALL * max(map(abs, rows[i].values()))
        others = len(rows[i]) - 1
        return min((others * (len(columns[j]) - 1), j) for j, value in rows[i].items() if abs(value) >= least)

    effort = _FILL * (m + len(values))
    heap = [(pivot(i)[0], i) for i in range(m)]
    heapify(heap)
    while heap:
        known, i = heappop(heap)
        if max(map(abs, rows[i].values()), default=0.0) < _LEFT:
            return False
        cost, j = pivot(i)
        if cost > known:
            heappush(heap, (cost, i))
            continue
        effort -= cost
        if effort < 0:
            return False
        _eliminate(rows, columns, i, j)
    return True


def _eliminate(rows: list[dict[int, float]], columns: list[set[int]], i: int, j: int) -> None:
    """Take row i, and with it column j, from the others."""
    own = rows[i]
    for k in own:
        columns[k].discard(i)
    factor = own.pop(j)
    for other in sorted(columns[j]):
        row = rows[other]
        share = row.pop(j) / factor
        for k, value in own.items():
            if k not in row:
                columns[k].add(other)
            row[k] = row.get(k, 0.0) - share * value
    columns[j].clear()
