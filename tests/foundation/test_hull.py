"""Convex hulls of points in a plane."""

from __future__ import annotations

import numpy as np
from scipy.spatial import ConvexHull

from lagdsl.foundation.numerics.hull import hull


def test_corners_are_those_of_another_algorithm() -> None:
    """Quickhull of Qhull, which gives them counterclockwise too."""
    points = np.random.default_rng(3).normal(size=(60, 2))
    found, other = hull(points), ConvexHull(points).vertices.tolist()
    start = other.index(found[0])
    assert found == other[start:] + other[:start]


def test_points_on_edges_equal_ones_and_lines_have_no_corners_of_their_own() -> None:
    square = np.array([[0, 0], [1, 0], [2, 0], [2, 2], [0, 2], [2, 2], [0, 1]], dtype=np.float64)
    assert hull(square) == [0, 2, 3, 4]
    assert hull(square[:3]) == [0, 2]
    assert hull(square[:1]) == [0]
