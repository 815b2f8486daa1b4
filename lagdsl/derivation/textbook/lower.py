"""The textbook's equations as a Program: the same functions as those of the graph route, from other mathematics.

Values come from SymPy alone. Tangent functions differentiate the lowered residual on the graph: SymPy would need one
derivative per variable and row, and a test compares the two on small models.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

from sympy import Expr, ImmutableDenseMatrix, Symbol

from lagdsl.algebra.graph.differentiate import Tangent
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import DIRECTION_OF, Group, Op
from lagdsl.derivation.program.functions import SIGNATURES
from lagdsl.derivation.program.layout import layout
from lagdsl.derivation.program.passes.components import with_components
from lagdsl.derivation.program.program import Block, Function, Program, vector_block, whole_block
from lagdsl.derivation.textbook.equations import EquationsOfMotion
from lagdsl.derivation.textbook.symbols import Symbols
from lagdsl.derivation.textbook.to_graph import ToGraph
from lagdsl.language.flat.model import FlatModel

_AT_GIVEN_SOLUTION = (Group.Q, Group.QD, Group.Z, Group.U, Group.P)


@dataclass(frozen=True, slots=True)
class _Dynamics:
    """Node ids of the pieces that several functions share; matrices in row-major order."""

    mass: list[int]
    forcing: list[int]
    jacobian: list[int]
    gamma: list[int]
    tau: list[int]
    r: list[int]
    s: list[int]


def lower(equations: EquationsOfMotion, flat: FlatModel, graph: Graph | None = None) -> Program:
    """The functions that every program has, on `graph` or a new one."""
    graph = Graph() if graph is None else graph
    to_graph = ToGraph(graph, symbol_nodes(graph, equations.symbols))
    blocks = _Blocks(to_graph, equations)
    shared = _dynamics(blocks)
    tangent = _tangent(graph, _AT_GIVEN_SOLUTION)
    solved_tangent = _tangent(graph, tuple(DIRECTION_OF))
    n, c = len(equations.q), len(equations.symbols.lam)
    mass, jacobian = _block("M", (n, n), shared.mass), _block("J", (c, n), shared.jacobian)
    phi = blocks.column("phi", equations.constraint)
    rates = blocks.column("residual", equations.velocity_constraint)
    zd = blocks.column("zd", equations.state_derivatives.values())
    y = blocks.column("y", equations.outputs.values())
    energies = equations.energies
    results: dict[str, tuple[Block, ...]] = {
        "start": _start(blocks, equations),
        "position_constraint": (phi, jacobian),
        "velocity_constraint": (rates, jacobian),
        "constraint_tangent": (
            vector_block("dphi", tangent(phi.elements)),
            vector_block("drate", tangent(rates.elements)),
        ),
        "mass_matrix": (mass,),
        "dynamics": (mass, vector_block("f", shared.forcing), jacobian, vector_block("gamma", shared.gamma)),
        "inverse_dynamics": (vector_block("tau", shared.tau),),
        "residual": (vector_block("r", shared.r), vector_block("s", shared.s)),
        "residual_tangent": (vector_block("dr", tangent(shared.r)), vector_block("ds", tangent(shared.s))),
        "state_derivative": (zd,),
        "state_derivative_tangent": (vector_block("dzd", solved_tangent(zd.elements)),),
        "output": (y,),
        "output_tangent": (vector_block("dy", solved_tangent(y.elements)),),
        "energies": (
            blocks.scalar("total", energies.total),
            blocks.scalar("kinetic", energies.kinetic),
            blocks.scalar("potential", energies.potential),
            blocks.scalar("jacobi", energies.jacobi),
        ),
        "momenta": (blocks.column("momenta", equations.momenta),),
        "power": _power(blocks, equations),
        "monitor": _monitor(blocks, equations),
        "initial_equation": (blocks.column("residual", equations.initial_equations),),
    }
    functions = tuple(
        Function(name=name, arguments=arguments, results=results[name]) for name, arguments in SIGNATURES.items()
    )
    return with_components(Program(name=equations.name, layout=layout(flat), graph=graph, functions=functions))


@dataclass(frozen=True, slots=True)
class _Blocks:
    """Result blocks from SymPy expressions."""

    to_graph: ToGraph
    equations: EquationsOfMotion

    def nodes(self, expressions: Iterable[Expr]) -> list[int]:
        return [self.to_graph.node(expression) for expression in expressions]

    def column(self, name: str, expressions: Iterable[Expr]) -> Block:
        return vector_block(name, self.nodes(expressions))

    def scalar(self, name: str, expression: Expr) -> Block:
        return _block(name, (), [self.to_graph.node(expression)])


def _block(name: str, shape: tuple[int, ...], nodes: Sequence[int]) -> Block:
    return whole_block(name, shape, nodes)


def symbol_nodes(graph: Graph, symbols: Symbols) -> dict[Symbol, int]:
    groups = {
        Group.Q: symbols.q,
        Group.QD: symbols.qd,
        Group.QDD: symbols.qdd,
        Group.Z: symbols.z,
        Group.U: symbols.u,
        Group.W: symbols.w,
        Group.P: symbols.p,
        Group.LAMBDA: symbols.lam,
    }
    nodes = {symbols.time: graph.symbol(Group.TIME)}
    for group, members in groups.items():
        nodes |= {symbol: graph.symbol(group, index) for index, symbol in enumerate(members)}
    return nodes


def _dynamics(blocks: _Blocks) -> _Dynamics:
    equations, graph = blocks.equations, blocks.to_graph.graph
    n, c = len(equations.q), len(equations.symbols.lam)
    mass = blocks.nodes(equations.mass_matrix)
    jacobian = blocks.nodes(equations.constraint_jacobian)
    forcing, gamma = blocks.nodes(equations.forcing), blocks.nodes(equations.gamma)
    qdd, lam = graph.symbols(Group.QDD, n), graph.symbols(Group.LAMBDA, c)
    tau = [graph.subtract(graph.dot(mass[i * n : (i + 1) * n], qdd), forcing[i]) for i in range(n)]
    r = [graph.subtract(tau[j], graph.dot(jacobian[j::n], lam)) for j in range(n)]
    s = [graph.subtract(graph.dot(jacobian[i * n : (i + 1) * n], qdd), gamma[i]) for i in range(c)]
    return _Dynamics(mass, forcing, jacobian, gamma, tau, r, s)


def _tangent(graph: Graph, groups: tuple[Group, ...]) -> Callable[[Iterable[int]], list[int]]:
    """The directional derivative of nodes along the direction arguments that belong to `groups`."""

    def seed(symbol: int) -> int:
        assert graph.op[symbol] is Op.SYMBOL
        return graph.symbol(DIRECTION_OF[graph.group(symbol)], graph.b[symbol])

    return Tangent(graph, groups, seed).of_all


def _start(blocks: _Blocks, equations: EquationsOfMotion) -> tuple[Block, ...]:
    start: Mapping[Symbol, Expr] = equations.start
    members = {"q": equations.q, "qd": equations.qd, "z": equations.symbols.z, "u": equations.symbols.u}
    return tuple(blocks.column(name, [start[symbol] for symbol in group]) for name, group in members.items())


def _power(blocks: _Blocks, equations: EquationsOfMotion) -> tuple[Block, ...]:
    def delivered(force: ImmutableDenseMatrix, sign: int) -> list[Expr]:
        return [sign * component * rate for component, rate in zip(force, equations.qd, strict=True)]

    return (
        blocks.column("load", delivered(equations.generalized_force, 1)),
        blocks.column("dissipated", delivered(equations.dissipative_force, -1)),
    )


def _monitor(blocks: _Blocks, equations: EquationsOfMotion) -> tuple[Block, ...]:
    graph = blocks.to_graph.graph
    scales = []
    for invariant in equations.invariants:
        scale = graph.zero
        for term in blocks.nodes(invariant.terms):
            scale = graph.binary(Op.MAX, scale, graph.unary(Op.ABS, term))
        scales.append(scale)
    return (
        blocks.column("invariant", [invariant.value for invariant in equations.invariants]),
        vector_block("scale", scales),
        blocks.column("assertion", equations.assertions),
    )
