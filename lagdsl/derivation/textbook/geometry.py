"""Vectors and rotation matrices as plain tuples of SymPy expressions, multiplied out entry by entry."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from sympy import Add, Expr, Integer, cos, sin, sqrt

Vector: TypeAlias = tuple[Expr, Expr, Expr]
Rotation: TypeAlias = tuple[Vector, Vector, Vector]
"""Rows; the columns are the frame's axes in world components."""

ZERO: Vector = (Integer(0), Integer(0), Integer(0))
IDENTITY: Rotation = (
    (Integer(1), Integer(0), Integer(0)),
    (Integer(0), Integer(1), Integer(0)),
    (Integer(0), Integer(0), Integer(1)),
)


def add(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(factor: Expr, a: Vector) -> Vector:
    return (factor * a[0], factor * a[1], factor * a[2])


def each(function: Callable[[Expr], Expr], a: Vector) -> Vector:
    return (function(a[0]), function(a[1]), function(a[2]))


def dot(a: Vector, b: Vector) -> Expr:
    return Add(a[0] * b[0], a[1] * b[1], a[2] * b[2])


def norm(a: Vector) -> Expr:
    return sqrt(dot(a, a))


def cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def transpose(a: Rotation) -> Rotation:
    return ((a[0][0], a[1][0], a[2][0]), (a[0][1], a[1][1], a[2][1]), (a[0][2], a[1][2], a[2][2]))


def apply(a: Rotation, v: Vector) -> Vector:
    return (dot(a[0], v), dot(a[1], v), dot(a[2], v))


def multiply(a: Rotation, b: Rotation) -> Rotation:
    columns = transpose(b)
    return transpose((apply(a, columns[0]), apply(a, columns[1]), apply(a, columns[2])))


def turn(axis: int, angle: Expr) -> Rotation:
    """About axis 0, 1 or 2."""
    c, s = cos(angle), sin(angle)
    one, zero = Integer(1), Integer(0)
    match axis:
        case 0:
            return ((one, zero, zero), (zero, c, -s), (zero, s, c))
        case 1:
            return ((c, zero, s), (zero, one, zero), (-s, zero, c))
        case _:
            return ((c, -s, zero), (s, c, zero), (zero, zero, one))


def turn_about(axis: Vector, angle: Expr) -> Rotation:
    """Rodrigues' formula about the direction of `axis`."""
    length = norm(axis)
    x, y, z = (component / length for component in axis)
    c, s = cos(angle), sin(angle)
    k = 1 - c
    return (
        (c + k * x * x, k * x * y - s * z, k * x * z + s * y),
        (k * x * y + s * z, c + k * y * y, k * y * z - s * x),
        (k * x * z - s * y, k * y * z + s * x, c + k * z * z),
    )


def turn_quaternion(e: tuple[Expr, Expr, Expr, Expr]) -> Rotation:
    """Rotation of e/|e|, scalar first (Euler-Rodrigues)."""
    w, x, y, z = e
    n = w * w + x * x + y * y + z * z
    return (
        ((w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n),
        (2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n),
        (2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n),
    )


def vee(a: Rotation) -> Vector:
    """The vector of a skew matrix: a = [v]x. Each entry is read once."""
    return (a[2][1], a[0][2], a[1][0])
