"""Shapes of `draw` statements, and the triangles of files beside their texts."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from pathlib import Path
from typing import cast

from lagdsl.derivation.scene.shapes import Numbers, Shape, ShapeKind
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.meshes.files import place_of, read_mesh
from lagdsl.foundation.meshes.triangles import MeshError, Triangles
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.semantics.items.shapes import KINDS

_SYMBOLS = frozenset({"rod", "cylinder", "box", "sphere", "circle"})
_SIZES = frozenset(role for role, kind in KINDS.items() if kind in ("length", "three lengths"))

# Triangles of a file, and of all.
_MOST, _MOST_TOGETHER = 6_000, 60_000


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


def meshes_of(shapes: Sequence[Shape], sink: Sink | None = None) -> dict[int, Triangles]:
    """The triangles of shapes, by their places among them; equal files have the same object.

    At most 6000 triangles of a file, and 60 000 of all. A shape whose file cannot be drawn has none: W0351 where its
    contents are the reason. A file that is not there has been told when its statement was checked.
    """
    files = {k: file for k, shape in enumerate(shapes) if (file := _file_of(shape)) is not None}
    most = min(_MOST, _MOST_TOGETHER // max(len(set(files.values())), 1))
    found: dict[int, Triangles] = {}
    for k, file in files.items():
        try:
            found[k] = read_mesh(file, most)
        except MeshError as fault:
            if sink is not None:
                sink.report("W0351", shapes[k].spans[0], file=shapes[k].texts["file"], reason=str(fault))
    return found


def _file_of(shape: Shape) -> Path | None:
    name = shape.texts.get("file")
    try:
        return None if shape.kind != "mesh" or name is None else place_of(name, shape.spans[0].file.folder)
    except MeshError:
        return None
