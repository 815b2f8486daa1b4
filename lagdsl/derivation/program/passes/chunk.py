"""Cutting a long function into pieces that a C compiler handles in linear time, with a scratch array between them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from lagdsl.foundation.record import record


@record()
class Chunks:
    """`pieces` are consecutive runs of statements.

    `slot` is the place in the scratch array of every statement that a later piece reads, `size` its length.
    """

    pieces: tuple[tuple[int, ...], ...]
    slot: dict[int, int]
    size: int


def chunk(statements: Sequence[int], reads: Callable[[int], Sequence[int]], largest: int) -> Chunks:
    """Pieces of at most `largest` statements. `reads(s)` are the statements whose values s uses directly.

    Places are reused as soon as the last reader's piece is over.
    """
    pieces = [tuple(statements[start : start + largest]) for start in range(0, len(statements), largest)]
    piece_of = {statement: index for index, piece in enumerate(pieces) for statement in piece}
    last_reader: dict[int, int] = {}
    for index, piece in enumerate(pieces[1:], 1):
        for statement in piece:
            for read in reads(statement):
                if piece_of.get(read, index) < index:
                    last_reader[read] = index
    return _allocate(pieces, last_reader)


def _allocate(pieces: list[tuple[int, ...]], last_reader: dict[int, int]) -> Chunks:
    slot: dict[int, int] = {}
    free: list[int] = []
    size = 0
    released: list[list[int]] = [[] for _ in pieces]
    for index, piece in enumerate(pieces):
        for statement in piece:
            if statement in last_reader:
                if free:
                    slot[statement] = free.pop()
                else:
                    slot[statement] = size
                    size += 1
                released[last_reader[statement]].append(slot[statement])
        free.extend(reversed(released[index]))
    return Chunks(tuple(pieces), slot, size)
