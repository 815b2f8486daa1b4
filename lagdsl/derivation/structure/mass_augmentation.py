"""Rows that give M the inertia that it lacks: along a quaternion, or of members of a loop without mass.

M + J' W J of some rows is regular where the constrained system is, and accelerations and multipliers stay the same if
J' W gamma is added to the forces. Few rows are taken, since each couples its coordinates; and so many that no position
of the loop is a singular one for them alone.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.derivation.structure.points import Geometry, Probe
from lagdsl.foundation.numerics.connected_blocks import Indices, connected_blocks, entries
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.numerics.sparse_matrix import SparseMatrix, beside, product, sparse

# M, scaled to a unit diagonal, is singular in directions with eigenvalues below this.
_WEIGHTLESS = 1e-10
# Rows are taken until every direction without inertia is held as well as by all rows, to this part.
_HELD = 0.2
# A row, of size one, that gives less than this part does not hold a direction.
_NOTHING = 1e-6


def stiffened(
    independent: Sequence[int], space: Geometry, points: Sequence[Probe], exchanged: Sequence[tuple[int, int]]
) -> dict[int, float]:
    """Inertia by row, in its unit: about that of the coordinates it moves. Rows with few coordinates come first.

    `exchanged` are rows, each with the coordinate that it gives: neither takes part.
    """
    left = np.delete(np.arange(len(space.q)), [column for _, column in exchanged])
    known = [(point.rows, point.mass) for point in points if point.mass is not None]
    masses = {id(mass): mass for _, mass in known}  # points may share a constant one
    weightless = {key: _weightless(mass.taken(left, left), space.sizes[left]) for key, mass in masses.items()}
    free = [weightless[id(mass)] for _, mass in known]
    if not any(directions.shape[1] for directions in free):
        return {}
    reach = [
        product(_without(rows, exchanged).taken(np.arange(len(rows)), left), directions)
        for (rows, _), directions in zip(known, free, strict=True)
    ]
    longest = np.max([at.largest() for at in reach], axis=0)
    candidates = [row for row in independent if longest[row] > _NOTHING]
    counts = space.pattern.counts()
    candidates.sort(key=lambda row: (int(counts[row]), row))
    ranks = [int(np.sum(_held(at, candidates) > _NOTHING)) for at in reach]
    chosen: list[int] = []
    for row in candidates:
        if all(_holds(at, chosen, candidates, rank) for at, rank in zip(reach, ranks, strict=True)):
            break
        chosen.append(row)
    inertia = np.median([mass.diagonal() for _, mass in known], axis=0) * space.sizes**2
    moved = {row: _moved(space, row, inertia) for row in sorted(chosen)}
    return {row: power_of_two(own / float(space.row_sizes[row]) ** 2) for row, own in moved.items()}


def _without(rows: SparseMatrix, exchanged: Sequence[tuple[int, int]]) -> SparseMatrix:
    """Rows in which the exchanged coordinates are expressed by the others."""
    if not exchanged:
        return rows
    dense = rows.dense()
    for row, column in exchanged:
        users = np.flatnonzero(dense[:, column])
        users = users[users != row]
        dense[users] -= np.outer(dense[users, column] / dense[row, column], dense[row])
    return sparse(dense)


def _moved(space: Geometry, row: int, inertia: Floats) -> float:
    """The largest inertia of the coordinates in the row, else in their component, else of all."""
    own = space.pattern.row(row) != 0.0
    beside = np.isin(space.components, space.components[own])
    among = [float(np.max(inertia[which], initial=0.0)) for which in (own, beside, np.ones_like(own))]
    return next((found for found in among if found > 0.0), 1.0)


def _weightless(mass: SparseMatrix, sizes: Floats) -> SparseMatrix:
    """Orthonormal columns, in natural sizes, that span the directions in which M vanishes."""
    diagonal = np.abs(mass.diagonal())
    heavy = diagonal > _WEIGHTLESS**2 * np.max(diagonal, initial=0.0)
    scale = np.where(heavy, 1.0 / np.sqrt(np.where(heavy, diagonal, 1.0)), 1.0)
    own = mass.only(heavy[mass.rows] & heavy[mass.columns])
    scaled = own.with_values(own.values * scale[own.rows] * scale[own.columns]).nonzero()
    found = [sparse(np.zeros((len(mass), 0)))]
    for parts in connected_blocks(_with_diagonal(scaled)).parts:
        blocks = entries(scaled, parts)
        try:  # ten times faster than eigenvalues, and mostly all that is needed
            np.linalg.cholesky(blocks - _WEIGHTLESS * np.eye(blocks.shape[1]))
        except np.linalg.LinAlgError:
            values, directions = np.linalg.eigh(blocks)
            for block in np.flatnonzero(values[:, 0] <= _WEIGHTLESS):
                members = parts.columns[block]
                columns = (scale / sizes)[members, None] * directions[block][:, values[block] <= _WEIGHTLESS]
                found.append(_orthonormal(columns, members, len(mass)))
    return beside(found)


def _orthonormal(columns: Floats, members: Indices, count: int) -> SparseMatrix:
    """An orthonormal basis of the columns (k, m), which stand in these of `count` rows."""
    basis = np.linalg.qr(columns / np.linalg.norm(columns, axis=0))[0]
    rows, numbers = np.indices(basis.shape)
    return SparseMatrix((count, basis.shape[1]), members[rows.ravel()], numbers.ravel(), basis.ravel())


def _with_diagonal(matrix: SparseMatrix) -> SparseMatrix:
    """With entries on all of the diagonal: every row is in a part."""
    empty = np.flatnonzero(matrix.diagonal() == 0.0)
    rows, columns = np.concatenate([matrix.rows, empty]), np.concatenate([matrix.columns, empty])
    return SparseMatrix(matrix.shape, rows, columns, np.concatenate([matrix.values, np.zeros(len(empty))]))


def _held(reach: SparseMatrix, rows: Sequence[int]) -> Floats:
    """Singular values of directions in the rows, the largest first."""
    own = reach.taken(list(rows)).nonzero()
    blocks = [np.linalg.svd(entries(own, parts), compute_uv=False).ravel() for parts in connected_blocks(own).parts]
    values = np.zeros(min(own.shape))
    found = np.concatenate([np.zeros(0), *blocks])
    values[: len(found)] = np.sort(found)[::-1]
    return values


def _holds(reach: SparseMatrix, chosen: Sequence[int], candidates: Sequence[int], rank: int) -> bool:
    """True if the chosen rows hold `rank` directions, nearly as well as all candidates do."""
    if not rank:
        return True
    return len(chosen) >= rank and bool(_held(reach, chosen)[rank - 1] >= _HELD * _held(reach, candidates)[rank - 1])


def power_of_two(value: float) -> float:
    """The nearest one: multiplying by it is exact."""
    return float(2.0 ** np.round(np.log2(value))) if 0.0 < value < np.inf else 1.0
