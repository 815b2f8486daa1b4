"""Edges of the solids that `draw` names, as lines in space: what living_page.md draws, seen through."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lagdsl.derivation.scene.shapes import Shape
from lagdsl.foundation.numerics.rank import Floats

_STEPS = 49


def outlines(shape: Shape, value: Callable[[int, int], Floats | None]) -> list[list[Floats]]:
    """Nothing for shapes without a size of their own. `value` gives so many scalars from a column on, as a vector."""
    numbers = dict(shape.numbers)

    def vector(role: str) -> Floats | None:
        return value(numbers[role], 3) if role in numbers else None

    def scalar(role: str) -> float | None:
        found = value(numbers[role], 1) if role in numbers else None
        return None if found is None else float(found[0])

    at, to = vector("at"), vector("to")
    if at is None:
        return []
    if to is not None:
        return [[at, to]] if shape.kind in ("box", "cylinder", "cone") else []
    x, y, z = (
        found if (found := vector(role)) is not None else unit for role, unit in zip("xyz", np.eye(3), strict=True)
    )
    radius = scalar("radius")
    if shape.kind in ("circle", "sphere") and radius is not None:
        return [_ring(at, radius * x, radius * y)]
    if shape.kind in ("disc", "cylinder", "cone") and radius is not None:
        axis = vector("axis") if "axis" in shape.vectors else None
        normal = z if axis is None else axis[0] * x + axis[1] * y + axis[2] * z
        length = scalar("length") or scalar("height") or 0.0
        return _round(at, normal, radius, length, shape.kind)
    size = vector("size") if "size" in shape.vectors else None
    if shape.kind == "box" and size is not None:
        return _edges(at, (size[0] * x, size[1] * y, size[2] * z))
    return []


def _ring(center: Floats, first: Floats, second: Floats) -> list[Floats]:
    return [center + np.cos(s) * first + np.sin(s) * second for s in np.linspace(0.0, 2.0 * np.pi, _STEPS)]


def _round(at: Floats, normal: Floats, radius: float, length: float, kind: str) -> list[list[Floats]]:
    """The rims of a cylinder about its middle, of a cone from its foot to its tip."""
    size = float(np.linalg.norm(normal))
    if size == 0.0:
        return []
    axis = normal / size
    first = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
    first *= radius / float(np.linalg.norm(first))
    second = np.cross(axis, first)
    if kind == "cone":
        tip = at + length * axis
        return [_ring(at, first, second), [at + first, tip, at - first]]
    if kind == "disc" or length == 0.0:
        return [_ring(at, first, second)]
    ends = (at - 0.5 * length * axis, at + 0.5 * length * axis)
    sides = [[end + side for end in ends] for side in (first, -first, second, -second)]
    return [*(_ring(end, first, second) for end in ends), *sides]


def _edges(center: Floats, axes: tuple[Floats, Floats, Floats]) -> list[list[Floats]]:
    """The faces across the last axis, and the edges between them."""
    a, b, c = (0.5 * axis for axis in axes)
    corners = [(-a - b), (a - b), (a + b), (-a + b), (-a - b)]
    faces = [[center + corner + side for corner in corners] for side in (-c, c)]
    return [*faces, *([near, far] for near, far in zip(faces[0][:4], faces[1][:4], strict=True))]
