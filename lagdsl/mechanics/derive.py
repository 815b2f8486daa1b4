"""From the flat model to a program by the scalable route: everything on one graph, nothing expanded."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from lagdsl.eliminate.count import flops
from lagdsl.flat.expression import FlatExpression
from lagdsl.flat.model import FlatModel
from lagdsl.flat.quantity import Item
from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import Group
from lagdsl.mechanics import constraints
from lagdsl.mechanics.builtin_quantities import Provider
from lagdsl.mechanics.eliminated import eliminated_equations
from lagdsl.mechanics.events import corner_functions, event_functions
from lagdsl.mechanics.lagrange import energies, lagrange
from lagdsl.mechanics.lagrange.inverse import inverse_dynamics
from lagdsl.mechanics.lowering.acceleration import refuse_accelerations
from lagdsl.mechanics.lowering.lowering import Lowering
from lagdsl.mechanics.lowering.symbols import Symbols
from lagdsl.mechanics.monitor import largest_term
from lagdsl.mechanics.shared_position_sums import share_positions
from lagdsl.mechanics.tangent import acceleration_tangent
from lagdsl.mechanics.tangents import SOLVED_GROUPS, STATE_GROUPS, directional
from lagdsl.program.functions import OPTIONAL, SIGNATURES
from lagdsl.program.layout import layout
from lagdsl.program.passes.components import with_components
from lagdsl.program.program import Block, Function, Program
from lagdsl.record import record
from lagdsl.structure.structure import Structure


@record(kw_only=True)
class Derivation:
    """A model's equations as nodes, before they are arranged in functions."""

    flat: FlatModel
    graph: Graph
    symbols: Symbols
    lowering: Lowering
    dynamics: lagrange.Dynamics
    energies: energies.SystemEnergies
    rows: constraints.Rows


def form_equations(flat: FlatModel) -> Derivation:
    """Energies, loads and constraints of `flat` on a new graph, with what outputs may ask of them."""
    graph = Graph()
    symbols = Symbols(graph, flat)
    lowering = Lowering(graph, flat, symbols)
    share_positions(lowering, flat)
    found = lagrange.dynamics(lowering, flat, symbols.directions)
    totals = energies.system_energies(graph, found, symbols.directions)
    lowering.provide = Provider(lowering, flat, symbols, found, totals)
    rows = constraints.constraint_rows(lowering, flat)
    return Derivation(
        flat=flat, graph=graph, symbols=symbols, lowering=lowering, dynamics=found, energies=totals, rows=rows
    )


# From so many coordinates on, M is not written out.
_MANY = 40


@record(kw_only=True)
class Derived:
    """A program, and what it was made from. `forming` are the operations for M, f, J and gamma at run time."""

    derivation: Derivation
    program: Program
    forming: int


def derive(flat: FlatModel, *, dense: bool | None = None) -> Program:
    """All functions of `lagdsl.program.functions`; `dense`: those that write out M, else what forms it by columns. By
    default the number of coordinates decides. Without `elimination` where there are constraints: see `solved`.

    Raises CompilationFailed where a load or an energy needs accelerations (E0308) or the derivative of an input that
    has none (E0304).
    """
    return derived(flat, dense=dense).program


def derived(flat: FlatModel, *, dense: bool | None = None) -> Derived:
    """The same with what `solved` needs."""
    derivation = form_equations(flat)
    blocks = {
        **_equations(derivation, len(flat.coordinates) < _MANY if dense is None else dense),
        **_energies(derivation),
        **_observed(derivation),
        **_start(derivation),
    }
    functions = tuple(
        Function(name=name, arguments=arguments, results=tuple(blocks[name]))
        for name, arguments in {**SIGNATURES, **OPTIONAL}.items()
        if name in blocks
    )
    functions += event_functions(derivation.lowering, flat) + corner_functions(derivation.lowering, flat)
    program = with_components(Program(name=flat.name, layout=layout(flat), graph=derivation.graph, functions=functions))
    result = Derived(derivation=derivation, program=program, forming=_cost_of_forming(derivation, blocks))
    return result if flat.constraints else replace(result, program=_with_elimination(result, None))


def solved(derived: Derived, structure: Structure) -> Program:
    """The program of `structure` with `elimination` where there are constraints: their structure decides how."""
    if not derived.derivation.flat.constraints or not structure.points:
        return structure.program
    return _with_elimination(derived, structure)


def _with_elimination(derived: Derived, structure: Structure | None) -> Program:
    derivation = derived.derivation
    directions, lowering = derivation.symbols.directions, derivation.lowering
    program = derived.program if structure is None else structure.program
    rows = constraints.rows_of(lowering, derivation.rows, directions)
    found = eliminated_equations(
        lowering, derivation.flat, derivation.dynamics, directions, rows, structure, derived.forming
    )
    if found is None:
        return program
    change = acceleration_tangent(found, *program.function("residual_tangent").results)
    kept = tuple(row.index for row in found.factor.rows.kept)
    return replace(program, functions=(*program.functions, found.function, change), kept_rows=kept)


