"""Is every coordinate given inertia, by the kinetic energy or by a constraint that ties it to one that has it?"""

from __future__ import annotations

import numpy as np

from lagdsl.diagnostics import Sink
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_points import Geometry, Probe, free_directions
from lagdsl.semantics.flat_model import FlatModel

# Smallest inertia in a direction the constraints leave free, relative to the largest, that still counts as inertia.
_TOLERANCE = 1e-12


def report_massless(flat: FlatModel, space: Geometry, points: list[Probe], sink: Sink) -> None:
    """E0503 for each coordinate that moves in a direction without inertia at every probed state.

    M itself may be singular (quaternions, massless links): what counts is M on the null space of J.
    """
    if not points or not flat.coordinates:
        return
    shares = np.full(len(flat.coordinates), np.inf)
    for point in points:
        shares = np.minimum(shares, _massless_shares(space, point))
    if float(np.max(shares)) < 1e-3:
        return
    leading = int(np.argmax(shares))
    for index, coordinate in enumerate(flat.coordinates):
        if shares[index] > 0.999 or (index == leading and not np.any(shares > 0.999)):
            why = f"the mass matrix is singular in this direction and no constraint determines der({coordinate.name})"
            span = coordinate.spans[0] if coordinate.spans else None
            sink.report("E0503", span, notes=(why,), name=coordinate.name)


def _massless_shares(space: Geometry, point: Probe) -> Floats:
    """How much of each coordinate's unit vector lies in the directions without inertia, 0 to 1."""
    diagonal = np.sqrt(np.abs(np.diag(point.mass)))
    largest = float(np.max(diagonal))
    scale = np.where(diagonal > 1e-9 * largest, 1.0 / np.where(diagonal > 0.0, diagonal, 1.0), space.sizes)
    free = free_directions(point.rows * (scale / space.sizes), space.parts(list(range(len(point.rows)))))
    values, directions = np.linalg.eigh(free.T @ ((point.mass * scale[:, None]) * scale) @ free)
    top = float(np.max(np.abs(values), initial=0.0))
    empty = free @ directions[:, np.abs(values) <= _TOLERANCE * top] if top > 0.0 else free
    return np.asarray(np.linalg.norm(empty, axis=1))
