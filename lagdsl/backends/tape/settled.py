"""What stands in the row before a function starts."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.backends.tape.nodes import Flags, Ints, Nodes, distinct
from lagdsl.graph.operation import FIRST_UNARY, Group, Op
from lagdsl.program.program import Function, Program
from lagdsl.record import record

# Where one and minus one stand: first among the constants.
ONE = 0
MINUS_ONE = 1
_PARAMETER = 1 << Group.P


@record()
class Settled:
    """`place` of every node of the graph that is in the row, -1 for others; `nodes` are those among them that are
    computed from others. Parameters stand from the place `parameters` on, what belongs to the function alone from
    `first` on."""

    place: Ints
    nodes: frozenset[int]
    parameters: int
    first: int

    def with_more(self, more: Ints) -> Settled:
        """The same with the nodes `more` in the next places."""
        place = self.place.copy()
        place[more] = self.first + np.arange(len(more))
        return Settled(place, self.nodes | frozenset(more.tolist()), self.parameters, self.first + len(more))


def settle(program: Program, nodes: Nodes, functions: Sequence[Function]) -> tuple[Settled, list[float], Ints]:
    """Constants, parameters and what follows from these alone; the constants; and the nodes that prepare() computes."""
    graph = program.graph
    roots = distinct(np.array([node for f in functions for b in f.results for node in b.elements], dtype=np.int64))
    live = np.array(graph.live(roots.tolist()), dtype=np.int64)
    hoisted = _hoisted(nodes, live, roots, nodes.groups & ~_PARAMETER == 0)
    numbers = live[nodes.op[live] == Op.CONSTANT]
    constants = [1.0, -1.0, *(graph.value[node] for node in numbers.tolist())]
    place = np.full(len(graph), -1, dtype=np.int64)
    place[numbers] = 2 + np.arange(len(numbers))
    symbols = live[(nodes.op[live] == Op.SYMBOL) & (nodes.operands[0, live] == Group.P)]
    place[symbols] = len(constants) + nodes.operands[1, symbols]
    first = len(constants) + len(program.layout.parameters)
    return Settled(place, frozenset(), len(constants), first).with_more(hoisted), constants, hoisted


def _hoisted(nodes: Nodes, live: Ints, roots: Ints, alone: Flags) -> Ints:
    """Nodes computed from parameters alone that something else is computed from, or that are results; ascending."""
    operands = nodes.operands[:, live[~alone[live] & (nodes.op[live] >= FIRST_UNARY)]].ravel()
    wanted = distinct(np.concatenate([operands[operands >= 0], roots]))
    return wanted[alone[wanted] & (nodes.op[wanted] >= FIRST_UNARY)]
