"""Elaboration of expressions: one pass from the tree to typed values, bottom up.

Names are resolved, kinds, shapes and dimensions checked, functions of the user expanded, literals converted to SI. An
error is reported once, at its place, and its value becomes poison.
"""

from __future__ import annotations

from typing import Final

from lagdsl.foundation.units.definition import si_value
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.foundation.units.parse import UnknownUnit, parse_unit
from lagdsl.language.flat import expression as flat
from lagdsl.language.semantics.expressions import calls, references
from lagdsl.language.semantics.expressions.templates import by_template, keep_template
from lagdsl.language.semantics.operators import angles, arithmetic, arrays, geometry
from lagdsl.language.semantics.operators.arithmetic import Operand
from lagdsl.language.semantics.operators.choice import choice
from lagdsl.language.semantics.operators.nested_loops import loop_fits
from lagdsl.language.semantics.scope.constants import NoValue, evaluate
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import braces
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import POISON, Poison, Scalar, Text, Value, is_structural
from lagdsl.language.semantics.variables import scale_points
from lagdsl.language.syntax import nodes

# To be looked for among texts that are spelled alike.
_SPELLED: Final = (nodes.Compound, nodes.Index)


def elaborate(ctx: Context, scope: Scope, node: nodes.Expression, adopt: bool = False) -> Value:
    """The typed value of `node`.

    `adopt`: the expression is a whole binding, modifier or array element of a declared quantity, so that a bare number
    takes the declared unit. A text that stands in `scope` again is the value of the first one, unless that left more
    than a value behind.
    """
    if not isinstance(node, _SPELLED):
        return _elaborated(ctx, scope, node, adopt)
    if scope.kind == "local" and ctx.current.templates.scope is not scope and not adopt:
        return _of_turn(ctx, scope, node)
    return _spelled(ctx, scope, node, adopt)


def _of_turn(ctx: Context, scope: Scope, node: nodes.Expression) -> Value:
    """A whole text in a turn of a loop."""
    templates = ctx.current.templates
    before, templates.scope = templates.scope, scope
    try:
        found = by_template(ctx, scope, node)
        if found is not None:
            return found
        effects = ctx.effects
        value = _spelled(ctx, scope, node, False)
        if isinstance(value, Scalar) and ctx.effects == effects:
            keep_template(ctx, scope, node, value)
        return value
    finally:
        templates.scope = before


def _spelled(ctx: Context, scope: Scope, node: nodes.Expression, adopt: bool) -> Value:
    current = ctx.current
    number = current.common.number(node)
    if number is None:
        return _elaborated(ctx, scope, node, adopt)
    values, key = current.common.of(scope, current.mode, number), (number, adopt)
    known = values.get(key)
    if known is not None:
        return known
    effects = ctx.effects
    value = _elaborated(ctx, scope, node, adopt)
    if not isinstance(value, Poison) and ctx.effects == effects:
        values[key] = value
    return value


def _elaborated(ctx: Context, scope: Scope, node: nodes.Expression, adopt: bool) -> Value:  # noqa: C901, PLR0912 one case for each node
    match node:
        case nodes.Number():
            return _number(ctx, node, adopt)
        case nodes.Reference():
            return references.reference(ctx, scope, node)
        case nodes.Parenthesized():
            return elaborate(ctx, scope, node.inner, adopt)
        case nodes.Binary():
            return _binary(ctx, scope, node)
        case nodes.Quantity():
            return _quantity(ctx, node)
        case nodes.Unary(operand=nodes.Quantity() as literal) if scale_points.is_signed_point(node):
            return _quantity(ctx, literal, node.operator)
        case nodes.Unary():
            scale_points.check_operator(ctx, node)
            adopt = adopt and node.operator != "not"
            value = elaborate(ctx, scope, node.operand, adopt)
            return arithmetic.unary(ctx, node, geometry.operand(ctx, value, node.operand.span))
        case nodes.Call():
            scale_points.check_call(ctx, scope, node)
            angles.check_call(ctx, scope, node)
            return calls.call(ctx, scope, node)
        case nodes.Member():
            return references.member(ctx, scope, node)
        case nodes.Index():
            return references.index(ctx, scope, node)
        case nodes.Conditional():
            return _conditional(ctx, scope, node, adopt)
        case nodes.Array():
            return arrays.stacked(
                ctx, scope, node, [(part, elaborate(ctx, scope, part, adopt)) for part in node.elements]
            )
        case nodes.Matrix():
            return arrays.matrix(ctx, scope, node, adopt)
        case nodes.Comprehension() | nodes.Reduction() if not loop_fits(ctx, scope, node):
            return POISON
        case nodes.Comprehension():
            return arrays.comprehension(ctx, scope, node, adopt)
        case nodes.Reduction():
            scale_points.check_call(ctx, scope, node)
            return arrays.reduction(ctx, scope, node)
        case nodes.Boolean():
            return Scalar(flat.Number(float(node.value)), DIMENSIONLESS, kind="Boolean")
        case nodes.String():
            return Text(node.value)
        case nodes.Tuple():
            found = "a list in round brackets"
            ctx.sink.report("E0312", node.span, expected="one value", found=found, help=braces(node.span.text))
            return POISON


