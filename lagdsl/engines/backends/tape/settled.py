"""Contents of the row before a function starts."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.algebra.graph.operation import FIRST_UNARY, Group, Op
from lagdsl.engines.backends.tape.nodes import Flags, Ints, Nodes, distinct
from lagdsl.foundation.record import record

# Places of one and minus one: first among the constants.
ONE = 0
MINUS_ONE = 1
_PARAMETER = 1 << Group.P


@record()
class Settled:
    """`place` of every node of the graph that is in the row, -1 for others. Parameters stand from the place
    `parameters` on, what belongs to the function alone from `first` on. Nothing is left to do for `hidden` nodes: what
    is computed from them is in the row."""

    place: Ints
    hidden: Flags
    parameters: int
    first: int

    def with_more(self, more: Ints) -> Settled:
        """The same with the nodes `more` in the next places."""
        place = self.place.copy()
        place[more] = self.first + np.arange(len(more))
        return Settled(place, self.hidden, self.parameters, self.first + len(more))


def settle(
    nodes: Nodes, parameters: int, lives: Sequence[Ints], results: Sequence[Ints]
) -> tuple[Settled, list[float], Ints]:
    """Constants, parameters and what follows from these alone, of functions with these nodes and results; the
    constants; and the nodes that prepare() computes."""
    graph = nodes.graph
    live = distinct(len(graph), *lives)
    alone = nodes.groups & ~_PARAMETER == 0
    roots = distinct(len(graph), *results)
    hoisted = _hoisted(nodes, live, roots, alone)
    numbers = live[nodes.op[live] == Op.CONSTANT]
    constants = [1.0, -1.0, *(graph.value[node] for node in numbers.tolist())]
    place = np.full(len(graph), -1, dtype=np.int64)
    place[numbers] = 2 + np.arange(len(numbers))
    symbols = live[(nodes.op[live] == Op.SYMBOL) & (nodes.operands[0, live] == Group.P)]
    place[symbols] = len(constants) + nodes.operands[1, symbols]
    first = len(constants) + parameters
    hidden = alone & (nodes.op >= FIRST_UNARY)
    hidden[hoisted] = False
    return Settled(place, hidden, len(constants), first).with_more(hoisted), constants, hoisted


def _hoisted(nodes: Nodes, live: Ints, roots: Ints, alone: Flags) -> Ints:
    """Nodes computed from parameters alone that something else is computed from, or that are results; ascending."""
    operands = nodes.operands[:, live[~alone[live] & (nodes.op[live] >= FIRST_UNARY)]].ravel()
    wanted = distinct(len(nodes.op), operands[operands >= 0], roots)
    return wanted[alone[wanted] & (nodes.op[wanted] >= FIRST_UNARY)]
