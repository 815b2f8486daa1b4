"""The statements of one function: which nodes get a variable, and in which order.

Only nodes that a result needs are there. A node used once stays inside the expression of its user, as far as that stays
short.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass

from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import Op

# Operations in one printed expression; bounds line length and the recursion of printers and parsers.
_LARGEST_EXPRESSION = 12


@dataclass(frozen=True, slots=True)
class Schedule:
    """`named` nodes become variables, in this order. `symbols` are the symbols read, ascending."""

    named: tuple[int, ...]
    symbols: tuple[int, ...]


def schedule(graph: Graph, roots: Iterable[int], given: Collection[int] = ()) -> Schedule:
    """Statements that compute `roots`, where the nodes of `given` are at hand already."""
    roots = list(roots)
    live = live_beside(graph, roots, given)
    uses = dict.fromkeys(live, 0)
    for node in live:
        if node not in given:
            for argument in graph.arguments(node):
                uses[argument] += 1
    for root in roots:
        uses[root] += 1
    weight: dict[int, int] = {}
    named: list[int] = []
    for node in live:
        if node in given or graph.op[node] in (Op.CONSTANT, Op.SYMBOL):
            weight[node] = 0
            continue
        weight[node] = 1 + sum(weight[argument] for argument in graph.arguments(node))
        if uses[node] > 1 or weight[node] > _LARGEST_EXPRESSION:
            named.append(node)
            weight[node] = 0
    symbols = tuple(node for node in live if graph.op[node] is Op.SYMBOL)
    return Schedule(tuple(named), symbols)


def live_beside(graph: Graph, roots: Iterable[int], given: Collection[int]) -> list[int]:
    """Ids of the nodes that `roots` are computed from, ascending; what only `given` nodes need is left out."""
    roots = list(roots)
    mark = bytearray(max(roots, default=-1) + 1)
    for root in roots:
        mark[root] = 1
    for node in range(len(mark) - 1, -1, -1):
        if mark[node] and node not in given:
            for argument in graph.arguments(node):
                mark[argument] = 1
    return [node for node, marked in enumerate(mark) if marked]
