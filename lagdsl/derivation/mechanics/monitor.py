"""Sizes of the terms of an invariant: the measure of its drift."""

from __future__ import annotations

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op


def largest_term(graph: Graph, root: int) -> int:
    """Largest absolute value among the terms of `root`; sums are looked through, also under a constant factor.

    Shared sums are looked at once: the size is linear in that of the expression.
    """
    known: dict[int, int] = {}
    stack = [root]
    while stack:
        node = stack[-1]
        if node in known:
            stack.pop()
            continue
        missing = [x for x in _summands(graph, node) if x not in known]
        if missing:
            stack += missing
            continue
        known[node] = _size(graph, node, known)
        stack.pop()
    return known[root]


def _summands(graph: Graph, node: int) -> tuple[int, ...]:
    op = graph.op[node]
    if op in (Op.ADD, Op.SUBTRACT, Op.NEGATE):
        return graph.arguments(node)
    if op in (Op.MULTIPLY, Op.DIVIDE) and _factor(graph, node):
        return tuple(x for x in graph.arguments(node) if not _is_still(graph, x))
    return ()


def _factor(graph: Graph, node: int) -> bool:
    """True if a product or quotient is a moving value times or over a constant one."""
    still_first, still_second = (_is_still(graph, x) for x in graph.arguments(node))
    return still_second != still_first and (still_second or graph.op[node] is Op.MULTIPLY)


def _is_still(graph: Graph, node: int) -> bool:
    return not graph.groups[node] & ~(1 << Group.P)


def _size(graph: Graph, node: int, known: dict[int, int]) -> int:
    inner = _summands(graph, node)
    op = graph.op[node]
    if not inner:
        return graph.unary(Op.ABS, node)
    if op is Op.NEGATE:
        return known[inner[0]]
    if len(inner) == 2:
        return graph.binary(Op.MAX, known[inner[0]], known[inner[1]])
    other = graph.a[node] if graph.a[node] != inner[0] else graph.b[node]
    magnitude = graph.unary(Op.ABS, other)
    return graph.rebuild(node, (magnitude, known[inner[0]]) if op is Op.MULTIPLY else (known[inner[0]], magnitude))
