"""Powers: what an exponent makes of a dimension."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as flat
from lagdsl.language.semantics.scope.constants import evaluate
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of, quantity
from lagdsl.language.semantics.scope.values import (
    POISON,
    Array,
    Numeric,
    Scalar,
    Value,
    Vector,
    highest,
    is_structural,
    latest,
)
from lagdsl.language.semantics.types.dimensions import fits
from lagdsl.language.syntax import nodes


def power(ctx: Context, node: nodes.Binary, base: Numeric, exponent: Numeric) -> Value:
    """`x^r`; a base with a dimension needs a literal rational exponent."""
    if not isinstance(base, Scalar) or not isinstance(exponent, Scalar):
        which, value = (node.left, base) if not isinstance(base, Scalar) else (node.right, exponent)
        hint = "for the square of a length write `v*v`" if isinstance(value, Vector | Array) else None
        ctx.sink.report("E0312", which.span, expected="a scalar", found=kind_of(value), help=hint)
        return POISON
    if not fits(exponent.dimension, DIMENSIONLESS):
        ctx.sink.report("E0408", node.right.span, found=quantity(exponent.dimension))
        return POISON
    variability, order = latest(base, exponent), highest(base, exponent)
    dimension = base.dimension
    if dimension is not None and not dimension.is_dimensionless:
        ratio = _rational(node.right, exponent)
        if ratio is None:
            ctx.sink.report("E0414", node.right.span, found=quantity(dimension))
            return POISON
        dimension = dimension**ratio
    if isinstance(base.expression, flat.Norm) and exponent.expression == flat.Number(2.0):
        vector = base.expression.vector
        return Scalar(flat.Dot(vector, vector), dimension, variability, order)
    return Scalar(flat.Binary("^", base.expression, exponent.expression), dimension, variability, order)


@cache
def _literal(text: str) -> Fraction:
    return Fraction(text)


def _rational(node: nodes.Node, value: Scalar) -> Fraction | None:
    """The exponent as an exact ratio: a literal, a ratio of literals, or a structural Integer."""
    if isinstance(node, nodes.Number) and len(node.text) < 30:
        ratio = _literal(node.text)
        return ratio if abs(ratio) <= 1000 and ratio.denominator <= 10**6 else None
    if isinstance(node, nodes.Parenthesized):
        return _rational(node.inner, value)
    if isinstance(node, nodes.Unary):
        unsigned = _rational(node.operand, value)
        return -unsigned if unsigned is not None and node.operator == "-" else unsigned
    if isinstance(node, nodes.Binary) and node.operator == "/":
        top, bottom = _rational(node.left, value), _rational(node.right, value)
        return top / bottom if top is not None and bottom else None
    if is_structural(value) and value.kind == "Integer":
        return Fraction(evaluate(value.expression))
    return None
