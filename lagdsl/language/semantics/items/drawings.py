"""`draw` items: shapes for the viewer."""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.foundation.units.dimension import LENGTH
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.semantics.items.colors import COLOR, NAMED_COLORS
from lagdsl.language.semantics.items.shapes import FEWEST_TEETH, INSTEAD_OF, KINDS, MOST_TEETH, SHAPES, WORDS, Place
from lagdsl.language.semantics.operators.conditions import structural_condition
from lagdsl.language.semantics.operators.geometry import as_frame, as_point
from lagdsl.language.semantics.scope.constants import structural_integer
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of, name_span
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import (
    Array,
    Component,
    FrameValue,
    Poison,
    Reaction,
    Scalar,
    Text,
    Value,
    Vector,
)
from lagdsl.language.semantics.types.dimensions import require
from lagdsl.language.syntax import nodes


def drawing(ctx: Context, scope: Scope, node: nodes.Draw) -> flat_model.Drawing | None:
    """The shape with its arguments and place, or None after a diagnostic."""
    if not structural_condition(ctx, scope, node.condition, "a drawing"):
        return None
    if node.shape not in SHAPES:
        hint = did_you_mean(node.shape, SHAPES, f"the shapes are {', '.join(SHAPES)}")
        ctx.sink.report("E0215", node.span, shape=node.shape, help=hint)
        return None
    rule, place = SHAPES[node.shape], _PLACES.get(node.place or "")
    if place is None or place not in rule.arguments:
        ctx.sink.report("E0331", node.span, shape=node.shape, ways=rule.ways)
        return None
    arguments = [_argument(ctx, scope, node, place, argument) for argument in node.arguments]
    anchors = [_anchor(ctx, scope, anchor, place) for anchor in node.anchors]
    known = [anchor for anchor in anchors if anchor is not None]
    given = [argument for argument in arguments if argument is not None]
    if len(known) < len(anchors) or len(given) < len(arguments):
        return None
    if not _shows_something(ctx, node, place, dict(given)):
        return None
    return flat_model.Drawing(
        spans=(node.span, *scope.spans), shape=node.shape, arguments=tuple(given), place=place, anchors=tuple(known)
    )


_PLACES: Mapping[str, Place] = {"at": "at", "on": "on", "between": "between"}


def _shows_something(ctx: Context, node: nodes.Draw, place: Place, arguments: dict[str, FlatExpression | str]) -> bool:
    """False after E0343. A file that is not there leaves the motion as it is: a warning, W0351."""
    if node.shape == "arrow" and place != "between" and "vector" not in arguments:
        example = f"arrow(vector = world.x) {WORDS[place]}"
        ctx.sink.report("E0343", node.span, shape="arrow", what="a vector", name="vector", example=example)
        return False
    if node.shape == "gear" and "teeth" not in arguments:
        what, example = "the number of its teeth", f"gear(radius = 5 cm, teeth = 20) {WORDS[place]}"
        ctx.sink.report("E0343", node.span, shape="gear", what=what, name="teeth", example=example)
        return False
    if node.shape != "mesh":
        return True
    file = arguments.get("file")
    if not isinstance(file, str):
        what, example = "the name of a file", 'mesh(file = "link.stl") on F'
        ctx.sink.report("E0343", node.span, shape="mesh", what=what, name="file", example=example)
        return False
    from lagdsl.foundation.meshes.files import place_of  # readers of meshes: few models have one
    from lagdsl.foundation.meshes.triangles import MeshError

    try:
        place_of(file, node.span.file.folder)
    except MeshError as fault:
        ctx.sink.report("W0351", node.span, file=file, reason=str(fault))
    return True


def _anchor(ctx: Context, scope: Scope, node: nodes.Expression, place: Place) -> FlatExpression | str | None:
    value = ctx.elaborate(ctx, scope, node, False)
    if place == "on":
        frame = as_frame(ctx, node, value)
        return frame.name if frame is not None else None
    point = as_point(ctx, scope, node, value)
    return point.expression if point is not None else None


