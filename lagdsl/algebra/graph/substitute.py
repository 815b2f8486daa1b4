"""Nodes replaced by others."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from lagdsl.algebra.graph.graph import Graph


class Substitution:
    """Nodes with what is in `replacement` replaced, simplified anew on the way up; memoised over calls."""

    def __init__(self, graph: Graph, replacement: Mapping[int, int]) -> None:
        self._graph = graph
        self._mask = 0
        for node in replacement:
            self._mask |= graph.groups[node]
        self._known = dict(replacement)

    def of(self, root: int) -> int:
        graph, known, mask = self._graph, self._known, self._mask
        groups, operands = graph.groups, graph.operands
        stack = [root] if groups[root] & mask else []
        while stack:
            node = stack[-1]
            if node in known:
                stack.pop()
                continue
            before, own = len(stack), operands[node]
            for x in own:
                if groups[x] & mask and x not in known:
                    stack.append(x)
            if len(stack) == before:
                new = [known.get(x, x) for x in own]
                known[node] = node if new == [*own] else graph.rebuild(node, new)
                stack.pop()
        return known.get(root, root)

    def of_all(self, roots: Iterable[int]) -> list[int]:
        return [self.of(root) for root in roots]
