"""The place of the machine: its extent, sizes chosen from it, and where it is seen from. As on the living page."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import field

import numpy as np

from lagdsl.derivation.scene.forms import COARSE, FINE
from lagdsl.derivation.scene.meshes import meshes_of
from lagdsl.derivation.scene.shapes import Scene, Shape
from lagdsl.foundation.meshes.triangles import Triangles
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

_ROWS_LOOKED_AT = 200
_MANY = 60  # shapes, each of them small
TILT = 0.38 / 0.92
"""Of the view on spatial machines: upwards over backwards."""

_SIDES = 12
_EQUAL = 0.05


@record(kw_only=True)
class Stage:
    """`rows` (rows, columns of the scene); `points` (n, 3) [m] of everything along the motion, their box from `low` to
    `high`.

    `length` [m] is the size of the machine, `scales` have the length of an arrow for a unit of a force [m/N], the
    radius of one for a unit of a torque [1/N]. `axes`: the unit directions right, up and back (towards the viewer).
    `meshes`: triangles by the number of the shape, in units of its file. `around`: faces of round forms.
    """

    scene: Scene
    rows: Floats
    points: Floats
    low: Floats
    high: Floats
    length: float
    scales: dict[str, float] = field(default_factory=dict)
    meshes: dict[int, Triangles] = field(default_factory=dict)
    axes: tuple[Floats, Floats, Floats]

    @property
    def around(self) -> int:
        return FINE if len(self.scene.shapes) < _MANY else COARSE

    @property
    def turn(self) -> Floats:
        """Rows (3, 3) right, up and towards the viewer of a picture, who sees spatial machines from above."""
        right, up, back = self.axes
        towards = back if self.scene.planar else (back + TILT * up) / math.hypot(1.0, TILT)
        return np.array([right, np.cross(towards, right), towards])

    @property
    def center(self) -> Floats:
        return np.asarray((self.low + self.high) / 2.0)


def stage_of(scene: Scene, rows: Floats, up: Sequence[float] | Floats) -> Stage:
    """`rows` are those of the scene's columns along the motion; `up` (3,) is a unit direction."""
    points = places_of(scene, rows)
    low, high = points.min(axis=0), points.max(axis=0)
    length = max(float(np.linalg.norm(high - low)) / math.sqrt(2.0), 1e-9)

    def scaled(kind: str) -> float:
        firsts = [dict(shape.numbers)["vector"] for shape in scene.shapes if shape.kind == kind]
        own = [np.linalg.norm(rows[:, first : first + 3], axis=1) for first in firsts]
        most = max((float(sizes.max(initial=0.0, where=np.isfinite(sizes))) for sizes in own), default=0.0)
        return 0.3 * length / most if most > 0.0 else 0.0

    scales = {"force": scaled("force"), "torque": 0.4 * scaled("torque")}
    axes = _facing(scene, np.array(up, dtype=np.float64), points)
    meshes = meshes_of(scene.shapes)
    box = {"low": low, "high": high}
    return Stage(scene=scene, rows=rows, points=points, **box, length=length, scales=scales, meshes=meshes, axes=axes)


def places_of(scene: Scene, rows: Floats) -> Floats:
    """All places (n, 3) [m] of the scene along the motion, with the room around them."""
    seen = rows[:: max(1, len(rows) // _ROWS_LOOKED_AT)]
    points: list[Floats] = []
    for shape in scene.shapes:
        if shape.kind == "frame":
            continue
        own = reach(shape, rows[0])
        firsts = [first for role, first in shape.numbers if role in ("at", "to")]
        firsts += [
            first for part in shape.parts for role, first in part.numbers if role in ("at", "to") and not part.still
        ]
        for first in dict.fromkeys(firsts):
            at = seen[:, first : first + 3]
            at = at[np.all(np.isfinite(at), axis=1)]
            points += [at - own, at + own]
    every = np.concatenate(points) if points else np.zeros((0, 3))
    if not len(every):
        every = np.zeros((1, 3))
    return every if np.any(np.ptp(every, axis=0) > 0.0) else np.concatenate([every - 0.5, every + 0.5])


def reach(shape: Shape, row: Floats) -> float:
    """Room that a shape with sizes of its own takes around its places, at one row [m]."""
    sizes = [
        abs(size.factor * row[size.column])
        for part in shape.parts
        for size in part.sizes
        if size.column is not None and not size.relative
    ]
    return max((float(size) for size in sizes if np.isfinite(size)), default=0.0)


def _facing(scene: Scene, up: Floats, points: Floats) -> tuple[Floats, Floats, Floats]:
    """The directions right, up and towards the viewer, as one first sees the machine: planar ones square on, others
    from the side on which their places spread most over the picture."""
    if scene.planar:
        right, above, back = np.eye(3)
        return right, above, back
    first = np.array([0.75, -1.0, 0.0]) if abs(up[2]) > 0.7 else np.array([0.6, 0.0, 1.0])
    first -= (first @ up) * up
    first /= np.linalg.norm(first)
    other = np.cross(up, first)
    turns = [np.pi * k / _SIDES for k in range(_SIDES)]
    backs = [math.cos(turn) * first + math.sin(turn) * other for turn in turns]
    seen = [points @ np.array([np.cross(up, back), up + TILT * back]).T for back in backs]
    # Sides that show as much come out equal but for rounding: the first of them is taken.
    spreads = np.array([np.linalg.det(np.cov(each, rowvar=False)) for each in seen])
    back = backs[int(np.argmax(spreads >= spreads.max() * (1.0 - _EQUAL)))]
    return np.cross(up, back), up, back
