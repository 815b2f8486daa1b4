"""The order of instructions: many of one kind that wait for nothing stand together, and run in one loop.

Processors foresee the jump from one instruction to the next only for so many jumps, and work on several instructions at
once only where these do not wait for each other. Of the kinds that are ready, the one is next that the longest chain of
instructions waits for.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from lagdsl.engines.backends.tape.instructions import CODE
from lagdsl.engines.backends.tape.nodes import Ints, distinct, sorted_by
from lagdsl.engines.backends.tape.selection import Selection

# Arrays take as long for any group as Python does for so many steps.
_MANY: Final = 64


def groups(selection: Selection) -> list[list[int]]:
    """Steps in their order, grouped: numbers of instructions and, following on these, of turns, which stand alone."""
    count, turns = len(selection.made), selection.turns
    maker = np.full(selection.count + 2, -1, dtype=np.int64)
    maker[selection.made] = np.arange(count)
    for number, turn in enumerate(turns, count):
        maker[turn.sines[turn.sines >= 0]] = number
        maker[turn.cosines[turn.cosines >= 0]] = number
    there = selection.operands >= 0
    rows = np.repeat(np.arange(count), np.count_nonzero(there, axis=1))
    before = np.concatenate([maker[selection.operands[there]], *(maker[turn.angles] for turn in turns)])
    after = np.concatenate([rows, *(np.full(len(turn.angles), k) for k, turn in enumerate(turns, count))])
    after, before = after[before >= 0], before[before >= 0]
    kinds = [*selection.code.tolist(), *range(len(CODE), len(CODE) + len(turns))]
    height = _heights(len(kinds), after.tolist(), before.tolist())
    by_maker, bounds = sorted_by(before, len(kinds))
    needs = np.bincount(after, minlength=len(kinds))
    return _Schedule(np.array(kinds), np.array(height), after[by_maker], bounds, needs).groups()


def _heights(steps: int, after: list[int], before: list[int]) -> list[int]:
    """The longest chain of steps that waits for each; `after` waits for `before`, pair by pair. Across turns, which
    stand at the end, it is an estimate, which is all that is needed."""
    height = [0] * steps
    for own, other in zip(reversed(after), reversed(before), strict=True):
        if height[other] <= height[own]:
            height[other] = height[own] + 1
    return height


class _Schedule:
    """Steps that are `ready` by kind, and the `highest` of them. Once for each step and each that waits for it: most of
    the time that a tape takes."""

    def __init__(self, kinds: Ints, height: Ints, readers: Ints, bounds: Ints, needs: Ints) -> None:
        self._arrays = kinds, height, readers, bounds, needs, np.zeros_like(needs)
        self._kinds, self._height = kinds.tolist(), height.tolist()
        self._readers, self._bounds = readers.tolist(), bounds.tolist()
        self._needs = needs.data  # gives Python single numbers of the array at once
        self._ready: dict[int, list[int]] = {kind: [] for kind in sorted(set(self._kinds))}
        self._highest = dict.fromkeys(self._ready, -1)

    def groups(self) -> list[list[int]]:
        """Of the kinds that are ready, with the highest of their steps first."""
        ready, highest = self._ready, self._highest
        found: list[list[int]] = []
        self._add([step for step, need in enumerate(self._needs) if not need])
        left = len(self._kinds)
        while left:
            kind = max(highest, key=highest.__getitem__)
            group = ready[kind]
            found.append(group)
            left -= len(group)
            ready[kind], highest[kind] = [], -1
            if len(group) < _MANY:
                self._release(group)
            else:
                self._release_many(np.array(group))
        return found

    def _release(self, group: list[int]) -> None:
        """Steps that wait for none but those of `group` become ready."""
        needs, readers, bounds = self._needs, self._readers, self._bounds
        released = []
        for step in group:
            for reader in readers[bounds[step] : bounds[step + 1]]:
                need = needs[reader] = needs[reader] - 1
                if not need:
                    released.append(reader)
        self._add(released)

    def _release_many(self, group: Ints) -> None:
        """The same on arrays."""
        kinds, height, readers, bounds, needs, place = self._arrays
        counts = bounds[group + 1] - bounds[group]
        inside = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
        waiting = readers[np.repeat(bounds[group], counts) + inside]
        np.subtract.at(needs, waiting, 1)
        places = np.arange(len(waiting))
        place[waiting] = places  # which ascend: of several the last one stays
        released = waiting[(needs[waiting] == 0) & (place[waiting] == places)]
        own = kinds[released]
        for kind in distinct(int(own.max(initial=-1)) + 1, own).tolist():
            members = released[own == kind]
            self._ready[kind] += members.tolist()
            self._highest[kind] = max(self._highest[kind], int(height[members].max()))

    def _add(self, released: list[int]) -> None:
        kinds, height, ready, highest = self._kinds, self._height, self._ready, self._highest
        for step in released:
            kind = kinds[step]
            ready[kind].append(step)
            if highest[kind] < height[step]:  # noqa: PLR1730, a call for each step
                highest[kind] = height[step]
