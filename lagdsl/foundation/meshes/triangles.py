"""Triangles of a surface, and fewer of them that look alike."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

Integers: TypeAlias = npt.NDArray[np.int64]

MOST_TRIANGLES = 2_000_000
_FARTHEST = 1e12
_FINEST = 1024


class MeshError(Exception):
    """A file holds no surface that can be drawn; the text says why, for behind a colon."""


@record(kw_only=True)
class Triangles:
    """`points` (n, 3) in units of the file, `corners` (m, 3): the points of each triangle, counterclockwise from
    outside."""

    points: Floats
    corners: Integers


def triangles(points: Floats, corners: Integers) -> Triangles:
    """Equal points become one, triangles without area leave. Raises MeshError where nothing to draw is left."""
    if len(corners) > MOST_TRIANGLES:
        raise MeshError(f"it has more than {MOST_TRIANGLES:,} triangles".replace(",", " "))
    if corners.size and not (corners.min() >= 0 and corners.max() < len(points)):
        raise MeshError("a triangle has a point that the file does not have")
    used = points[corners.ravel()]
    if not np.all(np.abs(used) < _FARTHEST):
        raise MeshError("a coordinate of a point is no finite number below 1e12")
    found, places = np.unique(used.astype(np.float32).astype(np.float64), axis=0, return_inverse=True)
    made = _proper(places.reshape(-1, 3))
    if len(made) == 0:
        raise MeshError("it has no triangle")
    return Triangles(points=found, corners=made)


def _proper(corners: Integers) -> Integers:
    """Triangles with three points, each once."""
    a, b, c = corners.T
    kept = corners[(a != b) & (b != c) & (c != a)]
    first = np.argmin(kept, axis=1) if len(kept) else np.zeros(0, dtype=np.int64)
    turned = np.take_along_axis(kept, (first[:, None] + np.arange(3)) % 3, axis=1)
    return np.unique(turned, axis=0)


def thinned(mesh: Triangles, most: int) -> Triangles:
    """At most so many triangles: points in one cell of a grid become their mean (Rossignac and Borrel 1993)."""
    if len(mesh.corners) <= most:
        return mesh
    low, high = 1, _FINEST
    best = _clustered(mesh, low)
    while high - low > 1:
        middle = (low + high) // 2
        made = _clustered(mesh, middle)
        if len(made.corners) <= most:
            low, best = middle, made
        else:
            high = middle
    return best


def _clustered(mesh: Triangles, cells: int) -> Triangles:
    """`cells` of the grid lie along the longest edge of the box around the mesh."""
    low = mesh.points.min(axis=0)
    cell = float(np.ptp(mesh.points, axis=0).max()) / cells
    places = np.minimum((mesh.points - low) / cell, cells - 1).astype(np.int64)
    _, group = np.unique(places @ np.array([1, cells, cells * cells]), return_inverse=True)
    group = group.ravel()
    count = np.bincount(group)
    means = np.stack([np.bincount(group, weights=mesh.points[:, k]) / count for k in range(3)], axis=1)
    return Triangles(points=means, corners=_proper(group[mesh.corners]))
