"""Work on many states shared out to all cores, in parts whose results do not depend on who does them."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from time import perf_counter
from typing import TypeAlias

# States of one part: few enough to stop soon after an interrupt and to end together, and a multiple of any number of
# vector lanes.
PART = 512
_PARTS_PER_THREAD = 4
# Seconds of work in one thread that are shared out: starting threads, and waiting for the last, takes a tenth of that.
_WORTH_THREADS = 5e-3

Part: TypeAlias = Callable[[int, int], None]


def cores() -> int:
    """Number of threads of this process that can work at the same time."""
    if hasattr(os, "sched_getaffinity"):
        return max(1, len(os.sched_getaffinity(0)))
    return os.cpu_count() or 1


def share_out(count: int, threads: int | None, worker: Callable[[], Part], largest: int = PART) -> None:
    """Call `part(first, end)` for the parts of `range(count)`; every thread has a `part = worker()` of its own.

    A part has at most `largest` states, but enough are left for all threads. `threads` None: one, and all cores for
    what is left after a first part if that takes much longer than threads take to start. Of several parts that raise,
    the first counts: a failure is the same in every run.
    """
    done = 0
    if threads is None:
        threads = cores() if count > PART else 1
        if threads > 1:
            part, done = worker(), PART
            begin = perf_counter()
            part(0, done)
            seconds = (perf_counter() - begin) * (count - done) / done
            if seconds < _WORTH_THREADS:
                _singly(part, done, count, largest)
                return
    size = max(PART, min(largest, (count - done) // (_PARTS_PER_THREAD * max(threads, 1))) // PART * PART)
    bounds = [(first, min(first + size, count)) for first in range(done, count, size)]
    if threads <= 1 or len(bounds) <= 1:
        _singly(worker(), done, count, largest)
        return
    from concurrent.futures import ThreadPoolExecutor

    own = threading.local()

    def work(first: int, end: int) -> None:
        if not hasattr(own, "part"):
            own.part = worker()
        own.part(first, end)

    with ThreadPoolExecutor(min(threads, len(bounds))) as pool:
        for _ in pool.map(work, *zip(*bounds, strict=True)):  # in their order; leaving it early cancels the rest
            pass


def _singly(part: Part, first: int, count: int, largest: int) -> None:
    for begin in range(first, count, largest):
        part(begin, min(begin + largest, count))
