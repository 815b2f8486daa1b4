"""A program as the bytes of a tape, as lag/tape.h describes them."""

from __future__ import annotations

import zlib
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from itertools import chain
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.differentiate import mask_of
from lagdsl.algebra.graph.operation import DIRECTION_OF, FIRST_UNARY
from lagdsl.derivation.program.lengths import counted, sizes
from lagdsl.derivation.program.passes.along import Along, along
from lagdsl.derivation.program.passes.motion_jacobian import motion_jacobian
from lagdsl.derivation.program.passes.pattern import equations_pattern, patterns
from lagdsl.derivation.program.program import Block, Layout, Program, Slot
from lagdsl.engines.backends.start import Start
from lagdsl.engines.backends.tape.function import NO_CODE, Code, Result, results_of, words_of
from lagdsl.engines.backends.tape.nodes import Ints, Nodes, distinct, live_sets, nodes_of
from lagdsl.engines.backends.tape.one_state import Base, OneState, beside, one_state
from lagdsl.engines.backends.tape.settled import Settled
from lagdsl.foundation.record import record
from lagdsl.language.flat.events import INITIAL

_DIRECTIONS: Final = mask_of(DIRECTION_OF.values())
VERSION: Final = 15
_MAGIC: Final = b"lagtape\n"
_NOWHERE: Final = 0xFFFFFFFF
_KINDS: Final = (
    *("variable", "contact", "impacts", "sticks", "direction", "relation", "timed"),
    *("delay", "delay_rate", "condition", "clock", "initial", "terminal", "load"),
)

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
    return Tapes(program).tape(start, parts)


class Tapes:
    """The tapes of one program: what all have in common is made once."""

    def __init__(self, program: Program) -> None:
        self._program = program
        self._common: tuple[OneState, list[bytes]] | None = None

    def tape(self, start: Start | None = None, parts: Collection[str] = ()) -> bytes:
        """As `tape` gives it."""
        program = self._program
        found = [along(program, parameters=part == PARTS[1]) if part in parts else None for part in PARTS[:2]]
        written = motion_jacobian(program) if PARTS[2] in parts else None
        nodes = nodes_of(program.graph, program.layout)
        if self._common is None:
            self._common = one_state(program, nodes), _tables(program)
        state, tables = self._common
        several = [[one.results for one in each.functions.values()] for each in found if each is not None]
        needed = _needed(nodes, several if written is None else [*several, [written.results]])
        every = [each for own in needed for each in own]
        base = beside(state, nodes, [each.live for each in every], [each.roots for each in every])
        jacobian = [] if written is None else [words_of(nodes, every[-1].live, every[-1].results, base.settled)]
        own = iter(needed)
        directions = [
            _NO_DIRECTIONS if each is None else _codes_along(nodes, each, next(own), base.settled) for each in found
        ]
        codes = [*base.codes, *(code for own, *_ in directions for code in own), *jacobian]
        of_state = [*base.codes, *(own[0] for own, *_ in directions), *jacobian]
        rows = [max(code.row for code in of_state), base.settled.first, *(n for _, *own in directions for n in own)]
        return _written(program, base, start, tables, codes, rows)


def _written(
    program: Program, base: Base, start: Start | None, tables: list[bytes], codes: Sequence[Code], rows: Sequence[int]
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
            _doubles(base.constants),
            *tables,
            *_start(start),
            _words(texts.of_slots(_slots(layout))),
            _words(map(texts.place, _messages(layout))),
            texts.section(),
            _words(table),
            _words(words),
        ]
    )


# ---- functions -------------------------------------------------------------------------------------------------------


_Directions: TypeAlias = tuple[list[Code], int, int]
_NO_DIRECTIONS: Final[_Directions] = ([NO_CODE] * (1 + len(ALONG)), 0, 0)


@record()
class _Needed:
    """A function: its results, their nodes, and all those that they are computed from."""

    results: list[Result]
    roots: Ints
    live: Ints


def _needed(nodes: Nodes, functions: Sequence[Sequence[Sequence[Block]]]) -> list[list[_Needed]]:
    """Of the results of all functions, part by part."""
    results = [[results_of(blocks) for blocks in own] for own in functions]
    roots = [[distinct(len(nodes.op), *(result.roots for result in each)) for each in own] for own in results]
    lives = iter(live_sets(nodes, list(chain.from_iterable(roots))) if functions else ())
    return [
        [_Needed(own, of, next(lives)) for own, of in zip(*part, strict=True)]
        for part in zip(results, roots, strict=True)
    ]


def _codes_along(nodes: Nodes, found: Along, needed: Sequence[_Needed], settled: Settled) -> _Directions:
    """Functions of several directions, that of the state first; how much they share of the row, and their own row.
    `needed` are the functions of `found`."""
    count = len(nodes.op)
    live = distinct(count, *(each.live for each in needed))
    common = _shared(nodes, live, distinct(count, *(each.roots for each in needed)))
    common = common[(settled.place[common] < 0) & ~settled.hidden[common]]
    after = settled.with_more(common)
    before = replace(settled, first=after.first)
    motion = results_of(found.motion)
    (live,) = live_sets(nodes, [distinct(count, common, *(result.roots for result in motion))])
    codes = [words_of(nodes, live, motion, before, common)]
    named = dict(zip(found.functions, needed, strict=True))
    for name in ALONG:
        own = named.get(name)
        codes.append(NO_CODE if own is None else words_of(nodes, _differentiated(nodes, own), own.results, after))
    return codes, after.first, max(after.first, *(code.row for code in codes[1:]))


def _shared(nodes: Nodes, live: Ints, roots: Ints) -> Ints:
    """Nodes that do not depend on a direction and are results or read by what does, ascending."""
    moving = nodes.groups & _DIRECTIONS != 0
    operands = nodes.operands[:, live[moving[live] & (nodes.op[live] >= FIRST_UNARY)]].ravel()
    wanted = distinct(len(nodes.op), operands[operands >= 0], roots)
    common: Ints = wanted[~moving[wanted]]
    return common


def _differentiated(nodes: Nodes, needed: _Needed) -> Ints:
    """Nodes that depend on a direction, and their operands."""
    live = needed.live
    moving = live[(nodes.groups[live] & _DIRECTIONS != 0) & (nodes.op[live] >= FIRST_UNARY)]
    operands = nodes.operands[:, moving].ravel()
    return distinct(len(nodes.op), moving, operands[operands >= 0], needed.roots)


def _written_once(codes: Sequence[Code]) -> tuple[list[int], NDArray[np.uint32]]:
    """First word and number of words of every function, and all words; those of one code stand there once."""
    table: list[int] = []
    start: dict[int, int] = {}
    end = 0
    for code in codes:
        if id(code) not in start:
            start[id(code)] = end
            end += len(code.words)
        table += (start[id(code)], len(code.words))
    return table, np.concatenate([code.words for code in {id(code): code for code in codes}.values()])


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
        bytes(instants.jumping),
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


def _words(values: Iterable[int] | Ints | NDArray[np.uint32]) -> bytes:
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
