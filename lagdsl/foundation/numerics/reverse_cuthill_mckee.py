"""An order of rows and columns in which the entries of a sparse matrix lie near its diagonal.

Sources: Cuthill and McKee, Reducing the bandwidth of sparse symmetric matrices, Proc. 24th Nat. Conf. ACM (1969);
reversed, and the first row: George and Liu, Computer Solution of Large Sparse Positive Definite Systems (1981),
sections 4.2 and 4.3.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence


def reverse_cuthill_mckee(count: int, entries: Iterable[tuple[int, int]]) -> list[int]:
    """The rows of a matrix (count, count) with these entries, and of its transpose, in that order. Every connected part
    begins at a row that is far from some other."""
    beside: list[set[int]] = [set() for _ in range(count)]
    for row, column in entries:
        if row != column:
            beside[row].add(column)
            beside[column].add(row)
    neighbors = [sorted(each, key=lambda node: (len(beside[node]), node)) for each in beside]
    order: list[int] = []
    found = [False] * count
    for node in range(count):
        if not found[node]:
            part = _numbered(neighbors, node)
            order += part
            for each in part:
                found[each] = True
    return order[::-1]


def _numbered(neighbors: Sequence[Sequence[int]], root: int) -> list[int]:
    """The part of `root`, from a node on that is as far from another as searches find."""
    order, last, depth = _search(neighbors, root)
    while True:
        far = min(order[last:], key=lambda node: len(neighbors[node]))
        order, last, reached = _search(neighbors, far)
        if reached <= depth:
            return order
        depth = reached


def _search(neighbors: Sequence[Sequence[int]], root: int) -> tuple[list[int], int, int]:
    """The part of `root`, breadth first, neighbors of one node by increasing degree; the place of the first node at the
    largest distance, and that distance."""
    order, seen = [root], {root}
    last, end, depth = 0, 1, 0
    for place, node in enumerate(order):  # it grows
        if place == end:
            last, end, depth = end, len(order), depth + 1
        new = [other for other in neighbors[node] if other not in seen]
        seen.update(new)
        order += new
    return order, last, depth
