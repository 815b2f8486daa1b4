"""Frames and vectors: members, methods, and what is accepted as a point."""

from __future__ import annotations

from collections.abc import Callable
from typing import assert_never

from lagdsl.foundation.diagnostics.catalog.habits import member_help
from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.foundation.source import Span
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS, FORCE, INERTIA, LENGTH, TIME
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import FrameStep
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.operators.axes import axis_of
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import arguments_text, kind_of, quantity, row_in_braces
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import (
    POISON,
    Array,
    Component,
    FrameValue,
    Numeric,
    Order,
    Poison,
    Reaction,
    Scalar,
    Text,
    Value,
    Vector,
    as_vector,
    component,
    highest,
    latest,
    rank,
)
from lagdsl.language.semantics.types.bare_numbers import collect
from lagdsl.language.semantics.types.dimensions import bare_number, fits, require
from lagdsl.language.syntax import nodes

WORLD = FrameValue("world", (), Variability.CONSTANT, Order.STILL)
AXES = ("x", "y", "z")
FRAME_MEMBERS = ("x", "y", "z", "origin")
METHODS = ("rotx", "roty", "rotz", "rotate", "euler", "quat", "axes", "move", "at", "point", "vec")


# ---- members ---------------------------------------------------------------------------------------------------------


def member(ctx: Context, node: nodes.Member, target: Value) -> Value:
    """`target.name`: axes and origin of a frame, components of a vector, force and torque of a reaction."""
    match target:
        case Poison():
            return POISON
        case FrameValue() if node.name in FRAME_MEMBERS:
            return frame_member(ctx, target, node.name, node.span)
        case Reaction() if node.name in ("force", "torque"):
            dimension = ctx.conventions.dimension(FORCE if node.name == "force" else FORCE * LENGTH)
            return Vector(_wrench(target, node.name), dimension, Variability.CONTINUOUS, Order.SOLUTION)
        case Vector() | Array(shape=(2 | 3,)) if node.name in AXES:
            vector = as_vector(target)
            assert vector is not None
            part = component(vector.expression, AXES.index(node.name))
            return Scalar(part, vector.dimension, vector.variability, vector.order)
        case Scalar() | Vector() | Array() | FrameValue() | Text() | Reaction() | Component():
            return _no_member(ctx, node, target)
        case _:
            assert_never(target)


def _wrench(reaction: Reaction, name: str) -> FlatExpression:
    """The force, or the torque: about another point it is larger by (r - r') x F."""
    force: FlatExpression = flat.FrameReaction(reaction.frame, "force")
    value = force
    if name == "torque":
        value = flat.FrameReaction(reaction.frame, "torque")
        if reaction.about is not None:
            arm = flat.Binary("-", flat.FrameOrigin(reaction.frame), flat.FrameOrigin(reaction.about))
            value = flat.Binary("+", value, flat.Cross(arm, force))
    return flat.Unary("-", value) if reaction.opposite else value


def _no_member(ctx: Context, node: nodes.Member, target: Value) -> Value:
    match target:
        case FrameValue() if node.name in METHODS:
            names: tuple[str, ...] = (f"{node.name}(...)",)
        case FrameValue():
            names = (*FRAME_MEMBERS, *METHODS)
        case Reaction():
            names = ("force", "torque")
        case Vector() | Array(shape=(2 | 3,)):
            names = AXES
        case Scalar() | Array() | Text() | Component() | Poison():
            names = ()
        case _:
            assert_never(target)
    listed = f"it has {', '.join(f'`.{name}`' for name in names)}" if names else None
    if isinstance(target, FrameValue) and node.name.startswith("frame_"):
        listed = f"it is a frame by itself: write `{node.target.span.text}`"
    hint = member_help(node.name, node.target.span.text) if isinstance(target, Scalar) else None
    hint = hint or did_you_mean(node.name, names, listed, mark=".")
    ctx.sink.report("E0210", node.name_span, name=node.name, what=kind_of(target).partition(":")[0], help=hint)
    return POISON


