"""Is every coordinate given inertia, by the kinetic energy or by a constraint that ties it to one that has it?"""

from __future__ import annotations

import numpy as np

from lagdsl.derivation.structure.points import Geometry, Probe, free_directions
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.connected_blocks import connected_blocks, entries
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.numerics.sparse_pivots import FEW, independent
from lagdsl.foundation.units.dimension import CHARGE
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.spans import around, place

# Smallest inertia in a direction the constraints leave free, relative to the largest, that still counts as inertia.
_TOLERANCE = 1e-12
# Eigenvalues of M, scaled to a unit diagonal, that are surely inertia.
_SAFE = 1e-6
_MOST_SHOWN = 6
_INDUCTANCE = (
    "every closed path of charge needs an inductance: put an inductor into this loop, as its wire is one, with a time "
    "L/R much shorter than what matters"
)
_FLANGE = "connect it to what moves with it and has a mass or an inertia, or prescribe its motion"


def report_massless(flat: FlatModel, space: Geometry, points: list[Probe], sink: Sink) -> None:
    """E0503 for each coordinate that moves in a direction without inertia at every probed state.

    M itself may be singular (quaternions, massless links): what counts is M on the null space of J.
    """
    masses = [point.mass for point in points if point.mass is not None]
    if len(masses) < max(len(points), 1) or not flat.coordinates:
        return
    if all(_shows_inertia(point, mass) for point, mass in zip(points, masses, strict=True)):
        return
    projectors = [_massless(space, point, mass) for point, mass in zip(points, masses, strict=True)]
    shares = np.min([np.sqrt(np.diag(each)) for each in projectors], axis=0)
    if float(np.max(shares)) < 1e-3:
        return
    leading = int(np.argmax(shares))
    for index in range(len(flat.coordinates)):
        if shares[index] > 0.999 or (index == leading and not np.any(shares > 0.999)):
            parts = np.abs(projectors[0][index])
            _report(flat, index, [int(i) for i in np.flatnonzero(parts > 0.1 * parts[index])], sink)


def _report(flat: FlatModel, index: int, together: list[int], sink: Sink) -> None:
    """`together`: the coordinates that move along, this one included."""
    coordinate = flat.coordinates[index]
    rates = [f"der({flat.coordinates[i].name})" for i in together]
    why = f"the mass matrix is singular in this direction and no constraint determines {rates[0]}"
    if len(rates) > 1:
        shown = rates if len(rates) <= _MOST_SHOWN else [*rates[:_MOST_SHOWN], "more"]
        why = f"{', '.join(shown[:-1])} and {shown[-1]} can change together without kinetic energy"
    labels = around(coordinate)
    help = _INDUCTANCE if coordinate.dimension == CHARGE else _FLANGE if labels else None
    sink.report("E0503", place(coordinate), *labels, notes=(why,), help=help, name=coordinate.name)


def _shows_inertia(point: Probe, mass: Floats) -> bool:
    """True if coordinates without a mass follow from the rows, and M of the others is positive definite. Of many
    coordinates only: the directions that are free need not be formed then."""
    if len(mass) <= FEW:
        return False
    heavy = np.diag(mass) > 0.0
    if np.any(mass[~heavy]):
        return False
    own = mass[np.ix_(heavy, heavy)]
    scale = 1.0 / np.sqrt(np.diag(own))
    own = own * scale[:, None] * scale
    for parts in connected_blocks(own != 0.0).parts:
        try:
            np.linalg.cholesky(entries(own, parts) - _SAFE * np.eye(parts.rows.shape[1]))
        except np.linalg.LinAlgError:
            return False
    return independent(point.rows[:, ~heavy].T)


def _massless(space: Geometry, point: Probe, mass: Floats) -> Floats:
    """The projector onto the directions without inertia; its diagonal has the squares of the coordinates' shares."""
    diagonal = np.sqrt(np.abs(np.diag(mass)))
    tied = np.max(
        np.where(mass != 0.0, diagonal, 0.0), axis=1
    )  # of the coordinates that M ties to each, itself included
    heavy = np.where(diagonal > 1e-9 * tied, diagonal, 0.0)
    scale = np.where(heavy > 0.0, 1.0 / np.where(heavy > 0.0, heavy, 1.0), _beside(space, heavy))
    free = free_directions(point.rows * (scale / space.sizes), space.parts(list(range(len(point.rows)))))
    values, directions = np.linalg.eigh(free.T @ ((mass * scale[:, None]) * scale) @ free)
    top = float(np.max(np.abs(values), initial=0.0))
    empty = free @ directions[:, np.abs(values) <= _TOLERANCE * top] if top > 0.0 else free
    return np.asarray(empty @ empty.T)


def _beside(space: Geometry, diagonal: Floats) -> Floats:
    """Scales of coordinates without inertia (nq,), so that a change of one weighs no more than where they have the
    smallest inertia of their component: henries of a circuit may be far from kilograms. `diagonal`: square roots."""
    sizes = diagonal * space.sizes
    least = np.full(int(np.max(space.components, initial=0)) + 1, np.inf)
    np.minimum.at(least, space.components[sizes > 0.0], sizes[sizes > 0.0])
    return np.asarray(space.sizes / np.where(np.isfinite(least), least, 1.0)[space.components])
