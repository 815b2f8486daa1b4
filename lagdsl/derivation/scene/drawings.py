"""Shapes of `draw` statements."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from typing import cast

from lagdsl.derivation.scene.shapes import Columns, Shape, ShapeKind
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.semantics.items.shapes import KINDS

_AXES = ("x", "y", "z")
_VECTORS = (
    *(fx.Vector, fx.PointReference, fx.FrameOrigin, fx.FrameAxis, fx.AngularVelocity, fx.MaterialVelocity),
    *(fx.Cross, fx.LinearMomentum, fx.AngularMomentum, fx.FrameReaction, fx.AdmissibleMotion),
)


_SYMBOLS = frozenset({"rod", "cylinder", "box", "sphere", "circle"})
_SIZES = frozenset(role for role, kind in KINDS.items() if kind in ("length", "three lengths"))


def is_symbol(drawing: fm.Drawing) -> bool:
    """True for a solid without a size of its own that a component draws: a joint, a massless arm, a mass centre."""
    sized = any(role in _SIZES for role, _ in drawing.arguments)
    return drawing.shape in _SYMBOLS and len(drawing.spans) > 1 and not sized


def is_mass_centre(drawing: fm.Drawing) -> bool:
    """True for the ball or ring of no size that a component draws at a point."""
    return is_symbol(drawing) and drawing.shape in ("sphere", "circle") and drawing.place == "at"


def drawn(drawing: fm.Drawing, columns: Columns) -> Shape:
    """The shape of one statement."""
    numbers, texts = dict(placed(drawing.anchors, columns)), {}
    for role, value in drawing.arguments:
        if isinstance(value, str):
            texts[role] = value
        elif role == "teeth" and isinstance(value, fx.Number):
            texts[role] = f"{value.value:.0f}"
        elif role == "axis":
            numbers[role] = columns.vector(_in_world(value, drawing.anchors[0]))
        elif is_vector(value):
            numbers["scales" if role == "scale" else role] = columns.vector(value)
        else:
            numbers[role] = columns.scalar(value)
    return Shape(
        kind=cast(ShapeKind, drawing.shape),
        name=drawing.spans[0].text,
        numbers=tuple(numbers.items()),
        texts=tuple(texts.items()),
        spans=drawing.spans,
    )


def _in_world(axis: fx.FlatExpression, anchor: fx.FlatExpression | str) -> fx.FlatExpression:
    """The direction that a vector has whose components are those along the axes of the frame of a shape."""
    if not isinstance(anchor, str) or anchor == "world":
        return axis
    parts = tuple(fx.Component(axis, k) for k in range(3))
    return along_axes(anchor, parts)


def along_axes(frame: str, parts: Sequence[fx.FlatExpression]) -> fx.FlatExpression:
    """The vector with these components along the axes of a frame; those that are 0 are left out."""
    pairs = [(part, fx.FrameAxis(frame, axis)) for axis, part in enumerate(parts) if part != fx.ZERO]
    terms = [axis if part == fx.ONE else fx.Binary("*", part, axis) for part, axis in pairs]
    return sum_of(terms) if terms else fx.ZERO_VECTOR


def sum_of(terms: Sequence[fx.FlatExpression]) -> fx.FlatExpression:
    return reduce(lambda total, term: fx.Binary("+", total, term), terms)


def mass_centre(body: fm.RigidBody) -> fx.FlatExpression:
    origin = fx.FrameOrigin(body.frame)
    return origin if set(body.com) <= {fx.ZERO} else fx.Binary("+", origin, along_axes(body.frame, body.com))


def placed(anchors: tuple[fx.FlatExpression | str, ...], columns: Columns) -> list[tuple[str, int]]:
    """Columns of the place of a shape: `at` a point, `on` a frame, `between` two points."""
    found: list[tuple[str, int]] = []
    for role, anchor in zip(("at", "to"), anchors, strict=False):
        if isinstance(anchor, str):
            found += on_frame(anchor, columns)
        else:
            found.append((role, columns.vector(anchor)))
    return found


def on_frame(frame: str, columns: Columns) -> list[tuple[str, int]]:
    """Origin and axes."""
    axes = [(_AXES[axis], columns.vector(fx.FrameAxis(frame, axis))) for axis in range(3)]
    return [("at", columns.vector(fx.FrameOrigin(frame))), *axes]


def is_vector(expression: fx.FlatExpression) -> bool:
    """Is it a geometric vector?"""
    while True:
        if isinstance(expression, _VECTORS):
            return True
        if isinstance(expression, fx.Derivative | fx.Unary):
            expression = expression.operand
        elif isinstance(expression, fx.Binary):  # the vector of a product stands on the right
            expression = expression.right if expression.operator == "*" else expression.left
        elif isinstance(expression, fx.Conditional):
            expression = expression.value
        else:
            return False