def _equations(derivation: Derivation, dense: bool) -> dict[str, list[Block]]:
    graph, symbols, lowering = derivation.graph, derivation.symbols, derivation.lowering
    directions, rows, terms = symbols.directions, derivation.rows, derivation.dynamics.terms
    phi = [
        residual if position_level else graph.zero
        for residual, position_level in zip(rows.residuals, rows.position_level, strict=True)
    ]
    velocity = constraints.velocity_residuals(lowering, rows)
    jacobian = _matrix("J", constraints.constraint_jacobian(graph, rows, directions), len(symbols.q))
    gamma = constraints.bias(lowering, rows)
    f = lagrange.forcing(lowering, terms) if dense or derivation.flat.states else []
    _refuse_accelerating_states(derivation, [*f, *gamma])
    tau = inverse_dynamics(lowering, derivation.flat, derivation.dynamics, directions)
    pulled = constraints.constraint_forces(graph, rows, list(symbols.lam), directions)
    r = [graph.subtract(force, pull) for force, pull in zip(tau, pulled, strict=True)]
    s = [lowering.rate.of(residual) for residual in velocity]
    if dense:
        mass = _matrix("M", lagrange.mass_matrix(graph, terms, directions), len(symbols.q))
        formed = {"mass_matrix": [mass], "dynamics": [mass, _vector("f", f), jacobian, _vector("gamma", gamma)]}
    else:
        formed = {"momentum_tangent": [_vector("momenta", directional(graph, terms.momentum, (Group.QD,)))]}
    return {
        **formed,
        "position_constraint": [_vector("phi", phi), jacobian],
        "velocity_constraint": [_vector("residual", velocity), jacobian],
        "constraint_tangent": [
            _vector("dphi", directional(graph, phi, STATE_GROUPS)),
            _vector("drate", directional(graph, velocity, STATE_GROUPS)),
        ],
        "inverse_dynamics": [_vector("tau", tau)],
        "residual": [_vector("r", r), _vector("s", s)],
        "residual_tangent": [
            _vector("dr", directional(graph, r, STATE_GROUPS)),
            _vector("ds", directional(graph, s, STATE_GROUPS)),
        ],
    }


def _cost_of_forming(derivation: Derivation, blocks: dict[str, list[Block]]) -> int:
    """Operations for M, f, J and gamma at run time."""
    graph = derivation.graph

    def cost(*names: str) -> int:
        return flops(graph, [node for name in names for block in blocks[name] for node in block.elements])

    if "dynamics" in blocks:
        return cost("dynamics")
    return len(derivation.symbols.q) * cost("momentum_tangent") + cost("inverse_dynamics", "velocity_constraint")


def _refuse_accelerating_states(derivation: Derivation, forces: Sequence[int]) -> None:
    """E0308 at a state whose equation needs accelerations, where its rate enters the equations of motion."""
    for state in derivation.flat.states:
        rate = derivation.lowering.scalar(state.derivative)
        if derivation.graph.depends(rate, Group.QDD, Group.LAMBDA):
            refuse_accelerations(derivation.graph, forces, state.spans, f"`der({state.name})`")


def _energies(derivation: Derivation) -> dict[str, list[Block]]:
    graph, directions = derivation.graph, derivation.symbols.directions
    found, totals = derivation.dynamics, derivation.energies
    return {
        "energies": [
            _number("total", totals.total),
            _number("kinetic", totals.kinetic),
            _number("potential", totals.potential),
            _number("jacobi", totals.jacobi),
        ],
        "momenta": [_vector("momenta", found.terms.momentum)],
        "power": [
            _vector("load", energies.load_power(graph, found, directions)),
            _vector("dissipated", energies.dissipated_power(graph, found, directions)),
        ],
    }


def _observed(derivation: Derivation) -> dict[str, list[Block]]:
    graph, flat = derivation.graph, derivation.flat
    rates = _scalars(derivation, flat.states, [state.derivative for state in flat.states])
    outputs = _scalars(derivation, flat.outputs, [output.value for output in flat.outputs])
    invariants = _scalars(derivation, flat.invariants, [invariant.value for invariant in flat.invariants])
    conditions = _scalars(derivation, flat.assertions, [assertion.condition for assertion in flat.assertions])
    initial = _scalars(derivation, flat.initial_equations, [item.residual for item in flat.initial_equations])
    return {
        "state_derivative": [_vector("zd", rates)],
        "state_derivative_tangent": [_vector("dzd", directional(graph, rates, SOLVED_GROUPS))],
        "output": [_vector("y", outputs)],
        "output_tangent": [_vector("dy", directional(graph, outputs, SOLVED_GROUPS))],
        "monitor": [
            _vector("invariant", invariants),
            _vector("scale", [largest_term(graph, invariant) for invariant in invariants]),
            _vector("assertion", conditions),
        ],
        "initial_equation": [_vector("residual", initial)],
    }


def _scalars(derivation: Derivation, items: Sequence[Item], values: Sequence[FlatExpression]) -> list[int]:
    nodes = []
    for item, value in zip(items, values, strict=True):
        derivation.lowering.place = item.spans
        nodes.append(derivation.lowering.scalar(value))
    return nodes


def _start(derivation: Derivation) -> dict[str, list[Block]]:
    flat, scalar = derivation.flat, derivation.lowering.scalar
    return {
        "start": [
            _vector("q", [scalar(coordinate.start) for coordinate in flat.coordinates]),
            _vector("qd", [scalar(coordinate.rate_start) for coordinate in flat.coordinates]),
            _vector("z", [scalar(state.start) for state in flat.states]),
            _vector("u", [scalar(item.default) for item in flat.inputs]),
        ]
    }


def _number(name: str, node: int) -> Block:
    return Block(name=name, shape=(), elements=(node,))


def _vector(name: str, nodes: Sequence[int]) -> Block:
    return Block(name=name, shape=(len(nodes),), elements=tuple(nodes))


def _matrix(name: str, rows: Sequence[Sequence[int]], columns: int) -> Block:
    return Block(name=name, shape=(len(rows), columns), elements=tuple(node for row in rows for node in row))
