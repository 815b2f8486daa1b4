"""Forces and torques: at points, on frames, on scalars; with their reactions."""

from __future__ import annotations

from typing import Literal, assert_never

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS, ENERGY, FORCE
from lagdsl.foundation.units.naming import describe, unit_text
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.semantics.items import labels
from lagdsl.language.semantics.operators.arguments import named_element
from lagdsl.language.semantics.operators.geometry import as_frame, as_point
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of, quantity
from lagdsl.language.semantics.scope.scope import Scope, Symbol
from lagdsl.language.semantics.scope.values import AnyDimension, FrameValue, Order, Poison, Scalar, Value, Vector
from lagdsl.language.semantics.types.dimensions import bare_number, fits, hidden_variables, quotient, report_unequal
from lagdsl.language.syntax import nodes


def load(ctx: Context, scope: Scope, node: nodes.Load, symbol: Symbol | None) -> flat_model.Load | None:
    """The load; None after a diagnostic, or for one of a component whose value is the zero of an input left unbound."""
    found = _load(ctx, scope, node, symbol)
    if found is None:
        return None
    made, value = found
    if scope.spans and _is_nothing(_expression(made)):
        return None
    if value.order >= Order.ACCELERATION:
        ctx.product.solved.append((made, value.dimension or DIMENSIONLESS))
    return made


def _expression(made: flat_model.Load) -> flat.FlatExpression:
    match made:
        case flat_model.PointForce():
            return made.force
        case flat_model.FrameTorque():
            return made.torque
        case flat_model.GeneralizedForce() | flat_model.RateForce():
            return made.value


def _is_nothing(value: flat.FlatExpression) -> bool:
    """True if literal zeros make it zero."""
    if isinstance(value, flat.Number):
        return value.value == 0.0
    if isinstance(value, flat.Vector):
        return _is_nothing(value.x) and _is_nothing(value.y) and _is_nothing(value.z)
    if isinstance(value, flat.Unary):
        return value.operator == "-" and _is_nothing(value.operand)
    if not isinstance(value, flat.Binary):
        return False
    match value.operator:
        case "*":
            return _is_nothing(value.left) or _is_nothing(value.right)
        case "+" | "-":
            return _is_nothing(value.left) and _is_nothing(value.right)
        case "/":
            return _is_nothing(value.left)
        case "^" | "<" | "<=" | ">" | ">=" | "==" | "<>" | "and" | "or":
            return False
        case _:
            assert_never(value.operator)


_Made = tuple[flat_model.Load, Scalar | Vector]
"""A load and its value."""


def _load(ctx: Context, scope: Scope, node: nodes.Load, symbol: Symbol | None) -> _Made | None:
    if node.at is not None:
        if node.keyword == "torque":
            ctx.sink.report("E0416", node.at.span)
            return None
        return _point_force(ctx, scope, node, symbol)
    assert node.on is not None
    target = ctx.elaborate(ctx, scope, node.on, False)
    if isinstance(target, Poison):
        _value(ctx, scope, node, symbol)
        return None
    if isinstance(target, FrameValue):
        return _torque(ctx, scope, node, symbol, target)
    if isinstance(target, Scalar) and target.kind != "Boolean":
        return _generalized(ctx, scope, node, symbol, target)
    hint = "a force acts `at` a point" if isinstance(target, Vector) else None
    ctx.sink.report("E0312", node.on.span, expected="a frame or a coordinate", found=kind_of(target), help=hint)
    return None


def _label(scope: Scope, symbol: Symbol | None) -> str | None:
    return symbol.made.labels[scope.path].name if symbol is not None else None


def _value(ctx: Context, scope: Scope, node: nodes.Load, symbol: Symbol | None) -> Scalar | Vector | None:
    """The value of the load; one with a label is made once, for its readers too."""
    if symbol is None:
        return labels.load_value(ctx, scope, node)
    value: Value = ctx.resolver.element(ctx, symbol, scope.path, node.span)
    return value if isinstance(value, Scalar | Vector) else None


