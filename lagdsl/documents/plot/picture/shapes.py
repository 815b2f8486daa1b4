"""The parts of the scene as faces and words, at one row of a motion."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from lagdsl.derivation.scene.forms import form
from lagdsl.derivation.scene.posed import Posed, placed
from lagdsl.derivation.scene.shapes import Shape, ShapeKind
from lagdsl.derivation.scene.stage import Stage
from lagdsl.documents.plot.picture.faces import Color, Faces, Painted, Words, color_of, ribbon
from lagdsl.foundation.meshes.triangles import Triangles, thinned
from lagdsl.foundation.numerics.rank import Floats

GAUGES: tuple[ShapeKind, ...] = ("slider", "dial")
_FEW = 1000  # triangles of a mesh: a picture has less detail than a page, and Matplotlib sorts all of them


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
            if part.form == "file" and number not in stage.meshes:
                return []
            unit = _corners(stage.meshes[number]) if part.form == "file" else form(part.form, stage.around)
            matrix = posed.matrix()
            turned = unit[:, ::-1] if np.linalg.det(matrix[:3, :3]) < 0.0 else unit
            return [Faces(corners=placed(turned, matrix), color=color, opacity=part.opacity)]
        case "line":
            return [ribbon(posed.line(), 2.0 * posed.size(part.sizes[2]), stage.turn[2], color)]
        case "trace":
            return _trace(posed, color)
        case "label":
            text, at = dict(shape.texts).get("text", shape.name), posed.vector("at")
            return [Words(text=text, at=at, size=0.06 * stage.length)]


def _corners(mesh: Triangles) -> Floats:
    """Triangles of a file as quadrilaterals (n, 4, 3) whose last corner is the third one again."""
    few = thinned(mesh, _FEW)
    return np.asarray(few.points[few.corners[:, (0, 1, 2, 2)]])


def _trace(posed: Posed, color: Color) -> list[Painted]:
    """The way of a point so far, and faintly all of it."""
    first, width = dict(posed.part.numbers)["at"], 0.006 * posed.stage.length
    every = posed.stage.rows[:, first : first + 3]
    towards = posed.stage.turn[2]
    way = [ribbon(every[: posed.row + 1], width, towards, color)] if posed.row > 0 else []
    return [ribbon(every, width, towards, color, opacity=0.2), *way]