def _binary(ctx: Context, scope: Scope, node: nodes.Binary) -> Value:
    """Checked where its operands are of other types than they were before."""
    known = ctx.current.alike.of(node)
    sound = known is not None
    if not sound:
        before = ctx.effects
        scale_points.check_operator(ctx, node)
        sound = ctx.effects == before
    left, right = elaborate(ctx, scope, node.left), elaborate(ctx, scope, node.right)
    same = known.value(left, right) if known is not None else None
    if same is not None:
        return same
    before = ctx.effects
    if node.operator not in ("and", "or"):
        left, right = geometry.operand(ctx, left, node.left.span), geometry.operand(ctx, right, node.right.span)
    angles.check_operator(ctx, scope, node)
    value = arithmetic.binary(ctx, scope, node, left, right)
    if sound and ctx.effects == before and not angles.stands_beside_number(node):
        ctx.current.alike.keep(node, left, right, value)
    return value


def _number(ctx: Context, node: nodes.Number, adopt: bool) -> Value:
    value = float(node.text)
    if value in (float("inf"), float("-inf")):
        ctx.sink.report("E0326", node.span, what="a number", most="1.8e308")
        return POISON
    integer = all(character.isdigit() for character in node.text)
    free = adopt or value == 0.0
    return Scalar(flat.Number(value), None if free else DIMENSIONLESS, kind="Integer" if integer else "Real")


def _quantity(ctx: Context, node: nodes.Quantity, sign: str = "") -> Value:
    """`sign` is part of a literal in a unit with an offset."""
    if not ctx.conventions.units:
        ctx.sink.report("E0409", node.span)
        return POISON
    try:
        unit = parse_unit(node.unit)
    except UnknownUnit as fault:
        hint = f"did you mean `{fault.suggestion}`?" if fault.suggestion else None
        ctx.sink.report("E0413", node.span, unit=node.unit, help=hint)
        return POISON
    value = si_value(sign + node.number, unit)
    if value in (float("inf"), float("-inf")):
        ctx.sink.report("E0326", node.span, what="a number", most="1.8e308")
        return POISON
    return Scalar(flat.Number(value), unit.dimension)


def _conditional(ctx: Context, scope: Scope, node: nodes.Conditional, adopt: bool) -> Value:
    """A structural condition chooses its branch at once, and the others are not read."""
    conditions: list[tuple[Scalar, Operand]] = []
    last = Operand(node.otherwise, POISON)
    for branch in node.branches:
        condition = arithmetic.boolean(ctx, Operand(branch.condition, elaborate(ctx, scope, branch.condition)))
        if condition is None:
            return POISON
        if is_structural(condition):
            try:
                taken = evaluate(condition.expression) != 0.0
            except NoValue as fault:
                ctx.sink.report("E0323", branch.condition.span, reason=str(fault))
                return POISON
            if taken:
                last = Operand(branch.value, elaborate(ctx, scope, branch.value, adopt))
                break
        else:
            conditions.append((condition, Operand(branch.value, elaborate(ctx, scope, branch.value, adopt))))
    else:
        last = Operand(node.otherwise, elaborate(ctx, scope, node.otherwise, adopt))
    for condition, operand in reversed(conditions):
        one = Operand(operand.node, geometry.operand(ctx, operand.value, operand.node.span))
        two = Operand(last.node, geometry.operand(ctx, last.value, last.node.span))
        last = Operand(last.node, choice(ctx, scope, condition, one, two, node))
    return last.value
