"""Symbols of one group by the expressions in which they occur: the entries of a Jacobian that can be nonzero."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group

Indices = NDArray[np.intp]


def occurrences(graph: Graph, elements: Sequence[int], group: Group) -> tuple[Indices, Indices]:
    """For each symbol of `group` in an element: the place of the element and the index of the symbol, element by
    element."""
    found = dependences(graph, elements, {group: 0})
    empty = np.zeros(0, dtype=np.intp)
    rows = np.repeat(np.arange(len(found)), [len(own) for own in found])
    return rows, np.concatenate([empty, *found])


def dependences(graph: Graph, elements: Sequence[int], first: Mapping[Group, int]) -> list[Indices]:
    """The symbols in each element, ascending: those of a group from its `first` number on.

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
    return [np.sort(numbers[_members(*known[element])] if element in known else numbers[:0]) for element in elements]


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
