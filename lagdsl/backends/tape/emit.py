"""A program as the bytes of a tape, as lag/tape.h describes them."""

from __future__ import annotations

import zlib
from collections.abc import Iterable, Sequence
from typing import Final

import numpy as np

from lagdsl.backends.c.emit import Start
from lagdsl.backends.tape.function import Settled, words_into, words_of
from lagdsl.backends.tape.nodes import Flags, Ints, Nodes, nodes_of
from lagdsl.flat.events import INITIAL
from lagdsl.graph.operation import FIRST_UNARY, Group, Op
from lagdsl.program import functions as known
from lagdsl.program.program import Function, Layout, Program, Slot
from lagdsl.program.verify import counted, sizes

VERSION: Final = 1
_MAGIC: Final = b"lagtape\n"
_PARAMETER: Final = 1 << Group.P
_NOWHERE: Final = 0xFFFFFFFF
_KINDS: Final = ("variable", "contact", "impacts", "relation", "timed", "condition", "clock")

# Functions by number, as lag_function counts them.
FUNCTIONS: Final = tuple(function.name for function in known.FUNCTIONS if function.single)

# The lengths that a tape starts with, and where the name of the model stands, as lag_tape_size counts them.
SIZES: Final = (
    *("nq", "nz", "nu", "nw", "np", "nc", "ny", "ni", "na", "nd", "ne", "rank", "nk", "nindicator", "ncontact"),
    *("ngap", "nclock", "nreset", "ncollision", "nstop", "nfail", "ntimed", "ndistance", "nswitched"),
    *("row", "prepared", "name"),
)


def tape(program: Program, start: Start | None = None) -> bytes:
    """The tape of `program`; the same program gives the same bytes. `start` tells where its motion begins."""
    nodes = nodes_of(program.graph)
    functions = [program.function(name) if program.has(name) else None for name in FUNCTIONS]
    settled, constants, hoisted = _settled(program, nodes, [f for f in functions if f is not None])
    codes, row = _codes(program, nodes, functions, settled, hoisted)
    texts = _Texts()
    layout = program.layout
    lengths = {
        **sizes(layout),
        **counted(program),
        "rank": len(layout.constraints) - sum(layout.redundant),
        "nk": len(program.kept_rows),
        "nswitched": len(layout.instants.switched_rows),
        "row": row,
        "prepared": settled.first,
        "name": texts.place(program.name),
    }
    return _written(
        [
            _words(lengths[name] for name in SIZES),
            _doubles(constants),
            *_tables(layout, program.kept_rows),
            *_start(start),
            _words(texts.of_slots(_slots(layout))),
            _words(map(texts.place, _messages(layout))),
            texts.section(),
            _words(_table(codes)),
            _words(np.concatenate([*codes, np.zeros(0, dtype=np.int64)])),
        ]
    )


# ---- functions -------------------------------------------------------------------------------------------------------


def _settled(program: Program, nodes: Nodes, functions: Sequence[Function]) -> tuple[Settled, Sequence[float], Ints]:
    """What stands in the row before a function starts: constants, parameters, what follows from these alone."""
    graph = program.graph
    roots = np.unique([node for f in functions for block in f.results for node in block.elements]).astype(np.int64)
    live = np.array(graph.live(roots.tolist()), dtype=np.int64)
    alone = nodes.groups & ~_PARAMETER == 0
    hoisted = _hoisted(nodes, live, roots, alone)
    numbers = live[nodes.op[live] == Op.CONSTANT]
    constants = [1.0, -1.0, *(graph.value[node] for node in numbers.tolist())]
    place = np.full(len(graph), -1, dtype=np.int64)
    place[numbers] = 2 + np.arange(len(numbers))
    symbols = live[(nodes.op[live] == Op.SYMBOL) & (nodes.operands[0, live] == Group.P)]
    place[symbols] = len(constants) + nodes.operands[1, symbols]
    parameters = len(program.layout.parameters)
    place[hoisted] = len(constants) + parameters + np.arange(len(hoisted))
    settled = Settled(place, frozenset(hoisted.tolist()), len(constants), len(constants) + parameters + len(hoisted))
    return settled, constants, hoisted


def _hoisted(nodes: Nodes, live: Ints, roots: Ints, alone: Flags) -> Ints:
    """Nodes computed from parameters alone that something else is computed from, or that are results; ascending."""
    operands = nodes.operands[:, live[~alone[live] & (nodes.op[live] >= FIRST_UNARY)]].ravel()
    wanted = np.union1d(operands[operands >= 0], roots)
    return wanted[alone[wanted] & (nodes.op[wanted] >= FIRST_UNARY)]


