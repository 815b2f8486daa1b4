"""Matrices of which few entries are not zero: J of a mechanism with many parts has a few entries in each row.

`scipy.sparse` has all of this, but takes as long to import as NumPy itself, and `lag check` needs no other part of
SciPy.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lagdsl.foundation.record import record

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]


@record()
class SparseMatrix:
    """`values` (k,) stand at `rows` (k,) and `columns` (k,) of a matrix of this shape (m, n); others are zero."""

    shape: tuple[int, int]
    rows: Indices
    columns: Indices
    values: Floats

    def __len__(self) -> int:
        return self.shape[0]

    def dense(self) -> Floats:
        """All entries (m, n)."""
        whole = np.zeros(self.shape)
        whole[self.rows, self.columns] = self.values
        return whole

    def with_values(self, values: Floats) -> SparseMatrix:
        """Other values (k,) at the same places."""
        return SparseMatrix(self.shape, self.rows, self.columns, values)

    def only(self, kept: Flags) -> SparseMatrix:
        """The entries that are flagged (k,)."""
        return SparseMatrix(self.shape, self.rows[kept], self.columns[kept], self.values[kept])

    def nonzero(self) -> SparseMatrix:
        """Without entries that are zero."""
        return self.only(self.values != 0.0)

    def taken(self, rows: Indices | list[int], columns: Indices | list[int] | None = None) -> SparseMatrix:
        """These rows and columns (default: all) in this order, none of them twice."""
        row, column = _numbers(rows, self.shape[0]), _numbers(columns, self.shape[1])
        kept = (row[self.rows] >= 0) & (column[self.columns] >= 0)
        count = self.shape[1] if columns is None else len(columns)
        return SparseMatrix((len(rows), count), row[self.rows[kept]], column[self.columns[kept]], self.values[kept])

    def transposed(self) -> SparseMatrix:
        """The same with rows and columns exchanged."""
        return SparseMatrix((self.shape[1], self.shape[0]), self.columns, self.rows, self.values)

    def row(self, index: int) -> Floats:
        """One row (n,)."""
        own = self.rows == index
        whole = np.zeros(self.shape[1])
        whole[self.columns[own]] = self.values[own]
        return whole

    def diagonal(self) -> Floats:
        """Entries of the diagonal of a square matrix."""
        own = self.rows == self.columns
        found = np.zeros(self.shape[0])
        found[self.rows[own]] = self.values[own]
        return found

    def counts(self) -> Indices:
        """Numbers of entries of the rows (m,)."""
        return np.bincount(self.rows, minlength=self.shape[0])

    def largest(self) -> Floats:
        """The largest size of an entry in each row (m,)."""
        found = np.zeros(self.shape[0])
        np.maximum.at(found, self.rows, np.abs(self.values))
        return found

    def lengths(self) -> Floats:
        """Euclidean norms of the rows (m,)."""
        return np.sqrt(np.bincount(self.rows, weights=self.values**2, minlength=self.shape[0]))

    def is_finite(self) -> bool:
        """True if all entries are numbers."""
        return bool(np.all(np.isfinite(self.values)))

    def __matmul__(self, x: Floats) -> Floats:
        """Products (m,) with a vector (n,), or (m, k) with the columns of a matrix (n, k)."""
        if x.ndim == 1:
            return np.asarray(
                np.bincount(self.rows, weights=self.values * x[self.columns], minlength=self.shape[0]), dtype=np.float64
            )
        return np.stack([self @ column for column in x.T], axis=1) if x.shape[1] else np.zeros((self.shape[0], 0))


def sparse(matrix: Floats | Flags) -> SparseMatrix:
    """The entries of (m, n) that are not zero."""
    rows, columns = np.nonzero(matrix)
    m, n = matrix.shape
    return SparseMatrix((m, n), rows, columns, np.asarray(matrix[rows, columns], dtype=np.float64))


def sparse_at(places: Indices, shape: tuple[int, ...], values: Floats) -> SparseMatrix:
    """`values` (k,) at `places` (k,) in the order of rows."""
    m, n = shape
    rows, columns = np.divmod(places, max(n, 1))
    return SparseMatrix((m, n), rows, columns, values)


def stack(upper: SparseMatrix, lower: SparseMatrix) -> SparseMatrix:
    """The rows of both, (m, n) above (k, n)."""
    (m, n), k = upper.shape, len(lower)
    rows, columns = np.concatenate([upper.rows, m + lower.rows]), np.concatenate([upper.columns, lower.columns])
    return SparseMatrix((m + k, n), rows, columns, np.concatenate([upper.values, lower.values]))


def beside(matrices: Sequence[SparseMatrix]) -> SparseMatrix:
    """The columns of all, (m, n) and (m, k) and so on, in this order."""
    first = np.cumsum([0, *(matrix.shape[1] for matrix in matrices)])
    return SparseMatrix(
        (len(matrices[0]), int(first[-1])),
        np.concatenate([matrix.rows for matrix in matrices]),
        np.concatenate([matrix.columns + own for matrix, own in zip(matrices, first[:-1], strict=True)]),
        np.concatenate([matrix.values for matrix in matrices]),
    )


def product(left: SparseMatrix, right: SparseMatrix) -> SparseMatrix:
    """(m, n) times (n, k): of each entry of `left` as many terms as its row of `right` has."""
    m, k = len(left), right.shape[1]
    order = np.argsort(right.rows, kind="stable")
    counts = right.counts()
    terms = counts[left.columns]
    begin = (np.cumsum(counts) - counts)[left.columns] - (np.cumsum(terms) - terms)
    own = order[np.repeat(begin, terms) + np.arange(np.sum(terms))]
    places = np.repeat(left.rows, terms) * k + right.columns[own]
    values = np.repeat(left.values, terms) * right.values[own]
    there, number = np.unique(places, return_inverse=True)
    sums = np.zeros(len(there))
    np.add.at(sums, number.ravel(), values)
    return sparse_at(there, (m, k), sums)


def _numbers(chosen: Indices | list[int] | None, count: int) -> Indices:
    """For each of `count` its number among the chosen, -1 if it is none of them."""
    if chosen is None:
        return np.arange(count)
    numbers = np.full(count, -1, dtype=np.intp)
    numbers[np.asarray(chosen, dtype=np.intp)] = np.arange(len(chosen))
    return numbers