def _argument(
    ctx: Context, scope: Scope, node: nodes.Draw, place: Place, argument: nodes.Expression | nodes.Named
) -> tuple[str, FlatExpression | str] | None:
    if not isinstance(argument, nodes.Named):
        if node.shape == "text" and isinstance(argument, nodes.String):
            return "text", argument.value
        hint = "give it a name: `radius = ...`"
        ctx.sink.report("E0211", argument.span, name=argument.span.text, function=f"draw {node.shape}", help=hint)
        return None
    given = {each.name for each in node.arguments if isinstance(each, nodes.Named)}
    rule = SHAPES[node.shape]
    instead = next((name for name in rule.instead if name in given and argument.name in INSTEAD_OF[name]), None)
    takes = rule.arguments[place]
    if instead is not None or argument.name not in takes:
        beside = f"({instead} = ...)" if instead is not None else f" {WORDS[place]}"
        left = [name for name in takes if instead is None or name not in INSTEAD_OF[instead]]
        meant = did_you_mean(argument.name, left, f"it takes {', '.join(f'`{name}`' for name in left)}")
        function = f"draw {node.shape}{beside}"
        ctx.sink.report("E0211", name_span(argument), name=argument.name, function=function, help=meant)
        return None
    value = ctx.elaborate(ctx, scope, argument.value, True)
    made = None if isinstance(value, Poison) else _value(ctx, scope, argument, place, value)
    return None if made is None else (argument.name, made)


def _value(
    ctx: Context, scope: Scope, argument: nodes.Named, place: Place, value: Value
) -> FlatExpression | str | None:
    """A value of the kind of the argument, else None after a diagnostic."""
    kind = KINDS[argument.name]
    if kind in ("length", "three lengths"):
        return _length(ctx, scope, argument, value)
    if kind == "count":
        return _count(ctx, argument, value)
    if kind in ("direction", "vector"):
        return _direction(ctx, argument, place, value)
    if not isinstance(value, Text):
        _strange(ctx, argument, "a text in quotes", value)
        return None
    if kind == "color" and not COLOR.fullmatch(value.value) and value.value.lower() not in NAMED_COLORS:
        hint = did_you_mean(value.value, NAMED_COLORS, "write a name, as `steelblue`, or digits, as `#4682b4`")
        ctx.sink.report("W0352", argument.value.span, color=value.value, help=hint)
    return value.value


def _length(ctx: Context, scope: Scope, argument: nodes.Named, value: Value) -> FlatExpression | None:
    """One or three lengths; a single `size` is that of a cube. A scale below zero mirrors."""
    several = KINDS[argument.name] == "three lengths"
    parts: tuple[FlatExpression, ...]
    match value:
        case Scalar():
            parts = (value.expression,)
        case Vector(expression=flat.Vector() as vector) if several:
            parts = (vector.x, vector.y, vector.z)
        case Array(shape=(3,)) if several:
            parts = value.elements
        case Vector() | Array() | Text() | FrameValue() | Reaction() | Component() | Poison():
            _strange(ctx, argument, "a length or three in braces" if several else "a length", value)
            return None
        case _:
            assert_never(value)
    if not require(ctx, scope, argument.value, value.dimension, LENGTH, "E0415", what=f"`{argument.name}`"):
        return None
    numbers = [part.value for part in parts if isinstance(part, flat.Number)]
    if argument.name != "scale" and any(number < 0 for number in numbers):
        _strange(ctx, argument, "positive", value)
        return None
    if several and len(parts) == 1 and argument.name == "size":
        parts *= 3
    return parts[0] if len(parts) == 1 else flat.Vector(*parts)


def _count(ctx: Context, argument: nodes.Named, value: Value) -> FlatExpression | None:
    """Teeth; those of a ring gear, which stand inside, are counted below zero (DIN 3960)."""
    number = structural_integer(ctx, value, argument.value, "E0333")
    if number is None:
        return None
    if not FEWEST_TEETH <= abs(number) <= MOST_TEETH:
        expected = f"between {FEWEST_TEETH} and {MOST_TEETH} in size"
        ctx.sink.report("E0334", argument.value.span, what="`teeth`", expected=expected, found=str(number))
        return None
    return flat.Number(float(number))


def _direction(ctx: Context, argument: nodes.Named, place: Place, value: Value) -> FlatExpression | None:
    """An axis on a frame is given in the frame's own axes, in braces."""
    match value:
        case Vector() if place != "on" or argument.name != "axis" or isinstance(value.expression, flat.Vector):
            return value.expression
        case Vector():
            ctx.sink.report("E0332", argument.value.span, what="`axis`")
            return None
        case Array(shape=(3,)):
            return flat.Vector(*value.elements)
        case Array() | Scalar() | Text() | FrameValue() | Reaction() | Component() | Poison():
            _strange(ctx, argument, "a vector", value)
            return None
        case _:
            assert_never(value)


def _strange(ctx: Context, argument: nodes.Named, expected: str, value: Value) -> None:
    """E0334, at the value."""
    shown = argument.value.span.text if isinstance(value, Scalar | Text | Array | Vector) else kind_of(value)
    ctx.sink.report("E0334", argument.value.span, what=f"`{argument.name}`", expected=expected, found=shown)
