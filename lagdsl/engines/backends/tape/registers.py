"""Places in the row for the values of a function: a place is free again after the last group that reads it."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Sequence

import numpy as np

from lagdsl.engines.backends.tape.nodes import Ints


class Registers:
    """The `place` of every value, -1 where it has none yet; those from `top` on were never used. Blocks of values in a
    row are taken and given back whole; what is left of a larger one serves as well."""

    def __init__(self, place: Ints, top: int, free: Sequence[int]) -> None:
        self.place, self.top = place, top
        self._free = list(free)
        self._blocks: list[tuple[int, int]] = []  # lengths and first places, ascending
        self._block_of = np.full(len(place), -1, dtype=np.int64)
        self._taken: list[list[int]] = []  # first place, length, values that are still read
        self._place, self._of = place.data, self._block_of.data  # give Python single numbers at once

    def take(self, values: Sequence[int]) -> None:
        """A place for each of `values` that has none."""
        place, free = self._place, self._free
        for value in values:
            if place[value] < 0:
                if not free and self._blocks:
                    length, first = self._blocks.pop(0)
                    free += range(first + length - 1, first - 1, -1)
                if free:
                    place[value] = free.pop()
                else:
                    place[value] = self.top
                    self.top += 1

    def take_block(self, values: Ints) -> None:
        """Places in a row, of the shortest block that has them; each by itself where some are settled."""
        if (self.place[values] >= 0).any():
            self.take(values.tolist())
            return
        length = len(values)
        at = bisect_left(self._blocks, (length, 0))
        if at < len(self._blocks):
            whole, first = self._blocks.pop(at)
            self._give_block(first + length, whole - length)
        else:
            first = self.top
            self.top += length
        self.place[values] = first + np.arange(length)
        self._block_of[values] = len(self._taken)
        self._taken.append([first, length, length])

    def give(self, values: Sequence[int]) -> None:
        """Nobody reads these any more."""
        place, of, free = self._place, self._of, self._free
        for value in values:
            number = of[value]
            if number < 0:
                free.append(place[value])
                continue
            block = self._taken[number]
            block[2] -= 1
            if not block[2]:
                self._give_block(block[0], block[1])

    def _give_block(self, first: int, length: int) -> None:
        if length:
            insort(self._blocks, (length, first))
