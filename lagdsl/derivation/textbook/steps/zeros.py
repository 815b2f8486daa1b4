"""Expressions that are zero by their form, as the curvature out of the plane of a cable that stays in it."""

from __future__ import annotations

from collections.abc import Mapping

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.quantity import Item


def vanishes(expression: fx.FlatExpression, named: Mapping[str, Item]) -> bool:
    """True if the expression is zero whatever its names stand for; definitions are looked up in `named`."""
    if isinstance(expression, fx.Number):
        return expression.value == 0.0
    if isinstance(expression, fx.Variable):
        item = named.get(expression.name)
        return isinstance(item, fm.Definition) and vanishes(item.value, named)
    if isinstance(expression, fx.Unary):
        return expression.operator == "-" and vanishes(expression.operand, named)
    if isinstance(expression, fx.Binary):
        left = vanishes(expression.left, named)
        if expression.operator in ("+", "-"):
            return left and vanishes(expression.right, named)
        return expression.operator in ("*", "/") and (
            left or (expression.operator == "*" and vanishes(expression.right, named))
        )
    return isinstance(expression, fx.Component) and _vanishes_along(expression.vector, expression.axis, named)


def _vanishes_along(vector: fx.FlatExpression, axis: int, named: Mapping[str, Item]) -> bool:
    if isinstance(vector, fx.Vector):
        return vanishes((vector.x, vector.y, vector.z)[axis], named)
    if isinstance(vector, fx.Binary) and vector.operator in ("*", "/"):
        return any(_vanishes_along(each, axis, named) for each in (vector.left, vector.right))
    if isinstance(vector, fx.Cross):
        others = [other for other in range(3) if other != axis]
        return all(
            _vanishes_along(vector.left, a, named) or _vanishes_along(vector.right, b, named)
            for a, b in (others, others[::-1])
        )
    return False
