"""The natural size of a result: how much it changes where every operation, and every variable, changes a little.

Stochastic arithmetic (Vignes, Mathematics and Computers in Simulation 35 (1993) 233): each operation is rounded at
random, here by a part of 1e-8 instead of 1e-16. A result that is identically zero differs from zero by a rounding of
this size; any other is comparable to it. Bounds of errors would compound from factor to factor.

In a state of rest, or of a mechanism that cannot move, rates are themselves round-off: there variables change by a part
of their natural sizes, of which a momentum that is zero is round-off, too. Accelerations are solved for: the rounding
of one reaches another by the roots of their inertias. In m/s2 and rad/s2 those of a thin beam differ by 1e7.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from lagdsl.algebra.graph.arithmetic import NUMPY, Value
from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.exchange.verify.states import Arrays
from lagdsl.foundation.numerics.rank import Floats

_PART = 1e-8
_SEED = 22
_DRAWS = 2
# Variables are round-off if all of a group are at most this part of their natural sizes.
_NONE = 1e-12
_VARIABLES = (Group.Q, Group.QD, Group.QDD, Group.LAMBDA)


def with_size(
    graph: Graph, nodes: Sequence[int], states: Arrays, natural: Mapping[Group, Floats], inertia: Floats | None = None
) -> tuple[Floats, Floats]:
    """Values (states, nodes) and their natural sizes. `natural` are sizes (n,) of the variables of some groups,
    `inertia` (states, nq) those that accelerations among the variables belong to."""
    count = len(states[Group.TIME])
    random = np.random.default_rng(_SEED)
    exact = _columns(evaluate(graph, nodes, states), count)
    size = np.abs(exact)
    weights = {} if inertia is None else {Group.QDD: np.sqrt(np.where(inertia > 0.0, inertia, 1.0))}
    for _ in range(_DRAWS):
        known = [group for group in _VARIABLES if group in states]
        moved = states | {
            group: _moved(states[group], natural.get(group), weights.get(group), random) for group in known
        }
        noisy = _columns(_noisy(graph, nodes, moved, random), count)
        size = np.maximum(size, np.abs(noisy - exact) / _PART)
    return exact, size


def _moved(values: Floats, natural: Floats | None, weight: Floats | None, random: np.random.Generator) -> Floats:
    """Each by a part of the largest of its state, by weight: one that constraints hold at zero is no natural size. By a
    part of their natural sizes where all are round-off."""
    weighed = np.abs(values) if weight is None else np.abs(values) * weight
    largest = np.max(weighed, axis=1, initial=0.0, keepdims=True)
    largest = largest if weight is None else largest / weight
    amplitude = largest
    if natural is not None:
        amplitude = np.where(np.any(np.abs(values) > _NONE * natural, axis=1, keepdims=True), largest, natural)
    return np.asarray(values + _PART * amplitude * random.uniform(-1, 1, values.shape))


def _noisy(graph: Graph, nodes: Sequence[int], states: Arrays, random: np.random.Generator) -> list[Value]:
    values: dict[int, Value] = {}
    with np.errstate(all="ignore"):
        for node in graph.live(nodes):
            op = graph.op[node]
            if op is Op.CONSTANT or op is Op.SYMBOL:
                values[node] = evaluate(graph, [node], states)[0]
            else:
                rounding = 1.0 + _PART * random.uniform(-1, 1)
                values[node] = NUMPY[op](*[values[x] for x in graph.arguments(node)]) * rounding
    return [values[node] for node in nodes]


def _columns(found: Sequence[Value], count: int) -> Floats:
    return np.stack([np.broadcast_to(np.real(each), (count,)) for each in found], axis=1)
