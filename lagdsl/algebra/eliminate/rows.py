"""Constraints in an elimination: rows sum_j terms_j qdd_j = bias, whose multiplier acts along `terms`.

The matrix of accelerations and multipliers together is [W, -J'; -J, 0], symmetric. A multiplier gets its pivot
-J W^-1 J' from the rates that its row uses, so that it is eliminated after the last of them. Then pivots of rates are
positive and those of multipliers negative in any order (Vanderbei, *SIAM J. Optim.* 5 (1995), 100).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field

from lagdsl.foundation.numerics.disjoint_sets import DisjointSets
from lagdsl.foundation.record import record


@record(kw_only=True)
class Row:
    """`index` among all rows; `terms` by rate, without those that are identically zero; nodes."""

    index: int
    terms: dict[int, int]
    bias: int


@record(kw_only=True)
class Rows:
    """The rows of a model by what becomes of them; rows without terms, whose multipliers are zero, are none of these.

    Multipliers of `solved` rows are eliminated, those of `kept` ones are left to run time. `following` rows depend on
    solved ones: they do not restrict accelerations, and all multipliers together are the shortest that do the same.
    `stiffened`: the inertia along a row, a node by its index, that M is given where it is singular by itself; as the
    accelerations along the row are known, M a = f then holds with J' inertia bias added on the right.
    """

    solved: tuple[Row, ...] = ()
    following: tuple[Row, ...] = ()
    kept: tuple[Row, ...] = ()
    stiffened: Mapping[int, int] = field(default_factory=dict)


@record(kw_only=True)
class Side:
    """A right-hand side: forces by velocity, accelerations along rows by index; nodes."""

    forces: Mapping[int, int] = field(default_factory=dict)
    biases: Mapping[int, int] = field(default_factory=dict)


def multiplier_of(row: int) -> int:
    """The variable that stands for the multiplier of a row; nodes have other numbers."""
    return -1 - 2 * row


def row_of(multiplier: int) -> int:
    """The index of the row of a multiplier."""
    return (-1 - multiplier) // 2


def velocity_of(row: int) -> int:
    """The variable that stands for J qd of a row; nodes have other numbers."""
    return -2 - 2 * row


def is_multiplier(variable: int) -> bool:
    return variable < 0 and variable % 2 == 1


def components(rows: Sequence[Row]) -> list[list[Row]]:
    """Rows that share rates, directly or through others."""
    rates = DisjointSets(rate for row in rows for rate in row.terms)
    for row in rows:
        first, *others = row.terms
        for rate in others:
            rates.join(first, rate)
    found: dict[int, list[Row]] = {}
    for row in rows:
        found.setdefault(rates.first(next(iter(row.terms))), []).append(row)
    return list(found.values())
