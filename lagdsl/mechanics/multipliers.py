"""Which multipliers are eliminated with the accelerations, and which rows M needs to be invertible: from numbers at
points of the constraint set, as rows may depend on each other there and nowhere else.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from lagdsl.eliminate.pivots import weakest
from lagdsl.eliminate.rows import Row, Rows, components
from lagdsl.eliminate.solve import Factor
from lagdsl.graph.evaluate import evaluate
from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import Group
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure import Structure
from lagdsl.mechanics.structure_points import Geometry, Probe

# M is singular in directions whose inertia is below this part of the largest, in natural sizes.
_WEIGHTLESS = 1e-10
# Rows are added to M until every direction without inertia is held as well as by all rows, to this part.
_HELD = 0.2
# The least part of a multiplier's pivot, at the points looked at, with which it is eliminated.
_WELL_CONDITIONED = 1e-4


def choose_rows(graph: Graph, rows: Sequence[Row], structure: Structure) -> Rows:
    """Rows with content that depend on no others are solved for."""
    redundant = structure.redundant
    solved = tuple(row for row in rows if row.terms and not redundant[row.index])
    kept = tuple(row for row in rows if not row.terms or redundant[row.index])
    weights = _stiffened([row.index for row in solved], structure.space, structure.points)
    constants = {index: graph.constant(weight) for index, weight in weights.items()}
    return Rows(solved=solved, kept=kept, stiffened=constants)


def weak_rows(factor: Factor, structure: Structure) -> Rows | None:
    """The same with rows left to run time whose multipliers had a small pivot at some point; None where there are
    none."""
    rows, strengths = factor.rows, _at_points(factor, structure)
    weak = set[int]()
    for members in components(rows.solved):
        indices = [row.index for row in members]
        largest = np.max([strengths[index][1] / _usual(strengths[index][1]) for index in indices], axis=0)
        for index in indices:
            pivot, size = strengths[index]
            if not np.all(pivot / _usual(size) > _WELL_CONDITIONED * largest):
                weak.add(index)
    if not weak:
        return None
    order = sorted((*rows.kept, *(row for row in rows.solved if row.index in weak)), key=lambda row: row.index)
    return replace(rows, solved=tuple(row for row in rows.solved if row.index not in weak), kept=tuple(order))


def least_pivot(factor: Factor, structure: Structure) -> int:
    """What subtraction left of the smallest pivot, and how weakly a row holds against the others of its component.

    Rows are compared in their usual sizes: one that is short is no row in a singular position, whatever its direction.
    """
    usual = {index: _usual(size) for index, (_, size) in _at_points(factor, structure).items()}
    groups = [[row.index for row in members] for members in components(factor.rows.solved)]
    return weakest(factor.graph, factor.pivot, factor.strengths, usual, groups)


def _usual(sizes: Floats) -> float:
    """A power of two near the median: multiplying by it is exact."""
    return _power_of_two(float(np.median(sizes)))


def _at_points(factor: Factor, structure: Structure) -> dict[int, tuple[Floats, Floats]]:
    """Pivots and sizes of the solved multipliers, each by point (k,)."""
    nodes = [node for pair in factor.strengths.values() for node in pair]
    values = evaluate(factor.graph, nodes, _symbols(structure.space, structure.points))
    count = len(structure.points)
    found = [np.broadcast_to(np.asarray(value, dtype=np.float64), count) for value in values]
    return {index: (found[2 * i], found[2 * i + 1]) for i, index in enumerate(factor.strengths)}


def _symbols(space: Geometry, points: Sequence[Probe]) -> Mapping[Group, object]:
    return {
        Group.TIME: space.t,
        Group.Q: np.array([point.q for point in points]),
        Group.QD: space.qd,
        Group.Z: space.z,
        Group.U: space.u,
        Group.W: space.w,
        Group.P: space.p,
    }


# ---- M without inertia in some directions ---------------------------------------------------------------------------


def _stiffened(independent: Sequence[int], space: Geometry, points: Sequence[Probe]) -> dict[int, float]:
    """Inertia along rows: as few rows as hold what has no inertia, those with the fewest coordinates first."""
    masses = [point.mass * space.sizes[:, None] * space.sizes for point in points if point.mass is not None]
    free = [_weightless(mass) for mass in masses]
    if not any(directions.shape[1] for directions in free):
        return {}
    rows = [point.rows for point in points]
    reach = [at @ directions for at, directions in zip(rows, free, strict=True)]
    moved = np.max([np.max(np.abs(at), axis=1, initial=0.0) for at in reach], axis=0)
    candidates = [row for row in independent if moved[row] > 1e-6]
    candidates.sort(key=lambda row: (int(np.sum(space.pattern[row])), row))
    wanted = [_HELD * _hold(at[candidates]) for at in reach]
    chosen: list[int] = []
    for row in candidates:
        if all(_hold(at[chosen]) >= enough for at, enough in zip(reach, wanted, strict=True)):
            break
        chosen.append(row)
    inertia = np.median([np.diag(mass) for mass in masses], axis=0)
    return {
        row: _power_of_two(float(np.max(inertia[space.pattern[row]])) / float(space.row_sizes[row]) ** 2)
        for row in sorted(chosen)
    }


def _weightless(mass: Floats) -> Floats:
    """Orthonormal directions in which M vanishes; columns."""
    values, directions = np.linalg.eigh(mass)
    return np.asarray(directions[:, values <= _WEIGHTLESS * values[-1]])


def _hold(reach: Floats) -> float:
    """The least that the rows (m, k) give of a direction; 1 without directions."""
    count, directions = reach.shape
    if count < directions:
        return 0.0
    return float(np.linalg.svd(reach, compute_uv=False)[-1]) if directions else 1.0


def _power_of_two(value: float) -> float:
    return float(2.0 ** np.round(np.log2(value))) if 0.0 < value < np.inf else 1.0
