"""The parts of Lagrange's equations that control engineers call by name: C(q, qd), dV/dq, and their sum.

With L = T - V and loads, dissipation and constraints left out,

    d/dt(dL/dqd) - dL/dq = M qdd + bias,   bias = C qd + dV/dq + what moving frames add

where C comes from Christoffel's symbols, C_jk = sum_i (dM_jk/dq_i + dM_ji/dq_k - dM_ki/dq_j) qd_i / 2, so that
dM/dt - 2 C is skew where M depends on q alone (Murray, Li and Sastry, *A Mathematical Introduction to Robotic
Manipulation*, 1994, section 4.2). The forces h of T at qdd = 0 hold each symbol twice: C is half the derivative of
their quadratic part by qd.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from lagdsl.algebra.graph.differentiate import Tangent, adjoints
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.mechanics.lagrange.inverse import bias_forces
from lagdsl.derivation.mechanics.lagrange.lagrange import Dynamics, mass_matrix, parts
from lagdsl.derivation.mechanics.lagrange.loads import VirtualWork
from lagdsl.derivation.mechanics.lagrange.through_states import ThroughStates
from lagdsl.derivation.program.program import Block, matrix_block, vector_block
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.language.flat.model import FlatModel


def equation_terms(equations: Equations) -> tuple[Block, ...]:
    """Results of the function `equation_terms`. Raises CompilationFailed (E0856) where T is not quadratic in the
    rates."""
    graph, symbols = equations.graph, equations.symbols
    inertial = bias_forces(equations.lowering, *_without_potential(equations), symbols.directions)
    _require_quadratic(equations)
    gravity = _gradient(graph, equations.dynamics.energies.potential, symbols.q)
    size = len(symbols.q)
    columns = [_column(graph, inertial, symbols.qd, k) for k in range(size)]
    return (
        matrix_block("C", list(zip(*columns, strict=True)), size),
        vector_block("g", gravity),
        vector_block("b", list(map(graph.add, inertial, gravity))),
    )


def _without_potential(equations: Equations) -> tuple[FlatModel, Dynamics]:
    """The model and its parts with kinetic energy and Lagrangian terms alone."""
    graph, flat, found = equations.graph, equations.flat, equations.dynamics
    kept = tuple(term for term in flat.energies if term.kind in ("kinetic", "lagrangian"))
    totals = replace(
        found.energies,
        potential=graph.zero,
        dissipation=graph.zero,
        lagrangian=graph.add(found.energies.kinetic, found.energies.extra),
    )
    work = VirtualWork(graph)
    through = ThroughStates(found.terms.by_states, [graph.zero] * len(found.terms.by_states))
    terms = parts(graph, totals, work, equations.symbols.directions, through)
    moving = Dynamics(energies=totals, work=work, terms=terms)
    return replace(flat, energies=kept, gravity=None, loads=()), moving


def _require_quadratic(equations: Equations) -> None:
    graph = equations.graph
    mass = mass_matrix(graph, equations.dynamics.terms, equations.symbols.directions)
    if any(graph.depends(entry, Group.QD) for row in mass for entry in row):
        sink = Sink()
        spans = next((term.spans for term in equations.flat.energies if term.kind != "potential"), ())
        sink.report("E0856", spans[0] if spans else None)
        raise CompilationFailed(sink.diagnostics)


def _gradient(graph: Graph, root: int, symbols: Sequence[int]) -> list[int]:
    found = adjoints(graph, {root: graph.one}, (Group.Q,))
    return [found.get(symbol, graph.zero) for symbol in symbols]


def _column(graph: Graph, forces: Sequence[int], rates: Sequence[int], k: int) -> list[int]:
    """Half the derivative by rate k of what is quadratic in the rates: that of all less that at rest."""

    def along(symbol: int) -> int:
        return graph.one if symbol == rates[k] else graph.zero

    whole = Tangent(graph, (Group.QD,), along).of_all(forces)
    at_rest = Substitution(graph, dict.fromkeys(rates, graph.zero)).of_all(whole)
    half = graph.constant(0.5)
    return [graph.multiply(half, graph.subtract(moving, still)) for moving, still in zip(whole, at_rest, strict=True)]