def frame_member(ctx: Context, frame: FrameValue, name: str, span: Span) -> Vector:
    base = anchored(ctx, frame, span)
    if name == "origin":
        origin = as_vector(base)
        assert origin is not None
        return Vector(origin.expression, ctx.conventions.dimension(LENGTH), base.variability, base.order)
    return Vector(axis_of(base.name, AXES.index(name)), DIMENSIONLESS, base.variability, base.order)


def anchored(ctx: Context, frame: FrameValue, span: Span) -> FrameValue:
    """The frame under a name of its own: one made on the spot gets one."""
    if not frame.steps:
        return frame
    name = ctx.product.unique("frame")
    ctx.product.named.append(flat_model.Frame(spans=(span,), name=name, parent=frame.name, steps=frame.steps))
    return FrameValue(name, (), frame.variability, frame.order)


# ---- what is accepted as a point, a vector, a frame ------------------------------------------------------------------


def operand(ctx: Context, value: Value, span: Span) -> Value:
    """A frame in a sum or product stands for its origin."""
    return frame_member(ctx, value, "origin", span) if isinstance(value, FrameValue) else value


def as_point(ctx: Context, scope: Scope, node: nodes.Expression, value: Value) -> Vector | None:
    """The value as a position in the world, or None after E0306 or a dimension error."""
    if isinstance(value, Poison):
        return None
    vector = as_vector(operand(ctx, value, node.span))
    if vector is None:
        hint = None
        if isinstance(value, Scalar) and fits(value.dimension, ctx.conventions.dimension(LENGTH)):
            hint = f"did you mean `{{{node.span.text}, 0}}`?"
        hint = hint or row_in_braces(node)
        ctx.sink.report("E0306", node.span, found=kind_of(value), help=hint)
        return None
    if not require(ctx, scope, node, vector.dimension, LENGTH, "E0415", what="a position"):
        return None
    return vector


def as_direction(
    ctx: Context, scope: Scope, node: nodes.Expression, value: Value, what: str, dimension: Dimension
) -> Vector | None:
    """The value as a geometric vector of the dimension, or None after a diagnostic."""
    if isinstance(value, Poison):
        return None
    vector = as_vector(value) if not isinstance(value, FrameValue) else None
    if vector is None:
        hint = None
        if isinstance(value, Scalar) and fits(value.dimension, ctx.conventions.dimension(dimension)):
            text = node.span.text if not isinstance(node, nodes.Binary) else f"({node.span.text})"
            hint = f"give it a direction: `{text}*world.x`"
            if what == "gravity":
                hint = f"gravity points down: `-{text.lstrip('-')}*world.y`"
        elif isinstance(value, Scalar) and what == "gravity" and (number := bare_number(node)) is not None:
            hint = f"gravity points down and has a unit: `-{number.lstrip('-')} m/s2*world.y`"
        hint = hint or row_in_braces(node)
        ctx.sink.report("E0312", node.span, expected=f"a vector for {what}", found=kind_of(value), help=hint)
        return None
    words = {"what": what, "expected": "a moment [N.m]"} if what == "a torque" else {"what": what}
    return vector if require(ctx, scope, node, vector.dimension, dimension, "E0415", **words) else None


def as_frame(ctx: Context, node: nodes.Expression, value: Value) -> FrameValue | None:
    """The value as a frame with a name, or None after a diagnostic."""
    if isinstance(value, FrameValue):
        return anchored(ctx, value, node.span)
    if not isinstance(value, Poison):
        ctx.sink.report("E0312", node.span, expected="a frame", found=kind_of(value))
    return None


def along_world(frame: FrameValue) -> bool:
    """True if the axes of the frame are those of the world, so that own and world components are the same."""
    return frame.name == "world" and all(isinstance(step, flat_model.Move | flat_model.Place) for step in frame.steps)


# ---- methods ---------------------------------------------------------------------------------------------------------


