"""Places in the row for the values of a function: a place is free again after the last step that reads it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from lagdsl.engines.backends.tape.nodes import Ints, sorted_by


def places(
    known: Ints,
    loaded: Sequence[int],
    writes: Sequence[int],
    several: Mapping[int, Sequence[int]],
    last: Ints,
    top: int,
) -> tuple[Ints, int]:
    """The place of every value, and the first one beyond all of them.

    `known` are the places that are settled, -1 for others; `last` the last step that reads a value, -1 where none does.
    The values `loaded` stand in a row from `top` on, a negative one is no value. Step by step, the value of `writes`
    is stored, or those of `several`.
    """
    dying = np.flatnonzero((known < 0) & (last >= 0) & (last < len(writes)))
    order, firsts = sorted_by(last[dying], len(writes))
    bounds, dies = firsts.tolist(), dying[order].tolist()
    place: list[int] = known.tolist()
    free: list[int] = []
    for value in loaded:
        if value < 0:
            free.append(top)
        else:
            place[value] = top
        top += 1
    end = 0
    for step, (written, until) in enumerate(zip(writes, bounds[1:], strict=False)):
        while end < until:
            free.append(place[dies[end]])
            end += 1
        for value in several[step] if written < 0 else (written,):
            if place[value] < 0:
                if free:
                    place[value] = free.pop()
                else:
                    place[value] = top
                    top += 1
    return np.array(place, dtype=np.int64), top
