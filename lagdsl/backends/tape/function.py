"""One function of a program as words of a tape."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from lagdsl.backends.tape.instructions import CODE, FIRST_ARITHMETIC, FIRST_FUNCTION, GROUPS, ON_V, REMAINING
from lagdsl.backends.tape.nodes import Flags, Ints, Nodes
from lagdsl.backends.tape.registers import places
from lagdsl.backends.tape.selection import Selection, live_of, select
from lagdsl.graph.operation import Group, Op

# Results with so many zeros are cleared before the others are written.
_FEWEST_ZEROS = 8


@dataclass(frozen=True, slots=True)
class Settled:
    """`place` of every node of the graph that is in the row before a function starts, -1 for others; `nodes` are those
    among them that are computed from others. Parameters stand from the place `parameters` on, what belongs to the
    function alone from `first` on."""

    place: Ints
    nodes: frozenset[int]
    parameters: int
    first: int


def words_of(nodes: Nodes, blocks: Sequence[Sequence[int]], settled: Settled) -> tuple[Ints, int]:
    """The instructions that fill the result arrays `blocks`, and the length of the row that they need."""
    elements = [np.array(block, dtype=np.int64) for block in blocks]
    roots = np.unique(np.concatenate([_NONE, *elements]))
    live = live_of(nodes, roots.tolist(), settled.nodes)
    known = settled.place[live]
    selection = select(nodes, live, known >= 0, np.searchsorted(live, roots))
    loads, loaded = _loads(nodes, live, known, settled.first)
    body, place, end = _body(selection, known, loaded, settled.first)
    stores = [
        _stored(number, place[np.searchsorted(live, block)], block != nodes.graph.zero)
        for number, block in enumerate(elements)
    ]
    return np.concatenate([*loads, body, *stores, [CODE["END"]]]), end


def words_into(nodes: Nodes, wanted: Ints, settled: Settled, parameters: int) -> tuple[Ints, int]:
    """The instructions that put the nodes `wanted`, ascending, into their places, after the constants and as many
    parameters, which have places in a row."""
    live = live_of(nodes, wanted.tolist(), frozenset())
    at_hand = settled.place[live] >= 0
    results = np.searchsorted(live, wanted)
    at_hand[results] = False
    selection = select(nodes, live, at_hand, results)
    body, _, end = _body(selection, settled.place[live], _NONE, settled.first)
    own = [GROUPS[Group.P], 0, parameters, settled.parameters]
    load = [CODE["LOAD"], *own] if parameters else []
    return np.concatenate([np.array([CODE["CONSTANTS"], *load]), body, [CODE["END"]]]), end


_NONE: Ints = np.zeros(0, dtype=np.int64)


def _loads(nodes: Nodes, live: Ints, known: Ints, first: int) -> tuple[list[Ints], Ints]:
    """The loads of the arguments, and their local numbers in the order of their places; -1 for what nothing reads."""
    symbols = np.flatnonzero((nodes.op[live] == Op.SYMBOL) & (known < 0))
    groups, indices = nodes.operands[0, live[symbols]], nodes.operands[1, live[symbols]]
    loads: list[Ints] = []
    loaded: list[Ints] = []
    for group in np.unique(groups).tolist():
        members, own = symbols[groups == group], indices[groups == group]
        start = int(own.min())
        row = np.full(int(own.max()) + 1 - start, -1, dtype=np.int64)
        row[own - start] = members
        place = first + sum(map(len, loaded))
        loads.append(np.array([CODE["LOAD"], GROUPS[Group(group)], start, len(row), place]))
        loaded.append(row)
    return loads, np.concatenate([_NONE, *loaded])


def _stored(number: int, place: Ints, nonzero: Flags) -> Ints:
    """The instruction that fills the result array `number`."""
    if not len(place):
        return _NONE
    if len(place) - np.count_nonzero(nonzero) < _FEWEST_ZEROS:
        return np.concatenate([[CODE["STORE"], number, 0, len(place)], place])
    entries = np.flatnonzero(nonzero)
    return np.concatenate([[CODE["SCATTER"], number, len(place), len(entries)], entries, place[entries]])


def _body(selection: Selection, known: Ints, loaded: Ints, first: int) -> tuple[Ints, Ints, int]:
    """The instructions between loads and stores, the place of every value, and the length of the row.

    Step 0 are the loads; every instruction and every turn is one step.
    """
    code, operands = _forwarded(selection)
    step = 1 + np.arange(len(code)) + np.searchsorted([turn.phase for turn in selection.turns], selection.phase)
    at_turn = [
        1 + int(np.searchsorted(selection.phase, turn.phase, "right")) + number
        for number, turn in enumerate(selection.turns)
    ]
    end = 1 + len(code) + len(at_turn)
    stores = ~_passes_on(code)
    writes: list[Sequence[int]] = [()] * end
    writes[0] = loaded.tolist()
    for where, value in zip(step[stores].tolist(), selection.made[stores].tolist(), strict=True):
        writes[where] = (value,)
    for where, turn in zip(at_turn, selection.turns, strict=True):
        writes[where] = [value for value in (*turn.sines.tolist(), *turn.cosines.tolist()) if value >= 0]
    values, when = _reads(selection, operands, step, at_turn, end)
    place, top = places(known, writes, values, when, first)
    spare = int(any((turn.sines < 0).any() or (turn.cosines < 0).any() for turn in selection.turns))
    padded = np.append(place, top)  # what nothing reads goes to the last place
    turns = [
        np.concatenate(
            [[CODE["SINCOS"], len(turn.angles)], padded[turn.angles], padded[turn.sines], padded[turn.cosines]]
        )
        for turn in selection.turns
    ]
    return (
        _assembled(code, np.where(stores, place[selection.made], -1), padded, operands, step, at_turn, turns),
        place,
        top + spare,
    )


def _reads(selection: Selection, operands: Ints, step: Ints, at_turn: Sequence[int], end: int) -> tuple[Ints, Ints]:
    """Values and the steps that read them, ascending; results are read at the end."""
    read = operands >= 0
    values = [operands[read], *(turn.angles for turn in selection.turns), selection.results]
    steps = [
        np.broadcast_to(step[:, None], operands.shape)[read],
        *(np.full(len(turn.angles), where) for where, turn in zip(at_turn, selection.turns, strict=True)),
        np.full(len(selection.results), end),
    ]
    value, when = np.concatenate(values), np.concatenate(steps)
    order = np.argsort(when, kind="stable")
    return value[order], when[order]


def _passes_on(code: Ints) -> Flags:
    """Instructions that store nothing."""
    second: Flags = (code - FIRST_ARITHMETIC) % 2 == 1
    return second & (code < FIRST_FUNCTION)


def _forwarded(selection: Selection) -> tuple[Ints, Ints]:
    """Instructions and operands where a value is handed to the next instruction, if that reads it."""
    code, operands = selection.form.copy(), selection.operands.copy()
    before = np.full(len(code), -2, dtype=np.int64)
    before[1:] = np.where(selection.phase[1:] == selection.phase[:-1], selection.made[:-1], -2)
    taken = np.zeros(len(code), dtype=np.bool_)
    for which in range(operands.shape[1]):
        rows = np.flatnonzero((selection.operands[:, which] == before) & ~taken & (ON_V[selection.form, which] >= 0))
        taken[rows] = True
        remaining = REMAINING[selection.form[rows], which]
        operands[rows] = np.where(
            remaining >= 0, np.take_along_axis(selection.operands[rows], np.maximum(remaining, 0), 1), -1
        )
        code[rows] = ON_V[selection.form[rows], which]
    ends = np.zeros(len(code), dtype=np.bool_)
    ends[:-1] = taken[1:] & (selection.uses[selection.made[:-1]] == 1) & (code[:-1] < FIRST_FUNCTION)
    code[ends] += 1
    return code, operands


def _assembled(
    code: Ints, target: Ints, place: Ints, operands: Ints, step: Ints, at_turn: Sequence[int], turns: Sequence[Ints]
) -> Ints:
    """The words of all steps after the loads."""
    width = np.zeros(1 + len(code) + len(turns), dtype=np.int64)
    read = operands >= 0
    width[step] = 1 + (target >= 0) + read.sum(axis=1)
    width[list(at_turn)] = [len(turn) for turn in turns]
    start = np.cumsum(width) - width
    words = np.zeros(int(width.sum()), dtype=np.int64)
    where = start[step]
    words[where] = code
    stored = target >= 0
    words[where[stored] + 1] = target[stored]
    where = where + 1 + stored
    for column in range(operands.shape[1]):  # operands stand from the left on
        there = read[:, column]
        words[where[there] + column] = place[operands[there, column]]
    for at, turn in zip(at_turn, turns, strict=True):
        words[start[at] : start[at] + len(turn)] = turn
    return words
