"""The order of instructions: many of one kind that wait for nothing stand together, and run in one loop.

Processors foresee the jump from one instruction to the next only for so many jumps, and work on several instructions at
once only where these do not wait for each other. Of the kinds that are ready, the one is next that the longest chain of
instructions waits for.
"""

from __future__ import annotations

import numpy as np

from lagdsl.backends.tape.instructions import CODE
from lagdsl.backends.tape.selection import Selection


def groups(selection: Selection) -> list[list[int]]:
    """Steps in their order, grouped: numbers of instructions and, following on these, of turns, which stand alone."""
    count, turns = len(selection.made), selection.turns
    maker = np.full(selection.count + 2, -1, dtype=np.int64)
    maker[selection.made] = np.arange(count)
    for number, turn in enumerate(turns, count):
        maker[turn.sines[turn.sines >= 0]] = number
        maker[turn.cosines[turn.cosines >= 0]] = number
    rows, columns = np.nonzero(selection.operands >= 0)
    before = np.concatenate([maker[selection.operands[rows, columns]], *(maker[turn.angles] for turn in turns)])
    after = np.concatenate([rows, *(np.full(len(turn.angles), k) for k, turn in enumerate(turns, count))])
    after, before = after[before >= 0], before[before >= 0]
    kinds = [*selection.code.tolist(), *range(len(CODE), len(CODE) + len(turns))]
    height = _heights(len(kinds), after.tolist(), before.tolist())
    by_maker = np.argsort(before, kind="stable")
    bounds = np.searchsorted(before[by_maker], np.arange(len(kinds) + 1))
    needs = np.bincount(after, minlength=len(kinds))
    return _scheduled(kinds, height, after[by_maker].tolist(), bounds.tolist(), needs.tolist())


def _heights(steps: int, after: list[int], before: list[int]) -> list[int]:
    """The longest chain of steps that waits for each; `after` waits for `before`, pair by pair. Across turns, which
    stand at the end, it is an estimate, which is all that is needed."""
    height = [0] * steps
    after.reverse()
    before.reverse()
    for own, other in zip(after, before, strict=True):
        if height[other] <= height[own]:
            height[other] = height[own] + 1
    return height


def _scheduled(
    kinds: list[int], height: list[int], readers: list[int], bounds: list[int], needs: list[int]
) -> list[list[int]]:
    ready: dict[int, list[int]] = {kind: [] for kind in sorted(set(kinds))}
    highest = dict.fromkeys(ready, -1)
    found: list[list[int]] = []
    group = [step for step, need in enumerate(needs) if not need]
    for step in group:
        _release(step, kinds[step], height[step], ready, highest)
    left = len(kinds)
    while left:
        kind = max(highest, key=highest.__getitem__)
        group = ready[kind]
        found.append(group)
        left -= len(group)
        ready[kind], highest[kind] = [], -1
        for step in group:
            for reader in readers[bounds[step] : bounds[step + 1]]:
                needs[reader] -= 1
                if not needs[reader]:
                    _release(reader, kinds[reader], height[reader], ready, highest)
    return found


def _release(step: int, kind: int, height: int, ready: dict[int, list[int]], highest: dict[int, int]) -> None:
    """From now on `step` waits for nothing."""
    ready[kind].append(step)
    highest[kind] = max(highest[kind], height)
