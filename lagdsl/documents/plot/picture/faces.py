"""Faces of solids: quadrilaterals in space, unit bodies along z as the living page has them."""

from __future__ import annotations

from functools import cache

import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

# Finer ones look no different at the size of a picture in a text.
_ROUND, _BALL, _TURNS = 18, 10, 9


@record(kw_only=True)
class Faces:
    """Quadrilaterals (n, 4, 3) [m], counterclockwise seen from outside, in one color (red, green, blue), 0 to 1.

    `opacity` 0 to 1. `closed`: nobody sees the inside. `flat`: a line or a mark, which has no light and shade.
    """

    corners: Floats
    color: tuple[float, float, float]
    opacity: float = 1.0
    closed: bool = True
    flat: bool = False


@record(kw_only=True)
class Ribbon:
    """A line through points (n, 3) [m], as wide in the picture as `width` [m] is there; `opacity` 0 to 1."""

    points: Floats
    width: float
    color: tuple[float, float, float]
    opacity: float = 1.0


@record(kw_only=True)
class Words:
    """A text at a point [m], as high as `size` [m]."""

    text: str
    at: Floats
    size: float


Part = Faces | Ribbon | Words


def placed(unit: Floats, matrix: Floats) -> Floats:
    """Corners (n, 4, 3) of a unit body through a transformation (4, 4)."""
    return np.asarray(unit @ matrix[:3, :3].T + matrix[:3, 3])


@cache
def cylinder(top: float = 1.0) -> Floats:
    """Of radius 1 from z = 0 to z = 1; `top` is the radius there."""
    angles = np.linspace(0.0, 2.0 * np.pi, _ROUND + 1)
    low = np.stack([np.cos(angles), np.sin(angles), np.zeros(_ROUND + 1)], axis=1)
    high = low * [top, top, 0.0] + [0.0, 0.0, 1.0]
    sides = np.stack([low[:-1], low[1:], high[1:], high[:-1]], axis=1)
    return np.concatenate([sides, _cap(low[:-1][::-1]), _cap(high[:-1])])


def _cap(rim: Floats) -> Floats:
    """A polygon as quadrilaterals from its first corner."""
    rest = [(k, k + 1, min(k + 2, len(rim) - 1)) for k in range(1, len(rim) - 1, 2)]
    return np.array([[rim[0], *(rim[i] for i in triple)] for triple in rest])


@cache
def sphere() -> Floats:
    """Of radius 1 about the origin."""
    theta = np.linspace(0.0, np.pi, _BALL + 1)[:, None]
    phi = np.linspace(0.0, 2.0 * np.pi, 2 * _BALL + 1)[None, :]
    z = np.broadcast_to(np.cos(theta), (_BALL + 1, 2 * _BALL + 1))
    return _mesh(np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), z], axis=-1))


@cache
def torus(thick: float) -> Floats:
    """About z, of radius 1; `thick` is the radius of its tube."""
    phi = np.linspace(0.0, 2.0 * np.pi, 2 * _ROUND + 1)[None, :]
    angle = np.linspace(0.0, 2.0 * np.pi, 7)[::-1, None]
    radius = 1.0 + thick * np.cos(angle)
    z = np.broadcast_to(thick * np.sin(angle), (7, 2 * _ROUND + 1))
    return _mesh(np.stack([radius * np.cos(phi), radius * np.sin(phi), z], axis=-1))


def _mesh(points: Floats) -> Floats:
    """The faces between the points of a grid (rows, columns, 3), rows going down and columns around."""
    corners = np.stack([points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]], axis=2)
    return corners.reshape(-1, 4, 3)


@cache
def cube() -> Floats:
    """Of edge 1 about the origin."""
    x = np.array([[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]]) / 2.0
    turns = [x, x[:, [1, 2, 0]], x[:, [2, 0, 1]]]
    return np.array([*turns, *(-turn[::-1] for turn in turns)])


@cache
def coil() -> Floats:
    """Points of a coil of radius 1 from z = 0 to z = 1, with straight ends."""
    count = _TURNS * 12
    angle = np.linspace(0.0, 2.0 * np.pi * _TURNS, count + 1)
    turns = np.stack([np.sin(angle), -np.cos(angle), 0.08 + 0.84 * angle / angle[-1]], axis=1)
    return np.concatenate([[[0.0, 0.0, 0.0]], turns, [[0.0, 0.0, 1.0]]])


def between(a: Floats, b: Floats, width: float, height: float | None = None) -> Floats:
    """The transformation (4, 4) that lays the unit length along z from a to b, with cross sections of that size."""
    z = b - a
    length = float(np.linalg.norm(z))
    unit = z / length if length > 0.0 else np.array([0.0, 0.0, 1.0])
    y = np.array([1.0, 0.0, 0.0]) if abs(unit[1]) > 0.9 else np.array([0.0, 1.0, 0.0])
    x = np.cross(y, unit)
    x /= np.linalg.norm(x)
    y = np.cross(unit, x)
    return matrix_of(x * width, y * (width if height is None else height), unit * max(length, 1e-12), a)


def matrix_of(x: Floats, y: Floats, z: Floats, at: Floats) -> Floats:
    """The transformation (4, 4) with these axes and this origin."""
    made = np.eye(4)
    made[:3, 0], made[:3, 1], made[:3, 2], made[:3, 3] = x, y, z, at
    return made
