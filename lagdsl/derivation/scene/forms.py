"""Unit bodies of pictures, all from one place: pages carry their triangles, files are painted from their faces.

A form is an array of quadrilaterals (n, 4, 3), counterclockwise seen from outside; a triangle has its third corner
twice. The axis of a round form is z.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cache
from itertools import pairwise

import numpy as np

from lagdsl.foundation.meshes.triangles import Triangles
from lagdsl.foundation.numerics.rank import Floats

FINE, COARSE = 24, 12
"""Faces around a round form: finer ones look no different, and where there are many shapes each of them is small."""

_TUBE = 7
_TURNS, _STEPS_OF_A_TURN = 8, 12
_SPOKES = 5
_TIP = 0.22  # of an arrow
_PEN = 0.02  # half the width of a stroke of a symbol
_GROUND = 1.3  # of the machine: the length of what it stands on


def block(x: tuple[float, float], y: tuple[float, float], z: tuple[float, float]) -> Floats:
    """A cuboid between these bounds."""
    corners = np.array([[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]])
    turns = [corners, corners[:, [1, 2, 0]], corners[:, [2, 0, 1]]]
    unit = np.array([*turns, *(-turn[::-1] for turn in turns)])
    bounds = np.array([x, y, z], dtype=np.float64)
    return np.asarray(bounds.mean(axis=1) + unit * np.ptp(bounds, axis=1) / 2.0)


def prism(rim: Floats, low: float = 0.0, high: float = 1.0, top: float = 1.0) -> Floats:
    """Over a polygon (n, 2), counterclockwise and star-shaped about the origin, narrowed by `top` at its upper end."""
    below = np.column_stack([rim, np.full(len(rim), low)])
    above = np.column_stack([top * rim, np.full(len(rim), high)])
    sides = np.stack([below, np.roll(below, -1, 0), np.roll(above, -1, 0), above], axis=1)
    return np.concatenate([sides, _cap(below)[:, ::-1], _cap(above)])


def _cap(rim: Floats) -> Floats:
    """Triangles about the axis."""
    middle = np.broadcast_to([0.0, 0.0, float(rim[0, 2])], rim.shape)
    following = np.roll(rim, -1, 0)
    return np.stack([middle, rim, following, following], axis=1)


def revolved(profile: Sequence[tuple[float, float]], around: int, part: float = 1.0) -> Floats:
    """A closed profile (radius, z), counterclockwise, turned about z by a part of a turn. Open ends have no faces."""
    phi = np.linspace(0.0, 2.0 * np.pi * part, max(round(around * part), 2) + 1)
    r, z = np.array([*profile, profile[0]]).T
    points = np.stack([np.outer(r, np.cos(phi)), np.outer(r, np.sin(phi)), np.outer(z, np.ones(len(phi)))], axis=-1)
    return np.asarray(_net(points)[:, ::-1])


def _net(points: Floats) -> Floats:
    """The faces between the points of a grid (rows, columns, 3), rows going down and columns around."""
    corners = np.stack([points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]], axis=2)
    return corners.reshape(-1, 4, 3)


def _circle(count: int) -> Floats:
    angles = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    return np.column_stack([np.cos(angles), np.sin(angles)])


def _sphere(around: int) -> Floats:
    rows = 2 * (around // 4)
    theta = np.linspace(0.0, np.pi, rows + 1)[:, None]
    phi = np.linspace(0.0, 2.0 * np.pi, 2 * rows + 1)[None, :]
    z = np.broadcast_to(np.cos(theta), (rows + 1, 2 * rows + 1))
    return _net(np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), z], axis=-1))


def _octants(around: int) -> Floats:
    """Every second octant of a ball; its image in a plane between octants has the others."""
    faces = _sphere(around)
    return np.asarray(faces[np.prod(np.sign(faces.mean(axis=1)), axis=1) < 0.0])


def _torus(thick: float, around: int, part: float = 1.0) -> Floats:
    angles = np.linspace(0.0, 2.0 * np.pi, _TUBE, endpoint=False)
    return revolved([(1.0 + thick * math.cos(a), thick * math.sin(a)) for a in angles], around, part)


def _spokes(around: int) -> Floats:
    bar = block((0.1, 0.84), (-0.045, 0.045), (-0.22, 0.22))
    return np.concatenate(
        [_turned(bar, 2.0 * np.pi * k / _SPOKES) for k in range(_SPOKES)] + [_drum(around, 0.16, 0.42)]
    )


def _drum(around: int, radius: float = 1.0, half: float = 0.5) -> Floats:
    return prism(radius * _circle(around), -half, half)


def _turned(faces: Floats, angle: float) -> Floats:
    c, s = math.cos(angle), math.sin(angle)
    return np.asarray(faces @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]))


def _turning_arrow(around: int) -> Floats:
    """Three quarters of a ring, with a tip: about z by the right-hand rule."""
    tip = prism(0.2 * _circle(12), 0.0, 0.5, 0.001) @ np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
    head = _turned(np.asarray(tip[:, ::-1] + np.array([1.0, -0.1, 0.0])), 1.5 * np.pi)
    angles = np.linspace(0.0, 2.0 * np.pi, _TUBE + 1)
    ring = np.stack([1.0 + 0.06 * np.cos(angles), 0.0 * angles, 0.06 * np.sin(angles)], axis=-1)
    begin = np.stack([np.broadcast_to([1.0, 0.0, 0.0], ring[1:].shape), ring[:-1], ring[1:], ring[1:]], axis=1)
    return np.concatenate([_torus(0.06, around, 0.75), begin, _turned(begin[:, ::-1], 1.5 * np.pi), head])


def _cart_wheels() -> Floats:
    """Of a cart that drives along x and stands at z = -1; its pin is the origin."""
    wheel = prism(0.4 * _circle(20), -0.12, 0.12)[:, :, [0, 2, 1]][:, ::-1]
    return np.concatenate([wheel + np.array([x, y, -0.6]) for x in (-0.9, 0.9) for y in (-0.5, 0.5)])


def _hatched(depth: float, long: float) -> Floats:
    """A line along x with its upper edge at z = 0, and strokes below it; `depth` is its thickness."""
    stroke = block((-0.1, 0.1), (-0.5, 0.5), (-2.6, 0.0)) * [depth, depth, depth]
    slanted = stroke.copy()
    slanted[..., 0] += 0.8 * stroke[..., 2]
    count = round(long / (1.6 * depth))
    strokes = [slanted + np.array([x, 0.0, 0.0]) for x in np.linspace(-0.48 * long, 0.5 * long, count)]
    line = block((-0.5 * long, 0.5 * long), (-0.5 * depth, 0.5 * depth), (-0.4 * depth, 0.0))
    return np.concatenate([line, *strokes])


def _gear(teeth: int) -> Floats:
    """Of pitch radius 1, a tooth at x; inner teeth for numbers below zero. Depths of DIN 867: 1 and 1.25 modules."""
    count, module = abs(teeth), 2.0 / abs(teeth)
    inner = teeth < 0
    tip, root = (1.0 - module, 1.0 + 1.25 * module) if inner else (1.0 + module, 1.0 - 1.25 * module)
    turns = (np.arange(count)[:, None] + np.array([-0.34, -0.12, 0.12, 0.34])).ravel() * 2.0 * np.pi / count
    radii = np.tile([root, tip, tip, root], count)
    rim = radii[:, None] * np.column_stack([np.cos(turns), np.sin(turns)])
    if not inner:
        return prism(rim, -0.5, 0.5)
    outside = (1.1 + 1.25 * module) * np.column_stack([np.cos(turns), np.sin(turns)])
    loops = [np.column_stack([each, np.full(len(each), z)]) for each, z in
             ((rim, -0.5), (outside, -0.5), (outside, 0.5), (rim, 0.5), (rim, -0.5))]  # fmt: skip
    points = np.array([np.vstack([loop, loop[:1]]) for loop in loops])
    return np.asarray(_net(points))


def _drawn(*lines: Sequence[tuple[float, float]]) -> Floats:
    """A symbol in the plane y = 0: lines through points (x, z), as bars."""
    bars = []
    for (x, z), (to_x, to_z) in (pair for line in lines for pair in pairwise(line)):
        length = math.hypot(to_x - x, to_z - z)
        bar = block((-0.5 * _PEN, length + 0.5 * _PEN), (-_PEN, _PEN), (-_PEN, _PEN))
        c, s = (to_x - x) / length, (to_z - z) / length
        bars.append(bar @ np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]]) + np.array([x, 0.0, z]))
    return np.concatenate(bars)


def _arc(radius: float, z: float, begin: float, end: float, steps: int) -> list[tuple[float, float]]:
    """About (0, z), from one angle to another, that 0 being the direction of x."""
    return [(radius * math.cos(a), z + radius * math.sin(a)) for a in np.linspace(begin, end, steps + 1)]


_LEADS = [((0.0, 0.0), (0.0, 0.25)), ((0.0, 0.75), (0.0, 1.0))]
_ROUND = _arc(0.25, 0.5, 0.0, 2.0 * np.pi, 24)
_COILS = [point for k in range(4) for point in _arc(0.0625, 0.3125 + 0.125 * k, -np.pi / 2, np.pi / 2, 6)[k > 0 :]]
_SYMBOLS: dict[str, Sequence[Sequence[tuple[float, float]]]] = {
    "resistor": [*_LEADS, [(-0.1, 0.25), (0.1, 0.25), (0.1, 0.75), (-0.1, 0.75), (-0.1, 0.25)]],
    "inductor": [*_LEADS, _COILS],
    "capacitor": [
        ((0.0, 0.0), (0.0, 0.43)),
        ((0.0, 0.57), (0.0, 1.0)),
        *(((-0.25, z), (0.25, z)) for z in (0.43, 0.57)),
    ],
    "voltage source": [((0.0, 0.0), (0.0, 1.0)), _ROUND],
    "current source": [*_LEADS, _ROUND, ((-0.25, 0.5), (0.25, 0.5))],
    "electric machine": [*_LEADS, _ROUND, [(-0.1, 0.38), (-0.1, 0.62), (0.0, 0.46), (0.1, 0.62), (0.1, 0.38)]],
    "earth": [((0.0, 0.0), (0.0, 0.3)), *(((-w, z), (w, z)) for w, z in ((0.25, 0.3), (0.16, 0.38), (0.07, 0.46)))],
}
"""IEC 60617, in a cell from z = 0 to z = 1."""


def _marks() -> Floats:
    """On both faces of a drum, so that one sees it turn."""
    plates = [block((0.15, 0.85), (-0.05, 0.05), z) for z in ((0.5, 0.52), (-0.52, -0.5))]
    return np.concatenate([_turned(plate, k * np.pi / 2) for k in range(4) for plate in plates])


_MAKERS: dict[str, Callable[[int], Floats]] = {
    "cylinder": lambda around: prism(_circle(around)),
    "drum": _drum,
    "cone": lambda around: prism(_circle(around), top=0.001),
    "octants": _octants,
    "ring": lambda around: _torus(0.28, around),
    "wire ring": lambda around: _torus(0.02, 2 * around),
    "cube": lambda _: block((-0.5, 0.5), (-0.5, 0.5), (-0.5, 0.5)),
    "beam": lambda _: block((-0.5, 0.5), (-0.5, 0.5), (0.0, 1.0)),
    "piston": lambda around: prism(_circle(around), 0.25, 0.65),
    "tire": lambda around: revolved([(0.82, -0.5), (1.0, -0.5), (1.0, 0.5), (0.82, 0.5)], around),
    "spokes": _spokes,
    "marks": lambda _: _marks(),
    "arrow": lambda around: np.concatenate(
        [prism(_circle(around) / 3.0, 0.0, 1.0 - _TIP), prism(_circle(around), 1.0 - _TIP, 1.0, 0.001)]
    ),
    "turning arrow": _turning_arrow,
    "cart": lambda _: block((-1.5, 1.5), (-0.6, 0.6), (-0.45, 0.45)),
    "cart wheels": lambda _: _cart_wheels(),
    "ground": lambda _: block((-0.5 * _GROUND, 0.5 * _GROUND), (-0.5 * _GROUND, 0.5 * _GROUND), (-0.02, 0.0)),
    "rail": lambda _: block((-0.5 * _GROUND, 0.5 * _GROUND), (-0.03, 0.03), (-0.02, 0.0)),
    "wall": lambda _: block((-0.08, 0.08), (-0.08, 0.08), (-0.02, 0.0)),
    "plane ground": lambda _: _hatched(0.014, _GROUND),
    "plane rail": lambda _: _hatched(0.01, _GROUND),
    "plane wall": lambda _: _hatched(0.01, 0.16),
}


FORMS = frozenset({*_MAKERS, *_SYMBOLS})


@cache
def form(name: str, around: int = FINE) -> Floats:
    """Faces (n, 4, 3) of a unit body; a gear has the number of its teeth behind its name."""
    if name in _SYMBOLS:
        return _drawn(*_SYMBOLS[name])
    kind, _, teeth = name.partition(" of ")
    return _gear(int(teeth)) if kind == "gear" else _MAKERS[name](around)


@cache
def triangles(name: str, around: int = FINE) -> Triangles:
    """The same with each corner once."""
    faces = np.round(form(name, around), 6)
    points, numbers = np.unique(faces.reshape(-1, 3), axis=0, return_inverse=True)
    quads = numbers.reshape(-1, 4)
    corners = np.concatenate([quads[:, (0, 1, 2)], quads[:, (0, 2, 3)]])
    kept = (corners[:, 0] != corners[:, 1]) & (corners[:, 1] != corners[:, 2]) & (corners[:, 0] != corners[:, 2])
    return Triangles(points=points, corners=corners[kept])


@cache
def coil() -> Floats:
    """Points (n, 3) of a coil of radius 1 from z = 0 to z = 1, with straight ends."""
    count = _TURNS * _STEPS_OF_A_TURN
    angle = np.linspace(0.0, 2.0 * np.pi * _TURNS, count + 1)
    turns = np.stack([np.sin(angle), -np.cos(angle), 0.12 + 0.76 * angle / angle[-1]], axis=1)
    low, high = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.1]], [[0.0, 0.0, 0.9], [0.0, 0.0, 1.0]]
    return np.concatenate([low, turns, high])
