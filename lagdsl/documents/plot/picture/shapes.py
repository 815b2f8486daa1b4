"""The parts of the scene at one row of a motion, as pieces that a picture is painted from: faces in space and words."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from lagdsl.derivation.scene.forms import form
from lagdsl.derivation.scene.looks import OTHER
from lagdsl.derivation.scene.posed import Posed, placed
from lagdsl.derivation.scene.shapes import Part, Shape, ShapeKind
from lagdsl.derivation.scene.stage import Stage
from lagdsl.foundation.meshes.triangles import thinned
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

Color = tuple[float, float, float]
"""Red, green, blue, 0 to 1."""

GAUGES: tuple[ShapeKind, ...] = ("slider", "dial")
_FEW = 1000  # triangles of a mesh: a picture has less detail than a page, and Matplotlib sorts all of them


@record(kw_only=True)
class Faces:
    """Quadrilaterals (n, 4, 3) [m], counterclockwise seen from outside, in one color.

    `opacity` 0 to 1. `closed`: nobody sees the inside. `flat`: a line or a mark, which has no light and shade.
    """

    corners: Floats
    color: Color
    opacity: float = 1.0
    closed: bool = True
    flat: bool = False


@record(kw_only=True)
class Words:
    """A text at a point [m], as high as `size` [m]."""

    text: str
    at: Floats
    size: float


Painted = Faces | Words


def parts_of(stage: Stage, row: int, without: Collection[ShapeKind] = ()) -> list[Painted]:
    """Everything that is drawn of the machine at a row, but for some kinds of shapes."""
    found: list[Painted] = []
    for number, shape in enumerate(stage.scene.shapes):
        if shape.kind in without or shape.kind == "frame":
            continue
        for part in shape.parts:
            posed = Posed(stage, part, 0 if part.still else row)
            if posed.is_seen():
                found += _painted(posed, shape, number)
    return found


def _painted(posed: Posed, shape: Shape, number: int) -> list[Painted]:
    part, color, stage = posed.part, color_of(posed.part), posed.stage
    match part.primitive:
        case "surface":
            if part.form != "file":
                unit = form(part.form, stage.around)
            elif number in stage.meshes:
                few = thinned(stage.meshes[number], _FEW)
                unit = few.points[few.corners[:, (0, 1, 2, 2)]]
            else:
                return []
            matrix = posed.matrix()
            turned = unit[:, ::-1] if np.linalg.det(matrix[:3, :3]) < 0.0 else unit
            return [Faces(corners=placed(turned, matrix), color=color, opacity=part.opacity)]
        case "line":
            return [ribbon(posed.line(), 2.0 * posed.size(part.sizes[2]), stage.turn[2], color)]
        case "trace":
            return _trace(posed, color)
        case "label":
            text, at = shape.texts.get("text", shape.name), posed.vector("at")
            return [Words(text=text, at=at, size=0.06 * stage.length)]


def _trace(posed: Posed, color: Color) -> list[Painted]:
    """The way of a point so far, and faintly all of it."""
    stage, width = posed.stage, 0.006 * posed.stage.length
    every, towards = stage.scene.values(stage.rows, posed.part.numbers["at"]), stage.turn[2]
    way = [ribbon(every[: posed.row + 1], width, towards, color)] if posed.row > 0 else []
    return [ribbon(every, width, towards, color, opacity=0.2), *way]


def color_of(part: Part) -> Color:
    """The color of a part, where Matplotlib knows it."""
    from matplotlib.colors import is_color_like, to_rgb

    red, green, blue = to_rgb(part.color if is_color_like(part.color) else OTHER)
    return red * part.shade, green * part.shade, blue * part.shade


def ribbon(points: Floats, width: float, towards: Floats, color: Color, opacity: float = 1.0) -> Faces:
    """A line through points (n, 3) [m], turned `towards` the viewer (3,), its pieces a little longer than they are, so
    that they join."""
    points = points[np.all(np.isfinite(points), axis=1)]
    ways = np.diff(points, axis=0)
    across = np.cross(towards, ways)
    sizes = np.linalg.norm(across, axis=1)
    kept = sizes > 1e-9 * float(np.max(sizes, initial=0.0))
    a, b, side = points[:-1][kept], points[1:][kept], 0.5 * width * across[kept] / sizes[kept, None]
    longer = (0.5 if opacity == 1.0 else 0.0) * np.cross(side, towards)
    corners = np.stack([a - side - longer, b - side + longer, b + side + longer, a + side - longer], axis=1)
    return Faces(corners=corners, color=color, opacity=opacity, closed=False, flat=True)
