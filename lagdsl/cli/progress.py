"""A progress bar on a terminal, for what takes longer than a second; nothing otherwise."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID

_PATIENCE = 1.0  # seconds without a bar


class _Bar:
    """Appears at the first report after the patience has run out."""

    def __init__(self, title: str) -> None:
        self._title = title
        self._began = monotonic()
        self._progress: Progress | None = None
        self._task: TaskID | None = None

    def report(self, fraction: float) -> None:
        """`fraction` of the work is done."""
        if self._progress is None:
            if monotonic() - self._began < _PATIENCE:
                return
            from rich.console import Console
            from rich.progress import Progress

            self._progress = Progress(console=Console(stderr=True), transient=True)
            self._task = self._progress.add_task(self._title, total=1.0)
            self._progress.start()
        assert self._task is not None
        self._progress.update(self._task, completed=fraction)

    def close(self) -> None:
        if self._progress is not None:
            self._progress.stop()


@contextmanager
def progress(title: str) -> Iterator[Callable[[float], None] | None]:
    """A function that takes the fraction done; None where nobody watches."""
    if not sys.stderr.isatty():
        yield None
        return
    bar = _Bar(title)
    try:
        yield bar.report
    finally:
        bar.close()
