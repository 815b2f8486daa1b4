"""Coordinates that move nothing in the picture: a dial for an angle, a slide for any other, in a row below it."""

from __future__ import annotations

import numpy as np

from lagdsl.derivation.scene.forms import form
from lagdsl.derivation.scene.posed import matrix_of, placed
from lagdsl.derivation.scene.shapes import Shape
from lagdsl.derivation.scene.stage import Stage
from lagdsl.documents.plot.picture.faces import Faces, Painted, Words
from lagdsl.foundation.numerics.rank import Floats

_BLUE = (0.145, 0.388, 0.922)
_GRAY = (0.580, 0.639, 0.722)
_SIZE = 0.16  # of the machine


def gauges(stage: Stage, row: int) -> list[Painted]:
    """All of them, turned towards the viewer."""
    return [part for shape, at in _places(stage) for part in _gauge(stage, row, shape, at)]


def reach(stage: Stage) -> Floats:
    """Points (n, 3) that the row of gauges takes."""
    right, up, _ = (axis * _SIZE * stage.length for axis in stage.axes)
    points = [at + x * right + y * up for _, at in _places(stage) for x in (-1.2, 1.2) for y in (-1.6, 1.1)]
    return np.array(points).reshape(-1, 3)


def _places(stage: Stage) -> list[tuple[Shape, Floats]]:
    """The gauges, each with its place (3,)."""
    found = [shape for shape in stage.scene.shapes if shape.kind in ("slider", "dial")]
    right, up, _ = stage.axes
    size = _SIZE * stage.length
    low = min(float(up @ stage.low), float(up @ stage.high)) - float(up @ stage.center)
    down = stage.center + up * (low - 1.7 * size)
    return [(shape, down + right * (k - (len(found) - 1) / 2.0) * 2.6 * size) for k, shape in enumerate(found)]


def _gauge(stage: Stage, row: int, shape: Shape, at: Floats) -> list[Painted]:
    values = stage.rows[:, dict(shape.numbers)["value"]]
    value, size = float(values[row]), _SIZE * stage.length
    x, y, z = (axis * size for axis in stage.axes)
    name = Words(text=shape.name, at=at - 1.35 * y, size=0.4 * size)
    if shape.kind == "dial":
        own = matrix_of(np.cos(value) * x + np.sin(value) * y, np.cos(value) * y - np.sin(value) * x, z, at)
        hand = np.asarray((form("cube") + np.array([0.0, 0.5, 0.0])) * [0.12, 1.0, 0.12])
        ring = Faces(corners=placed(form("wire ring"), matrix_of(x, y, z, at)), color=_GRAY)
        pin = Faces(corners=placed(form("cylinder"), matrix_of(0.1 * x, 0.1 * y, 0.15 * z, at)), color=_BLUE)
        return [ring, Faces(corners=placed(hand, own), color=_BLUE), pin, name]
    most = float(np.max(np.abs(values), initial=1e-12, where=np.isfinite(values)))
    rail = placed(np.asarray(form("cube") * [2.2, 0.06, 0.06]), matrix_of(x, y, z, at))
    carriage = placed(np.asarray(form("cube") * 0.5), matrix_of(x, y, z, at + x * (0.85 * value / most)))
    return [Faces(corners=rail, color=_GRAY), Faces(corners=carriage, color=_BLUE), name]
