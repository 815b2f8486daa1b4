"""Claims that need no monitoring: momenta of cyclic coordinates, and energies where neither time nor power enters.

A momentum dL/dqd_j is constant if dL/dq_j + Q_j - dD/dqd_j and column j of J vanish identically; Jacobi's integral if L
does not depend on time, states or inputs, loads and dissipation have no power, and constraints are scleronomic
(Noether's theorem in the form of Landau and Lifshitz, *Mechanics*, sections 6 and 7). Terms that are not the constant 0
as they stand are tried at random points with random parameters: an analytic expression that is zero at all of them to
rounding is zero.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from lagdsl.diagnostics import Sink
from lagdsl.graph.differentiate import adjoints
from lagdsl.graph.evaluate import evaluate_with_size
from lagdsl.graph.operation import STEPS, Group, Op
from lagdsl.mechanics.constraints import constraint_jacobian, velocity_residuals
from lagdsl.mechanics.derive import Derivation, form_equations
from lagdsl.semantics.flat_expression import FlatExpression, GeneralizedMomentum, SystemEnergy, Variable
from lagdsl.semantics.flat_model import Definition, FlatModel, Parameter

_POINTS = 12
_ROUNDING = 1e-11
_KINKS = STEPS | {Op.SELECT, Op.ABS, Op.MIN, Op.MAX, Op.MOD}


def report_proofs(flat: FlatModel, sink: Sink) -> None:
    """A note for each invariant of `flat` that is proved to hold for every motion and all parameters."""
    for invariant, proved in zip(flat.invariants, proved_invariants(flat), strict=True):
        if proved:
            sink.report("N0515", invariant.spans[0], name=invariant.name)


def proved_invariants(flat: FlatModel) -> tuple[bool, ...]:
    """For each invariant of `flat` whether it is an energy or a momentum that provably stays constant."""
    values = [_resolved(flat, invariant.value) for invariant in flat.invariants]
    if not any(isinstance(value, GeneralizedMomentum | SystemEnergy) for value in values):
        return (False,) * len(values)
    derivation = form_equations(flat)
    return tuple(_holds(derivation, value) for value in values)


def _resolved(flat: FlatModel, value: FlatExpression) -> FlatExpression:
    """What a name stands for in the end."""
    definitions = {item.name: item for item in flat.named if isinstance(item, Definition)}
    while isinstance(value, Variable) and value.name in definitions:
        value = definitions[value.name].value
    return value


def _holds(derivation: Derivation, value: FlatExpression) -> bool:
    match value:
        case GeneralizedMomentum(coordinate):
            index = derivation.symbols.coordinate_index[coordinate]
            return _vanish(derivation, _momentum_rate(derivation, index))
        case SystemEnergy("jacobi"):
            return _vanish(derivation, _jacobi_rate(derivation))
        case SystemEnergy("total"):
            return _vanish(derivation, [*_excess_of_energy(derivation), *_jacobi_rate(derivation)])
        case _:
            return False


def _momentum_rate(derivation: Derivation, index: int) -> Iterator[int]:
    """What changes dL/dqd of one coordinate."""
    graph, terms = derivation.graph, derivation.dynamics.terms
    yield graph.add(graph.subtract(terms.load[index], terms.drag[index]), terms.push[index])
    for row in constraint_jacobian(graph, derivation.rows, derivation.symbols.directions):
        yield row[index]


def _excess_of_energy(derivation: Derivation) -> Iterator[int]:
    """What makes T + V differ from Jacobi's integral: 2 T - qd.dT/dqd, and rates in V."""
    graph, found = derivation.graph, derivation.dynamics.energies
    slopes = adjoints(graph, {found.kinetic: graph.one}, (Group.QD,))
    twice = graph.multiply(graph.constant(2.0), found.kinetic)
    yield graph.subtract(twice, graph.sum(graph.multiply(rate, slope) for rate, slope in slopes.items()))
    yield from adjoints(graph, {found.potential: graph.one}, (Group.QD,)).values()


def _jacobi_rate(derivation: Derivation) -> Iterator[int]:
    """What changes qd.dL/dqd - L."""
    graph, symbols, found = derivation.graph, derivation.symbols, derivation.dynamics
    yield from adjoints(graph, {found.energies.lagrangian: graph.one}, (Group.TIME, Group.Z, Group.U)).values()
    forces = zip(found.terms.load, found.terms.drag, strict=True)
    yield graph.dot([graph.subtract(load, drag) for load, drag in forces], symbols.qd)
    jacobian = constraint_jacobian(graph, derivation.rows, symbols.directions)
    for residual, row in zip(velocity_residuals(derivation.lowering, derivation.rows), jacobian, strict=True):
        yield graph.subtract(residual, graph.dot(row, symbols.qd))


def _vanish(derivation: Derivation, nodes: Iterator[int] | Sequence[int]) -> bool:
    """Whether all of `nodes` are identically zero: as they stand, or at random points where they are smooth."""
    graph = derivation.graph
    open_ = [node for node in nodes if node != graph.zero]
    if not open_:
        return True
    if any(graph.op[node] in _KINKS for node in graph.live(open_)):
        return False
    symbols = _random_points(derivation)
    return all(
        bool(np.all(np.isfinite(size)) and np.all(np.abs(value) <= _ROUNDING * size))
        for value, size in evaluate_with_size(graph, open_, symbols)
    )


def _random_points(derivation: Derivation) -> dict[Group, np.ndarray]:
    """Points near the starts, so that they lie where the model is meant; the same in every run."""
    flat, graph, symbols = derivation.flat, derivation.graph, derivation.symbols
    random = np.random.default_rng(20)
    independent = [parameter for parameter in flat.parameters if not parameter.structural]
    defaults = {Group.P: np.array([parameter.value for parameter in independent]), Group.TIME: 0.0}
    starts = [derivation.lowering.scalar(coordinate.start) for coordinate in flat.coordinates]
    centre = np.array([float(value) for value, _ in evaluate_with_size(graph, starts, defaults)])

    spread = random.uniform(-1.0, 1.0, (2, _POINTS, len(centre)))
    return {
        Group.TIME: random.uniform(0.1, 2.0, _POINTS),
        Group.Q: centre * (1.0 + 0.3 * spread[0]) + 0.7 * spread[1],
        Group.QD: random.uniform(-2.0, 2.0, (_POINTS, len(symbols.qd))),
        Group.Z: random.uniform(-1.0, 1.0, (_POINTS, len(symbols.z))),
        Group.U: random.uniform(-1.0, 1.0, (_POINTS, len(symbols.u))),
        Group.P: np.stack([_varied(parameter, random) for parameter in independent], axis=-1)
        if independent
        else np.zeros((_POINTS, 0)),
    }


def _varied(parameter: Parameter, random: np.random.Generator) -> np.ndarray:
    """Values of a parameter of the sign it has; switches and counts stay as they are, absent effects are given one."""
    if parameter.kind != "Real":
        return np.full(_POINTS, parameter.value)
    scale = parameter.value if parameter.value != 0.0 else 1.0
    return scale * random.uniform(0.6, 1.4, _POINTS)
