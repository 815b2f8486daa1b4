"""Directional derivatives of what a program computes: one forward pass along direction symbols."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.graph.differentiate import Tangent
from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import Group

_DIRECTION_OF = {
    Group.Q: Group.DIRECTION_Q,
    Group.QD: Group.DIRECTION_QD,
    Group.Z: Group.DIRECTION_Z,
    Group.U: Group.DIRECTION_U,
    Group.P: Group.DIRECTION_P,
    Group.QDD: Group.DIRECTION_QDD,
    Group.LAMBDA: Group.DIRECTION_LAMBDA,
}
STATE_GROUPS = (Group.Q, Group.QD, Group.Z, Group.U, Group.P)
SOLVED_GROUPS = tuple(_DIRECTION_OF)


def directional(graph: Graph, roots: Iterable[int], groups: tuple[Group, ...]) -> list[int]:
    """d(root) for each of `roots` along the directions of `groups`; time and all other symbols are held."""

    def direction(symbol: int) -> int:
        return graph.symbol(_DIRECTION_OF[graph.group(symbol)], graph.b[symbol])

    return Tangent(graph, groups, direction).of_all(roots)
