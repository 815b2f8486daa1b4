"""Dependencies of the solutions of a sparse linear system on its equations, for any numbers in it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence


def matching(equations: Sequence[Sequence[int]], unknowns: int) -> list[int]:
    """For each equation an unknown of its own that occurs in it; -1 where there is none left.

    Equation i is given its unknown number i where that occurs in it; the others are found along augmenting paths
    (Duff, *ACM Transactions on Mathematical Software* 7, 1981).
    """
    owner = [-1] * unknowns
    match = [-1] * len(equations)
    for i, occurring in enumerate(equations):
        if i in occurring and i < unknowns and owner[i] < 0:
            owner[i], match[i] = i, i
    for i in range(len(equations)):
        if match[i] < 0:
            _augment(i, equations, owner, match)
    return match


def _augment(root: int, equations: Sequence[Sequence[int]], owner: list[int], match: list[int]) -> None:
    """A path from equation `root` to an unknown without equation, if there is one; matched along it."""
    came: dict[int, int] = {}  # the equation from which an unknown was reached
    queue = [root]
    for equation in queue:
        for unknown in equations[equation]:
            if unknown in came:
                continue
            came[unknown] = equation
            if owner[unknown] < 0:
                _exchange(root, unknown, came, owner, match)
                return
            queue.append(owner[unknown])


def _exchange(root: int, unknown: int, came: Mapping[int, int], owner: list[int], match: list[int]) -> None:
    """Every equation on the path to `unknown` takes the unknown that it was left by."""
    equation = -1
    while equation != root:
        equation = came[unknown]
        before = match[equation]
        owner[unknown], match[equation] = equation, unknown
        unknown = before


def components(successors: Sequence[Iterable[int]]) -> list[list[int]]:
    """Strongly connected components of a graph, each after all that can be reached from it (Tarjan, 1972)."""
    order = [-1] * len(successors)
    low = [0] * len(successors)
    on_stack = [False] * len(successors)
    stack: list[int] = []
    found: list[list[int]] = []
    count = 0
    for root in range(len(successors)):
        if order[root] >= 0:
            continue
        work = [(root, iter(successors[root]))]
        order[root] = low[root] = count
        count += 1
        stack.append(root)
        on_stack[root] = True
        while work:
            node, rest = work[-1]
            following = next(rest, None)
            if following is None:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == order[node]:
                    start = _last(stack, node)
                    found.append(stack[start:])
                    for member in stack[start:]:
                        on_stack[member] = False
                    del stack[start:]
            elif order[following] < 0:
                order[following] = low[following] = count
                count += 1
                stack.append(following)
                on_stack[following] = True
                work.append((following, iter(successors[following])))
            elif on_stack[following]:
                low[node] = min(low[node], order[following])
    return found


def _last(stack: Sequence[int], node: int) -> int:
    """Last place of `node` in the stack."""
    index = len(stack) - 1
    while stack[index] != node:
        index -= 1
    return index
