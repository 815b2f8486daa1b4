"""A progress bar on a terminal for what takes longer than a second; lines in a pipe or a file for what takes longer
than five."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Lock, Timer
from time import monotonic
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID

_PATIENCE = 1.0  # seconds without a bar
_PATIENCE_OF_LOGS = 5.0  # seconds without a line
_LINES = 10


class _Bar:
    """Appears when the patience has run out; it only moves to and fro until somebody reports."""

    def __init__(self, title: str) -> None:
        self._title = title
        self._lock = Lock()
        self._closed = False
        self._progress: Progress | None = None
        self._task: TaskID | None = None
        self._timer = Timer(_PATIENCE, self._show)
        self._timer.daemon = True
        self._timer.start()

    def report(self, fraction: float) -> None:
        """`fraction` of the work is done."""
        if self._progress is not None and self._task is not None:
            self._progress.update(self._task, total=1.0, completed=fraction)

    def close(self) -> None:
        """It leaves nothing on the terminal."""
        self._timer.cancel()
        with self._lock:
            self._closed = True
            if self._progress is not None:
                self._progress.stop()

    def _show(self) -> None:
        from rich.console import Console
        from rich.progress import Progress

        with self._lock:
            if not self._closed:
                shown = Progress(console=Console(stderr=True), transient=True)
                self._task = shown.add_task(self._title, total=None)
                shown.start()
                self._progress = shown


class _Lines:
    """One for each tenth of the work, from the first report after the patience has run out."""

    def __init__(self, title: str) -> None:
        self._title = title
        self._began = monotonic()
        self._told = 0

    def report(self, fraction: float) -> None:
        """`fraction` of the work is done."""
        tenth = int(fraction * _LINES)
        if self._told < tenth < _LINES and monotonic() - self._began >= _PATIENCE_OF_LOGS:
            self._told = tenth
            print(f"{self._title}: {100 * tenth // _LINES} %", file=sys.stderr, flush=True)


@contextmanager
def progress(title: str) -> Iterator[Callable[[float], None]]:
    """A function that takes the fraction done, for work that tells it. Nothing else may be written meanwhile."""
    if not sys.stderr.isatty():
        yield _Lines(title).report
        return
    bar = _Bar(title)
    try:
        yield bar.report
    finally:
        bar.close()