class _Arguments:
    """Positional arguments of a method call, taken one by one with their checks; `ok` tells whether all fitted."""

    def __init__(self, ctx: Context, scope: Scope, call: nodes.Call, frame: FrameValue, values: list[Value]) -> None:
        self.ctx, self.scope, self.call, self.values = ctx, scope, call, values
        self.turned = not along_world(frame)
        self.ok = True

    def node(self, index: int) -> nodes.Expression:
        argument = self.call.arguments[index]
        return argument.value if isinstance(argument, nodes.Named) else argument

    def angle(self, index: int) -> FlatExpression:
        value = self.values[index]
        if isinstance(value, Scalar) and fits(value.dimension, DIMENSIONLESS) and value.kind != "Boolean":
            collect(self.ctx, self.scope, self.node(index), value, "rad")
            return value.expression
        if isinstance(value, Scalar) and value.kind != "Boolean":
            found = quantity(value.dimension)
            self.ctx.sink.report("E0402", self.node(index).span, function="a rotation", found=found)
        elif not isinstance(value, Poison):
            self.ctx.sink.report("E0312", self.node(index).span, expected="an angle", found=kind_of(value))
        self.ok = False
        return flat.ZERO

    def own(self, index: int, what: str, dimension: Dimension, size: int = 3) -> tuple[FlatExpression, ...]:
        """Components in the frame's own axes: an array, never a world vector."""
        value, node = self.values[index], self.node(index)
        if isinstance(value, Scalar) and value.dimension is None and size == 3:
            return (flat.ZERO,) * 3
        accepted = isinstance(value, Array) and (value.shape == (size,) or (size == 3 and value.shape == (2,)))
        if isinstance(value, Array) and accepted:
            if require(self.ctx, self.scope, node, value.dimension, dimension, "E0415", what=what):
                return (*value.elements, flat.ZERO)[:size]
        elif isinstance(value, Vector):
            if isinstance(value.expression, flat.Vector) and not self.turned:
                return tuple(component(value.expression, axis) for axis in range(3))
            self.ctx.sink.report("E0332", node.span, what=what)
        elif not isinstance(value, Poison):
            self.ctx.sink.report("E0312", node.span, expected=f"{what} of {size} components", found=kind_of(value))
        self.ok = False
        return (flat.ZERO,) * size


def method(
    ctx: Context, scope: Scope, call: nodes.Call, name: nodes.Member, frame: FrameValue, values: list[Value]
) -> Value:
    """A method of a frame: a moved or turned frame, or a vector given in its axes."""
    sizes = {"rotate": 2, "euler": 4, "axes": 3}
    if name.name not in METHODS:
        return _no_member(ctx, name, frame)
    expected = sizes.get(name.name, 1)
    if len(values) != expected:
        ctx.sink.report("E0315", call.span, function=name.name, expected=arguments_text(expected), found=len(values))
        return POISON
    arguments = _Arguments(ctx, scope, call, frame, values)
    if name.name in ("point", "vec"):
        return _in_axes(ctx, frame, name, arguments)
    steps = _STEPS[name.name](ctx, arguments, name.name)
    if not arguments.ok or steps is None:
        return POISON
    moved = [value for value in values if isinstance(value, Scalar | Vector | Array | FrameValue)]
    return FrameValue(frame.name, (*frame.steps, *steps), latest(frame, *moved), highest(frame, *moved))


def _in_axes(ctx: Context, frame: FrameValue, name: nodes.Member, arguments: _Arguments) -> Value:
    value = arguments.values[0]
    dimension = LENGTH
    if name.name == "vec":
        dimension = value.dimension or DIMENSIONLESS if isinstance(value, Array) else DIMENSIONLESS
    offsets = arguments.own(0, "a position" if name.name == "point" else "a vector", dimension)
    if not arguments.ok or not isinstance(value, Scalar | Vector | Array):
        return POISON
    base = anchored(ctx, frame, name.span)
    origin = as_vector(base)
    assert origin is not None
    start = origin.expression if name.name == "point" else None
    expression = along_axes(base.name, offsets, start)
    shown = ctx.conventions.dimension(LENGTH) if name.name == "point" else value.dimension
    return Vector(expression, shown, latest(base, value), highest(base, value))


def along_axes(frame: str, offsets: tuple[FlatExpression, ...], start: FlatExpression | None) -> FlatExpression:
    """start + r1*x + r2*y + r3*z in the axes of the frame."""
    if frame == "world":
        return flat.Vector(*offsets)
    result = start
    for axis, offset in enumerate(offsets):
        if offset != flat.ZERO:
            term = flat.Binary("*", offset, axis_of(frame, axis))
            result = term if result is None else flat.Binary("+", result, term)
    return result if result is not None else flat.ZERO_VECTOR


