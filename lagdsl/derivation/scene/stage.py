"""The place of the machine: its extent, sizes chosen from it, and where it is seen from. As on the living page."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import field, replace

import numpy as np

from lagdsl.derivation.scene.drawings import meshes_of
from lagdsl.derivation.scene.forms import COARSE, FINE, triangles
from lagdsl.derivation.scene.shapes import UPRIGHT, Part, Scene, axes_along
from lagdsl.foundation.meshes.triangles import Triangles
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

_ROWS_LOOKED_AT = 200
_MANY = 60  # shapes, each of them small
TILT = 0.38 / 0.92
"""Of the view on spatial machines: upwards over backwards."""

BOARD = 0.16
"""Of the machine: half the width of the board of a gauge."""

_SIDES = 12
_ENDS = ("at", "to")
_EQUAL = 0.05
_REACH = 0.85  # of a board


@record(kw_only=True)
class Stage:
    """`rows` (rows, columns of the scene); `points` (n, 3) [m] of everything along the motion, their box from `low` to
    `high`.

    `length` [m] is the size of the machine, `scales` have the length of an arrow for a unit of a force [m/N], the
    radius of one for a unit of a torque [1/N], the length of one for a unit of a current [m/A]. `axes`: the unit
    directions right, up and back (towards the viewer).
    `boards` are the places (4, 4) of gauges.
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
    boards: tuple[Floats, ...] = ()

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
        arrows = [shape.numbers["vector"] for shape in scene.shapes if shape.kind == kind and shape.numbers]
        own = [np.linalg.norm(scene.values(rows, arrow), axis=1) for arrow in arrows]
        most = max((float(sizes.max(initial=0.0, where=np.isfinite(sizes))) for sizes in own), default=0.0)
        return 0.3 * length / most if most > 0.0 else 0.0

    scales = {"force": scaled("force"), "torque": 0.4 * scaled("torque"), "current": 0.4 * scaled("branch")}
    axes = _facing(scene, np.array(up, dtype=np.float64), points)
    meshes = meshes_of(scene.shapes)
    box = {"low": low, "high": high}
    made = Stage(scene=scene, rows=rows, points=points, **box, length=length, scales=scales, meshes=meshes, axes=axes)
    return replace(made, boards=tuple(_boards(made)))


def _boards(stage: Stage) -> Iterator[Floats]:
    """A row below the machine, turned towards the viewer. On that of a slider a unit to the right is the largest value
    along the motion, but for an edge."""
    found = [shape for shape in stage.scene.shapes if shape.kind in ("slider", "dial")]
    right, up, back = (axis * BOARD * stage.length for axis in stage.axes)
    low = min(float((end - stage.center) @ stage.axes[1]) for end in (stage.low, stage.high))
    row = stage.center + low * stage.axes[1] - 1.7 * up
    for k, shape in enumerate(found):
        values = np.abs(stage.scene.values(stage.rows, shape.numbers["value"]))
        most = float(np.max(values, initial=1e-12, where=np.isfinite(values)))
        unit = right * (_REACH / most if shape.kind == "slider" else 1.0)
        place = row + (k - (len(found) - 1) / 2.0) * 2.6 * right
        yield np.vstack([np.column_stack([unit, up, back, place]), [0.0, 0.0, 0.0, 1.0]])


def places_of(scene: Scene, rows: Floats) -> Floats:
    """All places (n, 3) [m] of the scene along the motion, with the room around them."""
    seen = rows[:: max(1, len(rows) // _ROWS_LOOKED_AT)]
    points = [np.zeros((0, 3))]
    for shape in scene.shapes:
        if shape.kind == "frame":
            continue
        points += [scene.values(seen, shape.numbers[role]) for role in _ENDS if role in shape.numbers]
        for part in (part for part in shape.parts if not part.still and part.board is None):
            places = [scene.values(seen, part.numbers[role]) for role in _ENDS if role in part.numbers]
            points += [at + side for at in places for side in (_room(scene, part, seen) if places else ())]
    known = [each[np.all(np.isfinite(each), axis=1)] for each in points]
    every = np.concatenate(known if any(map(len, known)) else [np.zeros((1, 3))])
    return every if np.any(np.ptp(every, axis=0) > 0.0) else np.concatenate([every - 0.5, every + 0.5])


def _room(scene: Scene, part: Part, rows: Floats) -> tuple[Floats, ...]:
    """Of a part with sizes of its own, from its place to the ends of the box around it, along the axes of the world
    (rows, 3) [m]."""
    unknown = part.primitive != "surface" or part.form == "file" or part.scale
    if unknown or any(size.relative for size in part.sizes[: 3 - ("to" in part.numbers)]):
        return (np.zeros(3),)
    values = (1.0 if size.value is None else scene.values(rows, size.value) for size in part.sizes)
    sizes = [np.reshape(size.factor * value, (-1, 1)) for size, value in zip(part.sizes, values, strict=True)]
    own = {role: scene.values(rows, value) for role, value in part.numbers.items()}
    if "to" in own:
        own["z"], sizes[2] = own["to"] - own["at"], np.zeros((1, 1))
    axes = zip(axes_along(own.get("z", UPRIGHT), own.get("x")), sizes, strict=True)
    corners = (
        np.stack(np.broadcast_arrays(*(axis * size for axis, size in axes)), axis=-1) @ triangles(part.form).points.T
    )
    return corners.min(axis=-1), corners.max(axis=-1)


def _facing(scene: Scene, up: Floats, points: Floats) -> tuple[Floats, Floats, Floats]:
    """The directions right, up and towards the viewer, as one first sees the machine: planar ones square on, others
    from the side on which their places spread most over the picture."""
    if scene.planar:
        right, above, back = np.eye(3)
        return right, above, back
    first = first_sight(up)
    other = np.cross(up, first)
    turns = [np.pi * k / _SIDES for k in range(_SIDES)]
    backs = [math.cos(turn) * first + math.sin(turn) * other for turn in turns]
    seen = [points @ np.array([np.cross(up, back), up + TILT * back]).T for back in backs]
    # Sides that show as much come out equal but for rounding: the first of them is taken.
    spreads = np.array([np.linalg.det(np.cov(each, rowvar=False)) for each in seen])
    back = backs[int(np.argmax(spreads >= spreads.max() * (1.0 - _EQUAL)))]
    return np.cross(up, back), up, back


def first_sight(up: Floats) -> Floats:
    """The unit direction (3,) towards a viewer in front, across `up`."""
    first = np.array([0.75, -1.0, 0.0]) if abs(up[2]) > 0.7 else np.array([0.6, 0.0, 1.0])
    first -= (first @ up) * up
    return np.asarray(first / np.linalg.norm(first))
