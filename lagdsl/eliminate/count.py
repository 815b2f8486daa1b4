"""What an evaluation costs."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import Group, Op

_COUNTED = frozenset({Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.DIVIDE})
_PARAMETER = 1 << Group.P


def flops(graph: Graph, roots: Iterable[int]) -> int:
    """Additions, subtractions, multiplications and divisions of one evaluation. What depends on parameters alone is
    computed once and not counted; nor are functions and changes of sign."""
    return sum(1 for node in graph.live(roots) if graph.op[node] in _COUNTED and graph.groups[node] & ~_PARAMETER)
