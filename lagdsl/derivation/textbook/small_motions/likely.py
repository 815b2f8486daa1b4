"""Equilibria that people see at once where equations have no short roots: coordinates at 0, angles at half a turn."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from sympy import Expr, Integer, nan, oo, pi, zoo

from lagdsl.derivation.textbook.small_motions.balance import Balance
from lagdsl.derivation.textbook.small_motions.statics import Place
from lagdsl.language.flat.quantity import is_angle

_MOST_ANGLES = 3
LONGEST_LIKELY = 3000
"""Nodes of an equation of motion that is looked at."""


def likely(balance: Balance, statics: Sequence[Expr]) -> list[Place]:
    """The ones at which the equations hold identically; none under constraints."""
    if balance.rows:
        return []
    coordinates = balance.flat.coordinates
    turns = sum(map(is_angle, coordinates)) <= _MOST_ANGLES
    choices = ((Integer(0), pi) if turns and is_angle(item) else (Integer(0),) for item in coordinates)
    places = (Place(dict(zip(balance.derivation.symbols.q, values, strict=True))) for values in product(*choices))
    return [place for place in places if all(_holds(balance, each, place) for each in statics)]


def _holds(balance: Balance, equation: Expr, place: Place) -> bool:
    value = equation.xreplace(place.at)
    return not value.has(zoo, oo, -oo, nan) and balance.tidy.is_zero(value)
