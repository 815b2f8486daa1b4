"""Products that are added to something: one operation, rounded once, where the machine has it.

The sum is there sooner than after a product and a sum, and recursions wait for it. Nothing is fused that a comparison
or a step depends on: a difference that is zero stays zero there.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import STEPS, Op

# Latency of operations, in additions; all others are as rare as a root.
_LATENCY = {Op.NEGATE: 0, Op.ADD: 1, Op.SUBTRACT: 1, Op.MULTIPLY: 1, Op.DIVIDE: 3}
_SLOW = 5


def fused(
    graph: Graph, live: Sequence[int], named: Collection[int], given: Collection[int], exact: Collection[int]
) -> dict[int, int]:
    """By sum or difference among the `live` nodes: which of its two operands, 0 or 1, is a product to be fused.

    Products that are `named` have other users, `given` ones are at hand. Of two products it is the later one.
    """
    ops, operands = graph.op, graph.operands
    when: dict[int, int] = {}
    chosen: dict[int, int] = {}
    for node in live:
        own = operands[node]
        if node in given or not own:
            when[node] = 0
            continue
        when[node] = max(when[x] for x in own) + _LATENCY.get(ops[node], _SLOW)
        if ops[node] not in (Op.ADD, Op.SUBTRACT) or node in exact:
            continue
        free = [
            which
            for which, x in enumerate(own)
            if ops[x] is Op.MULTIPLY and x not in named and x not in given and x not in exact
        ]
        if free:
            which = max(free, key=lambda each: (when[own[each]], each))
            chosen[node] = which
            when[node] = 1 + max(when[own[1 - which]], when[own[which]] - 1)
    return chosen


def fusible(graph: Graph, live: Sequence[int], roots: Sequence[int], exact: Collection[int]) -> set[int]:
    """Products that are used in sums and differences only, always with something that is no product."""
    ops, operands = graph.op, graph.operands
    found = {node for node in live if ops[node] is Op.MULTIPLY and node not in exact}
    found.difference_update(roots)
    for node in live:
        own = operands[node]
        fuses = ops[node] in (Op.ADD, Op.SUBTRACT) and node not in exact
        if not fuses or all(ops[x] is Op.MULTIPLY for x in own):
            found.difference_update(own)
    return found


def exact(graph: Graph, roots: Sequence[int]) -> set[int]:
    """Nodes that a step or a condition in what `roots` are computed from depends on."""
    found: set[int] = set()
    for node in reversed(graph.live(roots)):
        op, own = graph.op[node], graph.operands[node]
        if op in STEPS or op is Op.MOD or node in found:
            found.update(own)
        elif op is Op.SELECT:
            found.add(own[0])
    return found
