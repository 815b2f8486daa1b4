"""Dependencies of the solutions of a sparse linear system on its equations, for any numbers in it."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence

_NONE = -1


def matching(equations: Sequence[Sequence[int]], unknowns: int) -> list[int]:
    """For each equation an unknown of its own that occurs in it, for as many as possible; -1 for the others.

    Augmenting paths (Berge, PNAS 43 (1957) 842), the shortest one from each equation that is left over by a first
    choice: its own unknown, else one that is free.
    """
    chosen, owner = [_NONE] * len(equations), [_NONE] * unknowns
    for equation, occurring in enumerate(equations):
        free = [unknown for unknown in occurring if owner[unknown] == _NONE]
        if free:
            unknown = equation if equation in free else free[0]
            chosen[equation], owner[unknown] = unknown, equation
    for equation in range(len(equations)):
        if chosen[equation] == _NONE:
            _augment(equation, equations, chosen, owner)
    return chosen


def _augment(begin: int, equations: Sequence[Sequence[int]], chosen: list[int], owner: list[int]) -> None:
    """One more equation with an unknown, if a path leads from it to a free one."""
    came: dict[int, int] = {}
    waiting = deque([begin])
    while waiting:
        equation = waiting.popleft()
        for unknown in equations[equation]:
            if unknown in came:
                continue
            came[unknown] = equation
            if owner[unknown] != _NONE:
                waiting.append(owner[unknown])
                continue
            _exchange(unknown, came, chosen, owner)
            return


def _exchange(end: int, came: Mapping[int, int], chosen: list[int], owner: list[int]) -> None:
    """Each equation of the path to the free unknown takes the one after it."""
    unknown = end
    while unknown != _NONE:
        equation = came[unknown]
        chosen[equation], owner[unknown], unknown = unknown, equation, chosen[equation]


def components(successors: Sequence[Sequence[int]]) -> list[list[int]]:
    """Strongly connected components of a graph, each after all that can be reached from it.

    R. Tarjan, SIAM J. Comput. 1 (1972) 146, with a stack of its own.
    """
    count = len(successors)
    number, low = [_NONE] * count, [0] * count
    open_nodes: list[int] = []
    is_open = [False] * count
    found: list[list[int]] = []
    met = 0
    for root in range(count):
        if number[root] != _NONE:
            continue
        path = [(root, iter(successors[root]))]
        while path:
            node, rest = path[-1]
            if number[node] == _NONE:
                number[node] = low[node] = met
                met += 1
                open_nodes.append(node)
                is_open[node] = True
            following = next((other for other in rest if number[other] == _NONE or is_open[other]), None)
            if following is None:
                path.pop()
                if path:
                    low[path[-1][0]] = min(low[path[-1][0]], low[node])
                if low[node] == number[node]:
                    found.append(_closed(node, open_nodes, is_open))
            elif number[following] == _NONE:
                path.append((following, iter(successors[following])))
            else:
                low[node] = min(low[node], number[following])
    return found


def _closed(node: int, open_nodes: list[int], is_open: list[bool]) -> list[int]:
    """The component that ends with the node, in order; it is open no more."""
    members = [open_nodes.pop()]
    while members[-1] != node:
        members.append(open_nodes.pop())
    for each in members:
        is_open[each] = False
    return sorted(members)
