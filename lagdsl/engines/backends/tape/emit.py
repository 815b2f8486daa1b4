"""A program as the bytes of a tape, as lag/tape.h describes them."""

from __future__ import annotations

import zlib
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from hashlib import blake2b
from typing import Final

import numpy as np

from lagdsl.derivation.program import functions as known
from lagdsl.derivation.program.lengths import counted, sizes
from lagdsl.derivation.program.passes.along import Along, along, elements, shared
from lagdsl.derivation.program.passes.motion_jacobian import motion_jacobian
from lagdsl.derivation.program.passes.pattern import equations_pattern, patterns
from lagdsl.derivation.program.program import Layout, Program, Slot
from lagdsl.engines.backends.start import Start
from lagdsl.engines.backends.tape.function import Result, preparation, results_of, words_of
from lagdsl.engines.backends.tape.nodes import Ints, Nodes, distinct, live_sets, nodes_of
from lagdsl.engines.backends.tape.settled import Settled, settle
from lagdsl.language.flat.events import INITIAL

VERSION: Final = 13
_MAGIC: Final = b"lagtape\n"
_NOWHERE: Final = 0xFFFFFFFF
_KINDS: Final = (
    *("variable", "contact", "impacts", "sticks", "direction", "relation", "timed"),
    *("delay", "delay_rate", "condition", "clock", "initial", "terminal", "load"),
)

# Functions by number, as lag_function counts them.
FUNCTIONS: Final = tuple(function.name for function in known.FUNCTIONS if function.single)

# The lengths that a tape starts with, and where the name of the model stands, as lag_tape_size counts them.
SIZES: Final = (
    *("nq", "nz", "nu", "nw", "np", "nc", "ny", "ni", "na", "nd", "ne", "rank", "nk", "nindicator", "ncontact"),
    *(
        "ngap",
        "nclock",
        "nreset",
        "ncollision",
        "nstop",
        "nfail",
        "ntimed",
        "ndistance",
        "ncorner",
        "nway",
        "nturn",
        "ndelay",
        "nslip",
        "nfriction",
        "nload",
        "nswitched",
    ),
    *("ninertial", "nplace", "naxes", "ntwist"),
    *("row", "prepared", "shared", "along_row", "parameter_shared", "parameter_along_row", "name"),
)
_ROWS: Final = SIZES[-7:-1]

# Optional parts beside the functions of one state, and the functions of each part.
PARTS: Final = ("tangents", "parameter_tangents", "jacobian")
ALONG: Final = ("residual", "acceleration", "state_derivative", "output")


def tape(program: Program, start: Start | None = None, parts: Collection[str] = ()) -> bytes:
    """The tape of `program`; the same program gives the same bytes. `start` tells where its motion begins.

    `parts` of PARTS are what is wanted beside the functions of one state: those of several directions of derivatives
    at once, the derivatives of the motion.
    """
    found = [along(program, parameters=part == PARTS[1]) if part in parts else None for part in PARTS[:2]]
    written = motion_jacobian(program) if PARTS[2] in parts else None
    nodes = nodes_of(program.graph)
    single = [program.function(name).results if program.has(name) else () for name in FUNCTIONS]
    several = [each.functions[name].results for each in found if each is not None for name in each.functions]
    several += [] if written is None else [written.results]
    every = [results_of(blocks) for blocks in (*single, *several)]
    roots = [distinct(len(nodes.op), *(result.roots for result in own)) for own in every]
    lives = live_sets(nodes, roots)
    settled, constants, hoisted = settle(nodes, len(program.layout.parameters), lives, roots)
    live = np.array(program.graph.live(hoisted.tolist()), dtype=np.int64)
    first, row = preparation(nodes, live, hoisted, settled, len(program.layout.parameters))
    codes, ends = [first], [row]
    made: dict[tuple[tuple[int, bytes], ...], tuple[Ints, int]] = {}  # without constraints two functions are one
    for name, live, own in zip(FUNCTIONS, lives, every, strict=False):
        key = tuple((number, _key(result)) for number, result in enumerate(own) if result.count)
        if program.has(name) and key not in made:
            made[key] = words_of(nodes, live, own, settled)
        words, end = made[key] if program.has(name) else (_NONE, 0)
        codes.append(words)
        ends.append(end)
    rows = []
    for each in found:
        words_along, end, shared_end, own_row = _codes_along(nodes, each, settled)
        codes += words_along
        ends.append(end)
        rows += [shared_end, own_row]
    if written is not None:
        words, end = words_of(nodes, lives[-1], every[-1], settled)
        codes.append(words)
        ends.append(end)
    return _written(program, constants, start, codes, [max(ends), settled.first, *rows])


def _written(
    program: Program, constants: list[float], start: Start | None, codes: Sequence[Ints], rows: Sequence[int]
) -> bytes:
    """All sections."""
    texts = _Texts()
    layout = program.layout
    table, words = _written_once(codes)
    lengths = {
        **sizes(layout),
        **counted(program),
        "rank": len(layout.constraints) - sum(layout.redundant),
        "nk": len(program.kept_rows),
        "nswitched": len(layout.instants.switched_rows),
        **dict(zip(_ROWS, rows, strict=True)),
        "name": texts.place(program.name),
    }
    return _joined(
        [
            _words(lengths[name] for name in SIZES),
            _doubles(constants),
            *_tables(program),
            *_start(start),
            _words(texts.of_slots(_slots(layout))),
            _words(map(texts.place, _messages(layout))),
            texts.section(),
            _words(table),
            _words(words),
        ]
    )


