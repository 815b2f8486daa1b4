"""One function of a program as words of a tape."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.graph import ZERO
from lagdsl.algebra.graph.operation import FIRST_UNARY, Group, Op
from lagdsl.derivation.program.program import Block
from lagdsl.engines.backends.tape.arrangement import Arrangement
from lagdsl.engines.backends.tape.instructions import CODE, GROUPS, STRIDED, THREE_PRODUCTS, TWO_PRODUCTS
from lagdsl.engines.backends.tape.nodes import Flags, Ints, Nodes, Roles, distinct
from lagdsl.engines.backends.tape.schedule import groups
from lagdsl.engines.backends.tape.selection import Selection, select
from lagdsl.engines.backends.tape.settled import MINUS_ONE, ONE, Settled
from lagdsl.foundation.record import record

Piece: TypeAlias = tuple[Ints, Flags]
"""Words, and True where one is a place in the row."""

# Results with so many zeros are cleared before the others are written.
_FEWEST_ZEROS = 8


@record()
class Result:
    """A result array of `count` numbers: `nodes` stand at `places`, ascending; all others are zero."""

    count: int
    places: Ints
    nodes: Ints

    @property
    def roots(self) -> Ints:
        """All that it is computed from."""
        return self.nodes if len(self.nodes) == self.count else np.append(self.nodes, ZERO)


def results_of(blocks: Iterable[Block]) -> list[Result]:
    return [_result(block) for block in blocks]


def _result(block: Block) -> Result:
    nodes = np.array(block.nodes, dtype=np.int64)
    places = np.array(block.places, dtype=np.int64) if block.is_sparse else np.flatnonzero(nodes != ZERO)
    return Result(block.size, places, nodes if block.is_sparse else nodes[places])


@record()
class Code:
    """Instructions, and the length of the row that they need. `moves` where a word is a place in the row."""

    words: NDArray[np.uint32]
    moves: Flags
    row: int

    def moved(self, places: Ints, by: int) -> Code:
        """The same where what was settled lies in other `places`, and what belongs to the function alone lies `by`
        further."""
        words = self.words.copy()
        own = words[self.moves].astype(np.int64)
        settled = len(places)
        words[self.moves] = np.where(own < settled, places[np.minimum(own, settled - 1)], own + by)
        return Code(words, self.moves, self.row + by)


def words_of(nodes: Nodes, live: Ints, results: Sequence[Result], settled: Settled, kept: Ints | None = None) -> Code:
    """The instructions that fill the `results`, which are computed from the nodes `live`.

    The nodes `kept`, ascending, are put into places in a row: the last ones before those of the function itself.
    """
    kept = _NONE if kept is None else kept
    live = live[~settled.hidden[live]]
    known = settled.place[live]
    at_hand = known >= 0
    own = np.searchsorted(live, kept)
    places = settled.first - len(kept) + np.arange(len(kept))
    computed = nodes.op[kept] >= FIRST_UNARY
    known[own[computed]] = places[computed]
    told = distinct(len(live), own, *(np.searchsorted(live, result.roots) for result in results))
    loads, loaded = _loads(nodes, live, at_hand, settled.first)
    body, place, end = _computed(nodes, live, known, at_hand, loaded, told, settled.first)
    copied = np.array([places[~computed], place[own[~computed]], np.full(np.count_nonzero(~computed), ONE)])
    copies = _movable([CODE["MULTIPLY"], copied.shape[1]], copied.T.ravel()) if copied.size else _NOTHING
    stores = [_stored(number, result, live, place) for number, result in enumerate(results)]
    return _code([*loads, body, copies, *stores, _END], end)


def preparation(nodes: Nodes, live: Ints, hoisted: Ints, settled: Settled, parameters: int) -> Code:
    """The instructions that put the nodes `hoisted`, ascending, which are computed from `live`, into their places,
    after the constants and as many parameters."""
    known = settled.place[live]
    at_hand = known >= 0
    results = np.searchsorted(live, hoisted)
    at_hand[results] = False
    body, _, end = _computed(nodes, live, known, at_hand, _NONE, results, settled.first)
    own = _movable([CODE["LOAD"], GROUPS[Group.P], 0, parameters], np.array([settled.parameters]))
    return _code([_movable([CODE["CONSTANTS"]], _NONE), own if parameters else _NOTHING, body, _END], end)


_NONE: Ints = np.zeros(0, dtype=np.int64)


def _movable(head: Sequence[int], places: Ints) -> Piece:
    """Words that are no places, and then `places`."""
    return np.concatenate([np.array(head, dtype=np.int64), places]), np.arange(len(head) + len(places)) >= len(head)


_NOTHING: Piece = _movable([], _NONE)
_END: Piece = _movable([CODE["END"]], _NONE)


def _code(pieces: Sequence[Piece], row: int) -> Code:
    words, moves = zip(*pieces, strict=True)
    return Code(np.concatenate(words).astype(np.uint32), np.concatenate(moves), row)


NO_CODE: Final = _code([_NOTHING], 0)
"""Of a function that there is not."""


def _loads(nodes: Nodes, live: Ints, at_hand: Flags, first: int) -> tuple[list[Piece], Ints]:
    """The loads of the arguments, and their local numbers in the order of their places; -1 for what nothing reads."""
    symbols = np.flatnonzero((nodes.op[live] == Op.SYMBOL) & ~at_hand)
    groups, indices = nodes.operands[0, live[symbols]], nodes.operands[1, live[symbols]]
    loads: list[Piece] = []
    loaded: list[Ints] = []
    for group in distinct(len(Group), groups).tolist():
        members, own = symbols[groups == group], indices[groups == group]
        start = int(own.min())
        row = np.full(int(own.max()) + 1 - start, -1, dtype=np.int64)
        row[own - start] = members
        place = first + sum(map(len, loaded))
        loads.append(_movable([CODE["LOAD"], GROUPS[Group(group)], start, len(row)], np.array([place])))
        loaded.append(row)
    return loads, np.concatenate([_NONE, *loaded])


def _stored(number: int, result: Result, live: Ints, place: Ints) -> Piece:
    """The instruction that fills the result array `number`, where the nodes `live` are in these places."""
    count, entries, own = result.count, result.places, place[np.searchsorted(live, result.nodes)]
    if not count:
        return _NOTHING
    if count - len(entries) >= _FEWEST_ZEROS:
        return _movable([CODE["SCATTER"], number, count, len(entries), *entries.tolist()], own)
    whole = np.full(count, place[np.searchsorted(live, ZERO)] if len(entries) < count else -1)
    whole[entries] = own
    return _movable([CODE["STORE"], number, 0, count], whole)


def _computed(
    nodes: Nodes, live: Ints, known: Ints, at_hand: Flags, loaded: Ints, results: Ints, first: int
) -> tuple[Piece, Ints, int]:
    """The instructions between loads and stores, the place of every value, and the length of the row."""
    if at_hand[nodes.op[live] >= FIRST_UNARY].all():
        place = known.copy()
        place[loaded[loaded >= 0]] = first + np.flatnonzero(loaded >= 0)
        return _NOTHING, place, first + len(loaded)
    count = len(nodes.op)  # one and minus one are two more
    role = np.append(nodes.roles.role[live], [-1 - count, -2 - count])
    roles = Roles(role, np.append(nodes.roles.part[live], [0, 0]))
    return _body(select(nodes, live, at_hand, results), known, loaded, results, roles, first)


def _body(
    selection: Selection, known: Ints, loaded: Ints, results: Ints, roles: Roles, first: int
) -> tuple[Piece, Ints, int]:
    arranged = Arrangement(
        selection, groups(selection), np.append(known, [ONE, MINUS_ONE]), loaded, results, roles, first
    )
    spare = int(any((values < 0).any() for turn in selection.turns for values in (turn.sines, turn.cosines)))
    padded = np.append(arranged.place, arranged.top)  # what nothing reads goes behind all others
    pieces: list[Piece] = []
    plain: list[Sequence[int] | Ints] = []
    for stretch in [*arranged.stretches, None]:
        if stretch is not None and not stretch.strided:
            plain.append(stretch.steps)
            continue
        if plain:
            lengths = np.fromiter(map(len, plain), dtype=np.int64)
            order = np.fromiter(chain.from_iterable(plain), dtype=np.int64, count=int(lengths.sum()))
            pieces.append(_assembled(selection, order, lengths, padded))
            plain = []
        if stretch is not None:
            pieces.append(_over_strides(selection, np.asarray(stretch.steps), padded))
    words, moves = zip(*pieces, strict=True)
    return (np.concatenate(words), np.concatenate(moves)), arranged.place, arranged.top + spare


def _over_strides(selection: Selection, steps: Ints, place: Ints) -> Piece:
    """The words of one instruction for all `steps`."""
    code, operands = int(selection.code[steps[0]]), selection.operands[steps[:2]]
    summing = code in (TWO_PRODUCTS, THREE_PRODUCTS)
    own = place[operands[:, operands[0] >= 0]]
    head = [STRIDED[code], len(steps), int(place[selection.made[steps[0]]])]
    signs = selection.signs[steps[:1]] if summing else _NONE
    words = np.concatenate([head, signs, np.ravel([own[0], own[1] - own[0]], "F")])
    moves = np.zeros(len(words), dtype=np.bool_)
    moves[2] = True
    moves[3 + summing :: 2] = True
    return words, moves


def _assembled(selection: Selection, order: Ints, lengths: Ints, place: Ints) -> Piece:
    """The words of the steps in their `order`, in groups of such `lengths`."""
    count = len(selection.made)
    single = order < count
    width = np.empty(len(order), dtype=np.int64)
    summing = (selection.code == TWO_PRODUCTS) | (selection.code == THREE_PRODUCTS)
    before = 1 + summing  # words before the operands
    width[single] = (before + np.count_nonzero(selection.operands >= 0, axis=1))[order[single]]
    width[~single] = [3 * len(selection.turns[step - count].angles) for step in order[~single].tolist()]
    heads = np.zeros(len(order), dtype=np.int64)
    heads[np.cumsum(lengths) - lengths] = 2  # operation and number
    start = np.cumsum(width + heads) - width
    words = np.empty(int(width.sum()) + 2 * len(lengths), dtype=np.int64)
    firsts = order[np.cumsum(lengths) - lengths]
    at = start[np.cumsum(lengths) - lengths] - 2
    words[at] = np.append(selection.code, np.full(len(selection.turns), CODE["SINCOS"]))[firsts]
    words[at + 1] = lengths
    moves = np.ones(len(words), dtype=np.bool_)
    moves[at] = moves[at + 1] = False
    made, where = order[single], start[single]
    words[where] = place[selection.made[made]]
    words[where[summing[made]] + 1] = selection.signs[made[summing[made]]]
    moves[where[summing[made]] + 1] = False
    for column, own in enumerate(selection.operands[made].T):  # operands stand from the left on
        words[(where + before[made])[own >= 0] + column] = place[own[own >= 0]]
    for step, begin in zip(order[~single].tolist(), start[~single].tolist(), strict=True):
        turn = selection.turns[step - count]
        words[begin - 1] = len(turn.angles)
        words[begin : begin + 3 * len(turn.angles)] = place[np.concatenate([turn.angles, turn.sines, turn.cosines])]
    return words, moves
