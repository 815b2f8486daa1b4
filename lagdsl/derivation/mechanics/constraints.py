"""Constraint rows: residuals phi(q, t) or A(q, t) qd + b(q, t), their Jacobian J, and J' lambda.

The constraint force of `a = b` is +lambda d(a - b)/dq: a positive multiplier pushes towards larger a - b.
"""

from __future__ import annotations

from dataclasses import replace

from lagdsl.algebra.eliminate.rows import Row
from lagdsl.algebra.graph.differentiate import adjoints
from lagdsl.algebra.graph.graph import Graph
from lagdsl.derivation.mechanics.lowering.acceleration import refuse_accelerations
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.derivation.mechanics.lowering.symbols import Directions
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel


@record()
class Rows:
    """One entry per row in source order; `position_level` rows restrict the coordinates themselves."""

    residuals: tuple[int, ...]
    position_level: tuple[bool, ...]


def constraint_rows(lowering: Lowering, flat: FlatModel) -> Rows:
    residuals: list[int] = []
    levels: list[bool] = []
    for constraint in flat.constraints:
        lowering.place = constraint.spans
        nodes = [lowering.scalar(residual) for residual in constraint.residuals]
        refuse_accelerations(lowering.graph, nodes, constraint.spans, f"constraint `{constraint.name}`")
        residuals += nodes
        levels += [constraint.level == "position"] * len(nodes)
    return Rows(tuple(residuals), tuple(levels))


def constraint_jacobian(graph: Graph, rows: Rows, directions: Directions) -> list[dict[int, int]]:
    """J: d(phi)/dq of rows of position level, d(residual)/d(qd) of rows of velocity level; row by row, by column,
    ascending, without what is identically zero."""
    columns = [{symbol: j for j, symbol in enumerate(each)} for each in (directions.positions, directions.rates)]
    groups = (directions.position_group, directions.rate_group)
    found = []
    for residual, position_level in zip(rows.residuals, rows.position_level, strict=True):
        level = 0 if position_level else 1
        row = adjoints(graph, {residual: graph.one}, (groups[level],))
        known = {columns[level][symbol]: node for symbol, node in row.items() if symbol in columns[level]}
        found.append({column: known[column] for column in sorted(known) if known[column] != graph.zero})
    return found


def constraint_forces(graph: Graph, rows: Rows, multipliers: list[int], directions: Directions) -> list[int]:
    """J' lambda for each of `directions`, by one reverse sweep over the rows of each level."""
    seeds: tuple[dict[int, int], dict[int, int]] = ({}, {})
    for residual, position_level, multiplier in zip(rows.residuals, rows.position_level, multipliers, strict=True):
        weights = seeds[0] if position_level else seeds[1]
        weights[residual] = graph.add(weights.get(residual, graph.zero), multiplier)
    moved = adjoints(graph, seeds[0], (directions.position_group,))
    driven = adjoints(graph, seeds[1], (directions.rate_group,))
    return [
        graph.add(moved.get(position, graph.zero), driven.get(rate, graph.zero))
        for position, rate in zip(directions.positions, directions.rates, strict=True)
    ]


def velocity_residuals(lowering: Lowering, rows: Rows) -> list[int]:
    """J qd + b of every row: what has to vanish for the rates."""
    return [
        lowering.rate.of(residual) if position_level else residual
        for residual, position_level in zip(rows.residuals, rows.position_level, strict=True)
    ]


def bias(lowering: Lowering, rows: Rows) -> list[int]:
    """gamma of every row: what J qdd has to be."""
    return [lowering.graph.negate(lowering.bias_rate.of(residual)) for residual in velocity_residuals(lowering, rows)]


def baumgarte_terms(lowering: Lowering, rows: Rows, rate: int) -> list[int]:
    """Terms that are subtracted from gamma of every row, so that errors of the constraints decay with the rate a
    [1/s], the node `rate`: 2 a dphi/dt + a^2 phi for rows of position level, a (A qd + b) for others.

    Source: Baumgarte, *Comput. Methods Appl. Mech. Eng.* 1 (1972), 1, critically damped.
    """
    graph = lowering.graph
    terms = []
    for residual, position_level in zip(rows.residuals, rows.position_level, strict=True):
        decaying = residual
        if position_level:
            twice = graph.multiply(graph.constant(2.0), lowering.rate.of(residual))
            decaying = graph.add(twice, graph.multiply(rate, residual))
        terms.append(graph.multiply(rate, decaying))
    return terms


def with_baumgarte_terms(lowering: Lowering, rows: Rows, plain: list[Row], rate: int) -> list[Row]:
    """The rows `plain` of `rows_of` with these terms in their biases."""
    terms = baumgarte_terms(lowering, rows, rate)
    return [replace(row, bias=lowering.graph.subtract(row.bias, terms[row.index])) for row in plain]


def rows_of(lowering: Lowering, rows: Rows, directions: Directions) -> list[Row]:
    """J qdd = gamma row by row, as elimination takes them."""
    matrix = constraint_jacobian(lowering.graph, rows, directions)
    return [
        Row(index=index, terms={directions.rates[column]: term for column, term in terms.items()}, bias=gamma)
        for index, (terms, gamma) in enumerate(zip(matrix, bias(lowering, rows), strict=True))
    ]
