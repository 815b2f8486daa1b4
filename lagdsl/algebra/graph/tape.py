"""The meaning of a graph on plain numbers, for many evaluations of the same nodes.

The same as `evaluate`, prepared once: the nodes in order with their operations, and only the roots that are no
constants. The cost of a large matrix that is mostly structural zeros is then that of its other entries.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.fold import SCALAR
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op

_FAST: dict[Op, Callable[..., float]] = SCALAR | {
    Op.NEGATE: operator.neg,
    Op.ADD: operator.add,
    Op.SUBTRACT: operator.sub,
    Op.MULTIPLY: operator.mul,
    Op.DIVIDE: operator.truediv,
    Op.SELECT: lambda condition, value, otherwise: value if condition != 0.0 else otherwise,
}


class Tape:
    """Values of `roots` for symbols given as lists of floats by group, TIME as a float."""

    def __init__(self, graph: Graph, roots: Sequence[int]) -> None:
        self._graph = graph
        constants = graph.value
        self._template = np.zeros(len(roots))
        varied = []
        for i in np.flatnonzero(
            np.fromiter(roots, np.intp, len(roots)) != graph.zero
        ).tolist():  # few, in a large matrix
            if roots[i] in constants:
                self._template[i] = constants[roots[i]]
            else:
                varied.append(i)
        self._varied = np.array(varied, dtype=np.intp)
        self._roots = [roots[i] for i in varied]
        slots: dict[int, int] = {}
        self._initial: list[float] = []
        self._symbols: list[tuple[int, Group, int]] = []
        self._steps: list[tuple[int, Callable[..., float], tuple[int, ...]]] = []
        ops, operands = graph.op, graph.operands
        for slot, node in enumerate(graph.live(self._roots)):
            slots[node] = slot
            op, own = ops[node], operands[node]
            self._initial.append(constants[node] if op is Op.CONSTANT else 0.0)
            if len(own) == 2:  # most nodes
                self._steps.append((slot, _FAST[op], (slots[own[0]], slots[own[1]])))
            elif own:
                self._steps.append((slot, _FAST[op], tuple([slots[x] for x in own])))
            elif op is Op.SYMBOL:
                self._symbols.append((slot, graph.group(node), graph.b[node]))
        self._results = [slots[node] for node in self._roots]

    def __call__(self, symbols: Mapping[Group, list[float] | float]) -> NDArray[np.float64]:
        """Shape (roots,); what is not a number comes out as nan or inf."""
        values = self._initial.copy()
        for slot, group, index in self._symbols:
            given = symbols[group]
            values[slot] = given[index] if isinstance(given, list) else given
        result = self._template.copy()
        try:
            for slot, function, arguments in self._steps:
                if len(arguments) == 2:
                    values[slot] = function(values[arguments[0]], values[arguments[1]])
                else:
                    values[slot] = function(*[values[x] for x in arguments])
            result[self._varied] = [values[slot] for slot in self._results]
        except (ArithmeticError, ValueError):  # not a finite number somewhere: NumPy goes on where Python stops
            result[self._varied] = [float(value) for value in evaluate(self._graph, self._roots, symbols)]
        return result
