"""Symbols of one group by the expressions in which they occur: the entries of a Jacobian that can be nonzero."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group

Indices = NDArray[np.intp]


def occurrences(graph: Graph, elements: Sequence[int], group: Group) -> tuple[Indices, Indices]:
    """For each symbol of `group` in an element: the place of the element and the index of the symbol, element by
    element. Sets of symbols are sets of bits, so that a node costs little more than its operands."""
    known: dict[int, int] = {}
    operands, groups = graph.operands, graph.groups
    for node in graph.live(elements):
        if groups[node] >> group & 1:
            found = 0 if operands[node] else 1 << graph.b[node]
            for operand in operands[node]:
                found |= known.get(operand, 0)
            known[node] = found
    rows, columns = [], []
    for place, element in enumerate(elements):
        own = np.flatnonzero(_flags(known.get(element, 0)))
        rows.append(np.full(len(own), place, dtype=np.intp))
        columns.append(own)
    empty = np.zeros(0, dtype=np.intp)
    return np.concatenate([empty, *rows]), np.concatenate([empty, *columns])


def _flags(bits: int) -> NDArray[np.uint8]:
    data = bits.to_bytes((bits.bit_length() + 7) // 8, "little")
    return np.unpackbits(np.frombuffer(data, dtype=np.uint8), bitorder="little")
