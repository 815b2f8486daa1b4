"""The looks of things: the parts of each kind of shape, in colors and sizes of all pictures."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from lagdsl.derivation.scene.shapes import TOLD, Numbers, Part, Shape, ShapeKind, Size, is_vector
from lagdsl.language.flat import expression as fx

COLORS: Mapping[str, str] = {
    "spring": "#0d9488", "damper": "#7c3aed", "mass": "#2563eb", "body": "#3b82f6", "box": "#3b82f6",
    "cylinder": "#60a5fa", "cone": "#3b82f6", "disc": "#3b82f6", "gear": "#3b82f6", "sphere": "#2563eb",
    "circle": "#475569", "arrow": "#d97706", "force": "#dc2626", "torque": "#ea580c", "trace": "#d97706",
    "slider": "#2563eb", "dial": "#2563eb", "ground": "#94a3b8", "rail": "#94a3b8", "track": "#94a3b8",
    "mesh": "#94a3b8", "velocity": "#16a34a", "acceleration": "#9333ea", "admissible": "#db2777", "reaction": "#0284c7",
    "support": "#94a3b8", "reaction torque": "#0e7490", "constraint": "#b45309", "friction": "#c026d3",
}  # fmt: skip
OTHER = "#64748b"
_DARK = 0.72
RIM = "#475569"
_BOX = 0.06  # of the machine
CLEAR = 0.55
"""Opacity of ellipsoids of inertia: bodies may stand in each other, gimbals and their rotor."""

HATCHED = frozenset({"ground", "rail", "wall"})
"""Forms of what a machine stands on: planar machines have a hatched line in their stead."""

_ONE = Size(1.0)
_SHOWN = Size(1.0, None, False)
_TIP, _DIRECTION = Size(0.018), Size(0.2)
_AXES = {"x": "#dc2626", "y": "#16a34a", "z": "#2563eb"}
_RADII = {"rod": 0.007, "rope": 0.004, "spring": 0.026, "sphere": 0.04, "mass": 0.04, "circle": 0.014, "cylinder": 0.03,
          "cone": 0.06}  # fmt: skip
_SLIM = {"cylinder": 2.4, "cone": 2.0}
"""Lengths over radii."""
_OF_ARROWS = (("at", "at"), ("to", "to"), ("z", "vector"))


def sized(numbers: Numbers, role: str, otherwise: float) -> Size:
    """The length of a role, else a part of the machine."""
    return Size(1.0, numbers[role], False) if role in numbers else Size(otherwise)


def dressed(shapes: Iterable[Shape], planar: bool) -> tuple[Shape, ...]:
    """Shapes with the parts of their kinds, where they have none of their own, all in the colors of the kinds."""

    def shown(part: Part, shape: Shape) -> Part:
        color = shape.texts.get("color", COLORS.get(shape.kind, OTHER)) if part.color == OTHER else part.color
        if planar and part.form in HATCHED:
            return replace(part, form=f"plane {part.form}", opacity=1.0, color=color)
        return replace(part, color=color)

    found = []
    for each in shapes:
        parts = tuple(shown(part, each) for part in each.parts or parts_of(each, planar=planar))
        numbers = {role: value for role, value in each.numbers.items() if role in TOLD}
        found.append(replace(each, parts=parts, numbers=numbers))
    return tuple(found)


def parts_of(shape: Shape, *, planar: bool) -> list[Part]:
    """Besides those of `Part` the roles of its columns are the arguments of `draw`."""
    found, teeth = _parts(shape.kind, shape.numbers, planar), shape.texts.get("teeth")
    return [replace(found[0], form=f"gear of {teeth}")] if teeth else found


def _parts(kind: ShapeKind, numbers: Numbers, planar: bool) -> list[Part]:
    own = {**numbers, "x" if "to" in numbers else "z": numbers["axis"]} if "axis" in numbers else numbers
    place = {role: own[role] for role in ("at", "to", "x", "z") if role in own}
    radius = sized(numbers, "radius", _RADII.get(kind, 0.1))
    match kind:
        case "rod" | "rope":
            return [_round("cylinder", place, radius)]
        case "spring":
            return [Part(primitive="line", form="coil", numbers=place, sizes=(radius, radius, _times(radius, 0.16)))]
        case "damper":
            return [_round("cylinder", place, Size(0.005)), _round("piston", place, Size(0.018))]
        case "box":
            return [_box(place, numbers, planar)]
        case "cylinder" | "cone" | "disc" | "gear":
            return _turned(kind, place, numbers, radius)
        case "sphere" | "mass":
            return ball(place, radius)
        case "circle":
            return [_round("wire ring" if "radius" in numbers else "ring", place, radius, radius)]
        case "mesh":
            return [_scaled(place, numbers)]
        case _:
            return _marks(kind, place, numbers)


def _marks(kind: ShapeKind, place: Numbers, numbers: Numbers) -> list[Part]:
    """Arrows, ways, names and axes; nothing for what has a value alone."""
    if kind in ("trace", "text"):
        return [Part(primitive="trace" if kind == "trace" else "label", numbers=place)]
    if kind == "frame":
        ends = (({"at": numbers["at"], "z": numbers[axis]}, color) for axis, color in _AXES.items())
        return [replace(_round("beam", place, Size(0.006), Size(0.1)), color=color) for place, color in ends]
    if "at" not in numbers:
        return []
    way = {role: numbers[name] for role, name in _OF_ARROWS if name in numbers}
    if kind in ("torque", "reaction torque"):
        return [replace(_round("turning arrow", way, _SHOWN, _SHOWN), scale="torque")]
    return [arrow(way, "" if kind == "arrow" else "force")]


def arrow(place: Numbers, scale: str = "") -> Part:
    """To another point, along a vector as long as that is large, or of one length where it has no scale."""
    return Part(form="arrow", numbers=place, sizes=(_TIP, _TIP, _SHOWN if scale else _DIRECTION), scale=scale)


def _times(size: Size, factor: float) -> Size:
    return replace(size, factor=factor * size.factor)


def _round(form: str, place: Numbers, radius: Size, length: Size = _ONE) -> Part:
    return Part(form=form, numbers=place, sizes=(radius, radius, length))


def ball(place: Numbers, radius: Size) -> list[Part]:
    """Light and dark octants, as one marks a mass center: one sees it turn."""
    light = _round("octants", place, radius, radius)
    return [light, replace(light, sizes=(_times(radius, -1.0), radius, radius), shade=_DARK)]


def wheel(place: Numbers, radius: Size, width: Size) -> list[Part]:
    """With spokes, so that one sees it turn."""
    return [replace(_round("tire", place, radius, width), color=RIM), _round("spokes", place, radius, width)]


def _box(place: Numbers, numbers: Numbers, planar: bool) -> Part:
    """Length along x (or from A to B), width and height across; in planar pictures the height is upright. From A to B
    the width lies along an axis, if there is one."""
    width, height = sized(numbers, "width", _BOX), sized(numbers, "height", _BOX)
    across, up = (height, width) if planar and "x" not in place else (width, height)
    if "to" in numbers:
        return Part(form="beam", numbers=place, sizes=(across, up, Size(1.0)))
    if "size" in numbers:
        return Part(form="cube", numbers=place, sizes=_three(numbers["size"]))
    return Part(form="cube", numbers=place, sizes=(sized(numbers, "length", _BOX), across, up))


def _turned(kind: ShapeKind, place: Numbers, numbers: Numbers, radius: Size) -> list[Part]:
    """Cylinders and discs on a frame stand about their axis, their middle at its origin, cones from there on."""
    if "to" in numbers:
        return [_round("cone" if kind == "cone" else "cylinder", place, radius)]
    given = next((role for role in ("length", "height") if role in numbers), None)
    length = sized(numbers, given, 0.0) if given else _times(radius, _SLIM.get(kind, 0.12))
    body = _round("cone" if kind == "cone" else "drum", place, radius, length)
    return [body, replace(body, form="marks", color="#f8fafc")] if kind in ("disc", "gear") else [body]


def _scaled(place: Numbers, numbers: Numbers) -> Part:
    """Triangles of a file, in its units."""
    scale = numbers.get("scale")
    sizes = _three(scale) if scale is not None and is_vector(scale) else (Size(1.0, scale, False),) * 3
    return Part(form="file", numbers=place, sizes=sizes)


def _three(lengths: fx.FlatExpression) -> tuple[Size, Size, Size]:
    x, y, z = (Size(1.0, fx.Component(lengths, axis), False) for axis in range(3))
    return x, y, z
