"""`draw` items: shapes for the viewer."""

from __future__ import annotations

from pathlib import Path
from typing import Literal, assert_never

from lagdsl.diagnostics.suggest import did_you_mean
from lagdsl.flat import expression as flat
from lagdsl.flat import model as flat_model
from lagdsl.flat.expression import FlatExpression
from lagdsl.meshes.files import place_of
from lagdsl.meshes.triangles import MeshError
from lagdsl.semantics.operators.conditions import structural_condition
from lagdsl.semantics.operators.geometry import as_frame, as_point
from lagdsl.semantics.scope.context import Context
from lagdsl.semantics.scope.naming import kind_of, name_span
from lagdsl.semantics.scope.scope import Scope
from lagdsl.semantics.scope.values import Array, Component, FrameValue, Poison, Reaction, Scalar, Text, Value, Vector
from lagdsl.semantics.types.dimensions import require
from lagdsl.syntax import nodes
from lagdsl.units.dimension import LENGTH

SHAPES = (
    "rod",
    "spring",
    "damper",
    "box",
    "cylinder",
    "cone",
    "disc",
    "sphere",
    "circle",
    "arrow",
    "trace",
    "text",
    "mesh",
)
_BETWEEN = ("rod", "spring", "damper")
_LENGTHS = ("radius", "length", "width", "height", "size", "scale")
_ARGUMENTS = (*_LENGTHS, "color", "text", "coils", "vector", "axis", "file")


def drawing(ctx: Context, scope: Scope, node: nodes.Draw) -> flat_model.Drawing | None:
    """The shape with its arguments and place, or None after a diagnostic."""
    if not structural_condition(ctx, scope, node.condition, "a drawing"):
        return None
    if node.shape not in SHAPES:
        hint = did_you_mean(node.shape, SHAPES, f"the shapes are {', '.join(SHAPES)}")
        ctx.sink.report("E0215", node.span, shape=node.shape, help=hint)
        return None
    arguments = [_argument(ctx, scope, node, argument) for argument in node.arguments]
    place = _PLACES.get(node.place or "")
    if place is None or (node.shape in _BETWEEN and place != "between") or (node.shape == "mesh" and place != "on"):
        ways = {"mesh": "`on F`"}.get(node.shape, "`at P`, `on F` or `from A to B`")
        ways = "`from A to B`" if node.shape in _BETWEEN else ways
        ctx.sink.report("E0331", node.span, shape=node.shape, ways=ways)
        return None
    anchors = [_anchor(ctx, scope, anchor, place) for anchor in node.anchors]
    known = [anchor for anchor in anchors if anchor is not None]
    given = [argument for argument in arguments if argument is not None]
    if len(known) < len(anchors) or len(given) < len(arguments):
        return None
    if node.shape == "mesh" and not _has_file(ctx, node, dict(given)):
        return None
    return flat_model.Drawing(
        spans=(node.span, *scope.spans), shape=node.shape, arguments=tuple(given), place=place, anchors=tuple(known)
    )


_PLACES: dict[str, Literal["at", "on", "between"]] = {"at": "at", "on": "on", "between": "between"}


def _has_file(ctx: Context, node: nodes.Draw, arguments: dict[str, FlatExpression | str]) -> bool:
    """False after E0343. A file that is not there leaves the motion as it is: a warning, W0351."""
    file = arguments.get("file")
    if not isinstance(file, str):
        ctx.sink.report("E0343", node.span)
        return False
    try:
        place_of(file, Path(node.span.file.name).parent)
    except MeshError as fault:
        ctx.sink.report("W0351", node.span, file=file, reason=str(fault))
    return True


def _anchor(
    ctx: Context, scope: Scope, node: nodes.Expression, place: Literal["at", "on", "between"]
) -> FlatExpression | str | None:
    value = ctx.elaborate(ctx, scope, node, False)
    if place == "on":
        frame = as_frame(ctx, node, value)
        return frame.name if frame is not None else None
    point = as_point(ctx, scope, node, value)
    return point.expression if point is not None else None


def _argument(
    ctx: Context, scope: Scope, node: nodes.Draw, argument: nodes.Expression | nodes.Named
) -> tuple[str, FlatExpression | str] | None:
    if not isinstance(argument, nodes.Named):
        if node.shape == "text" and isinstance(argument, nodes.String):
            return "text", argument.value
        hint = "give it a name: `radius = ...`"
        ctx.sink.report("E0211", argument.span, name=argument.span.text, function=f"draw {node.shape}", help=hint)
        return None
    if argument.name not in _ARGUMENTS:
        meant = did_you_mean(argument.name, _ARGUMENTS, f"it takes {', '.join(_ARGUMENTS)}")
        ctx.sink.report("E0211", name_span(argument), name=argument.name, function=f"draw {node.shape}", help=meant)
        return None
    value = ctx.elaborate(ctx, scope, argument.value, True)
    return _value(ctx, scope, argument, value)


def _value(ctx: Context, scope: Scope, argument: nodes.Named, value: Value) -> tuple[str, FlatExpression | str] | None:
    what = f"`{argument.name}`"
    dimension = value.dimension if isinstance(value, Vector | Array | Scalar) and argument.name in _LENGTHS else None
    if not require(ctx, scope, argument.value, dimension, LENGTH, "E0415", what=what):
        return None
    match value:
        case Text():
            return argument.name, value.value
        case Scalar():
            return _sized(ctx, argument, value.expression, (value.expression,))
        case Vector(expression=flat.Vector() as parts):
            return _sized(ctx, argument, parts, (parts.x, parts.y, parts.z))
        case Vector():
            return argument.name, value.expression
        case Array(shape=(3,)):
            return _sized(ctx, argument, flat.Vector(*value.elements), value.elements)
        case Poison():
            return None
        case Array() | FrameValue() | Reaction() | Component():
            expected = "a number, a vector or a text"
            ctx.sink.report("E0312", argument.value.span, expected=expected, found=kind_of(value))
            return None
        case _:
            assert_never(value)


def _sized(
    ctx: Context, argument: nodes.Named, value: FlatExpression, parts: tuple[FlatExpression, ...]
) -> tuple[str, FlatExpression | str] | None:
    """None after E0334 for a length below zero; a scale below zero mirrors."""
    numbers = [part.value for part in parts if isinstance(part, flat.Number)]
    if argument.name in _LENGTHS and argument.name != "scale" and any(number < 0 for number in numbers):
        span = argument.value.span
        ctx.sink.report("E0334", span, what=f"`{argument.name}`", expected="positive", found=span.text)
        return None
    return argument.name, value
