"""Scalar expressions put together, zeros and ones left out."""

from __future__ import annotations

from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression


def negative(a: FlatExpression) -> FlatExpression:
    if isinstance(a, flat.Number):
        return flat.Number(0.0 - a.value)
    if isinstance(a, flat.Unary) and a.operator == "-":
        return a.operand
    return flat.Unary("-", a)


def plus(a: FlatExpression, b: FlatExpression) -> FlatExpression:
    if a == flat.ZERO:
        return b
    return a if b == flat.ZERO else flat.Binary("+", a, b)


def minus(a: FlatExpression, b: FlatExpression) -> FlatExpression:
    if b == flat.ZERO:
        return a
    return negative(b) if a == flat.ZERO else flat.Binary("-", a, b)


def times(a: FlatExpression, b: FlatExpression) -> FlatExpression:
    if flat.ZERO in (a, b):
        return flat.ZERO
    if a == flat.ONE:
        return b
    if a == flat.Number(-1.0):
        return negative(b)
    return a if b == flat.ONE else flat.Binary("*", a, b)


def over(a: FlatExpression, b: FlatExpression) -> FlatExpression:
    if a == flat.ZERO or b == flat.ONE:
        return a
    return negative(a) if b == flat.Number(-1.0) else flat.Binary("/", a, b)


def total(terms: list[FlatExpression]) -> FlatExpression:
    result: FlatExpression = flat.ZERO
    for term in terms:
        result = plus(result, term)
    return result
