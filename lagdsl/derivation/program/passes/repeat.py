"""Finding what repeats in a sequence: stretches that are one pattern again and again."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.foundation.record import record

# A pattern is looked for among the next occurrences of its first element, so far away at most.
_CANDIDATES = 16
_LONGEST_PATTERN = 600
# Least number of operations that a loop must save.
_LEAST_SAVING = 8


@record()
class Run:
    """`count` times `period` elements from `start` on; count 1 where nothing repeats."""

    start: int
    period: int
    count: int

    @property
    def stop(self) -> int:
        return self.start + self.period * self.count


def runs(sequence: Sequence[int]) -> tuple[Run, ...]:
    """The sequence as consecutive runs, each time the one that saves most from the first place that saves enough."""
    following = _following(sequence)
    found: list[Run] = []
    loose = index = 0
    while index < len(sequence):
        best = _best(sequence, following, index)
        if best is None:
            index += 1
            continue
        if loose < index:
            found.append(Run(loose, index - loose, 1))
        found.append(best)
        loose = index = best.stop
    if loose < index:
        found.append(Run(loose, index - loose, 1))
    return tuple(found)


def _following(sequence: Sequence[int]) -> list[int]:
    """For every element the place of the next equal one, or -1."""
    following = [-1] * len(sequence)
    last: dict[int, int] = {}
    for index in range(len(sequence) - 1, -1, -1):
        following[index] = last.get(sequence[index], -1)
        last[sequence[index]] = index
    return following


def _best(sequence: Sequence[int], following: Sequence[int], start: int) -> Run | None:
    best: Run | None = None
    saving = _LEAST_SAVING - 1
    again = following[start]
    for _ in range(_CANDIDATES):
        if again < 0 or again - start > _LONGEST_PATTERN:
            break
        period = again - start
        stop = again
        while stop < len(sequence) and sequence[stop] == sequence[stop - period]:
            stop += 1
        count = (stop - start) // period
        if (count - 1) * period > saving:
            saving = (count - 1) * period
            best = Run(start, period, count)
        again = following[again]
    return best
