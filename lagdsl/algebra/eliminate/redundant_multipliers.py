"""Multipliers of rows that depend on others: of all that do the same, the shortest.

A unit multiplier of a following row, with what the solved ones of its loop then are, does nothing: J'(e + K') = 0. The
component of the multipliers along these directions is subtracted. No two of them share a following row, so the matrix 1
+ K K' of their products is positive definite for every K.
"""

from __future__ import annotations

from collections.abc import Mapping

from lagdsl.algebra.eliminate.count import Budget
from lagdsl.algebra.eliminate.matrix import SparseSystem
from lagdsl.algebra.eliminate.rows import Rows, multiplier_of
from lagdsl.algebra.eliminate.steps import Pivoted, Steps, solve_steps, steps_of
from lagdsl.algebra.graph.graph import Graph
from lagdsl.foundation.record import record


@record()
class RedundantMultipliers:
    """K by following row and solved row, without what is identically zero; and 1 + K K' factored."""

    directions: dict[int, dict[int, int]]
    steps: Steps


def find_redundant_multipliers(graph: Graph, rows: Rows, tied: Mapping[int, Mapping[int, int]]) -> RedundantMultipliers:
    """`tied`: by multiplier of a solved row, in the order of elimination, its dependence on others of its loop."""
    index_of = {multiplier_of(row.index): row.index for row in (*rows.solved, *rows.following)}
    users: dict[int, list[int]] = {}
    for multiplier, shares in tied.items():
        for k in shares:
            users.setdefault(k, []).append(multiplier)
    order = {multiplier: position for position, multiplier in enumerate(tied)}
    directions: dict[int, dict[int, int]] = {}
    for row in rows.following:
        known = {multiplier_of(row.index): graph.one}
        for multiplier in sorted(_above(multiplier_of(row.index), users), key=order.__getitem__, reverse=True):
            shares = tied[multiplier]
            known[multiplier] = graph.negate(
                graph.sum(graph.multiply(share, known[k]) for k, share in shares.items() if k in known)
            )
        del known[multiplier_of(row.index)]
        directions[row.index] = {index_of[k]: value for k, value in known.items() if value != graph.zero}
    return RedundantMultipliers(directions, steps_of({}, _factored(graph, directions)))


def _above(multiplier: int, users: Mapping[int, list[int]]) -> dict[int, None]:
    """All that depend on it, directly or through others."""
    found: dict[int, None] = {}
    stack = [multiplier]
    while stack:
        for user in users.get(stack.pop(), ()):
            if user not in found:
                found[user] = None
                stack.append(user)
    return found


def _factored(graph: Graph, directions: Mapping[int, Mapping[int, int]]) -> list[Pivoted]:
    system = SparseSystem(graph, {})
    sharing: dict[int, list[int]] = {}
    for index, direction in directions.items():
        system.add(index, index, graph.one)
        for solved, value in direction.items():
            sharing.setdefault(solved, []).append(index)
            for other in sharing[solved]:
                system.add(index, other, graph.multiply(value, directions[other][solved]))
    return [Pivoted(index, system.pivot(index), system.minimize(index)) for index in directions]


def shortest(
    graph: Graph, redundant_multipliers: RedundantMultipliers, multipliers: Mapping[int, int]
) -> dict[int, int]:
    """`multipliers` of solved rows by index, with those of following ones taken as zero; then those of both."""
    along = {
        index: graph.sum(graph.multiply(value, multipliers[solved]) for solved, value in direction.items())
        for index, direction in redundant_multipliers.directions.items()
    }
    taken = solve_steps(graph, redundant_multipliers.steps, along, Budget(graph, None))
    result = dict(multipliers)
    for index, direction in redundant_multipliers.directions.items():
        result[index] = graph.negate(taken.get(index, graph.zero))
        for solved, value in direction.items():
            result[solved] = graph.subtract(result[solved], graph.multiply(value, taken.get(index, graph.zero)))
    return result
