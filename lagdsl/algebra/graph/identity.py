"""Identity of two expressions of parameters as functions, however they are written.

They are compared at a few scattered parameters: rational functions that agree there are the same (Schwartz and Zippel).
"""

from __future__ import annotations

from lagdsl.algebra.graph.fold import fold
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op

_RATIONAL = frozenset({Op.CONSTANT, Op.SYMBOL, Op.NEGATE, Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.DIVIDE})
_POINTS = 3
# Parameters lie between 1/2 and 2, scattered by multiples of the golden ratio.
_GOLDEN = 0.6180339887498949
# Ways to write the same thing differ by a few roundings.
_ROUNDING = 1e-13


def identical(graph: Graph, one: int, other: int) -> bool:
    """Both must depend on parameters alone. True only for the same node or for rational functions that are equal."""
    if one == other:
        return True
    below = _below(graph, one, other)
    if any(graph.op[node] not in _RATIONAL for node in below):
        return False
    for point in range(_POINTS):
        values = _values(graph, below, point)
        first, second = values[one], values[other]
        if first is None or second is None or abs(first - second) > _ROUNDING * abs(first):
            return False
    return True


def _below(graph: Graph, one: int, other: int) -> list[int]:
    """Nodes below the two, ascending."""
    found = {one, other}
    stack = [one, other]
    while stack:
        for argument in graph.arguments(stack.pop()):
            if argument not in found:
                found.add(argument)
                stack.append(argument)
    return sorted(found)


def _values(graph: Graph, below: list[int], point: int) -> dict[int, float | None]:
    """None where a value is no number."""
    values: dict[int, float | None] = {}
    for node in below:
        if graph.op[node] is Op.CONSTANT:
            values[node] = graph.value[node]
        elif graph.op[node] is Op.SYMBOL:
            assert graph.group(node) is Group.P
            values[node] = 0.5 + 1.5 * ((_POINTS * graph.b[node] + point + 1) * _GOLDEN % 1.0)
        else:
            arguments = [values[x] for x in graph.arguments(node)]
            known = [x for x in arguments if x is not None]
            values[node] = fold(graph.op[node], *known) if len(known) == len(arguments) else None
    return values
