"""Symbols of one group by the expressions in which they occur: the entries of a Jacobian that can be nonzero."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group

Indices = NDArray[np.intp]


class Dependences:
    """The symbols in each of some expressions. A list of those of one, ascending, is made for the caller who asks.

    Lists of all would take as many times the memory of their bits as a number has bits, and in a chain of relative
    angles each expression has nearly all symbols.
    """

    def __init__(self, numbers: Indices, sets: Sequence[tuple[int, int] | None]) -> None:
        self._numbers = numbers  # of the symbol at each place
        self._sets = sets

    def __len__(self) -> int:
        return len(self._sets)

    def __getitem__(self, row: int) -> Indices:
        found = self._sets[row]
        return self._numbers[:0] if found is None else np.sort(self._numbers[_members(*found)])

    def __iter__(self) -> Iterator[Indices]:
        return (self[row] for row in range(len(self)))

    @property
    def counts(self) -> list[int]:
        """Numbers of symbols, one for each expression."""
        return [0 if found is None else found[1].bit_count() for found in self._sets]


def occurrences(graph: Graph, elements: Sequence[int], group: Group) -> tuple[Indices, Indices]:
    """For each symbol of `group` in an element: the place of the element and the index of the symbol, element by
    element."""
    found = dependences(graph, elements, {group: 0})
    empty = np.zeros(0, dtype=np.intp)
    rows = np.repeat(np.arange(len(found)), found.counts)
    return rows, np.concatenate([empty, *found])


def dependences(graph: Graph, elements: Sequence[int], first: Mapping[Group, int]) -> Dependences:
    """The symbols in each element: those of a group from its `first` number on.

    A set is bits from some place on. Symbols that are read together have places beside each other, so that few of them
    are few bits, and a node costs little more than its operands. A set is forgotten behind its last use.
    """
    numbers, places = _numbered(graph, elements, first)
    known: dict[int, tuple[int, int]] = {}
    operands, nodes = graph.operands, graph.live(elements)
    last = {operand: node for node in nodes for operand in operands[node]} | dict.fromkeys(elements, -1)
    of = known.get
    for node in nodes:
        own = operands[node]
        if node in places:
            known[node] = places[node], 1
        elif own:
            found = of(own[0])
            for operand in own[1:]:
                other = of(operand)
                if other is not None and other is not found:
                    found = other if found is None else _union(found, other)
            if found is not None:
                known[node] = found
        for operand in own:
            if last[operand] == node:
                known.pop(operand, None)
    return Dependences(numbers, [of(element) for element in elements])


def _numbered(graph: Graph, elements: Sequence[int], first: Mapping[Group, int]) -> tuple[Indices, dict[int, int]]:
    """Symbols in the order in which a walk from the elements meets them: the number of each, and the place of each node
    in that order."""
    mask = sum(1 << group for group in first)
    operands, groups = graph.operands, graph.groups
    numbers: list[int] = []
    places: dict[int, int] = {}
    seen: set[int] = set()
    for element in elements:
        left = [element]
        while left:
            node = left.pop()
            if node in seen or not groups[node] & mask:
                continue
            seen.add(node)
            if operands[node]:
                left += operands[node]
            else:
                places[node] = len(numbers)
                numbers.append(first[graph.group(node)] + graph.b[node])
    return np.array(numbers, dtype=np.intp), places


def _union(one: tuple[int, int], other: tuple[int, int]) -> tuple[int, int]:
    """Of sets with the place of their first member and their bits from there on."""
    (place, bits), (place_of_other, bits_of_other) = one, other
    if place > place_of_other:
        return place_of_other, bits_of_other | bits << place - place_of_other
    found = bits | bits_of_other << place_of_other - place
    return one if found == bits else (place, found)


def _members(place: int, bits: int) -> Indices:
    """The places in a set."""
    data = bits.to_bytes((bits.bit_length() + 7) // 8, "little")
    return place + np.flatnonzero(np.unpackbits(np.frombuffer(data, dtype=np.uint8), bitorder="little"))
