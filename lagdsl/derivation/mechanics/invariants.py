"""Claims that need no monitoring: momenta of cyclic coordinates, and energies where neither time nor power enters.

A momentum dL/dqd_j is constant if dL/dq_j + Q_j - dD/dqd_j and column j of J vanish identically; Jacobi's integral if L
does not depend on time, states or inputs, loads and dissipation have no power, and constraints are scleronomic
(Noether's theorem in the form of Landau and Lifshitz, *Mechanics*, sections 6 and 7).
"""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.algebra.graph.differentiate import adjoints
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.constraints import constraint_jacobian, velocity_residuals
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.mechanics.zero_test import vanish
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.event_flow import branches
from lagdsl.language.flat.events import Impact, Reset
from lagdsl.language.flat.expression import FlatExpression, GeneralizedMomentum, SystemEnergy, Variable
from lagdsl.language.flat.model import Definition, FlatModel
from lagdsl.language.flat.spans import around


def report_proofs(equations: Equations, sink: Sink) -> None:
    """A note for each invariant of the model that is proved to hold for every motion and all parameters."""
    for invariant, proved in zip(equations.flat.invariants, proved_invariants(equations), strict=True):
        if proved:
            sink.report("N0515", invariant.spans[0], *around(invariant), name=invariant.name)


def proved_invariants(equations: Equations) -> tuple[bool, ...]:
    """For each invariant of the model whether it is an energy or a momentum that provably stays constant."""
    flat = equations.flat
    if _jumps(equations):
        return (False,) * len(flat.invariants)
    return tuple(_holds(equations, _resolved(flat, invariant.value)) for invariant in flat.invariants)


def _jumps(equations: Equations) -> bool:
    """True if an event may change the state, or what the energies are."""
    flat, energies = equations.flat, equations.dynamics.energies
    acts = any(isinstance(action, Reset | Impact) for branch in branches(flat) for action in branch.actions)
    return acts or bool(flat.events.contacts) or equations.graph.depends(energies.lagrangian, Group.W)


def _resolved(flat: FlatModel, value: FlatExpression) -> FlatExpression:
    """The definition behind a name, through all aliases."""
    definitions = {item.name: item for item in flat.named if isinstance(item, Definition)}
    while isinstance(value, Variable) and value.name in definitions:
        value = definitions[value.name].value
    return value


def _holds(equations: Equations, value: FlatExpression) -> bool:
    if isinstance(value, GeneralizedMomentum):
        index = equations.symbols.coordinate_index[value.coordinate]
        return vanish(equations, _momentum_rate(equations, index))
    kind = value.kind if isinstance(value, SystemEnergy) else None
    if kind == "jacobi":
        return vanish(equations, _jacobi_rate(equations))
    if kind == "total":
        return vanish(equations, [*_excess_of_energy(equations), *_jacobi_rate(equations)])
    return False


def _momentum_rate(equations: Equations, index: int) -> Iterator[int]:
    """Terms that change dL/dqd of one coordinate."""
    graph, terms = equations.graph, equations.dynamics.terms
    yield graph.add(graph.subtract(terms.load[index], terms.drag[index]), terms.push[index])
    for row in constraint_jacobian(graph, equations.rows, equations.symbols.directions):
        yield row.get(index, graph.zero)


def _excess_of_energy(equations: Equations) -> Iterator[int]:
    """Terms by which T + V differs from Jacobi's integral: 2 T - qd.dT/dqd, and rates in V."""
    graph, found = equations.graph, equations.dynamics.energies
    slopes = adjoints(graph, {found.kinetic: graph.one}, (Group.QD,))
    twice = graph.multiply(graph.constant(2.0), found.kinetic)
    yield graph.subtract(twice, graph.sum(graph.multiply(rate, slope) for rate, slope in slopes.items()))
    yield from adjoints(graph, {found.potential: graph.one}, (Group.QD,)).values()


def _jacobi_rate(equations: Equations) -> Iterator[int]:
    """Terms that change qd.dL/dqd - L."""
    graph, symbols, found = equations.graph, equations.symbols, equations.dynamics
    yield from adjoints(graph, {found.energies.lagrangian: graph.one}, (Group.TIME, Group.Z, Group.U)).values()
    forces = zip(found.terms.load, found.terms.drag, strict=True)
    yield graph.dot([graph.subtract(load, drag) for load, drag in forces], symbols.qd)
    jacobian = constraint_jacobian(graph, equations.rows, symbols.directions)
    for residual, row in zip(velocity_residuals(equations.lowering, equations.rows), jacobian, strict=True):
        rates = [symbols.qd[column] for column in row]
        yield graph.subtract(residual, graph.dot(list(row.values()), rates))
