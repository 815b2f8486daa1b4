"""Total time derivatives of nodes along a motion: q moves with qd, qd with qdd, time with 1.

Applied twice it gives accelerations. Derivatives are made by the local rules of forward differentiation and memoised,
so that the derivative of a chain of points is as small as the chain.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from lagdsl.algebra.graph.differentiate import Tangent
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op

MOVING = (Group.TIME, Group.Q, Group.QD, Group.Z, Group.U, Group.RELEASE, Group.QDD, Group.LAMBDA, Group.DIRECTION_Z)


class TimeDerivative(Tangent):
    """d/dt of nodes. Parameters and release rates are held, discretes too but for those that are `delayed`.

    `delayed` has their derivatives, which are held again. `rate(symbol)` gives that of states, their rates, inputs,
    accelerations and multipliers, or raises where
    there is none. With `bias` the accelerations are 0 instead of symbols: what is left of d/dt then does not depend on
    them.
    """

    def __init__(
        self, graph: Graph, rate: Callable[[int], int], *, bias: bool = False, delayed: Mapping[int, int] | None = None
    ) -> None:
        super().__init__(graph, (*MOVING, Group.W) if delayed else MOVING, self._motion)
        self._delayed = delayed or {}
        self._graph_of_rates = graph
        self._rate = rate
        self._bias = bias

    def _motion(self, symbol: int) -> int:
        graph = self._graph_of_rates
        assert graph.op[symbol] is Op.SYMBOL
        index = graph.b[symbol]
        group = graph.group(symbol)
        if group is Group.TIME:
            return graph.one
        if group is Group.QD:
            return graph.zero if self._bias else graph.symbol(Group.QDD, index)
        if group is Group.W:
            return self._delayed.get(symbol, graph.zero)
        moved = {Group.Q: Group.QD, Group.RELEASE: Group.RELEASE_RATE}.get(group)
        return self._rate(symbol) if moved is None else graph.symbol(moved, index)
