"""Locks of files: one process makes a file, and others that need it at the same time wait."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Hold the lock of the file `path`, which stays. On systems without locks nobody waits: a process writes the file
    beside its place and moves it there, and the last one replaces the files of the others."""
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
