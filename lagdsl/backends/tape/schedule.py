"""The order of instructions: many of one kind that wait for nothing stand together, and run in one loop.

Processors foresee the jump from one instruction to the next only for so many jumps, and work on several instructions at
once only where these do not wait for each other. Of the kinds that are ready, the one is next that the longest chain of
instructions waits for.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.backends.tape.instructions import CODE
from lagdsl.backends.tape.nodes import Ints
from lagdsl.backends.tape.selection import Selection


def groups(selection: Selection) -> list[list[int]]:
    """Steps in their order, grouped: numbers of instructions and, following on these, of turns, which stand alone."""
    count, turns = len(selection.made), selection.turns
    maker = np.full(selection.count + 3, -1, dtype=np.int64)  # the last one is that of no operand
    maker[selection.made] = np.arange(count)
    for number, turn in enumerate(turns, count):
        maker[turn.sines[turn.sines >= 0]] = number
        maker[turn.cosines[turn.cosines >= 0]] = number
    waits = maker[selection.operands]
    angles = [maker[turn.angles] for turn in turns]
    kinds = [*selection.code.tolist(), *range(len(CODE), len(CODE) + len(turns))]
    return _scheduled(kinds, _heights(waits, angles), *_readers(waits, angles))


def _heights(waits: Ints, angles: Sequence[Ints]) -> list[int]:
    """The longest chain of steps that waits for each. Across turns it is an estimate, which is all that is needed."""
    own = len(waits)
    height = [0] * (own + len(angles) + 1)  # the last one is that of no step
    for before in waits[::-1].tolist():
        own -= 1
        above = height[own] + 1
        for step in before:
            height[step] = max(height[step], above)
    for number in reversed(range(len(angles))):
        above = height[len(waits) + number] + 1
        for step in angles[number].tolist():
            height[step] = max(height[step], above)
    return height


def _readers(waits: Ints, angles: Sequence[Ints]) -> tuple[list[int], list[int], list[int]]:
    """The steps that wait for each, those of step i from bounds[i] to bounds[i + 1]; and for how many each waits."""
    steps = len(waits) + len(angles)
    behind = np.concatenate([np.repeat(np.arange(len(waits)), waits.shape[1])])
    behind = np.concatenate([behind, *(np.full(len(own), number) for number, own in enumerate(angles, len(waits)))])
    before = np.concatenate([waits.ravel(), *angles])
    behind, before = behind[before >= 0], before[before >= 0]
    order = np.argsort(before, kind="stable")
    bounds = np.searchsorted(before[order], np.arange(steps + 1))
    return behind[order].tolist(), bounds.tolist(), np.bincount(behind, minlength=steps).tolist()


def _scheduled(
    kinds: list[int], height: list[int], readers: list[int], bounds: list[int], needs: list[int]
) -> list[list[int]]:
    ready: dict[int, list[int]] = {kind: [] for kind in sorted(set(kinds))}
    highest = dict.fromkeys(ready, -1)
    for step, need in enumerate(needs):
        if not need:
            ready[kinds[step]].append(step)
            highest[kinds[step]] = max(highest[kinds[step]], height[step])
    found: list[list[int]] = []
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
                    own = kinds[reader]
                    ready[own].append(reader)
                    highest[own] = max(highest[own], height[reader])
    return found
