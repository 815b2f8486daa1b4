"""The meaning of a graph: values of nodes for given symbols. Every backend is tested against this."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from lagdsl.algebra.graph.arithmetic import NUMPY, Table, Value, precise
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.algebra.graph.size import SIZES, Sized

Symbols = Mapping[Group, Any]


def evaluate(graph: Graph, roots: Iterable[int], symbols: Symbols) -> list[Value]:
    """Values of `roots`.

    `symbols` maps a group to its array, the index last: leading axes broadcast. TIME is a number (or an array of the
    leading shape). Arrays may be complex, for derivatives by a complex step. A list of mpmath numbers makes the whole
    evaluation run at mpmath's working precision. Values that do not exist are nan or inf, never an error of NumPy.
    """
    roots = list(roots)
    table: Table = precise() if _is_precise(symbols) else NUMPY
    values: dict[int, Value] = {}
    with np.errstate(all="ignore"):
        for node in graph.live(roots):
            op = graph.op[node]
            if op is Op.CONSTANT:
                values[node] = np.float64(graph.value[node]) if table is NUMPY else graph.value[node]
            elif op is Op.SYMBOL:
                values[node] = _symbol(graph, node, symbols)
            else:
                values[node] = table[op](*[values[x] for x in graph.arguments(node)])
    return [values[root] for root in roots]


def evaluate_with_size(graph: Graph, roots: Iterable[int], symbols: Symbols) -> list[Sized]:
    """Values and their sizes: how large the terms are that a value is the sum of.

    size(a + b) = size(a) + size(b), size(a*b) = size(a)*size(b), size(f(a)) = max(|f(a)|, |f'(a)| size(a)). Two ways to
    compute the same thing agree to a few rounding errors of the size, not of the value, where terms cancel.
    """
    roots = list(roots)
    values: dict[int, Sized] = {}
    with np.errstate(all="ignore"):
        for node in graph.live(roots):
            op = graph.op[node]
            if op is Op.CONSTANT or op is Op.SYMBOL:
                value = np.float64(graph.value[node]) if op is Op.CONSTANT else _symbol(graph, node, symbols)
                values[node] = (value, np.abs(value))
                continue
            arguments = [values[x] for x in graph.arguments(node)]
            value = NUMPY[op](*[x for x, _ in arguments])
            values[node] = (value, np.maximum(np.abs(value), SIZES[op](value, *arguments)))
    return [values[root] for root in roots]


def _is_precise(symbols: Symbols) -> bool:
    return any(type(x).__module__.startswith("mpmath") for array in symbols.values() for x in _entries(array))


def _entries(array: Any) -> Iterable[Any]:
    return array if isinstance(array, list | tuple) else (array,)


def _symbol(graph: Graph, node: int, symbols: Symbols) -> Value:
    group, index = graph.group(node), graph.b[node]
    array = symbols[group]
    if group is Group.TIME:
        return array if type(array).__module__.startswith("mpmath") else np.asarray(array)[()]
    if isinstance(array, list | tuple):
        entry = array[index]
        return np.float64(entry) if isinstance(entry, int | float) else entry
    return np.asarray(array)[..., index]