def _turn(ctx: Context, arguments: _Arguments, name: str) -> tuple[FrameStep, ...] | None:
    return (flat_model.Rotate(AXES.index(name[-1]), arguments.angle(0)),)


def _rotate(ctx: Context, arguments: _Arguments, name: str) -> tuple[FrameStep, ...] | None:
    value = arguments.values[0]
    if isinstance(value, Array | Vector) and rank(value.variability) > rank(Variability.PARAMETER):
        ctx.sink.report(
            "E0317", arguments.node(0).span, what="the axis of `rotate`", allowed="parameters and constants"
        )
        return None
    x, y, z = arguments.own(0, "an axis", _own_dimension(value))
    return (flat_model.RotateAbout((x, y, z), arguments.angle(1)),)


def _own_dimension(value: Value) -> Dimension:
    """An axis is normalised: any dimension will do."""
    return value.dimension or DIMENSIONLESS if isinstance(value, Array) else DIMENSIONLESS


def _euler(ctx: Context, arguments: _Arguments, name: str) -> tuple[FrameStep, ...] | None:
    order = arguments.values[0]
    if not isinstance(order, Text) or len(order.value) != 3 or any(axis not in AXES for axis in order.value):
        if not isinstance(order, Poison):
            found = f'"{order.value}"' if isinstance(order, Text) else kind_of(order)
            ctx.sink.report("E0312", arguments.node(0).span, expected='three axes such as "zxz"', found=found)
        return None
    return tuple(flat_model.Rotate(AXES.index(axis), arguments.angle(k + 1)) for k, axis in enumerate(order.value))


def _quaternion(ctx: Context, arguments: _Arguments, name: str) -> tuple[FrameStep, ...] | None:
    a, b, c, d = arguments.own(0, "a quaternion", DIMENSIONLESS, 4)
    return (flat_model.RotateQuaternion((a, b, c, d)),)


def _axes(ctx: Context, arguments: _Arguments, name: str) -> tuple[FrameStep, ...] | None:
    axes = [
        as_direction(ctx, arguments.scope, arguments.node(k), arguments.values[k], "an axis", DIMENSIONLESS)
        for k in range(3)
    ]
    x, y, z = axes
    if x is None or y is None or z is None:
        return None
    return (flat_model.SetAxes(x.expression, y.expression, z.expression),)


def _move(ctx: Context, arguments: _Arguments, name: str) -> tuple[FrameStep, ...] | None:
    x, y, z = arguments.own(0, "a displacement", LENGTH)
    return (flat_model.Move((x, y, z)),)


def _at(ctx: Context, arguments: _Arguments, name: str) -> tuple[FrameStep, ...] | None:
    position = as_point(ctx, arguments.scope, arguments.node(0), arguments.values[0])
    return (flat_model.Place(position.expression),) if position is not None else None


_STEPS: dict[str, Callable[[Context, _Arguments, str], tuple[FrameStep, ...] | None]] = {
    "rotx": _turn,
    "roty": _turn,
    "rotz": _turn,
    "rotate": _rotate,
    "euler": _euler,
    "quat": _quaternion,
    "axes": _axes,
    "move": _move,
    "at": _at,
}


def time_derivative(ctx: Context, value: Numeric) -> Numeric:
    """d/dt: zero for what does not change, one order higher for what moves."""
    dimension = ctx.conventions.rate(value.dimension)
    still = rank(value.variability) <= rank(Variability.PARAMETER)
    order = Order(min(value.order + 1, Order.SOLUTION)) if value.order > Order.GIVEN else value.order
    match value:
        case Scalar():
            expression: FlatExpression = flat.ZERO if still else flat.Derivative(value.expression)
            return Scalar(expression, dimension, value.variability, order)
        case Vector():
            expression = flat.ZERO_VECTOR if still else flat.Derivative(value.expression)
            return Vector(expression, dimension, value.variability, order)
        case Array():
            parts = tuple(flat.ZERO if still else flat.Derivative(part) for part in value.elements)
            return Array(parts, value.shape, dimension, value.variability, order)


MOMENTUM = FORCE * TIME
ANGULAR_MOMENTUM = INERTIA / TIME
