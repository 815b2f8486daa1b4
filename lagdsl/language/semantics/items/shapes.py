"""Shapes of `draw` statements: the places they stand at, and the arguments that have an effect there."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, TypeAlias

from lagdsl.foundation.record import record

Place: TypeAlias = Literal["at", "on", "between"]
Kind: TypeAlias = Literal["count", "length", "three lengths", "direction", "vector", "color", "text", "file"]

KINDS: Mapping[str, Kind] = {
    "radius": "length",
    "length": "length",
    "width": "length",
    "height": "length",
    "size": "three lengths",
    "scale": "three lengths",
    "axis": "direction",
    "vector": "vector",
    "color": "color",
    "text": "text",
    "teeth": "count",
    "file": "file",
}
FEWEST_TEETH, MOST_TEETH = 4, 400
"""Of a gear: fewer have no foot circle, more are not seen."""

# Arguments that leave others without effect.
INSTEAD_OF: Mapping[str, tuple[str, ...]] = {"size": ("length", "width", "height"), "length": ("height",)}
WORDS: Mapping[Place, str] = {"at": "at P", "on": "on F", "between": "from A to B"}


@record()
class ShapeRule:
    """Arguments by place; `instead` has the arguments that exclude others."""

    arguments: Mapping[Place, tuple[str, ...]]
    instead: tuple[str, ...] = ()

    @property
    def ways(self) -> str:
        """The places in words."""
        *others, last = (f"`{WORDS[place]}`" for place in self.arguments)
        return f"{', '.join(others)} or {last}" if others else last


_BALL = ("radius", "color")
_TURNED = ("radius", "length", "height", "axis", "color")
_BOX = ("length", "width", "height", "size", "color")
_ROUND = ShapeRule({"at": _TURNED, "on": _TURNED, "between": _BALL}, ("length",))

SHAPES: Mapping[str, ShapeRule] = {
    "rod": ShapeRule({"between": _BALL}),
    "spring": ShapeRule({"between": _BALL}),
    "damper": ShapeRule({"between": ("color",)}),
    "box": ShapeRule({"at": _BOX, "on": _BOX, "between": ("width", "height", "axis", "color")}, ("size",)),
    "cylinder": _ROUND,
    "cone": _ROUND,
    "disc": _ROUND,
    "gear": ShapeRule({"at": ("teeth", *_TURNED), "on": ("teeth", *_TURNED)}, ("length",)),
    "sphere": ShapeRule({"at": _BALL, "on": _BALL}),
    "circle": ShapeRule({"at": _BALL, "on": _BALL}),
    "arrow": ShapeRule({"at": ("vector", "color"), "on": ("vector", "color"), "between": ("color",)}),
    "trace": ShapeRule({"at": ("color",), "on": ("color",)}),
    "text": ShapeRule({"at": ("text",), "on": ("text",)}),
    "mesh": ShapeRule({"on": ("file", "scale", "color")}),
}
