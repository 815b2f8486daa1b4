"""Shape functions of solid elements at the points of Gauss, in the order of nodes of CalculiX and Abaqus.

Source: O. C. Zienkiewicz and R. L. Taylor, The Finite Element Method, vol. 1, ch. 8 and 9.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from lagdsl.exchange.flexible.matrices import Floats
from lagdsl.foundation.record import record

_CORNERS = np.array(
    [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], dtype=float
)
_HEXAHEDRON_EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
_TETRAHEDRON_EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
_WEDGE_FACES = ((0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0))
_HEXAHEDRON_FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
_TETRAHEDRON_FACES = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))
FACES: dict[str, tuple[tuple[int, ...], ...]] = {
    "C3D4": _TETRAHEDRON_FACES,
    "C3D10": _TETRAHEDRON_FACES,
    "C3D6": _WEDGE_FACES,
    "C3D15": _WEDGE_FACES,
    "C3D8": _HEXAHEDRON_FACES,
    "C3D20": _HEXAHEDRON_FACES,
}
"""Corners of the faces of an element, seen from outside against the clock."""


@record(kw_only=True)
class Rule:
    """Derivatives of the shape functions [points, nodes, 3] by the coordinates of the element, and weights [points]."""

    derivatives: Floats
    weights: Floats


@cache
def rule(kind: str, reduced: bool) -> Rule | None:
    """The rule of an element: two points a direction (one of a linear element with reduced integration), four of a
    quadratic tetrahedron. None for wedges, whose stresses are not computed."""
    match kind:
        case "C3D8" | "C3D20":
            points, weights = _cube(1 if reduced and kind == "C3D8" else 2)
        case "C3D4":
            points, weights = np.full((1, 3), 0.25), np.array([1 / 6])
        case "C3D10":
            points, weights = _tetrahedron()
        case _:
            return None
    functions = {"C3D8": _hexahedron8, "C3D20": _hexahedron20, "C3D4": _tetrahedron4, "C3D10": _tetrahedron10}
    return Rule(derivatives=np.array([functions[kind](point) for point in points]), weights=weights)


def _cube(count: int) -> tuple[Floats, Floats]:
    points, weights = np.polynomial.legendre.leggauss(count)
    grid = np.array(np.meshgrid(points, points, points, indexing="ij")).reshape(3, -1).T
    return grid, np.einsum("i,j,k->ijk", weights, weights, weights).ravel()


def _tetrahedron() -> tuple[Floats, Floats]:
    """Four points, exact to the second degree: P. C. Hammer and A. H. Stroud, Math. Tables 10 (1956) 137."""
    near = (5 - np.sqrt(5)) / 20
    points = np.full((4, 3), near)
    points[[1, 2, 3], [0, 1, 2]] = 1 - 3 * near
    return points, np.full(4, 1 / 24)


def _hexahedron8(point: Floats) -> Floats:
    return _trilinear(_CORNERS, point) / 8


def _trilinear(corners: Floats, point: Floats) -> Floats:
    """Derivatives of (1 + x_a x)(1 + y_a y)(1 + z_a z)."""
    factors = 1 + corners * point
    others = np.array([factors[:, 1] * factors[:, 2], factors[:, 2] * factors[:, 0], factors[:, 0] * factors[:, 1]]).T
    return np.asarray(corners * others)


def _hexahedron20(point: Floats) -> Floats:
    """Corners: product times (x_a x + y_a y + z_a z - 2)/8; middles of edges: (1 - x^2)(1 + y_a y)(1 + z_a z)/4."""
    along = _CORNERS @ point - 2
    product = np.prod(1 + _CORNERS * point, axis=1)
    corners = (_trilinear(_CORNERS, point) * along[:, None] + product[:, None] * _CORNERS) / 8
    middles = np.zeros((12, 3))
    for row, (a, b) in enumerate(_HEXAHEDRON_EDGES):
        place = 0.5 * (_CORNERS[a] + _CORNERS[b])
        axis = int(np.flatnonzero(place == 0)[0])
        factors = 1 + place * point
        factors[axis] = 1 - point[axis] ** 2
        slopes = place.copy()
        slopes[axis] = -2 * point[axis]
        for k in range(3):
            middles[row, k] = slopes[k] * np.prod(np.delete(factors, k)) / 4
    return np.concatenate([corners, middles])


_LINEAR = np.array([[-1, -1, -1], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)


def _tetrahedron4(_: Floats) -> Floats:
    return _LINEAR


def _tetrahedron10(point: Floats) -> Floats:
    """L (2 L - 1) at corners, 4 L_a L_b on edges, of the volume coordinates L."""
    volumes = np.array([1 - point.sum(), *point])
    corners = (4 * volumes - 1)[:, None] * _LINEAR
    edges = [4 * (volumes[a] * _LINEAR[b] + volumes[b] * _LINEAR[a]) for a, b in _TETRAHEDRON_EDGES]
    return np.concatenate([corners, np.array(edges)])
