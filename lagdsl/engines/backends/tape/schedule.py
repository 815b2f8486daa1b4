"""The order of instructions: many of one kind that wait for nothing stand together, and run in one loop.

Processors foresee the jump from one instruction to the next only for so many jumps, and work on several instructions at
once only where these do not wait for each other. Of the kinds that are ready, the one is next that the longest chain of
instructions waits for.
"""

from __future__ import annotations

import numpy as np

from lagdsl.engines.backends.tape.instructions import CODE
from lagdsl.engines.backends.tape.nodes import sorted_by
from lagdsl.engines.backends.tape.selection import Selection


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
    return _scheduled(kinds, height, after[by_maker].tolist(), bounds.tolist(), needs.tolist())


def _heights(steps: int, after: list[int], before: list[int]) -> list[int]:
    """The longest chain of steps that waits for each; `after` waits for `before`, pair by pair. Across turns, which
    stand at the end, it is an estimate, which is all that is needed."""
    height = [0] * steps
    for own, other in zip(reversed(after), reversed(before), strict=True):
        if height[other] <= height[own]:
            height[other] = height[own] + 1
    return height


def _scheduled(
    kinds: list[int], height: list[int], readers: list[int], bounds: list[int], needs: list[int]
) -> list[list[int]]:
    """Of the kinds that are `ready`, with the `highest` of their steps. Once for each step and each that waits for it:
    most of the time that a tape takes."""
    ready: dict[int, list[int]] = {kind: [] for kind in sorted(set(kinds))}
    highest = dict.fromkeys(ready, -1)
    found: list[list[int]] = []
    released = [step for step, need in enumerate(needs) if not need]
    left = len(kinds)
    while True:
        for step in released:
            kind = kinds[step]
            ready[kind].append(step)
            if highest[kind] < height[step]:  # noqa: PLR1730, a call for each step
                highest[kind] = height[step]
        if not left:
            return found
        kind = max(highest, key=highest.__getitem__)
        group = ready[kind]
        found.append(group)
        left -= len(group)
        ready[kind], highest[kind] = [], -1
        released = []
        for step in group:
            for reader in readers[bounds[step] : bounds[step + 1]]:
                need = needs[reader] = needs[reader] - 1
                if not need:
                    released.append(reader)
