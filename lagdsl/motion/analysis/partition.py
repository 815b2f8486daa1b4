"""Minimal coordinates by partitioning: which coordinates and rates are independent, and how the others follow them.

With the constraints phi(q, t) = 0 and c = J qd + b = 0, independent coordinates y = q[position] and rates
v = qd[rate] are a chart of the constraint set: near a regular point every other coordinate and rate is a function of
them. dq = N dy spans the tangent space of the position rows, dqd = V dv that of all rows.
Source: Wehage and Haug, Generalized coordinate partitioning for dimension reduction in analysis of constrained dynamic
systems, Journal of Mechanical Design 104 (1982) 247-255.
"""

from __future__ import annotations

from collections.abc import Container, Sequence
from dataclasses import dataclass, replace

import numpy as np

from lagdsl.derivation.structure.names import balanced_coordinates, contact_rows
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats, rank
from lagdsl.motion.analysis.point import Directions, Point, System, constraint_changes, coordinate_sizes

# Of coordinates that can be left out equally well, the last ones are.
_PREFERENCE = 1e-3
_LIGHT = 1e3
_DEPENDS = 1e-8
# A row this much shorter than the longest has no content.
_VANISHES = 1e-12
# Ranks of a mode are looked at so many points, so far beside, as a part of the natural sizes.
_POINTS = 3
_BESIDE = 0.1
_SEED = 17


@dataclass(frozen=True, slots=True)
class Partition:
    """Indices of the independent coordinates and rates, in the order of the layout; J with its position rows.

    `held` are the rows that restrict positions: those of position level and integrable ones of velocity level.
    """

    position: tuple[int, ...]
    rate: tuple[int, ...]
    held: tuple[int, ...]
    jacobian: Floats
    sizes: Floats

    def position_following(self, right: Floats) -> Floats:
        """dq (nq, k) that is zero in the independent coordinates and has J dq = right (rows `held`, k)."""
        return self._following(self.jacobian[list(self.held)], self.position, right)

    def rate_following(self, right: Floats) -> Floats:
        """dqd (nq, k) that is zero in the independent rates and has J dqd = right (nc, k)."""
        return self._following(self.jacobian, self.rate, right)

    def _following(self, rows: Floats, independent: tuple[int, ...], right: Floats) -> Floats:
        n = len(self.sizes)
        dependent = [j for j in range(n) if j not in set(independent)]
        result = np.zeros((n, right.shape[1]))
        if dependent and len(rows):
            lengths = _powers_of_two(_lengths(rows * self.sizes))
            matrix = (rows * self.sizes / lengths[:, None])[:, dependent]
            result[dependent] = self.sizes[dependent, None] * _solved(matrix, right / lengths[:, None])
        return result


def partition(system: System, point: Point, held: Sequence[int], sink: Sink) -> Partition | None:
    """The chart about `point`; E0850 where the constraints lose rank, so that there is none. Rows of contacts and of
    friction that depend on each other in all of a mode lose none."""
    layout = system.engine.layout
    sizes = coordinate_sizes(system, point.p)
    jacobian = system.engine.evaluate("velocity_constraint", *point.arguments)[1]
    rows = jacobian * sizes
    rows = rows / _lengths(rows)[:, None]
    away = [row for row in contact_rows(system.flat) if not np.any(rows[row])]  # of open contacts
    kept = [row for row, redundant in enumerate(layout.redundant) if not redundant and row not in away]
    if rank(rows, _DEPENDS) < len(kept) and _lost(system, point, sizes, kept):
        slack = [layout.constraints[row].name for row in kept]
        sink.report("E0850", None, names=", ".join(f"`{name}`" for name in slack))
        return None
    place = list(range(len(sizes)))
    light = balanced_coordinates(system.flat)
    dependent = _dependent(rows[list(held)], place, light)
    position = [j for j in place if j not in set(dependent)]
    # The rows of velocity level restrict the rates of independent coordinates to this space.
    tangent = _null_basis(rows[list(held)], dependent, position)
    further = _dependent(rows @ tangent, position, light)
    rate = [j for j in position if j not in set(further)]
    return Partition(tuple(position), tuple(rate), tuple(held), jacobian, sizes)


