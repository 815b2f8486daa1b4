"""What subtraction left of pivots: the digits that an elimination without exchanges has lost."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import Op


class References:
    """For pivots, the largest of what they were made from by subtraction; memoised.

    Only for differences of nodes, unless `of_sums`: where multipliers are eliminated, they add to what is left.
    """

    def __init__(self, graph: Graph, *, of_sums: bool) -> None:
        self._graph, self._of_sums = graph, of_sums
        self._known: dict[int, int] = {}

    def of(self, root: int) -> int:
        """`root` itself where nothing was subtracted."""
        graph, known = self._graph, self._known
        stack = [root]
        while stack:
            node = stack[-1]
            parts = self._parts(node)
            missing = [part for part in parts if part not in known]
            if missing:
                stack += missing
                continue
            stack.pop()
            found = [known[part] for part in parts]
            if graph.op[node] is Op.SUBTRACT:
                known[node] = found[0]
            else:
                lost = [other for part, other in zip(parts, found, strict=True) if part != other]
                known[node] = _largest(graph, lost) if lost else node
        return known[root]

    def _parts(self, node: int) -> tuple[int, ...]:
        graph = self._graph
        match graph.op[node]:
            case Op.SUBTRACT:
                return (graph.a[node],)
            case Op.ADD if self._of_sums:
                return (graph.a[node], graph.b[node])
            case _:
                return ()


def _largest(graph: Graph, nodes: list[int]) -> int:
    largest = nodes[0]
    for node in nodes[1:]:
        if node != largest:
            largest = graph.binary(Op.MAX, largest, node)
    return largest


def least(graph: Graph, pivots: Iterable[tuple[int, int]]) -> int:
    """The least of pivot / reference; 1 where nothing was subtracted from any."""
    smallest = graph.one
    for pivot, reference in dict.fromkeys(pivots):
        if pivot != reference:
            smallest = graph.binary(Op.MIN, smallest, graph.divide(pivot, reference))
    return smallest


def weakest(
    graph: Graph,
    pivot: int,
    strengths: Mapping[int, tuple[int, int]],
    usual: Mapping[int, float],
    groups: Iterable[Sequence[int]],
) -> int:
    """The least of `pivot` and, over groups of rows, the pivot of a multiplier as a part of the largest size in its
    group; each in its usual size."""
    smallest = pivot
    for group in groups:
        if all(strengths[index][0] == strengths[index][1] for index in group) and len(group) == 1:
            continue
        left, largest = None, None
        for index in group:
            scale = graph.constant(1.0 / usual[index])
            own, size = (graph.multiply(scale, node) for node in strengths[index])
            left = own if left is None else graph.binary(Op.MIN, left, own)
            largest = size if largest is None else graph.binary(Op.MAX, largest, size)
        assert left is not None
        assert largest is not None
        smallest = graph.binary(Op.MIN, smallest, graph.divide(left, largest))
    return smallest
