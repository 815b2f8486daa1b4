"""Places in the row for the values of a function: a place is free again after the last group that reads it."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Sequence

import numpy as np

from lagdsl.engines.backends.tape.nodes import Ints


class Registers:
    """Places, of which those from `top` on were never used. Blocks are taken and given back whole; what is left of a
    larger one serves as well."""

    def __init__(self, top: int) -> None:
        self.top = top
        self._single: list[int] = []
        self._blocks: list[tuple[int, int]] = []  # lengths and first places, ascending

    def take(self) -> int:
        """One place."""
        if not self._single and self._blocks:
            length, first = self._blocks.pop(0)
            self._single += range(first + length - 1, first - 1, -1)
        if self._single:
            return self._single.pop()
        self.top += 1
        return self.top - 1

    def take_block(self, length: int) -> int:
        """The first of so many places in a row: of the shortest block that has them."""
        at = bisect_left(self._blocks, (length, 0))
        if at == len(self._blocks):
            self.top += length
            return self.top - length
        whole, first = self._blocks.pop(at)
        self.give_block(first + length, whole - length)
        return first

    def give(self, places: Sequence[int]) -> None:
        """Places that are free again."""
        self._single += places

    def give_block(self, first: int, length: int) -> None:
        if length:
            insort(self._blocks, (length, first))


class Blocks:
    """Blocks of values that were placed together: free when none of them is read any more."""

    def __init__(self, count: int, registers: Registers) -> None:
        self._registers = registers
        self._of = np.full(count, -1, dtype=np.int64)
        self._first: list[int] = []
        self._length: list[int] = []
        self._left: list[int] = []

    def place(self, values: Ints) -> Ints:
        """The places of `values`, in a row."""
        first = self._registers.take_block(len(values))
        self._of[values] = len(self._first)
        self._first.append(first)
        self._length.append(len(values))
        self._left.append(len(values))
        return first + np.arange(len(values))

    def leave(self, values: Ints, places: Ints) -> None:
        """Nobody reads these any more."""
        of = self._of[values]
        self._registers.give(places[of < 0].tolist())
        own = of[of >= 0]
        if len(own):
            numbers, counts = np.unique(own, return_counts=True)
            for block, count in zip(numbers.tolist(), counts.tolist(), strict=True):
                self._left[block] -= count
                if not self._left[block]:
                    self._registers.give_block(self._first[block], self._length[block])
