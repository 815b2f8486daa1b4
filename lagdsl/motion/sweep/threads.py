"""Runs in threads of this process: C makes them, and while it works in one thread, it works in others, too."""

from __future__ import annotations

import threading
from collections.abc import Generator, Iterable, Sequence
from queue import SimpleQueue
from typing import TypeAlias

from lagdsl.engines.runtime.ensemble import Stop
from lagdsl.motion.sweep.maker import Ensembles, Maker
from lagdsl.motion.sweep.plan import Task
from lagdsl.motion.sweep.run import Interrupted, Options, Outcome, SweptModel

_Message: TypeAlias = "list[Outcome] | BaseException | None"


def in_threads(
    subjects: Sequence[SweptModel], options: Options, tasks: Iterable[Task], left: int, threads: int
) -> Generator[Outcome, None, None]:
    """Outcomes as they come of the `left` tasks, by at most so many threads. Functions of Python, as inputs or as the
    NumPy engine, are called by one thread."""
    single = options.engine == "numpy" or any(map(callable, options.inputs.values()))
    count = 1 if single else max(1, min(threads, left))
    parts = _Parts(tasks, left, count)
    done: SimpleQueue[_Message] = SimpleQueue()
    stop = Stop()
    ensembles = Ensembles(subjects, options)
    makers = [Maker(subjects, options, ensembles, stop) for _ in range(count)]
    workers = [threading.Thread(target=_serve, args=(maker, parts, done), daemon=True) for maker in makers]
    for worker in workers:
        worker.start()
    try:
        while count:
            message = done.get()
            if isinstance(message, BaseException):
                raise message
            if message is None:
                count -= 1
            else:
                yield from message
    finally:
        stop.set()
        parts.close()
        for maker, worker in zip(makers, workers, strict=True):
            worker.join()
            maker.leave()


class _Parts:
    """Tasks for several threads, some at a time, those of one model together."""

    def __init__(self, tasks: Iterable[Task], left: int, threads: int) -> None:
        self._tasks = iter(tasks)
        self._next = next(self._tasks, None)
        self._threads = threads
        self._lock = threading.Lock()
        self.left = left

    def take(self, most: int, together: int) -> list[Task]:
        """At most so many, and few enough that no thread waits for another at the end: as many as go on together, or
        half of what is left for each of several threads; none where there are no more."""
        with self._lock:
            share = self.left // (2 * self._threads) if self._threads > 1 else self.left
            size = max(1, min(most, share), min(together, self.left // self._threads))
            part: list[Task] = []
            while self._next is not None and len(part) < size and self._next.swept == (part or [self._next])[0].swept:
                part.append(self._next)
                self._next = next(self._tasks, None)
            self.left -= len(part)
            return part

    def close(self) -> None:
        with self._lock:
            self._next = None


def _serve(worker: Maker, parts: _Parts, done: SimpleQueue[_Message]) -> None:
    """One thread: takes tasks, passes on outcomes, then None."""
    try:
        while tasks := parts.take(worker.size(), worker.together):
            done.put(worker.run(tasks, parts.left))
    except Interrupted:
        pass
    except BaseException as error:  # told where the outcomes are read
        done.put(error)
    done.put(None)
