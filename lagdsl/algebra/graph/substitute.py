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
        stack = [root]
        while stack:
            node = stack[-1]
            if node in known or not groups[node] & mask:
                stack.pop()
                continue
            before = len(stack)
            for x in operands[node]:
                if x not in known and groups[x] & mask:
                    stack.append(x)
            if len(stack) == before:
                known[node] = graph.rebuild(node, [known.get(x, x) for x in operands[node]])
                stack.pop()
        return known.get(root, root)

    def of_all(self, roots: Iterable[int]) -> list[int]:
        return [self.of(root) for root in roots]
