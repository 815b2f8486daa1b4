"""From the flat model to its equations of motion, by the scalable route: everything on one graph, nothing expanded."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import replace

from lagdsl.algebra.graph.graph import Graph
from lagdsl.derivation.mechanics import constraints
from lagdsl.derivation.mechanics.builtin_quantities import Provider
from lagdsl.derivation.mechanics.lagrange import energies, lagrange
from lagdsl.derivation.mechanics.lagrange.required import RequiredForces
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.derivation.mechanics.lowering.symbols import Symbols
from lagdsl.derivation.mechanics.shared_position_sums import share_positions
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel


@record(kw_only=True)
class Equations:
    """Lagrange's equations of a model, its energies and its constraints as nodes of one graph."""

    flat: FlatModel
    graph: Graph
    symbols: Symbols
    lowering: Lowering
    dynamics: lagrange.Dynamics
    required: RequiredForces
    energies: energies.SystemEnergies
    rows: constraints.Rows


def form_equations(flat: FlatModel) -> Equations:
    """Energies, loads and constraints of `flat` on a new graph, with what outputs may ask of them."""
    graph = Graph()
    symbols = Symbols(graph, flat)
    lowering = Lowering(graph, flat, symbols)
    share_positions(lowering, flat)
    required = lowering.provide = RequiredForces(lowering, flat)
    found = lagrange.dynamics(lowering, flat, symbols.directions)
    totals = energies.system_energies(graph, found, symbols.directions)
    lowering.provide = Provider(lowering, flat, symbols, found, totals, required)
    rows = constraints.constraint_rows(lowering, flat)
    return Equations(
        flat=flat,
        graph=graph,
        symbols=symbols,
        lowering=lowering,
        dynamics=found,
        required=required,
        energies=totals,
        rows=rows,
    )


def with_row_factors(equations: Equations, factors: Sequence[float]) -> Equations:
    """The same with rows times `factors` (nc,), and for all that is lowered from now on with the multipliers of the
    text as these times those of the rows."""
    flat, graph = equations.flat, equations.graph
    powers = [graph.constant(factor) for factor in factors]
    symbols = copy(equations.symbols)
    symbols.rows = {name: graph.multiply(by, lam) for (name, lam), by in zip(symbols.rows.items(), powers, strict=True)}
    lowering = Lowering(graph, flat, symbols)
    share_positions(lowering, flat)
    lowering.provide = Provider(lowering, flat, symbols, equations.dynamics, equations.energies, equations.required)
    residuals = tuple(graph.multiply(by, row) for by, row in zip(powers, equations.rows.residuals, strict=True))
    return replace(equations, symbols=symbols, lowering=lowering, rows=replace(equations.rows, residuals=residuals))
