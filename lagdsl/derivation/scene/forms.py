"""Unit bodies of pictures, all from one place: pages carry their triangles, files are painted from their faces.

A form is an array of quadrilaterals (n, 4, 3), counterclockwise seen from outside; a triangle has its third corner
twice. The axis of a round form is z.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
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
_BEND = 0.5  # of the tip of one that turns [rad]
_PEN = 0.02  # half the width of a stroke of a symbol
_GROUND = 1.3  # of the machine: the length of what it stands on

Profile = Sequence[tuple[float, float]]
"""Places (x, z) of a line, or (radius, z) of a closed one about the axis, counterclockwise."""


def block(x: tuple[float, float], y: tuple[float, float], z: tuple[float, float]) -> Floats:
    """A cuboid between these bounds."""
    corners = np.array([[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]])
    turns = [corners, corners[:, [1, 2, 0]], corners[:, [2, 0, 1]]]
    unit = np.array([*turns, *(-turn[::-1] for turn in turns)])
    bounds = np.array([x, y, z], dtype=np.float64)
    return np.asarray(bounds.mean(axis=1) + unit * np.ptp(bounds, axis=1) / 2.0)


def revolved(profile: Profile, around: int) -> Floats:
    """A closed profile, turned about z, with the middle of a face at x."""
    r, z = np.array([*profile, profile[0]]).T[..., None]
    return _net(r, _turn(around) - np.pi / around, z)


def _tube(angles: Floats, radii: Floats | float) -> Floats:
    """Around a circle of radius 1 about z, by the radii of the tube at these angles."""
    turn = _turn(_TUBE)[:, None]
    return _net(1.0 + radii * np.cos(turn), angles, radii * np.sin(turn))


def _turn(count: int) -> Floats:
    return np.linspace(0.0, 2.0 * np.pi, count + 1)


def _net(r: Floats, phi: Floats, z: Floats) -> Floats:
    """The faces between the points of a grid, rows going up outside and columns around; none that has no area."""
    points = np.stack(np.broadcast_arrays(r * np.cos(phi), r * np.sin(phi), z), axis=-1)
    corners = np.stack([points[:-1, 1:], points[1:, 1:], points[1:, :-1], points[:-1, :-1]], axis=2)
    found = corners.reshape(-1, 4, 3)
    areas = np.linalg.norm(np.cross(found[:, 2] - found[:, 0], found[:, 3] - found[:, 1]), axis=1)
    return np.asarray(found[areas > 1e-9])


def _octants(around: int) -> Floats:
    """Every second octant of a ball; its image in a plane between octants has the others."""
    theta = np.linspace(-np.pi / 2.0, np.pi / 2.0, 2 * (around // 4) + 1)[:, None]
    faces = _net(np.cos(theta), _turn(around), np.sin(theta))
    return np.asarray(faces[np.prod(np.sign(faces.mean(axis=1)), axis=1) < 0.0])


def _turned(faces: Floats, count: int) -> Floats:
    """So many of them, evenly about z."""
    cosines, sines = (of(2.0 * np.pi / count * np.arange(count)) for of in (np.cos, np.sin))
    turns = ([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]] for c, s in zip(cosines, sines, strict=True))
    return np.concatenate([faces @ np.array(turn) for turn in turns])


def _spokes(around: int) -> Floats:
    bars = _turned(block((0.1, 0.84), (-0.045, 0.045), (-0.22, 0.22)), _SPOKES)
    return np.concatenate([bars, form("drum", around) * [0.16, 0.16, 0.84]])


def _marks(_: int) -> Floats:
    """On both ends of a drum, so that one sees it turn: each within a face, their middles at one place, so that
    whoever paints faces in the order of their depths paints the mark on its face."""
    plates = [block((0.42, 0.9), (-0.05, 0.05), z) for z in ((0.5, 0.52), (-0.52, -0.5))]
    return _turned(np.concatenate(plates), 4)


def _turning_arrow(around: int) -> Floats:
    """Three quarters of a ring, with a tip: about z by the right-hand rule."""
    ring = np.linspace(0.0, 1.5 * np.pi, around)
    return _tube(np.array([0.0, *ring, ring[-1], ring[-1] + _BEND]), np.array([0.0, *[0.06] * around, 0.2, 0.0]))


def _cart_wheels(_: int) -> Floats:
    """Of a cart that drives along x and stands at z = -1; its pin is the origin."""
    wheel = (form("drum", 20) * [0.4, 0.4, 0.24])[:, ::-1, [0, 2, 1]]
    return np.concatenate([wheel + np.array([x, y, -0.6]) for x in (-0.9, 0.9) for y in (-0.5, 0.5)])


def _hatched(depth: float, long: float) -> Floats:
    """A line along x with its upper edge at z = 0, and strokes below it; `depth` is its thickness."""
    stroke = block((-0.1, 0.1), (-0.5, 0.5), (-2.6, 0.0)) * depth
    stroke[..., 0] += 0.8 * stroke[..., 2]
    count = round(long / (1.6 * depth))
    strokes = [stroke + np.array([x, 0.0, 0.0]) for x in np.linspace(-0.48 * long, 0.5 * long, count)]
    line = block((-0.5 * long, 0.5 * long), (-0.5 * depth, 0.5 * depth), (-0.4 * depth, 0.0))
    return np.concatenate([line, *strokes])


def _gear(teeth: int) -> Floats:
    """Of pitch radius 1, a tooth at x; inner teeth for numbers below zero. Depths of DIN 867: 1 and 1.25 modules."""
    sign, count, module = math.copysign(1.0, teeth), abs(teeth), 2.0 / abs(teeth)
    tip, root = 1.0 + sign * module, 1.0 - sign * 1.25 * module
    turns = (np.arange(count + 1)[:, None] + np.array([-0.34, -0.12, 0.12, 0.34])).ravel()[:-3] * 2.0 * np.pi / count
    radii = np.append(np.tile([root, tip, tip, root], count), root)
    body = np.full_like(radii, 0.0 if teeth > 0 else 1.1 + 1.25 * module)
    r = np.array([radii, body, body, radii, radii])
    z = 0.5 * sign * np.array([1.0, 1.0, -1.0, -1.0, 1.0])[:, None]
    return _net(r, turns, z)


def _drawn(*lines: Profile) -> Floats:
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
_SYMBOLS: Mapping[str, Sequence[Profile]] = {
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


_SQUARE = (-0.5, 0.5)
_WIDE = (-0.5 * _GROUND, 0.5 * _GROUND)
_THIN = (-0.02, 0.0)
_BLOCKS: Mapping[str, tuple[tuple[float, float], tuple[float, float], tuple[float, float]]] = {
    "cube": (_SQUARE, _SQUARE, _SQUARE),
    "beam": (_SQUARE, _SQUARE, (0.0, 1.0)),
    "cart": ((-1.5, 1.5), (-0.6, 0.6), (-0.45, 0.45)),
    "ground": (_WIDE, _WIDE, _THIN),
    "rail": (_WIDE, (-0.03, 0.03), _THIN),
    "wall": ((-0.08, 0.08), (-0.08, 0.08), _THIN),
}
_PROFILES: Mapping[str, Profile] = {
    "cylinder": [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)],
    "drum": [(0.0, -0.5), (1.0, -0.5), (1.0, 0.5), (0.0, 0.5)],
    "piston": [(0.0, 0.25), (1.0, 0.25), (1.0, 0.65), (0.0, 0.65)],
    "cone": [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)],
    "arrow": [(0.0, 0.0), (1.0 / 3.0, 0.0), (1.0 / 3.0, 1.0 - _TIP), (1.0, 1.0 - _TIP), (0.0, 1.0)],
    "tire": [(0.82, -0.5), (1.0, -0.5), (1.0, 0.5), (0.82, 0.5)],
}
_HATCHED = {"plane ground": (0.014, _GROUND), "plane rail": (0.01, _GROUND), "plane wall": (0.01, 0.16)}
_MAKERS: Mapping[str, Callable[[int], Floats]] = {
    "octants": _octants,
    "ring": lambda around: _tube(_turn(around), 0.28),
    "wire ring": lambda around: _tube(_turn(2 * around), 0.02),
    "spokes": _spokes,
    "marks": _marks,
    "turning arrow": _turning_arrow,
    "cart wheels": _cart_wheels,
}


FORMS = frozenset({*_SYMBOLS, *_BLOCKS, *_PROFILES, *_HATCHED, *_MAKERS})


@cache
def form(name: str, around: int = FINE) -> Floats:
    """Faces (n, 4, 3) of a unit body; a gear has the number of its teeth behind its name."""
    if name in _SYMBOLS:
        return _drawn(*_SYMBOLS[name])
    if name in _BLOCKS:
        return block(*_BLOCKS[name])
    if name in _PROFILES:
        return revolved(_PROFILES[name], around)
    if name in _HATCHED:
        return _hatched(*_HATCHED[name])
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