def _point_force(ctx: Context, scope: Scope, node: nodes.Load, symbol: Symbol | None) -> _Made | None:
    assert node.at is not None
    value = _value(ctx, scope, node, symbol)
    point = as_point(ctx, scope, node.at, ctx.elaborate(ctx, scope, node.at, False))
    frame = _optional_frame(ctx, scope, node.on)
    origin = None
    if node.origin is not None:
        origin = as_point(ctx, scope, node.origin, ctx.elaborate(ctx, scope, node.origin, False))
    origin_frame = _optional_frame(ctx, scope, node.origin_on)
    missing = (
        (node.on is not None and frame is None)
        or (node.origin is not None and origin is None)
        or (node.origin_on is not None and origin_frame is None)
    )
    if not isinstance(value, Vector) or point is None or missing:
        return None
    made = flat_model.PointForce(
        spans=(node.span, *scope.spans),
        label=_label(scope, symbol),
        force=value.expression,
        point=point.expression,
        frame=frame.name if frame is not None else None,
        origin=origin.expression if origin is not None else None,
        origin_frame=origin_frame.name if origin_frame is not None else None,
    )
    return made, value


def _optional_frame(ctx: Context, scope: Scope, node: nodes.Expression | None) -> FrameValue | None:
    return as_frame(ctx, node, ctx.elaborate(ctx, scope, node, False)) if node is not None else None


def _torque(ctx: Context, scope: Scope, node: nodes.Load, symbol: Symbol | None, target: FrameValue) -> _Made | None:
    assert node.on is not None
    if node.keyword == "force":
        ctx.sink.report("E0417", node.on.span, frame=node.on.span.text)
        return None
    value = _value(ctx, scope, node, symbol)
    frame = as_frame(ctx, node.on, target)
    origin = _optional_frame(ctx, scope, node.origin)
    if node.origin_on is not None:
        ctx.sink.report("E0312", node.origin_on.span, expected="nothing after `from` of a torque", found="`on`")
        return None
    if frame is None or value is None or (node.origin is not None and origin is None):
        return None
    if isinstance(value, Scalar):
        hint = f"give it an axis: `{node.value.span.text}*{node.on.span.text}.z`"
        ctx.sink.report("E0312", node.value.span, expected="a moment vector", found=kind_of(value), help=hint)
        return None
    made = flat_model.FrameTorque(
        spans=(node.span, *scope.spans),
        label=_label(scope, symbol),
        torque=value.expression,
        frame=frame.name,
        origin=origin.name if origin is not None else None,
    )
    return made, value


# ---- generalized forces ----------------------------------------------------------------------------------------------


def _generalized(ctx: Context, scope: Scope, node: nodes.Load, symbol: Symbol | None, target: Scalar) -> _Made | None:
    """Q_j = F ds/dq_j: the value times the target is an energy."""
    assert node.on is not None
    value = _value(ctx, scope, node, symbol)
    origin = _origin(ctx, scope, node, target)
    if value is None or (node.origin is not None and origin is None):
        return None
    if not isinstance(value, Scalar):
        hint = "a force vector acts `at` a point" if node.keyword == "force" else "a moment vector acts `on` a frame"
        ctx.sink.report("E0312", node.value.span, expected="a scalar on a scalar", found=kind_of(value), help=hint)
        return None
    if not _noun_fits(ctx, scope, node, value, target):
        return None
    keyword: Literal["force", "torque"] = "torque" if node.keyword == "torque" else "force"
    made = flat_model.GeneralizedForce(
        spans=(node.span, *scope.spans),
        label=_label(scope, symbol),
        keyword=keyword,
        value=value.expression,
        target=target.expression,
        origin=origin,
    )
    return made, value


