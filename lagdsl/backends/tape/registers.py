"""Places in the row for the values of a function: a place is free again after the last step that reads it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.backends.tape.nodes import Ints


def places(known: Ints, writes: Sequence[Sequence[int]], values: Ints, steps: Ints, top: int) -> tuple[Ints, int]:
    """The place of every value, and the first one beyond all of them.

    `known` are the places that are settled, -1 for others; `writes` the values that are stored, step by step; `values`
    are read at `steps`, which ascend. The values of step 0 stand in a row from `top` on; a negative one is no value.
    """
    last = np.zeros(len(known), dtype=np.int64)
    last[values] = steps  # of several the last one counts
    dying = np.flatnonzero((known < 0) & (last > 0))
    dying = dying[np.argsort(last[dying], kind="stable")]
    bounds = np.searchsorted(last[dying], np.arange(len(writes) + 1)).tolist()
    place: list[int] = known.tolist()
    free: list[int] = []
    for value in writes[0]:
        if value < 0:
            free.append(top)
        else:
            place[value] = top
        top += 1
    return _scan(place, free, writes, dying.tolist(), bounds, top)


def _scan(
    place: list[int],
    free: list[int],
    writes: Sequence[Sequence[int]],
    dying: list[int],
    bounds: list[int],
    top: int,
) -> tuple[Ints, int]:
    for step in range(1, len(writes)):
        for value in dying[bounds[step] : bounds[step + 1]]:
            free.append(place[value])
        for value in writes[step]:
            if place[value] < 0:
                if free:
                    place[value] = free.pop()
                else:
                    place[value] = top
                    top += 1
    return np.array(place, dtype=np.int64), top
