"""From the equations of motion to a program: the functions that simulation, analysis and export call."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics import constraints
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.mechanics.events import corner_functions, delay_functions, event_functions, way_functions
from lagdsl.derivation.mechanics.friction import friction_functions, load_functions
from lagdsl.derivation.mechanics.lagrange import energies, lagrange
from lagdsl.derivation.mechanics.lagrange.inverse import inverse_dynamics
from lagdsl.derivation.mechanics.lowering.acceleration import as_coordinate, needs_accelerations, refuse_accelerations
from lagdsl.derivation.mechanics.monitor import largest_term
from lagdsl.derivation.mechanics.solve import solve
from lagdsl.derivation.mechanics.tangents import SOLVED_GROUPS, STATE_GROUPS, directional
from lagdsl.derivation.mechanics.turns import turn_functions
from lagdsl.derivation.program.functions import OPTIONAL, SIGNATURES
from lagdsl.derivation.program.layout import layout
from lagdsl.derivation.program.passes.components import with_components
from lagdsl.derivation.program.passes.speeds import with_speeds
from lagdsl.derivation.program.program import Block, Function, Program, matrix_block, number_block, vector_block
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Item

# From so many coordinates on, M is not written out; the second number is for equations without constraints that
# elimination solves, where only starts and events read M.
_MANY = 40
_MANY_SOLVED = 12


def arrange(equations: Equations, *, dense: bool | None = None) -> Program:
    """All functions of `lagdsl.derivation.program.functions`. `dense` chooses those that write out M, else the
    one that forms it by columns; by default the number of coordinates decides, and what solves the equations. Equations
    without constraints are solved at once: no rank decides how.

    Raises CompilationFailed where a load or an energy needs accelerations (E0308) or the derivative of an input that
    has none (E0304).
    """
    flat = equations.flat
    few = len(flat.coordinates) < _MANY if dense is None else dense
    if flat.constraints:
        return _program(equations, dense=few)
    if dense is None and few and len(flat.coordinates) >= _MANY_SOLVED:
        solved = solve(equations, _program(equations, dense=False))
        if solved.has("elimination"):
            return solved
    return solve(equations, _program(equations, dense=few))


def _program(equations: Equations, *, dense: bool) -> Program:
    flat = equations.flat
    blocks = {
        **_dynamics(equations, dense),
        **_energies(equations),
        **observed(equations),
        **start(equations),
    }
    functions = tuple(
        Function(name=name, arguments=arguments, results=tuple(blocks[name]))
        for name, arguments in {**SIGNATURES, **OPTIONAL}.items()
        if name in blocks
    )
    program = Program(name=flat.name, layout=layout(flat), graph=equations.graph, functions=functions)
    return with_events(equations, program)


def with_events(equations: Equations, program: Program) -> Program:
    """`program`, which is on the graph of `equations`, with the functions of events and corners, which are no part of a
    derivation."""
    flat, lowering = equations.flat, equations.lowering
    added = (
        *event_functions(lowering, flat),
        *friction_functions(lowering, flat),
        *load_functions(lowering, flat, program),
        *corner_functions(lowering, flat),
        *way_functions(lowering, flat),
        *delay_functions(lowering, flat),
        *turn_functions(lowering, flat),
    )
    return with_speeds(flat, with_components(replace(program, functions=(*program.functions, *added))))


def _dynamics(equations: Equations, dense: bool) -> dict[str, list[Block]]:
    graph, symbols, lowering = equations.graph, equations.symbols, equations.lowering
    directions, rows, terms = symbols.directions, equations.rows, equations.dynamics.terms
    phi = [
        residual if position_level else graph.zero
        for residual, position_level in zip(rows.residuals, rows.position_level, strict=True)
    ]
    velocity = constraints.velocity_residuals(lowering, rows)
    jacobian = matrix_block("J", constraints.constraint_jacobian(graph, rows, directions), len(symbols.q))
    gamma = constraints.bias(lowering, rows)
    f = lagrange.forcing(lowering, terms) if dense or equations.flat.states else []
    _refuse_accelerating_states(equations, [*f, *gamma])
    _refuse_places_of_rates(equations, phi)
    tau = inverse_dynamics(lowering, equations.flat, equations.dynamics, directions)
    pulled = constraints.constraint_forces(graph, rows, list(symbols.lam), directions)
    r = [graph.subtract(force, pull) for force, pull in zip(tau, pulled, strict=True)]
    s = [lowering.rate.of(residual) for residual in velocity]
    if dense:
        mass = matrix_block("M", lagrange.mass_matrix(graph, terms, directions), len(symbols.q))
        formed = {
            "mass_matrix": [mass],
            "dynamics": [mass, vector_block("f", f), jacobian, vector_block("gamma", gamma)],
        }
    else:
        formed = {"momentum_tangent": [vector_block("momenta", directional(graph, terms.momentum, (Group.QD,)))]}
    return {
        **formed,
        "position_constraint": [vector_block("phi", phi), jacobian],
        "velocity_constraint": [vector_block("residual", velocity), jacobian],
        "constraint_tangent": [
            vector_block("dphi", directional(graph, phi, STATE_GROUPS)),
            vector_block("drate", directional(graph, velocity, STATE_GROUPS)),
        ],
        "inverse_dynamics": [vector_block("tau", tau)],
        "residual": [vector_block("r", r), vector_block("s", s)],
        "residual_tangent": [
            vector_block("dr", directional(graph, r, STATE_GROUPS)),
            vector_block("ds", directional(graph, s, STATE_GROUPS)),
        ],
    }


def _refuse_places_of_rates(equations: Equations, phi: Sequence[int]) -> None:
    """E0308 at a state whose rate follows rates of coordinates and that a position row holds: the second derivative of
    the row has accelerations that its gradient does not tell."""
    graph, lowering = equations.graph, equations.lowering
    present = set(graph.live(phi)) if equations.flat.states else set()
    for state, symbol in zip(equations.flat.states, equations.symbols.z, strict=True):
        if symbol in present and graph.depends(lowering.scalar(state.derivative), Group.QD):
            what = f"what a constraint on `{state.name}` asks for"
            raise needs_accelerations(state.spans, what, help=as_coordinate(state.name))


def _refuse_accelerating_states(equations: Equations, forces: Sequence[int]) -> None:
    """E0308 at a state whose equation needs accelerations, where its rate enters the equations of motion."""
    for state in equations.flat.states:
        rate = equations.lowering.scalar(state.derivative)
        if equations.graph.depends(rate, Group.QDD, Group.LAMBDA):
            refuse_accelerations(equations.graph, forces, state.spans, f"`der({state.name})`")


def _energies(equations: Equations) -> dict[str, list[Block]]:
    graph, directions = equations.graph, equations.symbols.directions
    found, totals = equations.dynamics, equations.energies
    return {
        "energies": [
            number_block("total", totals.total),
            number_block("kinetic", totals.kinetic),
            number_block("potential", totals.potential),
            number_block("jacobi", totals.jacobi),
        ],
        "momenta": [vector_block("momenta", found.terms.momentum)],
        "power": [
            vector_block("load", energies.load_power(graph, found, directions)),
            vector_block("dissipated", energies.dissipated_power(graph, found, directions)),
        ],
    }


def observed(equations: Equations) -> dict[str, list[Block]]:
    """Results of the functions for rates of states, outputs, invariants, assertions and initial equations."""
    graph, flat = equations.graph, equations.flat
    rates = _scalars(equations, flat.states, [state.derivative for state in flat.states])
    outputs = _scalars(equations, flat.outputs, [output.value for output in flat.outputs])
    invariants = _scalars(equations, flat.invariants, [invariant.value for invariant in flat.invariants])
    conditions = _scalars(equations, flat.assertions, [assertion.value for assertion in flat.assertions])
    initial = _scalars(equations, flat.initial_equations, [item.residual for item in flat.initial_equations])
    return {
        "state_derivative": [vector_block("zd", rates)],
        "state_derivative_tangent": [vector_block("dzd", directional(graph, rates, SOLVED_GROUPS))],
        "output": [vector_block("y", outputs)],
        "output_tangent": [vector_block("dy", directional(graph, outputs, SOLVED_GROUPS))],
        "monitor": [
            vector_block("invariant", invariants),
            vector_block("scale", [largest_term(graph, invariant) for invariant in invariants]),
            vector_block("assertion", conditions),
        ],
        "initial_equation": [vector_block("residual", initial)],
    }


def _scalars(equations: Equations, items: Sequence[Item], values: Sequence[FlatExpression]) -> list[int]:
    nodes = []
    for item, value in zip(items, values, strict=True):
        equations.lowering.place = item.spans
        nodes.append(equations.lowering.scalar(value))
    return nodes


def start(equations: Equations) -> dict[str, list[Block]]:
    """Results of the function `start`."""
    flat, scalar = equations.flat, equations.lowering.scalar
    return {
        "start": [
            vector_block("q", [scalar(coordinate.start) for coordinate in flat.coordinates]),
            vector_block("qd", [scalar(coordinate.rate_start) for coordinate in flat.coordinates]),
            vector_block("z", [scalar(state.start) for state in flat.states]),
            vector_block("u", [scalar(item.default) for item in flat.inputs]),
        ]
    }
