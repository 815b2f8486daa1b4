"""Items that expressions tie together: disjoint sets of numbers, and for each node one of the items it depends on."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group


class Ties:
    """Of `count` items. `item_of` tells that of a symbol of `groups`; -1: the symbol ties nothing."""

    def __init__(self, graph: Graph, count: int, groups: Iterable[Group], item_of: Callable[[int], int]) -> None:
        self._graph, self._item_of = graph, item_of
        self._leader = list(range(count))
        self._member = [-1] * len(graph)  # -1: depends on none
        self._mask = sum(1 << group for group in groups)

    def leader_of(self, item: int) -> int:
        """The least item of its set."""
        leader = self._leader
        while leader[item] != item:
            leader[item] = item = leader[leader[item]]
        return item

    def leaders(self) -> list[int]:
        return [self.leader_of(item) for item in range(len(self._leader))]

    def join(self, one: int, other: int) -> None:
        one, other = self.leader_of(one), self.leader_of(other)
        if one != other:
            self._leader[max(one, other)] = min(one, other)

    def look(self, roots: Iterable[int]) -> None:
        """Items on which `roots` and all nodes below them depend; those of one node are one."""
        graph, member, mask = self._graph, self._member, self._mask
        operands, groups = graph.operands, graph.groups
        for node in graph.live(roots):
            if not groups[node] & mask:
                continue
            found = -1 if operands[node] else self._item_of(node)
            for operand in operands[node]:
                other = member[operand]
                if other >= 0 and other != found:
                    if found >= 0:
                        self.join(found, other)
                    found = other
            member[node] = found

    def tie(self, item: int, node: int) -> None:
        """The item and those on which the node depends are one."""
        if self._member[node] >= 0:
            self.join(item, self._member[node])
