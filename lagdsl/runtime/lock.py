"""Locks of files: one process makes a file, and others that need it at the same time wait."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Hold the lock of the file `path`, which stays. Where there are no locks, nobody waits: who makes a file writes
    it beside its place and moves it there, and whoever comes last replaces what the others made."""
    try:
        import fcntl
    except ImportError:  # Windows
        yield
        return
    with path.open("w") as file:
        with suppress(OSError):  # a file system without locks
            fcntl.flock(file, fcntl.LOCK_EX)
        yield


def lock_of(kept: Path) -> Path:
    """The lock for a file that is named by a hexadecimal digest: sixteen of them do for a folder."""
    return kept.parent / f"lock-{kept.name[0]}"
