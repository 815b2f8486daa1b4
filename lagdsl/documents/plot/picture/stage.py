"""The place of the machine: its extent, sizes chosen from it, and where it is seen from. As on the living page."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import field

import numpy as np

from lagdsl.derivation.scene.meshes import meshes_of
from lagdsl.derivation.scene.shapes import Scene, Shape
from lagdsl.foundation.meshes.triangles import Triangles, thinned
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

_ROWS_LOOKED_AT = 200
_FEW = 1000  # triangles of a mesh: a picture has less detail than a page, and Matplotlib sorts all of them
_GAUGES = ("slider", "dial")


@record(kw_only=True)
class Stage:
    """`rows` (rows, columns of the scene); `points` (n, 3) [m] of everything along the motion, their box from `low` to
    `high`.

    `length` [m] is the size of the machine, `mass` [kg] the largest, `force` and `torque` the length of an arrow for a
    unit of its load [m/N, 1/N]. `axes`: the unit directions right, up and back (towards the viewer). `meshes`: corners
    (n, 4, 3) by the number of the shape, in units of its file.
    """

    scene: Scene
    rows: Floats
    points: Floats
    low: Floats
    high: Floats
    length: float
    scales: dict[str, float] = field(default_factory=dict)
    meshes: dict[int, Floats] = field(default_factory=dict)
    axes: tuple[Floats, Floats, Floats]

    @property
    def center(self) -> Floats:
        return np.asarray((self.low + self.high) / 2.0)


def stage_of(scene: Scene, rows: Floats, up: Sequence[float]) -> Stage:
    """`rows` are those of the scene's columns along the motion; `up` (3,) is a unit direction."""
    points = _places(scene, rows)
    low, high = points.min(axis=0), points.max(axis=0)
    length = max(float(np.linalg.norm(high - low)) / math.sqrt(2.0), 1e-9)

    def largest(kind: str, role: str, width: int) -> float:
        sizes = [
            float(np.linalg.norm(rows[:, column : column + width], axis=1).max(initial=0.0, where=_finite(rows)))
            for shape in scene.shapes
            for name, column in shape.numbers
            if shape.kind == kind and name == role
        ]
        return max(sizes, default=0.0)

    def scaled(most: float) -> float:
        return 0.3 * length / most if most > 0.0 else 0.0

    scales = {
        "mass": largest("mass", "mass", 1),
        "force": scaled(largest("force", "vector", 3)),
        "torque": scaled(largest("torque", "vector", 3)),
    }
    axes = _facing(scene, np.array(up, dtype=np.float64))
    meshes = {k: _corners(thinned(mesh, _FEW)) for k, mesh in meshes_of(scene.shapes).items()}
    box = {"low": low, "high": high}
    return Stage(scene=scene, rows=rows, points=points, **box, length=length, scales=scales, meshes=meshes, axes=axes)


def _corners(mesh: Triangles) -> Floats:
    """Triangles as quadrilaterals (n, 4, 3) whose last corner is the third one again."""
    return np.asarray(mesh.points[mesh.corners[:, (0, 1, 2, 2)]])


def _finite(rows: Floats) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    return np.asarray(np.all(np.isfinite(rows), axis=1))


def _places(scene: Scene, rows: Floats) -> Floats:
    """All places of the scene along the motion."""
    seen = rows[:: max(1, len(rows) // _ROWS_LOOKED_AT)]
    points: list[Floats] = []
    for shape in scene.shapes:
        if shape.kind == "frame":
            continue
        numbers = dict(shape.numbers)
        own = reach(shape, rows[0])
        for role in ("at", "to"):
            if role in numbers:
                at = seen[:, numbers[role] : numbers[role] + 3]
                at = at[np.all(np.isfinite(at), axis=1)]
                points += [at - own, at + own]
    every = np.concatenate(points) if points else np.zeros((0, 3))
    if not len(every):
        every = np.zeros((1, 3))
    return every if np.any(np.ptp(every, axis=0) > 0.0) else np.concatenate([every - 0.5, every + 0.5])


def reach(shape: Shape, row: Floats) -> float:
    """Room that a shape takes around its place, at one row [m]: half its length, its radius; of a body more than half
    the largest axis of its ellipsoid, a^2 + b^2 + c^2 = 5 (I_xx + I_yy + I_zz)/(2 m), and of a bar a good half."""
    numbers = dict(shape.numbers)

    def number(role: str, k: int = 0) -> float:
        return float(row[numbers[role] + k]) if role in numbers else 0.0

    if shape.kind != "body":
        return max(number("radius"), 0.5 * number("length"), 0.5 * number("height"))
    mass, moments = number("mass"), sum(number("inertia", k) for k in range(3))
    square = 2.5 * moments / mass if mass > 0.0 else 0.0
    return 0.6 * math.sqrt(square) if math.isfinite(square) and square > 0.0 else 0.0


def _facing(scene: Scene, up: Floats) -> tuple[Floats, Floats, Floats]:
    """The directions right, up and towards the viewer, as one first sees the machine."""
    if scene.planar:
        right, above, back = np.eye(3)
        return right, above, back
    back = np.array([0.75, -1.0, 0.0]) if abs(up[2]) > 0.7 else np.array([0.6, 0.0, 1.0])
    back -= (back @ up) * up
    back /= np.linalg.norm(back)
    return np.cross(up, back), up, back


def gauges_of(scene: Scene) -> list[int]:
    """Numbers of the shapes that are gauges."""
    return [k for k, shape in enumerate(scene.shapes) if shape.kind in _GAUGES]
