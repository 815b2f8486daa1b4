"""Islands of a program: what shares nothing but time, inputs and parameters moves by itself.

Every entry of every argument and result is an item. Two belong to one island where an element of a result depends on
both, stands at both, as an entry of M does, or where the layout says that one belongs to the other: a contact, its row
and its entry of `w`. Energies and the pivot of `elimination` are one number for the whole program, and tie nothing.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.functions import BY_NAME
from lagdsl.derivation.program.lengths import counted, sizes
from lagdsl.derivation.program.program import Block, Layout, Program
from lagdsl.foundation.record import record
from lagdsl.language.flat.events import Kind

Indices = NDArray[np.intp]

# The length of the entries of a group of symbols.
AXIS_OF: Mapping[Group, str] = {
    **dict.fromkeys((Group.Q, Group.QD, Group.QDD), "nq"),
    **dict.fromkeys((Group.DIRECTION_Q, Group.DIRECTION_QD, Group.DIRECTION_QDD), "nq"),
    **dict.fromkeys((Group.Z, Group.DIRECTION_Z), "nz"),
    **dict.fromkeys((Group.LAMBDA, Group.DIRECTION_LAMBDA), "nc"),
    Group.W: "nw",
}
# Results that are numbers of entries, and of which length: the values of `time_event`, outputs.
NUMBERS: Mapping[tuple[str, str], str] = {("time_event", "entry"): "ntimed", ("turn", "entry"): "ny"}
# Only a start asks for them, which is found for the whole program.
OF_STARTS = frozenset({"initial_equation", "initial_equation_tangent"})
# Lengths of programs that are written for others, and no motion asks for.
_EXPORTED = ("nd", "ninertial", "nplace", "naxes", "ntwist")
# Entries of w of a kind, one by one, and what they belong to.
_KINDS: Mapping[Kind, str] = {
    "contact": "ncontact",
    "impacts": "ncontact",
    "sticks": "nfriction",
    "direction": "nslip",
    "relation": "nindicator",
    "timed": "ntimed",
    "delay": "ndelay",
    "delay_rate": "ndelay",
    "clock": "nclock",
    "load": "nload",
}
# Guards, which end steps: without any of these an island has no instants of its own.
_GUARDS = ("nindicator", "ngap", "nfriction", "ntimed", "nclock", "ncorner", "ndelay")


@record()
class Island:
    """The entries of one island, ascending, by length: `places["nq"]` are its coordinates, `places["nc"]` its rows."""

    places: Mapping[str, Indices]

    def count(self, axis: str) -> int:
        return len(self.places[axis])


@record()
class Partition:
    """The islands of a program, and for each item, from the `first` of its length on, the number of its island."""

    islands: tuple[Island, ...]
    first: Mapping[str, int]
    number: Sequence[int]

    def of(self, axis: str, index: int) -> int:
        return self.number[self.first[axis] + index]


def partition(program: Program) -> Partition | None:
    """None where there is one island alone. A `terminate` ends the motion of all, so it leaves one.

    A part without guards never ends a step of others: all of that is one island, with what has neither coordinates nor
    states. Islands consist of whole components, so one component is one island.
    """
    if len(set(program.layout.components)) == 1:
        return None
    own = {axis: length for axis, length in sizes(program.layout).items() if axis not in ("nu", "np")}
    lengths = {**own, **counted(program), "nk": len(program.kept_rows)}
    if lengths["nstop"] or any(lengths[axis] for axis in _EXPORTED) or not any(lengths[axis] for axis in _GUARDS):
        return None
    first, total = dict[str, int](), 0
    for axis, length in lengths.items():
        first[axis], total = total, total + length
    items = _Items(total)
    for one, other in _belonging(program, lengths):
        items.join(first[one[0]] + one[1], first[other[0]] + other[1])
    _Elements(program, first, items).tie()
    owners = _owners(items, first, lengths)
    if len(set(owners)) < 2:
        return None
    names: dict[int, int] = {}
    number = [names.setdefault(owner, len(names)) for owner in owners]
    return Partition(_islands(number, first, lengths), first, number)


class _Items:
    """Disjoint sets of items."""

    def __init__(self, count: int) -> None:
        self._leader = list(range(count))

    def leader_of(self, item: int) -> int:
        leader = self._leader
        while leader[item] != item:
            leader[item] = item = leader[leader[item]]
        return item

    def join(self, one: int, other: int) -> None:
        one, other = self.leader_of(one), self.leader_of(other)
        if one != other:
            self._leader[max(one, other)] = min(one, other)

    def leaders(self) -> list[int]:
        return [self.leader_of(item) for item in range(len(self._leader))]


def _belonging(program: Program, lengths: Mapping[str, int]) -> Iterator[tuple[tuple[str, int], tuple[str, int]]]:
    """Pairs of items, as the layout tells them."""
    layout, instants = program.layout, program.layout.instants
    seen = dict.fromkeys(_KINDS, 0)
    for place, kind in enumerate(layout.kinds):
        if kind in seen:
            yield ("nw", place), (_KINDS[kind], seen[kind])
            seen[kind] += 1
    for contact, row in enumerate(instants.contact_rows):
        yield ("ncontact", contact), ("nc", row)
        yield ("ncontact", contact), ("ngap", contact)
    for collision in range(lengths["ncollision"]):
        yield ("ncollision", collision), ("ngap", len(instants.contact_rows) + collision)
    slips = [each for each, count in enumerate(instants.friction_slips) for _ in range(count)]
    for slip, (friction, row) in enumerate(zip(slips, instants.friction_rows, strict=True)):
        yield ("nslip", slip), ("nfriction", friction)
        yield ("nslip", slip), ("nc", row)
    for friction, contact in enumerate(instants.friction_contacts):
        if contact < len(instants.contact_rows):
            yield ("nfriction", friction), ("ncontact", contact)
    for reset, place in enumerate(instants.reset_places):
        yield ("nreset", reset), _entry_of(layout, place)
    for kept, row in enumerate(program.kept_rows):
        yield ("nk", kept), ("nc", row)
    for (name, result), axis in NUMBERS.items():
        for place, value in enumerate(_constants(program, name, result)):
            yield (BY_NAME[name].results[-1].shape[0], place), (axis, value)


def _entry_of(layout: Layout, place: int) -> tuple[str, int]:
    """The coordinate or state of a place in (q, qd, z)."""
    n = len(layout.coordinates)
    return ("nq", place % n) if place < 2 * n else ("nz", place - 2 * n)


def _constants(program: Program, name: str, result: str) -> list[int]:
    if not program.has(name):
        return []
    place = [each.name for each in BY_NAME[name].results].index(result)
    return [int(program.graph.value[node]) for node in program.function(name).results[place].elements]


class _Elements:
    """Ties by the elements of results; each node knows one of the items that it depends on."""

    def __init__(self, program: Program, first: Mapping[str, int], items: _Items) -> None:
        self._program, self._first, self._items = program, first, items
        self._member = [-1] * len(program.graph)  # -1: depends on none

    def tie(self) -> None:
        graph, roots, tied = self._program.graph, set[int](), list[tuple[tuple[str, ...], Block]]()
        for function in self._program.functions:
            for result, block in zip(BY_NAME[function.name].results, function.results, strict=True):
                if result.shape and function.name not in OF_STARTS and "nu" not in result.shape:
                    tied.append((result.shape, block))
                    roots.update(block.nodes)
        self._look(graph.live(roots))
        for shape, block in tied:
            for item, node in self._at(shape, block):
                if self._member[node] >= 0:
                    self._items.join(item, self._member[node])

    def _at(self, shape: tuple[str, ...], block: Block) -> Iterator[tuple[int, int]]:
        """Items and the elements that stand there; both items of an entry of a matrix are one."""
        rows = self._first[shape[0]]
        if len(shape) == 1:
            yield from zip(range(rows, rows + block.size), block.nodes, strict=True)
            return
        columns, width = self._first[shape[1]], block.shape[1]
        for place, node in block.entries:
            item = rows + place // width
            self._items.join(item, columns + place % width)
            yield item, node

    def _look(self, live: Iterable[int]) -> None:
        graph, member, items = self._program.graph, self._member, self._items
        operands, groups = graph.operands, graph.groups
        mask = sum(1 << group for group in AXIS_OF)
        for node in live:
            if not groups[node] & mask:
                continue
            found = -1 if operands[node] else self._first[AXIS_OF[graph.group(node)]] + graph.b[node]
            for operand in operands[node]:
                other = member[operand]
                if other >= 0 and other != found:
                    if found >= 0:
                        items.join(found, other)
                    found = other
            member[node] = found


def _owners(items: _Items, first: Mapping[str, int], lengths: Mapping[str, int]) -> list[int]:
    """For each item the leader of its island."""
    leaders = items.leaders()

    def of(axes: Iterable[str]) -> set[int]:
        return {leader for axis in axes for leader in leaders[first[axis] : first[axis] + lengths[axis]]}

    moving = of(("nq", "nz"))
    alone = moving & of(_GUARDS)
    rest = sorted(moving - alone) or sorted(alone)
    return [leader if leader in alone else rest[0] for leader in leaders]


def _islands(number: Sequence[int], first: Mapping[str, int], lengths: Mapping[str, int]) -> tuple[Island, ...]:
    count = max(number) + 1
    found: list[dict[str, Indices]] = [{} for _ in range(count)]
    for axis, length in lengths.items():
        own = np.array(number[first[axis] : first[axis] + length], dtype=np.intp)
        order = np.argsort(own, kind="stable")
        ends = np.searchsorted(own[order], np.arange(count + 1))
        for each, begin, end in zip(found, ends[:-1].tolist(), ends[1:].tolist(), strict=True):
            each[axis] = order[begin:end]
    return tuple(Island(each) for each in found)
