"""Graph search: which frames follow from which. Pure; nodes and edges are numbers.

A spanning tree is grown from the nodes that are known, cheapest edge first (Prim's algorithm with a heap). Costs of
edges are all different, so that the tree is the one of least cost and does not depend on anything else.
"""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from dataclasses import field
from typing import TypeAlias

from lagdsl.foundation.record import mutable_record, record

Cost: TypeAlias = tuple[int, ...]

# Steps that come next, in this order.
_GIVE, _CROSS, _CROSS_LAST = range(3)


@record()
class Edge:
    """Node `b` follows from node `a` and the other way round, once the nodes `needs` are known."""

    a: int
    b: int
    cost: Cost
    needs: tuple[int, ...] = ()


@record()
class Given:
    """The node is known as soon as the nodes `needs` are."""

    node: int
    needs: tuple[int, ...] = ()


@record()
class Step:
    """The way to a node: over an edge (`backward`: from its b to its a), or by one of the givens."""

    node: int
    edge: int | None = None
    backward: bool = False
    given: int | None = None


@record()
class Tree:
    """`steps` in the order in which they were made; `cuts` are the edges that close a loop, `redundant_edges` the
    givens of nodes that were known before, both in the order of their numbers."""

    steps: tuple[Step, ...]
    cuts: tuple[int, ...]
    redundant_edges: tuple[int, ...]


def span(count: int, edges: Sequence[Edge], givens: Sequence[Given]) -> Tree:
    """The tree over the nodes 0 to count - 1 that can be known."""
    return _Growth(count, edges, givens).grown()


@mutable_record()
class _Waiting:
    """Needs of edges and givens that are not met yet."""

    missing: list[int]
    by_node: dict[int, list[int]] = field(default_factory=dict)

    @staticmethod
    def of(needs_of: Sequence[tuple[int, ...]]) -> _Waiting:
        waiting = _Waiting([])
        for number, needed in enumerate(needs_of):
            needs = dict.fromkeys(needed)
            waiting.missing.append(len(needs))
            for node in needs:
                waiting.by_node.setdefault(node, []).append(number)
        return waiting

    def met(self, node: int) -> list[int]:
        """Edges and givens whose last missing need is this node."""
        ready = []
        for number in self.by_node.get(node, ()):
            self.missing[number] -= 1
            if self.missing[number] == 0:
                ready.append(number)
        return ready


class _Growth:
    def __init__(self, count: int, edges: Sequence[Edge], givens: Sequence[Given]) -> None:
        self._edges, self._givens = edges, givens
        self._known = [False] * count
        self._steps: list[Step] = []
        self._edge_needs = _Waiting.of([edge.needs for edge in edges])
        self._given_needs = _Waiting.of([given.needs for given in givens])
        self._at: list[list[int]] = [[] for _ in range(count)]
        for number, edge in enumerate(edges):
            self._at[edge.a].append(number)
            if edge.b != edge.a:
                self._at[edge.b].append(number)
        self._pending = [0] * count
        for given in givens:
            self._pending[given.node] += 1
        self._next: list[tuple[int, Cost, int]] = [
            (_GIVE, (), number) for number, missing in enumerate(self._given_needs.missing) if not missing
        ]
        self._surplus: list[int] = []

    def grown(self) -> Tree:
        while self._next:
            when, cost, number = heapq.heappop(self._next)
            if when == _GIVE:
                self._give(number)
            else:
                self._cross(when, cost, number)
        used = {step.edge for step in self._steps}
        known, missing = self._known, self._edge_needs.missing
        closing = (n for n, edge in enumerate(self._edges) if known[edge.a] and known[edge.b] and not missing[n])
        cuts = tuple(n for n in closing if n not in used)
        return Tree(tuple(self._steps), cuts, tuple(sorted(self._surplus)))

    def _give(self, number: int) -> None:
        node = self._givens[number].node
        self._pending[node] -= 1
        if self._known[node]:
            self._surplus.append(number)
        else:
            self._reach(Step(node, given=number))

    def _cross(self, when: int, cost: Cost, number: int) -> None:
        """Reach the far end of an edge; a node that may yet be given is left to the last."""
        edge = self._edges[number]
        if self._known[edge.a] and self._known[edge.b]:
            return
        node = edge.a if self._known[edge.b] else edge.b
        if self._pending[node] and when != _CROSS_LAST:
            heapq.heappush(self._next, (_CROSS_LAST, cost, number))
            return
        self._reach(Step(node, edge=number, backward=node == edge.a))

    def _reach(self, step: Step) -> None:
        self._known[step.node] = True
        self._steps.append(step)
        for number in self._given_needs.met(step.node):
            heapq.heappush(self._next, (_GIVE, (), number))
        for number in self._edge_needs.met(step.node):
            self._offer(number)
        for number in self._at[step.node]:
            self._offer(number)

    def _offer(self, number: int) -> None:
        edge = self._edges[number]
        usable = self._edge_needs.missing[number] == 0 and self._known[edge.a] != self._known[edge.b]
        if usable:
            heapq.heappush(self._next, (_CROSS, edge.cost, number))
