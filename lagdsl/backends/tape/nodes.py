"""A graph as arrays, for passes over all its nodes at once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lagdsl.graph.graph import Graph
from lagdsl.record import record

Ints = NDArray[np.int64]
Flags = NDArray[np.bool_]

_BITS = 62
_ALL = (1 << _BITS) - 1


@record()
class Nodes:
    """`op`, `groups` (nodes) and `operands` (3, nodes; -1: none), as in the graph: the first two of a symbol are its
    group and its index."""

    graph: Graph
    op: Ints
    operands: Ints
    groups: Ints


def distinct(count: int, *numbers: Ints | Sequence[int]) -> Ints:
    """The numbers, all below `count`, ascending, each once."""
    there = np.zeros(count, dtype=np.bool_)
    for each in numbers:
        there[np.asarray(each, dtype=np.int64)] = True
    return np.flatnonzero(there)


def live_sets(nodes: Nodes, roots: Sequence[Ints]) -> list[Ints]:
    """For every one of `roots` all nodes that these are computed from, themselves included, ascending. In one pass."""
    reached = [0] * len(nodes.op)
    for which, own in enumerate(roots):
        for node in own.tolist():
            reached[node] |= 1 << which
    operands = nodes.graph.operands
    for node in range(len(reached) - 1, -1, -1):
        mask = reached[node]
        if mask:
            for operand in operands[node]:
                reached[operand] |= mask
    found = []
    for start in range(0, len(roots), _BITS):
        part = np.array([mask >> start & _ALL for mask in reached] if len(roots) > _BITS else reached, dtype=np.int64)
        found += [np.flatnonzero(part >> which & 1) for which in range(min(_BITS, len(roots) - start))]
    return found


def nodes_of(graph: Graph) -> Nodes:
    """The arrays of `graph`."""
    operands = np.array([graph.a, graph.b, graph.c], dtype=np.int64)
    op = np.frombuffer(bytes(graph.op), dtype=np.uint8).astype(np.int64)
    return Nodes(graph, op, operands, np.array(graph.groups, dtype=np.int64))
