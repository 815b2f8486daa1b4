"""Linear algebra of the search: combinations that vanish on all rows, in echelon form, with coefficients as people
write them."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from lagdsl.foundation.numerics.rank import Floats

# Above the rounding of solved accelerations, far below what a term that does not cancel leaves.
ZERO = 1e-9
_NULL = 1e-7
_PIVOT = 1e-6
_LARGEST_DENOMINATOR = 64
_NEAR = 1e-7


def cancelling(changes: Floats, sizes: Floats) -> Floats:
    """Rows of coefficients c (d, n) with changes @ c = 0, in reduced echelon form, each beginning with 1.

    Columns and rows are scaled by the size of their terms, so that units do not count.
    """
    column = _or_one(np.max(sizes, axis=0, initial=0.0))
    row = _or_one(np.max(sizes / column, axis=1, initial=0.0))
    _, lengths, axes = np.linalg.svd(changes / column / row[:, None], full_matrices=True)
    rank = int(np.count_nonzero(lengths > _NULL * np.sqrt(len(changes))))
    found = _echelon(axes[rank:]) / column
    return np.array([each / each[np.flatnonzero(each)[0]] for each in found]).reshape(-1, changes.shape[1])


def remainder(coefficients: Floats, changes: Floats, sizes: Floats) -> float:
    """The largest change of a combination, as a part of its terms. Coefficients (n,), or (rows, n) where they depend
    on parameters."""
    total = np.abs(np.sum(coefficients * changes, axis=1))
    size = np.sum(np.abs(coefficients) * sizes, axis=1)
    return float(np.max(total / _or_one(size), initial=0.0))


def is_new(values: Floats, size: float, known: list[Floats]) -> bool:
    """Is a column of values, sums of terms of a `size`, no combination of known ones and a constant?"""
    basis = np.stack([np.ones(len(values)), *known], axis=1)
    basis = basis / _or_one(np.max(np.abs(basis), axis=0))
    if not (np.isfinite(values).all() and size > 0.0):
        return False
    best = np.linalg.lstsq(basis, values / size, rcond=1e-10)[0]
    return bool(np.max(np.abs(basis @ best - values / size)) > _NEAR)


def fraction(value: float) -> Fraction | None:
    """The simple fraction that a number is, to its error."""
    near = Fraction(value).limit_denominator(_LARGEST_DENOMINATOR)
    return near if near != 0 and abs(float(near) - value) <= _NEAR * abs(value) else None


def _echelon(rows: Floats) -> Floats:
    """Gauss and Jordan with the largest pivot of a column; what cancels is zero."""
    rows = np.array(rows)
    done = 0
    for column in range(rows.shape[1]):
        if done == len(rows):
            break
        best = done + int(np.argmax(np.abs(rows[done:, column])))
        if abs(rows[best, column]) <= _PIVOT:
            continue
        rows[[done, best]] = rows[[best, done]]
        rows[done] /= rows[done, column]
        others = np.arange(len(rows)) != done
        rows[others] -= np.outer(rows[others, column], rows[done])
        done += 1
    rows[np.abs(rows) <= _PIVOT] = 0.0
    return rows[:done]


def _or_one(sizes: Floats) -> Floats:
    """Sizes to divide by: 1 where there is nothing."""
    return np.asarray(np.where(sizes > 0.0, sizes, 1.0))
