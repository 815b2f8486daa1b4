"""The lecture's count: 3N + 6B coordinates in space, less the independent restrictions, are the degrees of freedom."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sympy import Expr, Symbol

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.textbook.contributions import Contributions
from lagdsl.derivation.textbook.differentiate import partial
from lagdsl.derivation.textbook.symbols import Symbols
from lagdsl.derivation.textbook.to_graph import ToGraph
from lagdsl.language.flat.model import FlatModel

_SEED = 20
_RANK_TOLERANCE = 1e-7


@dataclass(frozen=True, slots=True, kw_only=True)
class Count:
    """`placing` coordinates move a particle or body, `other` (charges, volumes) do not; `normalisations` are the
    unit length conditions of quaternions, which restrict nothing. Ranks are those of the declared rows at a general
    point."""

    particles: int
    bodies: int
    placing: int
    other: int
    normalisations: int
    position_rows: int
    position_rank: int
    rows: int
    rank: int

    @property
    def in_space(self) -> int:
        return 3 * self.particles + 6 * self.bodies

    @property
    def built_in(self) -> int:
        """Restrictions that the choice of coordinates takes care of; negative where they are more than needed."""
        return self.in_space - (self.placing - self.normalisations)

    @property
    def declared(self) -> int:
        """Independent declared restrictions of the configuration."""
        return self.position_rank - self.normalisations

    @property
    def freedom(self) -> int:
        """Degrees of freedom of the configuration."""
        return self.placing + self.other - self.position_rank

    @property
    def velocity_freedom(self) -> int:
        return self.placing + self.other - self.rank


def count(
    flat: FlatModel,
    table: Symbols,
    parts: Contributions,
    constants: Sequence[tuple[Symbol, Expr]],
    residuals: Sequence[Expr],
    velocities: Sequence[Expr],
) -> Count:
    """`residuals` of the position rows and `velocities` (J qd + b) of all rows that always hold, in the symbols of
    the model and in `constants`, each defined by those before it."""
    moving = frozenset().union(*(x.free_symbols for item in parts.inertials for x in (*item.position, *item.spin)))
    placing = sum(1 for q, qd in zip(table.q, table.qd, strict=True) if q in moving or qd in moving)
    levels = [constraint.level for constraint in flat.constraints if not constraint.of_law for _ in constraint.rows]
    position = [velocity for velocity, level in zip(velocities, levels, strict=True) if level == "position"]
    ranks = _Ranks(flat, table, constants)
    return Count(
        particles=len(flat.masses),
        bodies=len(flat.bodies),
        placing=placing,
        other=len(table.q) - placing,
        normalisations=sum(1 for constraint in flat.constraints if constraint.normalisation),
        position_rows=len(position),
        position_rank=ranks.of(residuals, position),
        rows=len(velocities),
        rank=ranks.of(residuals, velocities),
    )


class _Ranks:
    """Ranks of constraint rows at a general point near the starts where the position rows hold."""

    def __init__(self, flat: FlatModel, table: Symbols, constants: Sequence[tuple[Symbol, Expr]]) -> None:
        self._graph = Graph()
        self._table = table
        nodes = {table.time: self._graph.symbol(Group.TIME)}
        groups = {
            Group.Q: table.q,
            Group.QD: table.qd,
            Group.Z: table.z,
            Group.U: table.u,
            Group.W: table.w,
            Group.P: table.p,
        }
        for group, members in groups.items():
            nodes |= {symbol: self._graph.symbol(group, index) for index, symbol in enumerate(members)}
        self._to_graph = ToGraph(self._graph, nodes)
        for symbol, value in constants:
            self._to_graph.define(symbol, value)
        self._parameters = [p.value for p in flat.parameters if not p.structural]

    def of(self, residuals: Sequence[Expr], velocities: Sequence[Expr]) -> int:
        if not velocities:
            return 0
        qd = self._table.qd
        rows = [self._to_graph.node(partial(velocity, rate)) for velocity in velocities for rate in qd]
        jacobian = self._values(rows, self._project(residuals)).reshape(len(velocities), len(qd))
        if not np.all(np.isfinite(jacobian)):
            return len(velocities)
        sizes = np.linalg.norm(jacobian, axis=1)
        scaled = jacobian / np.where(sizes > 0, sizes, 1.0)[:, None]
        return int(np.sum(np.linalg.svd(scaled, compute_uv=False) > _RANK_TOLERANCE))

    def _project(self, residuals: Sequence[Expr]) -> NDArray[np.float64]:
        """Newton's method in minimum norm from a random point; where it fails the rank is taken where it ended."""
        q: NDArray[np.float64] = 0.5 + 0.5 * np.random.default_rng(_SEED).random(len(self._table.q))
        phi = [self._to_graph.node(residual) for residual in residuals]
        slopes = [self._to_graph.node(partial(residual, x)) for residual in residuals for x in self._table.q]
        for _ in range(30 if residuals else 0):
            value = self._values(phi, q)
            slope = self._values(slopes, q).reshape(len(residuals), len(q))
            if not (np.all(np.isfinite(value)) and np.all(np.isfinite(slope))):
                break
            q = q - np.linalg.lstsq(slope, value, rcond=1e-10)[0]
        return q

    def _values(self, nodes: list[int], q: NDArray[np.float64]) -> NDArray[np.float64]:
        table = self._table
        arguments: dict[Group, Any] = {
            Group.TIME: 0.3,
            Group.Q: q,
            Group.QD: np.ones(len(q)),
            Group.Z: 0.5 + 0.5 * np.random.default_rng(_SEED + 1).random(len(table.z)),
            Group.U: np.zeros(len(table.u)),
            Group.W: np.zeros(len(table.w)),
            Group.P: np.array(self._parameters, dtype=float),
        }
        return np.array([float(value) for value in evaluate(self._graph, nodes, arguments)])
