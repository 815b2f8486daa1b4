"""A watcher of long work where none is given: a notebook draws a bar."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

Progress: TypeAlias = Callable[[float], None]
Watcher: TypeAlias = Callable[[str], Progress]

_watchers: list[Watcher] = []


def watch_with(watcher: Watcher | None) -> None:
    """Let `watcher` make what is called with the part of the work that is done, from its title; None: nobody."""
    _watchers[:] = [] if watcher is None else [watcher]


def watched(progress: Progress | None, title: str) -> Progress | None:
    """The function that is told of the work: `progress` where it is given, else that of the watcher."""
    return progress if progress is not None or not _watchers else _watchers[-1](title)