def _lost(system: System, point: Point, sizes: Floats, kept: Sequence[int]) -> bool:
    """True if `kept` rows, which depend on each other here, do not so everywhere. Contacts and friction may have such
    rows in all of a mode, as the legs of a table have: these share their forces."""
    if not contact_rows(system.flat) & set(kept):
        return True
    chance = np.random.default_rng(_SEED)
    beside = [replace(point, q=point.q + _BESIDE * sizes * chance.uniform(-1, 1, len(sizes))) for _ in range(_POINTS)]
    ranks = []
    for at in (point, *beside):
        rows = system.engine.evaluate("velocity_constraint", *at.arguments)[1][list(kept)] * sizes
        ranks.append(rank(rows / _lengths(rows)[:, None], _DEPENDS) if np.isfinite(rows).all() else 0)
    return max(ranks) > ranks[0]


def position_basis(chosen: Partition) -> Floats:
    """N (nq, count): dq = N dy."""
    unit = np.eye(len(chosen.sizes))[:, list(chosen.position)]
    return unit + chosen.position_following(-chosen.jacobian[list(chosen.held)] @ unit)


def directions(system: System, point: Point, chosen: Partition, inputs: int) -> Directions:
    """One direction for each independent coordinate, rate, state and input, continued onto the constraints.

    Positions obey J dq = -dphi/du du, rates J dqd = -(d(J qd + b)/dq dq + ...).
    """
    n, nz = len(point.q), len(point.z)
    free, fast = len(chosen.position), len(chosen.rate)
    total = free + fast + nz + inputs
    q, qd, z, u = np.zeros((total, n)), np.zeros((total, n)), np.zeros((total, nz)), np.zeros((total, inputs))
    q[:free] = position_basis(chosen).T
    qd[free + np.arange(fast), list(chosen.rate)] = 1.0
    z[free + fast : free + fast + nz] = np.eye(nz)
    u[free + fast + nz :] = np.eye(inputs)
    if len(chosen.jacobian):
        moved = constraint_changes(system, point, Directions(q=np.zeros_like(q), qd=np.zeros_like(q), z=z, u=u))[0]
        q += chosen.position_following(-moved.T[list(chosen.held)]).T
        drift = constraint_changes(system, point, Directions(q=q, qd=qd, z=z, u=u))[1]
        qd += chosen.rate_following(-drift.T).T
    return Directions(q=q, qd=qd, z=z, u=u)


def _solved(matrix: Floats, right: Floats) -> Floats:
    """Of full column rank; rows that depend on others agree with them. By elimination in rows that do not: what cancels
    between rows of ones, as currents of a node, leaves no round-off."""
    rows = _dependent(matrix.T, range(len(matrix)))
    if len(rows) == matrix.shape[1]:
        return np.asarray(np.linalg.solve(matrix[rows], right[rows]))
    return np.asarray(np.linalg.lstsq(matrix, right, rcond=1e-12)[0])


def _lengths(rows: Floats) -> Floats:
    """Lengths of the rows; infinite for a row that vanishes on the constraints: its direction is round-off."""
    lengths = np.linalg.norm(rows, axis=1)
    return np.where(lengths > _VANISHES * np.max(lengths, initial=0.0), lengths, np.inf)


def _powers_of_two(lengths: Floats) -> Floats:
    """The next larger ones: a division by them does not round."""
    return np.ldexp(1.0, np.frexp(lengths)[1])


def _dependent(rows: Floats, place: Sequence[int], light: Container[int] = ()) -> list[int]:
    """Of the columns, which belong to `place`, as many as the rank says: the best conditioned ones, of `light` ones
    before others. The rate of a coordinate without inertia is no state: it jumps where forces do."""
    from scipy.linalg import qr

    if not rows.size:
        return []
    # Absolute: rows have unit length, and what is left of those that hold already is round-off.
    count = int(np.count_nonzero(np.linalg.svd(rows, compute_uv=False) > _DEPENDS))
    weights = 1.0 + _PREFERENCE * np.arange(rows.shape[1]) / rows.shape[1]
    weights[[j in light for j in place]] *= _LIGHT
    order = qr(rows * weights, mode="r", pivoting=True)[1]
    return sorted(place[j] for j in order[:count])


def _null_basis(rows: Floats, dependent: Sequence[int], independent: Sequence[int]) -> Floats:
    basis = np.zeros((rows.shape[1], len(independent)))
    basis[list(independent), np.arange(len(independent))] = 1.0
    if dependent:
        basis[list(dependent)] = _solved(rows[:, list(dependent)], -rows[:, list(independent)])
    return basis
