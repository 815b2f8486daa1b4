"""Cost of an evaluation."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op

_COUNTED = frozenset({Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.DIVIDE})
_PARAMETER = 1 << Group.P


def flops(graph: Graph, roots: Iterable[int]) -> int:
    """Additions, subtractions, multiplications and divisions of one evaluation. Nodes that depend on parameters alone
    are computed once and not counted; nor are functions and changes of sign."""
    ops, groups, others = graph.op, graph.groups, ~_PARAMETER
    return len([node for node in graph.live(roots) if ops[node] in _COUNTED and groups[node] & others])


class TooMany(Exception):  # noqa: N818  it is a reason to try something else
    """More nodes were made than the result can be worth."""


class Budget:
    """Number of nodes that may still be made; None: no bound."""

    def __init__(self, graph: Graph, nodes: int | None) -> None:
        self._graph = graph
        self._most = None if nodes is None else len(graph) + nodes

    def check(self) -> None:
        """Raises TooMany."""
        if self._most is not None and len(self._graph) > self._most:
            raise TooMany
