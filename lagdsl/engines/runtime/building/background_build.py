"""A library that is compiled while something else goes on, and given up when nobody waits for it any more."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from pathlib import Path

from lagdsl.engines.runtime.building.build import build
from lagdsl.engines.runtime.building.compiler import Cancellation, Cancelled
from lagdsl.foundation.diagnostics import CompilationFailed


class BackgroundBuild:
    """Compiles what `sources` gives into the file `name` of the cache, in a thread of its own.

    `library` is its path once it is there. It stays None after a failure: the caller continues without the faster code.
    """

    def __init__(self, sources: Callable[[], Mapping[str, str]], flags: tuple[str, ...], name: str) -> None:
        self.library: Path | None = None
        self._cancellation = Cancellation()
        self._thread = threading.Thread(target=self._work, args=(sources, flags, name), daemon=True)
        self._thread.start()

    @property
    def is_running(self) -> bool:
        return self._thread.is_alive()

    def cancel(self) -> None:
        """End the compiler and wait until what it has written is gone."""
        self._cancellation.cancel()
        self._thread.join()

    def _work(self, sources: Callable[[], Mapping[str, str]], flags: tuple[str, ...], name: str) -> None:
        try:
            self.library = build(sources(), flags, name=name, cancellation=self._cancellation)
        except (CompilationFailed, Cancelled):
            return
