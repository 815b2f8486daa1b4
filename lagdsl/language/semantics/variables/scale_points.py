"""Literals in a unit with an offset, such as `20 degC`: points on a scale, not amounts.

`-5 degC` is 268.15 K. The sum of two points, or twice a point, means nothing that does not depend on the zero of the
scale (JCGM 200:2012, 1.27, on values referred to a conventional reference scale), so only what does not is accepted: a
point by itself, the difference of two points, and a point with a difference added to it, `20 degC + dT`. A difference
has no place on such a scale.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import assert_never

from lagdsl.foundation.units.definition import UnitDefinition, si_value
from lagdsl.foundation.units.parse import UnknownUnit, parse_unit
from lagdsl.language.semantics.operators.paths import designated
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Scope, Symbol, TypeInfo
from lagdsl.language.semantics.variables.attributes import attributes
from lagdsl.language.syntax import nodes

_ADDING = ("sum", "product", "norm", "mod")


def is_signed_point(node: nodes.Unary) -> bool:
    """`-5 degC`, which is one literal."""
    return node.operator in "+-" and isinstance(node.operand, nodes.Quantity) and _unit(node.operand) is not None


def check_operator(ctx: Context, node: nodes.Binary | nodes.Unary) -> None:
    """E0418 for a point where an amount is needed: in products, behind `+`, under a sign that is not its own."""
    if not ctx.conventions.units:
        return
    if isinstance(node, nodes.Unary):
        if node.operator in ("-", "+") and not is_signed_point(node):
            _refuse(ctx, node.operand, f"`{node.operator}` before parentheses")
    elif node.operator == "+":
        _refuse(ctx, node.right, "the right side of `+`")
    elif node.operator in ("*", "/", ".*", "./", "^"):
        _refuse(ctx, node.left, f"`{node.operator}`")
        _refuse(ctx, node.right, f"`{node.operator}`")


def check_call(ctx: Context, scope: Scope, node: nodes.Call | nodes.Reduction) -> None:
    """E0418 for points that a function adds up or multiplies, E0415 for the place of a difference on a scale."""
    name = node.function.span.text
    if not ctx.conventions.units:
        return
    if name == "value" and isinstance(node, nodes.Call):
        _check_value(ctx, scope, node)
    elif name in _ADDING:
        for part in (node.body,) if isinstance(node, nodes.Reduction) else node.arguments:
            if not isinstance(part, nodes.Named):
                _refuse(ctx, part, f"`{name}`")


def _check_value(ctx: Context, scope: Scope, node: nodes.Call) -> None:
    """E0415 for `value(T - 20 degC, "degC")`, which would be 273.15 too small."""
    match node.arguments:
        case (difference, nodes.String(value=text)) if not isinstance(difference, nodes.Named):
            unit = _known(text)
            if unit is None or not unit.shift or not _is_difference(ctx, scope, difference):
                return
            expected, found = "a temperature", "a difference of temperatures"
            hint = f'write `value({difference.span.text}, "K")`: a difference has the same number in K'
            ctx.sink.report("E0415", difference.span, what="the value", expected=expected, found=found, help=hint)


def _is_difference(ctx: Context, scope: Scope, node: nodes.Expression) -> bool:
    """True for a TemperatureDifference and for what is left of a temperature when another is subtracted."""
    if isinstance(node, nodes.Parenthesized):
        return _is_difference(ctx, scope, node.inner)
    if isinstance(node, nodes.Binary):
        return node.operator == "-" and (_point(node.right) is not None or _is_temperature(ctx, scope, node.right))
    info = _declared(ctx, scope, node)
    return info is not None and info.is_difference


def _is_temperature(ctx: Context, scope: Scope, node: nodes.Expression) -> bool:
    """True for what is declared with a scale that has a zero of its own, as each Temperature is."""
    info = _declared(ctx, scope, node)
    unit = _known(info.display_unit) if info is not None and info.display_unit is not None else None
    return unit is not None and unit.shift != 0


def _declared(ctx: Context, scope: Scope, node: nodes.Expression) -> TypeInfo | None:
    quantity = node.target if isinstance(node, nodes.Index) else node
    entry = designated(ctx, scope, quantity)
    return entry.info if isinstance(entry, Symbol) else None


def check_difference(ctx: Context, symbol: Symbol) -> None:
    """E0418 for points as values of a TemperatureDifference."""
    if symbol.info is None or not symbol.info.is_difference or not ctx.conventions.units:
        return
    values = [binding.node for binding in symbol.given.bindings.values()]
    values += [attribute.value for attribute in attributes(ctx, symbol).values()]
    for value in values:
        _refuse(ctx, value, f"`{symbol.info.name}`")


def _refuse(ctx: Context, node: nodes.Expression, where: str) -> None:
    found = _point(node)
    if found is None:
        return
    literal, sign = (found, "") if isinstance(found, nodes.Quantity) else (found.operand, found.operator)
    assert isinstance(literal, nodes.Quantity)
    number = f"{sign}{literal.number}"
    kelvin = f"{si_value(number, parse_unit(literal.unit)):.15g}"
    ctx.sink.report("E0418", found.span, literal=f"{number} {literal.unit}", where=where, number=number, kelvin=kelvin)


def _point(node: nodes.Expression) -> nodes.Quantity | nodes.Unary | None:
    """The first point among what the value of `node` may be, with its sign."""
    match node:
        case nodes.Number() | nodes.Binary() | nodes.Designator() | nodes.Call():
            return None
        case nodes.Quantity():
            return node if _unit(node) is not None else None
        case nodes.Unary() if is_signed_point(node):
            return node
        case nodes.Unary():
            return _point(node.operand) if node.operator in ("-", "+") else None
        case nodes.Parenthesized(inner=inner) | nodes.Comprehension(body=inner):
            return _point(inner)
        case nodes.Array(elements=parts):
            return _first(parts)
        case nodes.Matrix(rows=rows):
            return _first(part for row in rows for part in row)
        case nodes.Conditional(branches=branches, otherwise=otherwise):
            return _first([*(branch.value for branch in branches), otherwise])
        case nodes.String() | nodes.Boolean() | nodes.Reduction() | nodes.Tuple():
            return None
        case _:
            assert_never(node)


def _first(parts: Iterable[nodes.Expression]) -> nodes.Quantity | nodes.Unary | None:
    for part in parts:
        found = _point(part)
        if found is not None:
            return found
    return None


def _unit(node: nodes.Quantity) -> UnitDefinition | None:
    """The unit if it has an offset."""
    unit = _known(node.unit)
    return unit if unit is not None and unit.shift else None


def _known(text: str) -> UnitDefinition | None:
    try:
        return parse_unit(text)
    except UnknownUnit:
        return None
