"""Independent parts of a system of equations: rows and columns that share no entry fall apart.

A machine with a hundred loops has a hundred small problems, not one large one. All parts are worked on in lockstep,
parts of one shape stacked, so that a function is evaluated once for all of them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from lagdsl.foundation.numerics.sparse_matrix import SparseMatrix
from lagdsl.foundation.record import record

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]


@record()
class Parts:
    """Parts of one shape: `labels` (k,), their `rows` (k, r) and `columns` (k, c)."""

    labels: Indices
    rows: Indices
    columns: Indices

    def only(self, chosen: Flags) -> Parts:
        """Flagged ones (k,)."""
        return Parts(self.labels[chosen], self.rows[chosen], self.columns[chosen])


@record()
class Partition:
    """Label of the part of each row (m,) and column (n,); `parts` by shape: those with rows and columns both."""

    row_labels: Indices
    column_labels: Indices
    count: int
    parts: tuple[Parts, ...]

    def sizes(self, residual: Floats) -> Floats:
        """Euclidean norm of the residuals of each part; infinite where one is no number."""
        return _norms(self.row_labels, residual, self.count)

    def distances(self, point: Floats) -> Floats:
        """Euclidean norm of the coordinates of each part."""
        return _norms(self.column_labels, point, self.count)

    def mixed(self, chosen: Flags, point: Floats, other: Floats) -> Floats:
        """`point` in the chosen parts, `other` in the rest."""
        return np.where(chosen[self.column_labels], point, other)


def connected_blocks(pattern: SparseMatrix) -> Partition:
    """The finest partition of rows and columns for which entries that are not among those of `pattern` are zero."""
    (m, n), rows, columns = pattern.shape, pattern.rows, pattern.columns
    first = np.arange(m + n)  # a row or column of the same part that comes before, in the end the first
    while True:
        one, other = first[rows], first[m + columns]
        if np.array_equal(one, other):
            break
        np.minimum.at(first, np.maximum(one, other), np.minimum(one, other))
        while not np.array_equal(first, first[first]):
            first = first[first]
    names, labels = np.unique(first, return_inverse=True)
    return labelled(labels[:m], labels[m:], len(names))


def labelled(row_labels: Indices, column_labels: Indices, count: int) -> Partition:
    """The partition with these labels, 0 to count - 1."""
    rows: list[list[int]] = [[] for _ in range(count)]
    columns: list[list[int]] = [[] for _ in range(count)]
    for index, label in enumerate(row_labels.tolist()):
        rows[label].append(index)
    for index, label in enumerate(column_labels.tolist()):
        columns[label].append(index)
    shapes: dict[tuple[int, int], list[int]] = {}
    for label in range(count):
        if rows[label] and columns[label]:
            shapes.setdefault((len(rows[label]), len(columns[label])), []).append(label)
    parts = tuple(
        Parts(
            np.array(members, dtype=np.intp),
            np.array([rows[label] for label in members], dtype=np.intp),
            np.array([columns[label] for label in members], dtype=np.intp),
        )
        for members in shapes.values()
    )
    return Partition(row_labels, column_labels, count, parts)


def whole(m: int, n: int) -> Partition:
    """One part of everything."""
    return labelled(np.zeros(m, dtype=np.intp), np.zeros(n, dtype=np.intp), 1)


def entries(matrix: Floats | SparseMatrix, parts: Parts) -> Floats:
    """The blocks (k, r, c) of a matrix."""
    if not isinstance(matrix, SparseMatrix):
        return np.asarray(matrix[parts.rows[:, :, None], parts.columns[:, None, :]])
    (count, r), c = parts.rows.shape, parts.columns.shape[1]
    row_block, row = _places(parts.rows, matrix.shape[0])
    column_block, column = _places(parts.columns, matrix.shape[1])
    block = row_block[matrix.rows]
    own = (block >= 0) & (block == column_block[matrix.columns])
    found = np.zeros((count, r, c))
    found[block[own], row[matrix.rows[own]], column[matrix.columns[own]]] = matrix.values[own]
    return found


def _places(members: Indices, count: int) -> tuple[Indices, Indices]:
    """For each of `count` the number of its part, -1 if it is in none of them, and its place there."""
    block, place = np.full(count, -1, dtype=np.intp), np.zeros(count, dtype=np.intp)
    block[members] = np.arange(len(members))[:, None]
    place[members] = np.arange(members.shape[1])
    return block, place


def _norms(labels: Indices, values: Floats, count: int) -> Floats:
    sums = np.bincount(labels, weights=values * values, minlength=count)
    return np.asarray(np.where(np.isfinite(sums), np.sqrt(sums), np.inf))
