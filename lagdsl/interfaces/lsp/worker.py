"""The queue of texts to be looked at: a text is looked at when it has rested, and only in its last version."""

from __future__ import annotations

import sys
from collections.abc import Callable
from threading import Condition, Thread, stack_size
from time import monotonic
from typing import Generic, TypeVar

Key = TypeVar("Key")

_STACK = 256 * 1024 * 1024  # trees may be deep


class Worker(Generic[Key]):
    """A thread that calls `work` with each key that was asked for, `rest` seconds after it was last asked for."""

    def __init__(self, rest: float, work: Callable[[Key], None]) -> None:
        self._rest = rest
        self._work = work
        self._due: dict[Key, float] = {}
        self._condition = Condition()
        self._ended = False
        before = stack_size(_STACK)
        self._thread = Thread(target=self._run, daemon=True)
        self._thread.start()
        stack_size(before)

    def ask(self, key: Key, *, rest: float | None = None) -> None:
        """Look at `key` soon; an earlier question about it is dropped."""
        with self._condition:
            self._due[key] = monotonic() + (self._rest if rest is None else rest)
            self._condition.notify()

    def forget(self, key: Key) -> None:
        with self._condition:
            self._due.pop(key, None)

    def end(self) -> None:
        with self._condition:
            self._ended = True
            self._condition.notify()

    def _run(self) -> None:
        while True:
            with self._condition:
                while not self._ended and (not self._due or min(self._due.values()) > monotonic()):
                    self._condition.wait(max(min(self._due.values()) - monotonic(), 0) if self._due else None)
                if self._ended:
                    return
                key = min(self._due, key=lambda each: self._due[each])
                del self._due[key]
            try:
                self._work(key)
            except Exception as failure:  # one text must not end the queue of all
                print(f"lag lsp: {type(failure).__name__}: {failure}", file=sys.stderr)
