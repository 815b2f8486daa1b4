"""Directional derivatives of what a program computes: one forward pass along direction symbols."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.algebra.graph.differentiate import Tangent
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import DIRECTION_OF, Group

STATE_GROUPS = (Group.Q, Group.QD, Group.Z, Group.U, Group.P)
SOLVED_GROUPS = tuple(DIRECTION_OF)
P_GROUPS = (Group.P,)


def directional(graph: Graph, roots: Iterable[int], groups: tuple[Group, ...]) -> list[int]:
    """d(root) for each of `roots` along the directions of `groups`; time and all other symbols are held."""

    def direction(symbol: int) -> int:
        return graph.symbol(DIRECTION_OF[graph.group(symbol)], graph.b[symbol])

    return Tangent(graph, groups, direction).of_all(roots)
