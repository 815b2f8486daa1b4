"""Is every coordinate given inertia, by the kinetic energy or by a constraint that ties it to one that has it?"""

from __future__ import annotations

import numpy as np

from lagdsl.derivation.structure.names import listed
from lagdsl.derivation.structure.points import Geometry, Probe
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.connected_blocks import Flags, connected_blocks
from lagdsl.foundation.numerics.part_by_part import free_directions, is_positive_definite
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.numerics.sparse_matrix import SparseMatrix
from lagdsl.foundation.numerics.sparse_pivots import FEW, independent
from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import CHARGE
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.spans import around, place

# Smallest inertia in a direction the constraints leave free, relative to the largest, that still counts as inertia.
_TOLERANCE = 1e-12
# Part of a direction that a coordinate needs to be told, and to be told alone.
_SHARE = 1e-3
_ALONE = 0.999
_MOST_SHOWN = 6
_INDUCTANCE = (
    "every closed path of charge needs an inductance, a resistance or a capacitance: put a resistor into this loop, as "
    "its wire is one"
)
_FLANGE = "connect it to what moves with it and has a mass or an inertia, or prescribe its motion"


@record()
class Massless:
    """Directions without inertia that the constraints leave free, at the first probed point: `basis` (nq, m) in
    coordinates divided by `sizes` (nq,), orthonormal. `shares` (nq,) are the least parts of the coordinates in
    them at any point."""

    basis: Floats
    sizes: Floats
    shares: Floats


def massless(flat: FlatModel, space: Geometry, points: list[Probe]) -> Massless | None:
    """None where M is regular on the null space of J at some probed state, which is what counts: M itself may be
    singular (quaternions, massless links)."""
    masses = [point.mass for point in points if point.mass is not None]
    if len(masses) < max(len(points), 1) or not flat.coordinates:
        return None
    if all(_shows_inertia(space, point, mass) for point, mass in zip(points, masses, strict=True)):
        return None
    found = [_directions(space, point, mass) for point, mass in zip(points, masses, strict=True)]
    shares = np.min([np.linalg.norm(basis, axis=1) for basis, _ in found], axis=0)
    return Massless(*found[0], shares) if float(np.max(shares)) >= _SHARE else None


def report_massless(flat: FlatModel, found: Massless, sink: Sink) -> None:
    """E0503 for each coordinate that moves in a direction without inertia at every probed state."""
    leading = int(np.argmax(found.shares))
    projector = found.basis @ found.basis.T
    for index in range(len(flat.coordinates)):
        if found.shares[index] > _ALONE or (index == leading and not np.any(found.shares > _ALONE)):
            parts = np.abs(projector[index])
            names = [f"der({flat.coordinates[i].name})" for i in np.flatnonzero(parts > 0.1 * parts[index])]
            why = f"the mass matrix is singular in this direction and no constraint determines {names[0]}"
            if len(names) > 1:
                why = f"{some_of(names)} can change together without kinetic energy"
            report_direction(flat, index, why, sink)


def some_of(names: list[str]) -> str:
    """`der(a), der(b) and der(c)`; of many the first few."""
    return listed(names if len(names) <= _MOST_SHOWN else [*names[:_MOST_SHOWN], "more"])


def report_direction(flat: FlatModel, index: int, why: str, sink: Sink, help: str | None = None) -> None:
    """E0503 at the coordinate of this number."""
    coordinate = flat.coordinates[index]
    labels = around(coordinate)
    known = _INDUCTANCE if coordinate.dimension == CHARGE else _FLANGE if labels else None
    sink.report("E0503", place(coordinate), *labels, notes=(why,), help=help or known, name=coordinate.name)


def _shows_inertia(space: Geometry, point: Probe, mass: SparseMatrix) -> bool:
    """True if coordinates without a mass follow from the rows, and M of the others is positive definite on the null
    space of rows that tie coordinates of one block of it, as that of a unit quaternion. Of many coordinates only: the
    directions that are free need not be formed then."""
    if len(mass) <= FEW:
        return False
    heavy = mass.diagonal() > 0.0
    moved = np.flatnonzero(heavy)
    if np.any(mass.values[~heavy[mass.rows]]):
        return False
    own = mass.taken(moved, moved)
    if not is_positive_definite(own) and not is_positive_definite(own, _within_blocks(space, point, own, heavy)):
        return False
    return independent(point.rows.transposed().taken(np.flatnonzero(~heavy)))


def _within_blocks(space: Geometry, point: Probe, mass: SparseMatrix, heavy: Flags) -> SparseMatrix:
    """The rows of J, in coordinates, with all entries in one block of M; `mass` is that of the heavy ones."""
    count = len(point.rows)
    labels = np.full(len(heavy), -1, dtype=np.intp)
    labels[heavy] = connected_blocks(mass.nonzero()).column_labels
    rows = point.rows.with_values(point.rows.values / space.sizes[point.rows.columns]).nonzero()
    least, largest = np.full(count, len(heavy), dtype=np.intp), np.full(count, -1, dtype=np.intp)
    np.minimum.at(least, rows.rows, labels[rows.columns])
    np.maximum.at(largest, rows.rows, labels[rows.columns])
    return rows.taken(np.flatnonzero((least == largest) & (least >= 0)), np.flatnonzero(heavy))


def _directions(space: Geometry, point: Probe, inertia: SparseMatrix) -> tuple[Floats, Floats]:
    """The directions without inertia by columns, orthonormal in coordinates divided by the sizes, which come second."""
    mass = inertia.dense()
    diagonal = np.sqrt(np.abs(np.diag(mass)))
    tied = np.max(
        np.where(mass != 0.0, diagonal, 0.0), axis=1
    )  # of the coordinates that M ties to each, itself included
    heavy = np.where(diagonal > 1e-9 * tied, diagonal, 0.0)
    scale = np.where(heavy > 0.0, 1.0 / np.where(heavy > 0.0, heavy, 1.0), _beside(space, heavy))
    rows = point.rows.with_values(point.rows.values * (scale / space.sizes)[point.rows.columns])
    free = free_directions(rows, space.parts(list(range(len(rows)))))
    values, directions = np.linalg.eigh(free.T @ ((mass * scale[:, None]) * scale) @ free)
    top = float(np.max(np.abs(values), initial=0.0))
    return free @ directions[:, np.abs(values) <= _TOLERANCE * top] if top > 0.0 else free, scale


def _beside(space: Geometry, diagonal: Floats) -> Floats:
    """Scales of coordinates without inertia (nq,), so that a change of one weighs no more than where they have the
    smallest inertia of their component: henries of a circuit may be far from kilograms. `diagonal`: square roots."""
    sizes = diagonal * space.sizes
    least = np.full(int(np.max(space.components, initial=0)) + 1, np.inf)
    np.minimum.at(least, space.components[sizes > 0.0], sizes[sizes > 0.0])
    return np.asarray(space.sizes / np.where(np.isfinite(least), least, 1.0)[space.components])
