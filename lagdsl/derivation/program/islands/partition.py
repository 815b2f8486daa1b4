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
from lagdsl.derivation.program.program import Layout, Program
from lagdsl.derivation.program.ties import Ties
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
    if len(set(program.layout.components)) < 2:
        return None
    own = {axis: length for axis, length in sizes(program.layout).items() if axis not in ("nu", "np")}
    lengths = {**own, **counted(program), "nk": len(program.kept_rows)}
    if lengths["nstop"] or any(lengths[axis] for axis in _EXPORTED) or not any(lengths[axis] for axis in _GUARDS):
        return None
    first, total = dict[str, int](), 0
    for axis, length in lengths.items():
        first[axis], total = total, total + length
    graph = program.graph
    items = Ties(graph, total, AXIS_OF, lambda node: first[AXIS_OF[graph.group(node)]] + graph.b[node])
    for one, other in _belonging(program, lengths):
        items.join(first[one[0]] + one[1], first[other[0]] + other[1])
    _tie_results(program, first, items)
    owners = _owners(items, first, lengths)
    if len(set(owners)) < 2:
        return None
    names: dict[int, int] = {}
    number = [names.setdefault(owner, len(names)) for owner in owners]
    return Partition(_islands(number, first, lengths), first, number)


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


def _tie_results(program: Program, first: Mapping[str, int], items: Ties) -> None:
    """By the elements of results, and both items of an entry of a matrix."""
    tied = [
        (result.shape, block)
        for function in program.functions
        for result, block in zip(BY_NAME[function.name].results, function.results, strict=True)
        if result.shape and function.name not in OF_STARTS and "nu" not in result.shape
    ]
    items.look({node for _, block in tied for node in block.nodes})
    for shape, block in tied:
        rows = first[shape[0]]
        if len(shape) == 1:
            for place, node in enumerate(block.nodes):
                items.tie(rows + place, node)
            continue
        columns, width = first[shape[1]], block.shape[1]
        for place, node in block.entries:
            items.join(rows + place // width, columns + place % width)
            items.tie(rows + place // width, node)


def _owners(items: Ties, first: Mapping[str, int], lengths: Mapping[str, int]) -> list[int]:
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
