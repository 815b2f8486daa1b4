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
        stack = [root]
        while stack:
            node = stack[-1]
            if node in known or not graph.groups[node] & mask:
                known.setdefault(node, node)
                stack.pop()
                continue
            arguments = graph.arguments(node)
            missing = [x for x in arguments if x not in known]
            if missing:
                stack += missing
                continue
            known[node] = graph.rebuild(node, [known[x] for x in arguments])
            stack.pop()
        return known[root]

    def of_all(self, roots: Iterable[int]) -> list[int]:
        return [self.of(root) for root in roots]
