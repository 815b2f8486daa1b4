"""Forces along directions without inertia: N' f of M qdd - J' lam = f.

Coordinates D that rows tie to the others by parameters have no weight that is a number. Their equations give the
multipliers that would act in these rows, f_D + J_D' lam = 0, and the force on the others is f + J' lam.
"""

from __future__ import annotations

from lagdsl.algebra.graph.differentiate import adjoints
from lagdsl.derivation.mechanics.lagrange.lagrange import Terms
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.derivation.mechanics.lowering.symbols import Symbols
from lagdsl.language.flat.expression import ForceBalance
from lagdsl.language.flat.model import FlatModel


def force_balance(lowering: Lowering, flat: FlatModel, symbols: Symbols, terms: Terms, balance: ForceBalance) -> int:
    """The node of the force, a linear function of the forces on the coordinates that `balance` names."""
    graph, place = lowering.graph, symbols.coordinate_index
    slopes = _jacobian_rows(lowering, flat, symbols, [row for _, row in balance.ties])
    # one equation per tied coordinate, its multipliers by number and its force last; then the force that is asked for
    table = [[*(row[place[name]] for row in slopes), _force(lowering, terms, place[name])] for name, _ in balance.ties]
    weighted = [(graph.constant(weight), place[name]) for name, weight in balance.weights]
    last = [graph.sum(graph.multiply(weight, row[i]) for weight, i in weighted) for row in slopes]
    last.append(graph.sum(graph.multiply(weight, _force(lowering, terms, i)) for weight, i in weighted))
    for k, pivot in enumerate(table):
        for row in (*table[k + 1 :], last):
            factor = graph.divide(row[k], pivot[k])
            row[k:] = [graph.subtract(x, graph.multiply(factor, y)) for x, y in zip(row[k:], pivot[k:], strict=True)]
    return last[-1]


def _force(lowering: Lowering, terms: Terms, i: int) -> int:
    applied = lowering.graph.add(lowering.graph.subtract(terms.load[i], terms.drag[i]), terms.push[i])
    return lowering.graph.subtract(applied, lowering.bias_rate.of(terms.momentum[i]))


def _jacobian_rows(lowering: Lowering, flat: FlatModel, symbols: Symbols, names: list[str]) -> list[list[int]]:
    """J of these rows, by coordinates."""
    graph, directions = lowering.graph, symbols.directions
    found = {
        row: (residual, constraint.level == "position")
        for constraint in flat.constraints
        for row, residual in zip(constraint.rows, constraint.residuals, strict=True)
    }
    rows = []
    for name in names:
        residual, position_level = found[name]
        by = directions.positions if position_level else directions.rates
        group = directions.position_group if position_level else directions.rate_group
        slopes = adjoints(graph, {lowering.scalar(residual): graph.one}, (group,))
        rows.append([slopes.get(symbol, graph.zero) for symbol in by])
    return rows
