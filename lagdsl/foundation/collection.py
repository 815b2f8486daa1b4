"""Python's search for cycles of objects, while trees and graphs are made that have none.

Each search looks at what was made since the last one, and sometimes at all there is: a sixth of the time of compiling.
Behind a block the next search looks once at what the block made. (Objects that `gc.freeze` and `gc.unfreeze` make old
are not counted: the interpreter would search everything again and again.)
"""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Lock


class _Pause:
    """Blocks that wait for no search, in all threads together: the last one lets it go on."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._blocks = 0
        self._was_enabled = False

    def begin(self) -> None:
        with self._lock:
            if self._blocks == 0:
                self._was_enabled = gc.isenabled()
                gc.disable()
            self._blocks += 1

    def end(self) -> None:
        with self._lock:
            self._blocks -= 1
            if self._blocks == 0 and self._was_enabled:
                gc.enable()


_PAUSE = _Pause()


@contextmanager
def without_collection() -> Iterator[None]:
    """No search for cycles while the block runs. Objects that nobody holds are freed at once all the same."""
    _PAUSE.begin()
    try:
        yield
    finally:
        _PAUSE.end()