# ---- functions -------------------------------------------------------------------------------------------------------

_NONE: Ints = np.zeros(0, dtype=np.int64)


def _codes_along(nodes: Nodes, found: Along | None, settled: Settled) -> tuple[list[Ints], int, int, int]:
    """The words of the functions of several directions; the row of what they share, how much that is, their own row."""
    if found is None:
        return [_NONE] * (1 + len(ALONG)), 0, 0, 0
    functions = [found.functions[name] for name in ALONG if name in found.functions]
    common = np.array(shared(nodes.graph, elements(functions), ()), dtype=np.int64)
    common = common[(settled.place[common] < 0) & ~settled.hidden[common]]
    after = settled.with_more(common)
    before = replace(settled, first=after.first)
    motion = results_of(found.motion)
    (live,) = live_sets(nodes, [distinct(len(nodes.op), common, *(result.roots for result in motion))])
    primal, single = words_of(nodes, live, motion, before, common)
    codes, row = [primal], after.first
    for name in ALONG:
        words = _NONE
        if name in found.functions:
            own = results_of(found.functions[name].results)
            live = _reached(nodes, distinct(len(nodes.op), *(result.roots for result in own)), after)
            words, end = words_of(nodes, live, own, after)
            row = max(row, end)
        codes.append(words)
    return codes, single, after.first, row


def _key(result: Result) -> bytes:
    """Equal for equal results."""
    return blake2b(np.concatenate([[result.count], result.places, result.nodes]).tobytes()).digest()


def _reached(nodes: Nodes, roots: Ints, settled: Settled) -> Ints:
    """Nodes from which `roots` are computed, down to those that are in the row already."""
    given = frozenset(np.flatnonzero(settled.place >= 0).tolist())
    return np.array(nodes.graph.live(roots.tolist(), given), dtype=np.int64)


def _written_once(codes: Sequence[Ints]) -> tuple[list[int], Ints]:
    """First word and number of words of every function, and all words; those of the same array stand there once."""
    table: list[int] = []
    start: dict[int, int] = {}
    words: list[Ints] = [_NONE]
    for code in codes:
        if id(code) not in start:
            start[id(code)] = sum(map(len, words))
            words.append(code)
        table += (start[id(code)], len(code))
    return table, np.concatenate(words)


# ---- tables ----------------------------------------------------------------------------------------------------------


def _tables(program: Program) -> list[bytes]:
    layout, equations = program.layout, equations_pattern(program)
    instants = layout.instants
    kinds = [kind_number(layout, index) for index in range(len(layout.kinds))]
    return [
        _doubles(layout.defaults),
        bytes(layout.position_level),
        bytes(layout.redundant),
        bytes(kinds),
        bytes(instants.strict),
        bytes(instants.whole_inputs),
        bytes(instants.one_way),
        _words(program.kept_rows),
        _words(instants.contact_rows),
        _words(instants.friction_rows),
        _words(instants.friction_slips),
        _words(instants.friction_contacts),
        _words(instants.switched_rows),
        _words(instants.reset_places),
        *(_words(numbers) for _, pattern in patterns(program).values() for numbers in pattern),
        *map(_words, (*equations.entries, equations.places, equations.groups, equations.value_groups)),
        _words(layout.components),
    ]


def kind_number(layout: Layout, index: int) -> int:
    """The lag_kind of an entry of w."""
    kind = layout.kinds[index]
    if kind == "instant":
        return _KINDS.index("initial" if layout.discretes[index].name == INITIAL else "terminal")
    return _KINDS.index(kind)


def _start(start: Start | None) -> list[bytes]:
    """Time and state, then what is said of their entries; all empty where nothing is known."""
    if start is None:
        return [b""] * 10
    return [
        _doubles([start.t, *start.x]),
        bytes(start.fixed),
        bytes(start.written),
        *(_doubles(numbers) for numbers in (start.nominal, start.minimum, start.maximum)),
        bytes(start.free),
        *(_doubles(n) for n in (start.parameter_nominal, start.parameter_minimum, start.parameter_maximum)),
    ]


def _slots(layout: Layout) -> list[Slot]:
    return [
        *(*layout.coordinates, *layout.states, *layout.inputs, *layout.discretes, *layout.parameters),
        *(*layout.constraints, *layout.outputs, *layout.invariants, *layout.definitions),
    ]


def _messages(layout: Layout) -> Sequence[str]:
    instants = layout.instants
    return [*layout.assertions, *instants.frictions, *instants.resets, *instants.stops, *instants.failures]


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


def _joined(sections: Sequence[bytes]) -> bytes:
    """Head, lengths of the sections in bytes, and the sections, each from a multiple of 8 bytes on."""
    lengths = np.array([len(section) for section in sections], dtype="<u8").tobytes()
    body = b"".join([lengths, *(section + bytes(-len(section) % 8) for section in sections)])
    head = np.array([VERSION, zlib.crc32(body)], dtype="<u4").tobytes()
    return _MAGIC + head + np.array([len(body)], dtype="<u8").tobytes() + body
