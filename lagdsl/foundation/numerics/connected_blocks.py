"""Independent parts of a system of equations: rows and columns that share no entry fall apart.

A machine with a hundred loops has a hundred small problems, not one large one. All parts are worked on in lockstep,
parts of one shape stacked, so that a function is evaluated once for all of them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

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


def connected_blocks(pattern: Flags) -> Partition:
    """The finest partition of rows and columns for which entries outside of `pattern` (m, n) are zero."""
    m, n = pattern.shape
    rows, columns = np.nonzero(pattern)
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


def entries(matrix: Floats, parts: Parts) -> Floats:
    """The blocks (k, r, c) of a matrix."""
    return np.asarray(matrix[parts.rows[:, :, None], parts.columns[:, None, :]])


def _norms(labels: Indices, values: Floats, count: int) -> Floats:
    sums = np.bincount(labels, weights=values * values, minlength=count)
    return np.asarray(np.where(np.isfinite(sums), np.sqrt(sums), np.inf))
