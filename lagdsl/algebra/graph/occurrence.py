"""Symbols of one group by the expressions in which they occur: the entries of a Jacobian that can be nonzero."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group

Indices = NDArray[np.intp]


def occurrences(graph: Graph, elements: Sequence[int], group: Group) -> tuple[Indices, Indices]:
    """For each symbol of `group` in an element: the place of the element and the index of the symbol, element by
    element."""
    rows, columns = [], []
    for place, found in enumerate(dependences(graph, elements, {group: 0})):
        own = members(found)
        rows.append(np.full(len(own), place, dtype=np.intp))
        columns.append(own)
    empty = np.zeros(0, dtype=np.intp)
    return np.concatenate([empty, *rows]), np.concatenate([empty, *columns])


def dependences(graph: Graph, elements: Sequence[int], first: Mapping[Group, int]) -> list[int]:
    """The symbols in each element, as a set of bits: those of a group from its `first` bit on. A node costs little more
    than its operands, and its set is forgotten behind its last use."""
    known: dict[int, int] = {}
    operands, groups = graph.operands, graph.groups
    mask = sum(1 << group for group in first)
    nodes = [node for node in graph.live(elements) if groups[node] & mask]
    last = {operand: node for node in nodes for operand in operands[node]} | dict.fromkeys(elements, -1)
    for node in nodes:
        found = 0 if operands[node] else 1 << first[graph.group(node)] + graph.b[node]
        for operand in operands[node]:
            found |= known.get(operand, 0)
            if last[operand] == node:
                known.pop(operand, None)
        known[node] = found
    return [known.get(element, 0) for element in elements]


def members(bits: int) -> Indices:
    """The numbers of the bits that are set, ascending. Zeros below the first one cost nothing."""
    first = ((bits & -bits).bit_length() - 1) // 8 * 8 if bits else 0
    bits >>= first
    data = bits.to_bytes((bits.bit_length() + 7) // 8, "little")
    return first + np.flatnonzero(np.unpackbits(np.frombuffer(data, dtype=np.uint8), bitorder="little"))
