"""Sizes of the rows of constraints: as large as their derivatives usually come out.

Ranks are found by comparing rows. So a row that is far smaller than those beside it, as a current by farads may be
beside lengths, is multiplied by a power of two. The motion stays the same, and its multiplier in the text as well.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np

from lagdsl.foundation.numerics.connected_blocks import Flags, Indices
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.numerics.sparse_matrix import SparseMatrix
from lagdsl.foundation.record import record

# J (nc, nq) at one point, with relative errors of this size in the coordinates and the parameters. Its entries stand at
# the same places at all points.
Look: TypeAlias = Callable[[float], SparseMatrix]

# A row that is smaller, as a part of the largest one beside it, may be round-off.
_ROUNDING = 1e-12
# Errors of the numbers that enter, and the part by which round-off changes with them.
_ERROR = 2.0**-50
_CHANGED = 1e-3
# A row that is shorter than this part of the longest one beside it is multiplied.
_FAR = 1e-4
# The largest power of two, with room for products: all normal numbers come near the others by it.
_MOST = 1000
# An entry of J that is smaller, as a part of its row, at every point looked at is none.
_ABSENT = 1e-13


@record()
class RowSizes:
    """`natural` (nc,) are sizes in natural sizes of the coordinates: for rows that are zero but for round-off that of
    the largest row beside them, for rows that are zero 1. `factors` (nc,) make rows of J as long as the longest beside
    them where they are far shorter, and are 1 elsewhere; `plain` rows are not compared, but become as long as the
    others where they are far from that. `pattern` (nc, nq) has a one where an entry is not zero
    everywhere."""

    natural: Floats
    factors: Floats
    pattern: SparseMatrix


def row_sizes(
    usual: Sequence[Look], others: Sequence[Look], sizes: Floats, components: Indices, plain: Flags
) -> RowSizes:
    """Medians over the `usual` points, and for rows that are zero there over the `others`. `sizes` (nq,) and
    `components` are those of the coordinates; `plain` (nc,) are rows without a multiplier, whose size means nothing."""
    measured = _measured((*usual, *others), 0.0, sizes)
    natural, lengths = _usual(measured.natural, len(usual)), _usual(measured.lengths, len(usual))
    beside = _largest_beside(natural, measured.largest, components)
    noise = np.zeros(len(natural), dtype=np.bool_)
    in_doubt = (natural > 0.0) & (natural <= _ROUNDING * beside)
    if in_doubt.any():
        changes = _measured((*usual, *others), _ERROR, sizes)
        noise = in_doubt & (_usual(changes.lengths, len(usual)) > _CHANGED * lengths)
    absent = np.maximum(_ABSENT * natural, np.where(noise, _ROUNDING * beside, 0.0))
    factors = _factors(np.where(noise, 0.0, lengths), measured.largest, components, plain)
    size = np.where(noise, beside, np.where(natural > 0.0, natural, 1.0))
    there = measured.largest.only(measured.largest.values > absent[measured.largest.rows])
    return RowSizes(size, factors, there.with_values(np.ones(len(there.values))))


@record()
class Measured:
    """Of the rows of J at k points: lengths in natural sizes of the coordinates and as they are (k, nc), the largest
    size of each entry (nc, nq)."""

    natural: Floats
    lengths: Floats
    largest: SparseMatrix


def _measured(looks: Sequence[Look], error: float, sizes: Floats) -> Measured:
    """J at each point, or how it changes there with an error of the numbers that enter."""
    natural, lengths, largest = [], [], list[Floats]()
    for look in looks:
        matrix = look(0.0)
        values = look(error).values - matrix.values if error else matrix.values
        there = matrix.with_values(np.abs(values)).nonzero()
        scaled = there.values * sizes[there.columns]
        natural.append(_roots_of_squares(there.rows, scaled, len(matrix)))
        lengths.append(_lengths(there.rows, there.values, len(matrix)))
        seen = np.abs(values) * sizes[matrix.columns]
        largest.append(np.where(np.isfinite(seen), seen, np.inf))
    return Measured(np.array(natural), np.array(lengths), matrix.with_values(np.max(largest, axis=0)))


def _roots_of_squares(rows: Indices, entries: Floats, count: int) -> Floats:
    """Lengths (count,) of the rows in which these entries stand."""
    with np.errstate(over="ignore"):
        return np.sqrt(np.bincount(rows, weights=entries * entries, minlength=count))


def _lengths(rows: Indices, entries: Floats, count: int) -> Floats:
    """The same of rows whose squares may be no numbers any more."""
    largest = np.zeros(count)
    np.maximum.at(largest, rows, entries)
    unit = np.where((largest > 0.0) & np.isfinite(largest), largest, 1.0)
    return np.asarray(unit * _roots_of_squares(rows, entries / unit[rows], count))


def _factors(lengths: Floats, largest: SparseMatrix, components: Indices, plain: Flags) -> Floats:
    """Powers of two, which round nothing."""
    beside = _largest_beside(np.where(plain, 0.0, lengths), largest, components)
    far = (lengths > 0.0) & (lengths < _FAR * beside) & np.isfinite(beside)
    far |= plain & np.isfinite(lengths) & (beside > 0.0) & (lengths > beside / _FAR)
    power = np.round(np.log2(np.where(far, beside, 1.0)) - np.log2(np.where(far, lengths, 1.0)))
    return np.where(far, 2.0 ** np.minimum(power, _MOST), 1.0)


def _largest_beside(row_sizes: Floats, entries: SparseMatrix, components: Indices) -> Floats:
    """The largest size (nc,) of a row in the component of each row, which is that of its largest entry in `entries`
    (nc, nq)."""
    if not len(row_sizes) or not entries.shape[1]:
        return np.zeros(len(row_sizes))
    own = components[_first_largest(entries)]
    most = np.zeros(int(np.max(own)) + 1)
    np.maximum.at(most, own, row_sizes)
    return np.asarray(most[own])


def _first_largest(matrix: SparseMatrix) -> Indices:
    """The column of the largest entry of each row (m,), the first of several; 0 of a row without entries."""
    found = np.zeros(len(matrix), dtype=np.intp)
    order = np.lexsort((matrix.columns, -matrix.values, matrix.rows))
    rows, first = np.unique(matrix.rows[order], return_index=True)
    found[rows] = matrix.columns[order[first]]
    return found


def _usual(lengths: Floats, count: int) -> Floats:
    """The median (nc,) of the lengths (k, nc) of each row over the first `count` points, of those at which it does not
    vanish; the lower one of two in the middle. Where it vanishes at all of them, over the others."""
    first, rest = _median(lengths[:count]), _median(lengths[count:])
    return np.where(first > 0.0, first, rest)


def _median(lengths: Floats) -> Floats:
    """Not the largest: rows that turn tan(a/2) to zero are as long as one likes where a is near half a turn."""
    usual = np.zeros(lengths.shape[-1])
    for row, found in enumerate(lengths.T):
        counted = np.sort(found[np.isfinite(found) & (found > 0.0)])
        if len(counted):
            usual[row] = counted[(len(counted) - 1) // 2]
    return usual
