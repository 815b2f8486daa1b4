"""Lagrange's equations on the graph, for any Lagrangian.

    d/dt(dL/dqd) - dL/dq + dD/dqd = Q + J' lambda

Momenta dL/dqd and dL/dq come from one reverse sweep of L, the mass matrix d2L/dqd2 from tangents of the momenta, and
d(dL/dqd)/dt from one forward tangent of all momenta along the motion. Nothing is written for quadratic kinetic
energies: velocity-dependent and non-quadratic Lagrangians take the same path.
"""

from __future__ import annotations

from dataclasses import field

from lagdsl.algebra.graph.differentiate import adjoints, symmetric_jacobian
from lagdsl.algebra.graph.graph import Graph
from lagdsl.derivation.mechanics.lagrange.lagrangian import Energies, energies
from lagdsl.derivation.mechanics.lagrange.loads import VirtualWork, generalized_forces, virtual_work
from lagdsl.derivation.mechanics.lagrange.through_states import ThroughStates, through_states
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.derivation.mechanics.lowering.symbols import Directions
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel


@record(kw_only=True)
class Terms:
    """Parts of Lagrange's equations, one entry per direction: `push` is dL/dq, `drag` dD/dqd, `load` Q. `by_states` is
    what dL/dq would have more if rates of states were not held."""

    momentum: list[int]
    push: list[int]
    drag: list[int]
    load: list[int]
    by_states: list[int]


@record(kw_only=True)
class Dynamics:
    """A model's energies, loads and the parts of its equations. `gradients` are those of Lagrangians, by coordinates
    and velocities, that two forms of the equations ask for."""

    energies: Energies
    work: VirtualWork
    terms: Terms
    gradients: dict[int, dict[int, int]] = field(default_factory=dict, compare=False, repr=False)


def dynamics(lowering: Lowering, flat: FlatModel, directions: Directions) -> Dynamics:
    """The parts of Lagrange's equations for `directions`."""
    totals = energies(lowering, flat)
    work = virtual_work(lowering, flat)
    found = through_states(lowering, flat, directions)
    return Dynamics(energies=totals, work=work, terms=parts(lowering.graph, totals, work, directions, found))


def parts(
    graph: Graph, totals: Energies, work: VirtualWork, directions: Directions, through: ThroughStates | None = None
) -> Terms:
    """The derivatives of the energies and the generalized forces of the loads."""
    none = [graph.zero] * len(directions.positions)
    found = through or ThroughStates(none, none)
    both = adjoints(graph, {totals.lagrangian: graph.one}, (directions.position_group, directions.rate_group))
    lost = adjoints(graph, {totals.dissipation: graph.one}, (directions.rate_group,))
    return Terms(
        momentum=[both.get(rate, graph.zero) for rate in directions.rates],
        push=_less(graph, [both.get(position, graph.zero) for position in directions.positions], found.push),
        drag=_less(graph, [lost.get(rate, graph.zero) for rate in directions.rates], found.drag),
        load=generalized_forces(work, directions),
        by_states=found.push,
    )


def _less(graph: Graph, values: list[int], others: list[int]) -> list[int]:
    return [graph.subtract(value, other) for value, other in zip(values, others, strict=True)]


def mass_matrix(graph: Graph, terms: Terms, directions: Directions) -> list[list[int]]:
    """M = d2L/dqd2, symmetric: half of it is differentiated."""
    return symmetric_jacobian(graph, terms.momentum, directions.rates)


def forcing(lowering: Lowering, terms: Terms) -> list[int]:
    """f = Q - dD/dqd + dL/dq - d(dL/dqd)/dt at qdd = 0: everything that is not M qdd or J' lambda."""
    graph, bias = lowering.graph, lowering.bias_rate
    return [
        graph.subtract(applied, bias.of(momentum))
        for applied, momentum in zip(applied_forces(graph, terms), terms.momentum, strict=True)
    ]


def inverse_dynamics(lowering: Lowering, terms: Terms) -> list[int]:
    """tau = M qdd - f with the accelerations as symbols, without a mass matrix: of about the size of T and V."""
    graph = lowering.graph
    return [
        graph.subtract(lowering.rate.of(momentum), applied)
        for momentum, applied in zip(terms.momentum, applied_forces(graph, terms), strict=True)
    ]


def applied_forces(graph: Graph, terms: Terms) -> list[int]:
    """Q - dD/dqd + dL/dq."""
    return [
        graph.add(graph.subtract(load, drag), push)
        for load, drag, push in zip(terms.load, terms.drag, terms.push, strict=True)
    ]
