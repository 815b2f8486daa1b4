"""Dependence of the nodes of a graph, and its kind: sets of symbols as the bits of numbers, one pass over the graph."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from enum import IntEnum
from typing import TypeAlias

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import FIRST_BINARY, STEPS, Group, Op


class Kind(IntEnum):
    """Kind of dependency on a symbol: by a factor that is a number, that depends on parameters only, that changes at
    events only, or otherwise."""

    CONSTANT = 0
    PARAMETER = 1
    DISCRETE = 2
    DEPENDENT = 3


# Symbols (bits) on which a value depends in this way or a stronger one, for each Kind.
Influence: TypeAlias = tuple[int, int, int, int]
NONE: Influence = (0, 0, 0, 0)

_PARAMETERS = 1 << Group.P
_EVENTS = _PARAMETERS | 1 << Group.W


def union(one: Influence, other: Influence) -> Influence:
    return (one[0] | other[0], one[1] | other[1], one[2] | other[2], one[3] | other[3])


def raised(influence: Influence, kind: Kind) -> Influence:
    """At least of this kind."""
    everything = influence[0]
    a, b, c, d = influence
    return (a, everything if kind >= 1 else b, everything if kind >= 2 else c, everything if kind >= 3 else d)


def only(influence: Influence, bits: int) -> Influence:
    return (influence[0] & bits, influence[1] & bits, influence[2] & bits, influence[3] & bits)


def kind_of(influence: Influence, bit: int) -> Kind:
    """Of a symbol that matters."""
    return Kind(sum(1 for level in influence[1:] if level & bit))


class Influences:
    """Of all nodes of `graph` that `roots` are computed from; symbols have the bits that `bits` gives them. `without`
    are pairs of a root and a symbol that it does not depend on."""

    def __init__(
        self, graph: Graph, roots: Iterable[int], bits: Mapping[int, int], without: Iterable[tuple[int, int]] = ()
    ) -> None:
        self._graph = graph
        self._known: dict[int, Influence] = {}
        for node in graph.live(roots):
            if graph.op[node] is Op.SYMBOL:
                bit = bits.get(node, 0)
                self._known[node] = (bit, 0, 0, 0)
            else:
                self._known[node] = self._combine(node)
        for root, symbol in without:
            if root in self._known:
                self._known[root] = only(self._known[root], ~bits[symbol])

    def __getitem__(self, node: int) -> Influence:
        return self._known[node]

    def of_all(self, nodes: Iterable[int]) -> Influence:
        total = NONE
        for node in nodes:
            total = union(total, self._known[node])
        return total

    def _factor(self, node: int) -> Kind:
        """Effect of a factor with the value of this node on the dependence of its product."""
        groups = self._graph.groups[node]
        if not groups:
            return Kind.CONSTANT
        if not groups & ~_PARAMETERS:
            return Kind.PARAMETER
        return Kind.DEPENDENT if groups & ~_EVENTS else Kind.DISCRETE

    def _combine(self, node: int) -> Influence:
        graph, known = self._graph, self._known
        op, a = graph.op[node], graph.a[node]
        if op is Op.CONSTANT:
            return NONE
        if op is Op.NEGATE:
            return known[a]
        if op in STEPS or op < FIRST_BINARY:
            return self._bent(node)
        b = graph.b[node]
        if op in (Op.ADD, Op.SUBTRACT):
            return union(known[a], known[b])
        if op is Op.MULTIPLY:
            return union(raised(known[a], self._factor(b)), raised(known[b], self._factor(a)))
        if op is Op.DIVIDE:
            divisor = raised(known[b], max(self._factor(a), self._factor(b)))
            return union(raised(known[a], self._factor(b)), divisor)
        if op is Op.SELECT:
            branches = union(known[b], known[graph.c[node]])
            return union(raised(branches, self._factor(a)), raised(known[a], Kind.DEPENDENT))
        return self._bent(node)

    def _bent(self, node: int) -> Influence:
        """A function of its arguments, whose slope varies as they do."""
        total = NONE
        for argument in self._graph.operands[node]:
            total = union(total, self._known[argument])
        return raised(total, self._factor(node))
