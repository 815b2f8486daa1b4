"""Values of nodes, and how they move along directions: exact, by complex steps on the graph of the model.

`floor` and `ceil` of what moves are taken as their arguments, in value and slope: a loop without its quantizers. Other
jumps keep their value. Where two sides of a function meet at the point and the directions lead away, the result is that
of one side only; it is told which nodes these are, as far as a choice between them makes a difference.
Source: Squire and Trapp, Using complex variables to estimate derivatives of real functions, SIAM Review 40 (1998)
110-112.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from lagdsl.algebra.graph.arithmetic import NUMPY, Table
from lagdsl.algebra.graph.evaluate import evaluate_with_size
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import STEPS, Group, Op
from lagdsl.foundation.numerics.rank import Floats

_STEP = 1e-100
# Two sides meet where they differ by less than this part of their terms: a fixed point is known to 1e-12.
_MEETS = 1e-10
_SAME = 1e-12
_TIED = (Op.LESS, Op.LESS_EQUAL, Op.EQUAL, Op.MIN, Op.MAX, Op.ABS, Op.SIGN)

_TABLE: Table = {
    **NUMPY,
    Op.FLOOR: lambda x: x if np.any(np.imag(x)) else np.floor(np.real(x)),
    Op.CEIL: lambda x: x if np.any(np.imag(x)) else np.ceil(np.real(x)),
}


def _leaking(op: Op) -> Any:
    """The value of a limit with the slope of the side that moves: Newton's method finds its way back from there."""

    def taken(x: Any, y: Any) -> Any:
        value = NUMPY[op](x, y)
        moving = next((each for each in (x, y) if np.any(np.imag(each))), value)
        return value if np.any(np.imag(value)) else np.real(value) + 1j * np.imag(moving)

    return taken


_LEAKING: Table = {**_TABLE, Op.MIN: _leaking(Op.MIN), Op.MAX: _leaking(Op.MAX)}

# Nodes whose sides meet, and if their values jump there: else they have a corner.
Borders = frozenset[tuple[int, bool]]
_NONE: Borders = frozenset()


@dataclass(frozen=True, slots=True, kw_only=True)
class Place:
    """Values of the symbols by group, TIME a number; tangents (k, length) by group, none for what is held; and the
    entries of w that depend on borders already. `leaks`: limits move with what they limit."""

    values: Mapping[Group, Any]
    tangents: Mapping[Group, Floats]
    borders: Mapping[int, Borders] = field(default_factory=dict)
    leaks: bool = False

    @property
    def count(self) -> int:
        return len(next(iter(self.tangents.values())))


@dataclass(frozen=True, slots=True, kw_only=True)
class Moved:
    """Values (m,), tangents (k, m), and the borders that each depends on."""

    values: Floats
    tangents: Floats
    borders: tuple[Borders, ...]


def moved(graph: Graph, roots: Sequence[int], place: Place) -> Moved:
    """Of the nodes `roots`."""
    symbols = {
        group: np.asarray(value) + 1j * _STEP * place.tangents[group] if group in place.tangents else value
        for group, value in place.values.items()
    }
    live = graph.live(roots)
    sizes = _sizes(graph, live, place)
    table = _LEAKING if place.leaks else _TABLE
    found: dict[int, Any] = {}
    borders: dict[int, Borders] = {}
    with np.errstate(all="ignore"):
        for node in live:
            op = graph.op[node]
            if op is Op.CONSTANT:
                found[node] = np.float64(graph.value[node])
            elif op is Op.SYMBOL:
                group, index = graph.group(node), graph.b[node]
                found[node] = symbols[group] if group is Group.TIME else np.asarray(symbols[group])[..., index]
                if group is Group.W and index in place.borders:
                    borders[node] = place.borders[index]
            else:
                arguments = graph.arguments(node)
                found[node] = table[op](*(found[each] for each in arguments))
                own = _borders(graph, node, found, borders, sizes)
                if own:
                    borders[node] = own
    count = place.count
    values = np.array([float(np.real(np.ravel(found[root])[0])) for root in roots])
    tangents = np.array([np.broadcast_to(np.imag(found[root]) / _STEP, (count,)) for root in roots]).reshape(-1, count)
    return Moved(
        values=values, tangents=np.ascontiguousarray(tangents.T), borders=tuple(borders.get(r, _NONE) for r in roots)
    )


def _sizes(graph: Graph, live: Sequence[int], place: Place) -> dict[int, float]:
    """The sizes of the terms in arguments of functions with two sides."""
    tied = [node for node in live if graph.op[node] in _TIED]
    arguments = list(dict.fromkeys(each for node in tied for each in graph.arguments(node)))
    found = evaluate_with_size(graph, arguments, place.values)
    return {node: float(size) for node, (_, size) in zip(arguments, found, strict=True)}


def _borders(
    graph: Graph, node: int, found: Mapping[int, Any], borders: Mapping[int, Borders], sizes: Mapping[int, float]
) -> Borders:
    """Borders on which the node depends: those of its arguments, and its own where its sides meet. A step does not
    see a corner beside it, only a jump."""
    op, arguments = graph.op[node], graph.arguments(node)
    if op is Op.SELECT and arguments[0] in borders:
        one, other = found[arguments[1]], found[arguments[2]]
        if np.all(np.abs(np.real(one) - np.real(other)) <= _SAME * np.abs(np.real(one))):
            rest = borders.get(arguments[1], _NONE) | borders.get(arguments[2], _NONE)
            same = np.all(_close(np.imag(one), np.imag(other)))
            return rest if same else rest | {(each, False) for each, _ in borders[arguments[0]]}
    own = _NONE.union(*(borders.get(each, _NONE) for each in arguments))
    if op in STEPS and op not in (Op.FLOOR, Op.CEIL):
        own = frozenset(each for each in own if each[1])
    if op not in _TIED:
        return own
    left = found[arguments[0]]
    right = found[arguments[1]] if len(arguments) > 1 else np.float64(0.0)
    size = sum(sizes[each] for each in arguments)
    apart = np.max(np.abs(np.real(left) - np.real(right)))
    meets = apart <= _MEETS * size and not np.all(_close(np.imag(left), np.imag(right)))
    return own | {(node, op in STEPS)} if meets else own


def _close(one: Any, other: Any) -> Any:
    return np.abs(one - other) <= 1e-9 * (np.abs(one) + np.abs(other))
