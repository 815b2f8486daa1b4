"""Functions that are given piece by piece: balanced trees of conditionals."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression


def chosen(x: FlatExpression, borders: Sequence[float], pieces: Sequence[FlatExpression]) -> FlatExpression:
    """`pieces[k]` below `borders[k]`, the last one beyond them all."""
    if not borders:
        return pieces[0]
    middle = len(borders) // 2
    below = chosen(x, borders[:middle], pieces[: middle + 1])
    above = chosen(x, borders[middle + 1 :], pieces[middle + 1 :])
    return flat.Conditional(flat.Binary("<", x, flat.Number(borders[middle])), below, above)


def chosen_by_number(number: FlatExpression, pieces: Sequence[FlatExpression]) -> FlatExpression:
    """`pieces[number]`."""
    return chosen(number, [k - 0.5 for k in range(1, len(pieces))], pieces)