def _origin(ctx: Context, scope: Scope, node: nodes.Load, target: Scalar) -> flat.FlatExpression | None:
    """The scalar that takes the opposite load."""
    if node.origin is None:
        return None
    value = ctx.elaborate(ctx, scope, node.origin, False)
    if isinstance(value, Poison):
        return None
    if not isinstance(value, Scalar):
        ctx.sink.report("E0312", node.origin.span, expected="a scalar, like the target", found=kind_of(value))
        return None
    if not fits(value.dimension, target.dimension):
        assert node.on is not None
        report_unequal(ctx, "act between", scope, (node.on, target.dimension), (node.origin, value.dimension))
        return None
    return value.expression


def _noun_fits(ctx: Context, scope: Scope, node: nodes.Load, value: Scalar, target: Scalar) -> bool:
    """E0403: dimension of the value against that of the target, and the noun against both."""
    if not ctx.conventions.units:
        return True
    assert node.on is not None
    shown = target.dimension or DIMENSIONLESS
    wanted = ENERGY / shown
    name = node.on.span.text
    on = f"angle `{name}`" if shown.is_dimensionless else f"`{name}`"
    is_number = _is_plain_number(ctx, scope, node.on)
    if is_number:
        on = f"number `{name}`"
    described = "an angle" if shown.is_dimensionless and not is_number else quantity(shown)
    place = Label(node.on.span, f"`{name}` is {described}")
    if not fits(value.dimension, wanted):
        angle = shown.is_dimensionless and not is_number
        words = "a moment [N.m]" if angle else quantity(wanted)
        found = quantity(value.dimension)
        hint = "did you mean `force ... at P`?" if angle and node.keyword == "force" else None
        hint = _with_unit(node.value, wanted, value.dimension) or hint
        notes = hidden_variables(scope, node.value)
        span, keyword = node.value.span, node.keyword
        ctx.sink.report(
            "E0403", span, place, notes=notes, help=hint, keyword=keyword, target=on, expected=words, found=found
        )
        return False
    noun = "torque" if wanted == labels.MOMENT else "force"
    if noun != node.keyword and not is_number:
        described = "a moment [N.m]" if noun == "torque" else f"{describe(wanted)} [{unit_text(wanted)}]"
        ctx.sink.report("E0412", node.value.span, place, keyword=node.keyword, noun=noun, found=described, target=name)
        return False
    return True


def _with_unit(node: nodes.Expression, wanted: Dimension, found: AnyDimension) -> str | None:
    """Help for a factor without a unit at the beginning of a product: `-0.1*der(theta)`."""
    first = node
    while isinstance(first, nodes.Binary) and first.operator in ("*", "/"):
        first = first.left
    number = bare_number(first)
    missing = quotient(wanted, found)
    if number is None or missing.is_dimensionless:
        return None
    noun = "N" if wanted == FORCE else "N.m"
    rest = unit_text(quotient(DIMENSIONLESS, found))
    named = noun if rest == "1" else f"{noun}.{rest}"  # `N.m.s`, as a data sheet has it, instead of `kg.m2/s`
    fitting = "1/" not in rest and wanted in (FORCE, labels.MOMENT)
    return f"a unit is missing: `{number} {named if fitting else unit_text(missing)}`"


def _is_plain_number(ctx: Context, scope: Scope, node: nodes.Expression) -> bool:
    """True if the target is declared without a unit, or an expression of such: no angle, so that what acts on it is a
    force or a torque alike."""
    if isinstance(node, nodes.Parenthesized):
        return _is_plain_number(ctx, scope, node.inner)
    if isinstance(node, nodes.Unary):
        return _is_plain_number(ctx, scope, node.operand)
    if isinstance(node, nodes.Binary):
        numbers = [side for side in (node.left, node.right) if not isinstance(side, nodes.Number)]
        return bool(numbers) and all(_is_plain_number(ctx, scope, side) for side in numbers)
    found = named_element(ctx, scope, node)
    info = found[0].info if found is not None else None
    return info is not None and info.unit == "1" and (info.dimension or DIMENSIONLESS).is_dimensionless
