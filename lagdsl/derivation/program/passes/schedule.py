"""The statements of one function: which nodes get a variable, and in which order.

Only nodes that a result needs are there. A node used once stays inside the expression of its user, as far as that stays
short.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import FIRST_UNARY, Op
from lagdsl.foundation.record import record

# Operations in one printed expression; bounds line length and the recursion of printers and parsers.
_LARGEST_EXPRESSION = 12


@record()
class Schedule:
    """`named` nodes become variables, in this order. `symbols` are the symbols read, ascending."""

    named: tuple[int, ...]
    symbols: tuple[int, ...]


def schedule(
    graph: Graph,
    roots: Sequence[int],
    given: Collection[int] = (),
    live: Sequence[int] | None = None,
    repeated: Collection[int] = (),
) -> Schedule:
    """Statements that compute `roots`, where the nodes of `given` are at hand already; `live`, where it is known.

    Nodes of `repeated` that are one operation stay inside all expressions that use them.
    """
    ops, operands = graph.op, graph.operands
    live = graph.live(roots, given) if live is None else live
    uses = dict.fromkeys(live, 0)
    for node in live:
        if node not in given:
            for operand in operands[node]:
                uses[operand] += 1
    for root in roots:
        uses[root] += 1
    weight: dict[int, int] = {}
    named: list[int] = []
    symbols: list[int] = []
    for node in live:
        op = ops[node]
        if op is Op.SYMBOL:
            symbols.append(node)
        if op < FIRST_UNARY or node in given:
            weight[node] = 0
            continue
        total = 1
        for operand in operands[node]:
            total += weight[operand]
        if total > _LARGEST_EXPRESSION or (uses[node] > 1 and not (total == 1 and node in repeated)):
            named.append(node)
            total = 0
        weight[node] = total
    return Schedule(tuple(named), tuple(symbols))
