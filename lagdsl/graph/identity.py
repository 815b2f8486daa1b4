"""Whether two expressions of parameters are the same function, however they are written.

They are compared at a few random parameters: rational functions that agree there are the same (Schwartz and Zippel).
"""

from __future__ import annotations

import numpy as np

from lagdsl.graph.evaluate import evaluate
from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import Group, Op

_RATIONAL = frozenset({Op.CONSTANT, Op.SYMBOL, Op.NEGATE, Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.DIVIDE})
_POINTS = 3
# Ways to write the same thing differ by a few roundings.
_ROUNDING = 1e-13


def identical(graph: Graph, one: int, other: int) -> bool:
    """Both must depend on parameters alone. True only for the same node or for rational functions that are equal."""
    if one == other:
        return True
    live = graph.live((one, other))
    if any(graph.op[node] not in _RATIONAL for node in live):
        return False
    size = 1 + max((graph.b[node] for node in live if graph.op[node] is Op.SYMBOL), default=0)
    assert all(graph.group(node) is Group.P for node in live if graph.op[node] is Op.SYMBOL)
    points = np.random.default_rng(0).uniform(0.5, 2.0, (_POINTS, size))
    first, second = (np.broadcast_to(x, _POINTS) for x in evaluate(graph, (one, other), {Group.P: points}))
    return bool(np.all(np.abs(first - second) <= _ROUNDING * np.abs(first)))
