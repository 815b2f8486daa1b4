"""Sums and products in an order in which little waits: what is there early is taken together first.

No operation more: only sums and products that nothing else uses are taken apart, and those of parameters alone come
together. Recursions along a chain are as slow as what each link waits for.
"""

from __future__ import annotations

import heapq
from collections.abc import Collection, Sequence
from itertools import islice

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.derivation.program.passes.fuse import exact
from lagdsl.derivation.program.program import Block

# Latency of operations, in additions; all others are as rare as a root.
_LATENCY = {Op.NEGATE: 0, Op.ADD: 1, Op.SUBTRACT: 1, Op.MULTIPLY: 1, Op.DIVIDE: 3}
_SLOW = 5
_PARAMETERS = 1 << Group.P
_MULTIPLY = Op.MULTIPLY
# 1 of sums, 2 of products, 0 of what is neither.
_LEVELS = {op: 1 if op in (Op.ADD, Op.SUBTRACT) else 2 if op is Op.MULTIPLY else 0 for op in Op}


def reassociate(graph: Graph, roots: Sequence[int], kept: Collection[int]) -> list[int]:
    """Nodes that mean the same as `roots`, up to rounding, with the latest operands outermost. Nodes of `kept` stay."""
    return _Pass(graph, roots, kept).roots


def reassociated(graph: Graph, blocks: Sequence[Block]) -> tuple[Block, ...]:
    """Results of one function with the same values, sooner; what the check of pivots compares is nothing that must be
    exact."""
    kept = exact(graph, [node for block in blocks if block.name != "pivot" for node in block.nodes])
    nodes = iter(reassociate(graph, [node for block in blocks for node in block.nodes], kept))
    return tuple(block.with_nodes(list(islice(nodes, len(block.nodes)))) for block in blocks)


class _Pass:
    def __init__(self, graph: Graph, roots: Sequence[int], kept: Collection[int]) -> None:
        self._graph = graph
        self._kept = kept
        self._when: dict[int, int] = {}
        self._inner: set[int] = set()
        live = graph.live(roots)
        self._uses = self._counted(live, roots)
        self._absorb(live)
        self._new: dict[int, int] = {}
        for node in live:
            if node not in self._inner:
                self._new[node] = self._rebuilt(node)
        self.roots = [self._new[root] for root in roots]

    def _counted(self, live: Sequence[int], roots: Sequence[int]) -> dict[int, int]:
        uses, operands = dict.fromkeys(live, 0), self._graph.operands
        for node in live:
            for operand in operands[node]:
                uses[operand] += 1
        for root in roots:
            uses[root] += 1
        return uses

    def _absorb(self, live: Sequence[int]) -> None:
        """Sums in sums and products in products that nothing else uses."""
        ops, operands, groups, uses = self._graph.op, self._graph.operands, self._graph.groups, self._uses
        for node in live:
            level = _LEVELS[ops[node]]
            if not level or node in self._kept:
                continue
            for x in operands[node]:
                if uses[x] == 1 and _LEVELS[ops[x]] == level and x not in self._kept and groups[x] & ~_PARAMETERS:
                    self._inner.add(x)

    def _is_parametric(self, node: int) -> bool:
        return not self._graph.groups[node] & ~_PARAMETERS

    def _rebuilt(self, node: int) -> int:
        graph = self._graph
        operands = graph.operands[node]
        if not operands or not graph.groups[node] & ~_PARAMETERS or node in self._kept:
            return node
        if not self._inner.isdisjoint(operands):
            return self._sum(node) if _LEVELS[graph.op[node]] == 1 else self._product(self._factors(node))
        known = self._new
        if graph.op[node] is _MULTIPLY:
            return self._gathered(known[operands[0]], known[operands[1]])
        return graph.rebuild(node, [known[x] for x in operands])

    def _gathered(self, x: int, y: int) -> int:
        """x*y; a parameter goes to the parameter that is a factor of the other already."""
        graph, groups = self._graph, self._graph.groups
        for first, second in ((x, y), (y, x)):
            if not groups[first] & ~_PARAMETERS and graph.op[second] is _MULTIPLY:
                for which, factor in enumerate(graph.operands[second]):
                    if self._is_parametric(factor):
                        return graph.multiply(graph.multiply(first, factor), graph.operands[second][1 - which])
        return graph.multiply(x, y)

    def _factors(self, node: int) -> list[int]:
        found: list[int] = []
        stack = [node]
        while stack:
            x = stack.pop()
            if x == node or x in self._inner:
                stack.extend(reversed(self._graph.operands[x]))
            else:
                found.append(self._new[x])
        return found

    def _product(self, factors: list[int]) -> int:
        heap = [(self._time(x), index, x) for index, x in enumerate(factors)]
        heapq.heapify(heap)
        count = len(heap)
        while len(heap) > 1:
            x, y = heapq.heappop(heap)[2], heapq.heappop(heap)[2]
            count += 1
            product = self._gathered(x, y)
            heapq.heappush(heap, (self._time(product), count, product))
        return heap[0][2]

    def _sum(self, node: int) -> int:
        graph = self._graph
        heap: list[tuple[int, int, int, bool]] = []
        stack = [(node, False)]
        while stack:
            x, negative = stack.pop()
            if x == node or x in self._inner:
                first, second = graph.operands[x]
                stack += [(second, negative ^ (graph.op[x] is Op.SUBTRACT)), (first, negative)]
            else:
                heap.append((self._wanted(self._new[x]), len(heap), self._new[x], negative))
        heapq.heapify(heap)
        count = len(heap)
        while len(heap) > 1:
            _, _, x, x_negative = heapq.heappop(heap)
            _, _, y, y_negative = heapq.heappop(heap)
            count += 1
            if x_negative == y_negative:
                total, negative = graph.add(x, y), x_negative
            else:
                total, negative = (graph.subtract(x, y) if y_negative else graph.subtract(y, x)), False
            heapq.heappush(heap, (self._wanted(total), count, total, negative))
        _, _, total, negative = heap[0]
        return graph.negate(total) if negative else total

    def _wanted(self, node: int) -> int:
        """When the operands of a product are there, since its sum comes with it; else when the node is."""
        graph = self._graph
        is_product = graph.op[node] is _MULTIPLY and graph.groups[node] & ~_PARAMETERS
        return self._time(node) - (1 if is_product else 0)

    def _time(self, node: int) -> int:
        """When a node is there, in additions."""
        when, all_operands, groups = self._when, self._graph.operands, self._graph.groups
        found = when.get(node)
        if found is not None:
            return found
        stack = [node]
        while stack:
            x = stack[-1]
            operands = all_operands[x]
            if not operands or not groups[x] & ~_PARAMETERS:
                when[x] = 0
                stack.pop()
                continue
            before = len(stack)
            for y in operands:
                if y not in when:
                    stack.append(y)
            if len(stack) == before:
                when[x] = self._after(x, operands)
                stack.pop()
        return when[node]

    def _after(self, node: int, operands: Sequence[int]) -> int:
        op, ops, when = self._graph.op[node], self._graph.op, self._when
        if _LEVELS[op] == 1:
            x, y = operands
            at_x, at_y = when[x], when[y]
            first = at_x - 1 if ops[x] is _MULTIPLY else at_x
            second = at_y - 1 if ops[y] is _MULTIPLY else at_y
            return 1 + max(first, second, min(at_x, at_y))
        return max([when[x] for x in operands]) + _LATENCY.get(op, _SLOW)
