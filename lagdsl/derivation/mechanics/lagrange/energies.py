"""Energies and power of a model as functions of its state."""

from __future__ import annotations

from typing import Literal

from lagdsl.algebra.graph.differentiate import Tangent
from lagdsl.algebra.graph.graph import Graph
from lagdsl.derivation.mechanics.lagrange.lagrange import Dynamics
from lagdsl.derivation.mechanics.lowering.symbols import Directions
from lagdsl.foundation.record import record

EnergyKind = Literal["total", "kinetic", "potential", "jacobi"]


@record()
class SystemEnergies:
    """Nodes [J]. `total` is T + V and, for each `lagrangian` term Lx, qd.dLx/dqd - Lx, so that velocity-linear terms
    add nothing; `jacobi` is qd.dL/dqd - L."""

    total: int
    kinetic: int
    potential: int
    jacobi: int

    def of(self, kind: EnergyKind) -> int:
        nodes: dict[EnergyKind, int] = {
            "total": self.total,
            "kinetic": self.kinetic,
            "potential": self.potential,
            "jacobi": self.jacobi,
        }
        return nodes[kind]


def system_energies(graph: Graph, found: Dynamics, directions: Directions) -> SystemEnergies:
    energies, terms = found.energies, found.terms

    def own_rate(symbol: int) -> int:
        return symbol

    along_rates = Tangent(graph, (directions.rate_group,), own_rate)
    extra = graph.subtract(along_rates.of(energies.extra), energies.extra)
    total = graph.add(graph.add(energies.kinetic, energies.potential), extra)
    work = graph.dot(directions.rates, terms.momentum)
    return SystemEnergies(total, energies.kinetic, energies.potential, graph.subtract(work, energies.lagrangian))


def load_power(graph: Graph, found: Dynamics, directions: Directions) -> list[int]:
    """Q_j qd_j [W]."""
    return [graph.multiply(load, rate) for load, rate in zip(found.terms.load, directions.rates, strict=True)]


def dissipated_power(graph: Graph, found: Dynamics, directions: Directions) -> list[int]:
    """dD/dqd_j qd_j [W]."""
    return [graph.multiply(drag, rate) for drag, rate in zip(found.terms.drag, directions.rates, strict=True)]
