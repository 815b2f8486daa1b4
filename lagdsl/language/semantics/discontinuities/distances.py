"""Distances that pass zero where a function jumps or bends."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.semantics.operators.pieces import chosen
from lagdsl.language.semantics.scope.product import Met


def distances(met: Met) -> list[FlatExpression]:
    """Of a discontinuity that is taken as it stands."""
    if met.pieces is not None:
        return at_borders(met.pieces.x, met.pieces.borders)
    expression = met.expression
    if isinstance(expression, fx.Binary):
        return [fx.Binary("-", expression.left, expression.right)]
    assert isinstance(expression, fx.Function)
    x, other = expression.arguments[0], expression.arguments[-1]
    match expression.name:
        case "min" | "max":
            return [fx.Binary("-", x, other)]
        case "mod":
            return [at_whole_numbers(fx.Binary("/", x, other))]
        case "floor" | "ceil":
            return [at_whole_numbers(x)]
        case "abs" | "sign" | "atan2":
            return [x]
        case _:
            raise AssertionError(f"{expression.name} is no discontinuity")


def at_whole_numbers(x: FlatExpression) -> FlatExpression:
    """A distance that passes zero where x is a whole number: parabolas in turn above and below, with slopes of 1 there.
    Zero is met exactly."""
    below = fx.Function("floor", (x,))
    beyond = fx.Binary("-", x, below)
    arc = fx.Binary("*", beyond, fx.Binary("-", fx.ONE, beyond))
    odd = fx.Function("mod", (below, fx.Number(2.0)))
    return fx.Binary("*", fx.Binary("-", fx.ONE, fx.Binary("*", fx.Number(2.0), odd)), arc)


def at_borders(x: FlatExpression, borders: Sequence[float]) -> list[FlatExpression]:
    """The same for given numbers, by several distances: their signs are the bits of a Gray code of the interval, so
    that no two intervals have the same signs. A step over a narrow one shows."""
    count = len(borders)
    return [_alternating(x, borders[(1 << k) - 1 :: 2 << k]) for k in range(count.bit_length())]


def _alternating(x: FlatExpression, borders: Sequence[float]) -> FlatExpression:
    """Parabolas between the borders, in turn above and below zero, with slopes of 1 there; straight outside."""
    pieces: list[FlatExpression] = [fx.Binary("-", fx.Number(borders[0]), x)]
    for k, (a, b) in enumerate(pairwise(borders)):
        sides = fx.Binary("-", x, fx.Number(a)), fx.Binary("-", x, fx.Number(b))
        arc = fx.Binary("*", fx.Binary("*", fx.Number((-1) ** k / (b - a)), sides[0]), sides[1])
        pieces.append(arc)
    sign = fx.Number((-1.0) ** len(borders))
    pieces.append(fx.Binary("*", sign, fx.Binary("-", x, fx.Number(borders[-1]))))
    return chosen(x, borders, pieces)
