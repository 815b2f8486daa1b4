"""Shapes of `draw` statements."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from typing import cast

from lagdsl.derivation.scene.shapes import Numbers, Shape, ShapeKind
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.semantics.items.shapes import KINDS

_SYMBOLS = frozenset({"rod", "cylinder", "box", "sphere", "circle"})
_SIZES = frozenset(role for role, kind in KINDS.items() if kind in ("length", "three lengths"))


def is_symbol(drawing: fm.Drawing) -> bool:
    """True for a solid without a size of its own that a component draws: a joint, a massless arm, a mass centre."""
    sized = any(role in _SIZES for role, _ in drawing.arguments)
    return drawing.shape in _SYMBOLS and len(drawing.spans) > 1 and not sized


def is_mass_centre(drawing: fm.Drawing) -> bool:
    """True for the ball or ring of no size that a component draws at a point."""
    return is_symbol(drawing) and drawing.shape in ("sphere", "circle") and drawing.place == "at"


def drawn(drawing: fm.Drawing) -> Shape:
    """The shape of one statement: `at` a point, `on` a frame, `between` two points."""
    numbers, texts = dict[str, fx.FlatExpression](), dict[str, str]()
    for end, anchor in zip(("at", "to"), drawing.anchors, strict=False):
        numbers |= on_frame(anchor) if isinstance(anchor, str) else {end: anchor}
    for role, value in drawing.arguments:
        if isinstance(value, str):
            texts[role] = value
        elif role == "teeth" and isinstance(value, fx.Number):
            texts[role] = f"{value.value:.0f}"
        else:
            numbers[role] = _in_world(value, drawing.anchors[0]) if role == "axis" else value
    kind = cast(ShapeKind, drawing.shape)
    return Shape(kind=kind, name=drawing.spans[0].text, numbers=numbers, texts=texts, spans=drawing.spans)


def _in_world(axis: fx.FlatExpression, anchor: fx.FlatExpression | str) -> fx.FlatExpression:
    """The direction that a vector has whose components are those along the axes of the frame of a shape."""
    if not isinstance(anchor, str) or anchor == "world":
        return axis
    return along_axes(anchor, tuple(fx.Component(axis, k) for k in range(3)))


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


def on_frame(frame: str) -> Numbers:
    """Origin and axes."""
    return {"at": fx.FrameOrigin(frame), **{name: fx.FrameAxis(frame, axis) for axis, name in enumerate("xyz")}}
