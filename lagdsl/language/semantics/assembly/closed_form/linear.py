"""Expressions that are linear in one variable."""

from __future__ import annotations

from collections.abc import Iterable
from typing import assert_never

from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.traversal import postorder
from lagdsl.language.semantics.assembly.closed_form.algebra import minus, negative, over, plus, times


def variables(parts: Iterable[FlatExpression]) -> dict[str, None]:
    """Names of all variables, in the order of the text."""
    return {node.name: None for part in parts for node in postorder(part) if isinstance(node, flat.Variable)}


def linear(expression: FlatExpression, name: str) -> tuple[FlatExpression, FlatExpression] | None:
    """(a, b) of a*name + b; None where it is not seen to be of that form. `a` and `b` are free of the name."""
    if name not in variables((expression,)):
        return flat.ZERO, expression
    if isinstance(expression, flat.Variable):
        return flat.ONE, flat.ZERO
    if isinstance(expression, flat.Unary) and expression.operator == "-":
        found = linear(expression.operand, name)
        return (negative(found[0]), negative(found[1])) if found is not None else None
    return _linear_binary(expression, name) if isinstance(expression, flat.Binary) else None


def _linear_binary(expression: flat.Binary, name: str) -> tuple[FlatExpression, FlatExpression] | None:
    left, right = expression.left, expression.right
    match expression.operator:
        case "+" | "-":
            one, two = linear(left, name), linear(right, name)
            if one is None or two is None:
                return None
            joined = plus if expression.operator == "+" else minus
            return joined(one[0], two[0]), joined(one[1], two[1])
        case "*":
            factor, rest = (left, right) if name not in variables((left,)) else (right, left)
            found = linear(rest, name) if name not in variables((factor,)) else None
            return (times(factor, found[0]), times(factor, found[1])) if found is not None else None
        case "/":
            found = linear(left, name) if name not in variables((right,)) else None
            return (over(found[0], right), over(found[1], right)) if found is not None else None
        case "^" | "<" | "<=" | ">" | ">=" | "==" | "<>" | "and" | "or":
            return None
        case _:
            assert_never(expression.operator)
