"""Outlines of the solids of a scene in a plane: the hull of each of their pieces."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np

from lagdsl.derivation.scene.forms import triangles
from lagdsl.derivation.scene.posed import placed
from lagdsl.foundation.numerics.connected_blocks import connected_blocks
from lagdsl.foundation.numerics.rank import Floats


def outlines(form: str, matrix: Floats, project: Callable[[Floats], Floats]) -> list[list[Floats]]:
    """Closed lines around a unit form that `matrix` (4, 4) places, seen by `project`."""
    return [_hull([project(point) for point in placed(piece, matrix)]) for piece in _pieces(form)]


@cache
def _pieces(form: str) -> list[Floats]:
    """Points (n, 3) of the connected parts of a form."""
    mesh = triangles(form)
    touched = np.zeros((len(mesh.corners), len(mesh.points)), dtype=bool)
    np.put_along_axis(touched, mesh.corners, True, axis=1)
    labels = connected_blocks(touched).column_labels
    return [mesh.points[labels == k] for k in np.unique(labels)]


def _hull(points: list[Floats]) -> list[Floats]:
    """The convex hull, closed, counterclockwise (A. M. Andrew, Information Processing Letters 9 (1979) 216)."""
    ordered = sorted({(round(float(x), 12), round(float(y), 12)) for x, y in points})
    chain: list[tuple[float, float]] = []
    for way in (ordered, ordered[::-1]):
        kept = len(chain)
        for x, y in way:
            while len(chain) - kept >= 2:
                (ax, ay), (bx, by) = chain[-2:]
                if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 0.0:
                    break
                chain.pop()
            chain.append((x, y))
        chain.pop()
    return [np.array(point) for point in [*chain, chain[0]]] if chain else []
