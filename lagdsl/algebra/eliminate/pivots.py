"""Cancellation in pivots: the digits that an elimination without exchanges has lost."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from lagdsl.algebra.eliminate.form import NotApplicable
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Op
from lagdsl.foundation.record import record

# A row follows from others if its squared distance from them is below this part of its size.
_FOLLOWS = 1e-10
# A row whose size is below this part of the largest one is none: its entries are round-off.
_SHORT = 1e-6


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
                known[node] = _extreme(graph, Op.MAX, lost) if lost else node
        return known[root]

    def _parts(self, node: int) -> tuple[int, ...]:
        graph = self._graph
        if graph.op[node] is Op.SUBTRACT:
            return (graph.a[node],)
        if graph.op[node] is Op.ADD and self._of_sums:
            return (graph.a[node], graph.b[node])
        return ()


def least(graph: Graph, pivots: Iterable[tuple[int, int]]) -> int:
    """The least of pivot / |reference|; negative where a pivot is, 1 where nothing was subtracted from any.

    Raises NotApplicable where a pivot is negative however parameters are chosen: the system is not positive definite.
    """
    smallest = graph.one
    for pivot, reference in dict.fromkeys(pivots):
        if pivot != reference:
            part = graph.divide(pivot, graph.unary(Op.ABS, reference))
        elif graph.op[pivot] is Op.NEGATE or graph.value.get(pivot, 1.0) <= 0.0:
            raise NotApplicable
        else:
            part = graph.select(graph.binary(Op.LESS, graph.zero, pivot), graph.one, graph.negate(graph.one))
        smallest = graph.binary(Op.MIN, smallest, part)
    return smallest


@record(kw_only=True)
class Loop:
    """Rows that share coordinates, by index; `usual` are sizes of the solved ones, to compare them by."""

    solved: Sequence[int]
    following: Sequence[int]
    usual: Mapping[int, float]


def weakest(
    graph: Graph,
    pivot: int,
    strengths: Mapping[int, tuple[int, int]],
    groups: Sequence[Loop],
    kept: Sequence[tuple[int, int]],
) -> int:
    """The least of `pivot` and, over groups of rows, the pivot of a multiplier as a part of the largest size in its
    group; zero where a row does not follow from others that should, or a kept one does: of each, what rates give to its
    size and what solved rows take from that."""
    smallest = pivot
    everywhere = [strengths[index][1] for group in groups for index in group.solved]
    for group in groups:
        if len(group.solved) > 1:
            scales = {index: graph.constant(1.0 / group.usual[index]) for index in group.solved}
            left = [graph.multiply(scale, strengths[index][0]) for index, scale in scales.items()]
            sizes = [graph.multiply(scale, strengths[index][1]) for index, scale in scales.items()]
            part = graph.divide(_extreme(graph, Op.MIN, left), _extreme(graph, Op.MAX, sizes))
            smallest = graph.binary(Op.MIN, smallest, part)
        for index in group.following:
            longest = _extreme(graph, Op.MAX, [strengths[index][1] for index in group.solved] or everywhere)
            smallest = graph.binary(Op.MIN, smallest, _follows(graph, *strengths[index], longest))
    for given, taken in kept:
        if taken != graph.zero:
            most = graph.multiply(graph.constant(_FOLLOWS), given)
            own = graph.binary(Op.LESS_EQUAL, most, graph.subtract(given, taken))  # also where it is zero
            smallest = graph.binary(Op.MIN, smallest, own)
    return smallest


def _follows(graph: Graph, left: int, size: int, longest: int) -> int:
    """True if others leave nothing of a row; one that is short against `longest` is round-off."""
    least_size = graph.multiply(graph.constant(_SHORT), longest)
    most = graph.multiply(graph.constant(_FOLLOWS), graph.binary(Op.MAX, size, least_size))
    return graph.binary(Op.LESS_EQUAL, graph.unary(Op.ABS, left), most)


def _extreme(graph: Graph, op: Op, nodes: Sequence[int]) -> int:
    found = nodes[0]
    for node in dict.fromkeys(nodes):
        if node != found:
            found = graph.binary(op, found, node)
    return found
