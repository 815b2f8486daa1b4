"""Independent rows of large sparse matrices, shown by elimination: singular values cost the cube of their number.

The pivot of the least product of other entries in its row and its column comes first, of those that are not small in
their row. Source: Duff, Erisman and Reid, *Direct Methods for Sparse Matrices*, 2nd ed., 2017, chapters 5 and 7.
"""

from __future__ import annotations

from collections.abc import Callable
from heapq import heapify, heappop, heappush
from typing import TypeAlias

import numpy as np

from lagdsl.foundation.numerics.sparse_matrix import SparseMatrix

# Entries of a row by column.
_Row: TypeAlias = dict[int, float]
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

    def left(row: _Row, _: _Row) -> _Row:
        return row if max(map(abs, row.values()), default=0.0) >= _LEFT else {}

    return _eliminates(matrix.with_values(matrix.values / sizes[matrix.rows]), left)


def regular(matrix: SparseMatrix) -> bool:
    """True if elimination shows that (n, n) is regular, whatever the sizes of rows and columns; False where it does not
    tell.

    Each pivot is a part of 1e-3, at least, of the largest term in it, and the fill is bounded.
    """

    def left(row: _Row, terms: _Row) -> _Row:
        return {j: value for j, value in row.items() if abs(value) >= _LEFT * terms[j]}

    m, n = matrix.shape
    return m == n and matrix.is_finite() and _eliminates(matrix, left)


def _eliminates(matrix: SparseMatrix, left: Callable[[_Row, _Row], _Row]) -> bool:
    """True if there is a pivot in every row among the entries that are `left`, as told by its values and the largest
    terms in them."""
    m, n = matrix.shape
    rows: list[_Row] = [{} for _ in range(m)]
    columns: list[set[int]] = [set() for _ in range(n)]
    there = matrix.nonzero()
    for i, j, value in zip(there.rows.tolist(), there.columns.tolist(), there.values.tolist(), strict=True):
        rows[i][j] = value
        columns[j].add(i)
    terms = [{j: abs(value) for j, value in row.items()} for row in rows]

    def pivot(i: int) -> tuple[int, int] | None:
        own = left(rows[i], terms[i])
        least = _NOT_SMALL * max(map(abs, own.values()), default=0.0)
        others = len(rows[i]) - 1
        costs = ((others * (len(columns[j]) - 1), j) for j, value in own.items() if abs(value) >= least)
        return min(costs, default=None)

    effort = _FILL * (m + len(there.values))
    first = [pivot(i) for i in range(m)]
    if None in first:
        return False
    heap = [(found[0], i) for i, found in enumerate(first) if found is not None]
    heapify(heap)
    while heap:
        known, i = heappop(heap)
        found = pivot(i)
        if found is None:
            return False
        cost, j = found
        if cost > known:
            heappush(heap, (cost, i))
            continue
        effort -= cost
        if effort < 0:
            return False
        _eliminate(rows, terms, columns, i, j)
    return True


def _eliminate(rows: list[_Row], terms: list[_Row], columns: list[set[int]], i: int, j: int) -> None:
    """Take row i, and with it column j, from the others."""
    own = rows[i]
    for k in own:
        columns[k].discard(i)
    factor = own.pop(j)
    for other in sorted(columns[j]):
        row, largest = rows[other], terms[other]
        share = row.pop(j) / factor
        for k, value in own.items():
            term = share * value
            if k not in row:
                columns[k].add(other)
            row[k] = row.get(k, 0.0) - term
            largest[k] = max(largest.get(k, 0.0), abs(term))
    columns[j].clear()
