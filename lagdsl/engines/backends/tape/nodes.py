"""A graph as arrays, for passes over all its nodes at once."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import DIRECTION_OF, FIRST_TERNARY, Group, Op
from lagdsl.derivation.program.program import Layout
from lagdsl.foundation.record import record

Ints = NDArray[np.int64]
Flags = NDArray[np.bool_]

_NUMBER: Final = re.compile(r"\d+")
# Parts alike that are worth an instruction over strides: two vectors of 512 bits.
LEAST: Final = 16
_BITS = 62
_ALL = (1 << _BITS) - 1


@record()
class Nodes:
    """`op`, `groups` (nodes) and `operands` (3, nodes; -1: none), as in the graph: the first two of a symbol are its
    group and its index. `roles` of arguments."""

    graph: Graph
    op: Ints
    operands: Ints
    groups: Ints
    roles: Roles


@record()
class Roles:
    """The `role` (values) that a value plays in each of parts alike, and the number of its `part`; alone in its role,
    which is negative, where there are none."""

    role: Ints
    part: Ints


def distinct(count: int, *numbers: Ints | Sequence[int]) -> Ints:
    """The numbers, all below `count`, ascending, each once."""
    there = np.zeros(count, dtype=np.bool_)
    for each in numbers:
        there[np.asarray(each, dtype=np.int64)] = True
    return np.flatnonzero(there)


def sorted_by(keys: Ints, count: int) -> tuple[Ints, Ints]:
    """The places of `keys`, all below `count`, in ascending order of the keys, equal ones as they stand; and by key the
    first of these, with their number at the end."""
    ordered = np.sort(keys * len(keys) + np.arange(len(keys)))  # all are different: no slower order that is stable
    firsts = np.zeros(count + 1, dtype=np.int64)
    np.cumsum(np.bincount(keys, minlength=count), out=firsts[1:])
    return ordered % max(1, len(keys)), firsts


def live_sets(nodes: Nodes, roots: Sequence[Ints]) -> list[Ints]:
    """For every one of `roots` all nodes that these are computed from, themselves included, ascending. In one pass."""
    reached = [0] * len(nodes.op)
    for which, own in enumerate(roots):
        for node in own.tolist():
            reached[node] |= 1 << which
    for node, operands in zip(range(len(reached) - 1, -1, -1), reversed(nodes.graph.operands), strict=True):
        mask = reached[node]
        if mask:
            for operand in operands:
                reached[operand] |= mask
    found = []
    for start in range(0, len(roots), _BITS):
        part = _numbers([mask >> start & _ALL for mask in reached] if len(roots) > _BITS else reached)
        there = np.flatnonzero(part)
        masks = part[there]
        found += [there[masks & 1 << which != 0] for which in range(min(_BITS, len(roots) - start))]
    return found


def nodes_of(graph: Graph, layout: Layout) -> Nodes:
    """The arrays of `graph`, whose arguments are those of `layout`."""
    op = np.frombuffer(bytes(graph.op), dtype=np.uint8).astype(np.int64)
    operands = np.full((3, len(op)), -1, dtype=np.int64)
    operands[0], operands[1] = _numbers(graph.a), _numbers(graph.b)
    ternary = np.flatnonzero(op >= FIRST_TERNARY)
    operands[2, ternary] = [graph.c[node] for node in ternary.tolist()]
    return Nodes(graph, op, operands, _numbers(graph.groups), _roles(op, operands, layout))


def _roles(op: Ints, operands: Ints, layout: Layout) -> Roles:
    """Arguments whose names differ in the first number play one role; parameters and all other nodes are alone."""
    slots = {
        Group.LAMBDA: layout.constraints,
        Group.Z: layout.states,
        Group.U: layout.inputs,
        Group.W: layout.discretes,
    }
    slots |= dict.fromkeys((Group.Q, Group.QD, Group.QDD), layout.coordinates)
    slots |= {of: slots[group] for group, of in DIRECTION_OF.items() if group in slots}
    role, part = -1 - np.arange(len(op)), np.zeros(len(op), dtype=np.int64)
    known: dict[tuple[Group, str], int] = {}
    for node in np.flatnonzero(op == Op.SYMBOL).tolist():
        group, index = Group(operands[0, node]), operands[1, node]
        own = slots.get(group, ())
        number = _NUMBER.search(own[index].name) if index < len(own) else None
        if number is not None:
            name = number.string[: number.start()] + number.string[number.end() :]
            role[node] = known.setdefault((group, name), len(known))
            part[node] = int(number.group())
    members = np.bincount(role[role >= 0], minlength=len(known))
    there = np.flatnonzero(role >= 0)
    few = there[members[role[there]] < LEAST]
    role[few] = -1 - few
    return Roles(role, part)


def _numbers(values: Sequence[int]) -> Ints:
    return np.fromiter(values, dtype=np.int64, count=len(values))
