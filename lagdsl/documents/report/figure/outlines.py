"""Outlines of the solids of a scene in a plane: the hull of each of their pieces."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np

from lagdsl.derivation.scene.forms import triangles
from lagdsl.derivation.scene.posed import placed
from lagdsl.foundation.numerics.connected_blocks import connected_blocks
from lagdsl.foundation.numerics.hull import hull
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.numerics.sparse_matrix import sparse


def outlines(form: str, matrix: Floats, project: Callable[[Floats], Floats]) -> list[list[Floats]]:
    """Closed lines around a unit form that `matrix` (4, 4) places, seen by `project`."""
    found = []
    for piece in _pieces(form):
        seen = np.array([project(point) for point in placed(piece, matrix)])
        rim = hull(seen)
        found.append([seen[k] for k in (*rim, rim[0])])
    return found


@cache
def _pieces(form: str) -> list[Floats]:
    """Points (n, 3) of the connected parts of a form."""
    mesh = triangles(form)
    touched = np.zeros((len(mesh.corners), len(mesh.points)), dtype=bool)
    np.put_along_axis(touched, mesh.corners, True, axis=1)
    labels = connected_blocks(sparse(touched)).column_labels
    return [mesh.points[labels == k] for k in np.unique(labels)]
