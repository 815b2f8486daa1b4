"""Dependencies of the solutions of a sparse linear system on its equations, for any numbers in it."""

from __future__ import annotations

from collections.abc import Sequence
from graphlib import TopologicalSorter

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components, maximum_bipartite_matching


def matching(equations: Sequence[Sequence[int]], unknowns: int) -> list[int]:
    """For each equation an unknown of its own that occurs in it, for as many as possible; -1 for the others."""
    found: list[int] = maximum_bipartite_matching(_pattern(equations, unknowns), perm_type="column").tolist()
    return found


def components(successors: Sequence[Sequence[int]]) -> list[list[int]]:
    """Strongly connected components of a graph, each after all that can be reached from it."""
    count, found = connected_components(_pattern(successors, len(successors)), connection="strong")
    labels: list[int] = found.tolist()
    members: list[list[int]] = [[] for _ in range(count)]
    reached: list[set[int]] = [set() for _ in range(count)]
    for node, label in enumerate(labels):
        members[label].append(node)
        reached[label] |= {labels[other] for other in successors[node]} - {label}
    return [members[label] for label in TopologicalSorter(dict(enumerate(reached))).static_order()]


def _pattern(rows: Sequence[Sequence[int]], columns: int) -> csr_array[np.float64]:
    """The matrix with a one at each of the places of each row."""
    places = [(row, column) for row, found in enumerate(rows) for column in found]
    at = np.array(places, dtype=np.int32).reshape(-1, 2).T
    return csr_array((np.ones(len(places)), (at[0], at[1])), shape=(len(rows), columns))
