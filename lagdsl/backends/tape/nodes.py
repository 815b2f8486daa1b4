"""A graph as arrays, for passes over all its nodes at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from lagdsl.graph.graph import Graph
from lagdsl.record import record

Ints = NDArray[np.int64]
Flags = NDArray[np.bool_]


@record()
class Nodes:
    """`op`, `groups` (nodes) and `operands` (3, nodes; -1: none), as in the graph: the first two of a symbol are its
    group and its index."""

    graph: Graph
    op: Ints
    operands: Ints
    groups: Ints


def nodes_of(graph: Graph) -> Nodes:
    """The arrays of `graph`."""
    operands = np.array([graph.a, graph.b, graph.c], dtype=np.int64)
    op = np.frombuffer(bytes(graph.op), dtype=np.uint8).astype(np.int64)
    return Nodes(graph, op, operands, np.array(graph.groups, dtype=np.int64))


def distinct(values: Ints) -> Ints:
    """Each value once, ascending: `np.unique`, which would load the masked arrays of NumPy for as long as a tape takes
    to write."""
    ordered = np.sort(values)
    first: Ints = ordered[np.concatenate([[True], ordered[1:] != ordered[:-1]])[: len(ordered)]]
    return first
