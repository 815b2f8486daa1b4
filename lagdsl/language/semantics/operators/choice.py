"""`if condition then value else otherwise`, as an expression."""

from __future__ import annotations

from lagdsl.language.flat import expression as flat
from lagdsl.language.semantics.operators.arithmetic import Operand, aligned, joint_kind
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import an, kind_of
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import (
    NUMERIC,
    POISON,
    Array,
    Poison,
    Scalar,
    Value,
    Vector,
    highest,
    latest,
)
from lagdsl.language.semantics.types.dimensions import fits, joined, report_unequal
from lagdsl.language.syntax import nodes


def choice(
    ctx: Context, scope: Scope, condition: Scalar, value: Operand, otherwise: Operand, node: nodes.Node
) -> Value:
    """`if condition then value else otherwise`, branches of one shape and dimension."""
    if isinstance(value.value, Poison) or isinstance(otherwise.value, Poison):
        return POISON
    kinds = [getattr(operand.value, "kind", "Real") for operand in (value, otherwise)]
    if kinds[0] != kinds[1] and not (kinds[0] in NUMERIC and kinds[1] in NUMERIC):
        named, other = (otherwise, value) if kinds[0] in NUMERIC else (value, otherwise)
        expected = f"{an(kinds[0] if named is value else kinds[1])}, like the other branch"
        ctx.sink.report("E0312", other.node.span, expected=expected, found=kind_of(other.value))
        return POISON
    pair = aligned(ctx, value, otherwise, node)
    if pair is None:
        return POISON
    one, two = pair
    if not fits(one.dimension, two.dimension):
        left, right = (value.node, one.dimension), (otherwise.node, two.dimension)
        report_unequal(ctx, "choose between", scope, left, right)
        return POISON
    dimension = joined(one.dimension, two.dimension)
    variability, order = latest(condition, one, two), highest(condition, one, two)
    if isinstance(one, Scalar) and isinstance(two, Scalar):
        expression = flat.Conditional(condition.expression, one.expression, two.expression)
        kind = one.kind if one.kind == two.kind else "Real"
        return Scalar(expression, dimension, variability, order, kind)
    if isinstance(one, Vector) and isinstance(two, Vector):
        expression = flat.Conditional(condition.expression, one.expression, two.expression)
        return Vector(expression, dimension, variability, order)
    assert isinstance(one, Array) and isinstance(two, Array), "aligned gives equal shapes"
    pairs = zip(one.elements, two.elements, strict=True)
    parts = tuple(flat.Conditional(condition.expression, a, b) for a, b in pairs)
    return Array(parts, one.shape, dimension, variability, order, joint_kind(one, two))