def _codes(
    program: Program, nodes: Nodes, functions: Sequence[Function | None], settled: Settled, hoisted: Ints
) -> tuple[list[Ints], int]:
    """The words of prepare() and of every function, none where the program lacks it; and the length of the row."""
    preparation, row = words_into(nodes, hoisted, settled, len(program.layout.parameters))
    codes = [preparation]
    for function in functions:
        words = np.zeros(0, dtype=np.int64)
        if function is not None:
            words, end = words_of(nodes, [block.elements for block in function.results], settled)
            row = max(row, end)
        codes.append(words)
    return codes, row


def _table(codes: Sequence[Ints]) -> Iterable[int]:
    """First word and number of words of every function."""
    first = 0
    for words in codes:
        yield from (first, len(words))
        first += len(words)


# ---- tables ----------------------------------------------------------------------------------------------------------


def _tables(layout: Layout, kept_rows: Sequence[int]) -> list[bytes]:
    instants = layout.instants
    kinds = [kind_number(layout, index) for index in range(len(layout.kinds))]
    return [
        _doubles(layout.defaults),
        bytes(layout.position_level),
        bytes(layout.redundant),
        bytes(kinds),
        bytes(instants.strict),
        _words(kept_rows),
        _words(instants.contact_rows),
        _words(instants.switched_rows),
        _words(instants.reset_places),
    ]


def kind_number(layout: Layout, index: int) -> int:
    """The lag_kind of an entry of w."""
    if layout.kinds[index] == "instant":
        return len(_KINDS) + (layout.discretes[index].name != INITIAL)
    return _KINDS.index(layout.kinds[index])


def _start(start: Start | None) -> list[bytes]:
    """Time and state, then what is said of their entries; all empty where nothing is known."""
    if start is None:
        return [b""] * 6
    return [
        _doubles([start.t, *start.x]),
        bytes(start.fixed),
        bytes(start.written),
        *(_doubles(numbers) for numbers in (start.nominal, start.minimum, start.maximum)),
    ]


def _slots(layout: Layout) -> list[Slot]:
    return [
        *(*layout.coordinates, *layout.states, *layout.inputs, *layout.discretes, *layout.parameters),
        *(*layout.constraints, *layout.outputs, *layout.invariants, *layout.definitions),
    ]


def _messages(layout: Layout) -> Sequence[str]:
    instants = layout.instants
    return [*layout.assertions, *instants.resets, *instants.stops, *instants.failures]


class _Texts:
    """Texts by their first byte in the section of texts, each once, ended by a zero."""

    def __init__(self) -> None:
        self._place: dict[str, int] = {}
        self._bytes = bytearray()

    def place(self, text: str) -> int:
        known = self._place.get(text)
        if known is None:
            known = self._place[text] = len(self._bytes)
            self._bytes += text.encode("utf-8", errors="replace").replace(b"\0", b"?") + b"\0"
        return known

    def of_slots(self, slots: Sequence[Slot]) -> Iterable[int]:
        for slot in slots:
            place = None if slot.place is None else slot.place.replace("\\", "/").rpartition("/")[2]
            yield from (self.place(slot.name), self.place(slot.unit))
            yield _NOWHERE if place is None else self.place(place)

    def section(self) -> bytes:
        return bytes(self._bytes)


# ---- the file --------------------------------------------------------------------------------------------------------


def _words(values: Iterable[int] | Ints) -> bytes:
    array = values if isinstance(values, np.ndarray) else np.array(list(values), dtype=np.int64)
    return array.astype("<u4").tobytes()


def _doubles(values: Sequence[float]) -> bytes:
    return np.array(values, dtype="<f8").tobytes()


def _written(sections: Sequence[bytes]) -> bytes:
    """Head, lengths of the sections in bytes, and the sections, each from a multiple of 8 bytes on."""
    lengths = np.array([len(section) for section in sections], dtype="<u8").tobytes()
    body = b"".join([lengths, *(section + bytes(-len(section) % 8) for section in sections)])
    head = np.array([VERSION, zlib.crc32(body)], dtype="<u4").tobytes()
    return _MAGIC + head + np.array([len(body)], dtype="<u8").tobytes() + body
