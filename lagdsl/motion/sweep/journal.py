"""Journal of a sweep, on disk: a file to which every outcome is appended, and which is read to resume.

A first line with the fingerprint of the sweep, then records: lengths, checksum, a text of JSON, numbers. A record that
was cut short is worth nothing and cut off; everything before it counts.
"""

from __future__ import annotations

import json
import os
import struct
import zlib
from collections.abc import Iterator
from pathlib import Path
from types import TracebackType
from typing import BinaryIO

import numpy as np

from lagdsl.motion.sweep.run import Outcome

_FRAME = struct.Struct("<QQL")  # bytes of the head, bytes of the numbers, checksum of both


class Busy(ValueError):  # noqa: N818  it is not the sweep that is wrong
    """Another process is at the same sweep."""


class Journal:
    """Open for appending, by one process at a time; use it in a `with` statement, which leaves no file without a run.
    Raises OSError, Busy."""

    def __init__(self, path: Path, fingerprint: str) -> None:
        """Go on with what is there, which must be of the same sweep, or begin."""
        self.path = path
        self._file: BinaryIO = path.open("a+b")
        try:
            _lock(self._file, path)
        except Busy:
            self._file.close()
            raise
        self._file.seek(0)
        if _first_line(self._file) != fingerprint:  # it holds no run: nobody goes on with those of another sweep
            self._file.truncate(0)
            self._file.write(_title(fingerprint))
        else:
            for _ in _records(self._file):
                pass
            self._file.truncate(self._file.tell())
        self._file.flush()

    def __enter__(self) -> Journal:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._file.close()
        if next(outcomes(self.path), None) is None:  # nothing that could be resumed
            self.path.unlink()

    def append(self, outcome: Outcome) -> None:
        """On disk when it returns, as far as this process can see to it."""
        head = json.dumps(
            {
                "index": outcome.index,
                "status": outcome.status,
                "ended": outcome.ended,
                "message": outcome.message,
                "names": outcome.names,
                "units": outcome.units,
                "shape": outcome.values.shape,
            }
        ).encode()
        numbers = np.ascontiguousarray(outcome.values, dtype="<f8").tobytes()
        self._file.seek(0, os.SEEK_END)
        self._file.write(_FRAME.pack(len(head), len(numbers), zlib.crc32(head + numbers)) + head + numbers)
        self._file.flush()


def require_idle(path: Path) -> None:
    """Raise Busy where a process has the journal at `path` open."""
    with path.open("r+b") as file:
        _lock(file, path)


def fingerprint_of(path: Path) -> str | None:
    """The fingerprint of the sweep whose journal lies at `path`; None where there is none."""
    if not path.is_file():
        return None
    with path.open("rb") as file:
        return _first_line(file)


def outcomes(path: Path) -> Iterator[Outcome]:
    """The finished runs, in the order in which they ended."""
    with path.open("rb") as file:
        if _first_line(file) is not None:
            yield from _records(file)


def _lock(file: BinaryIO, path: Path) -> None:
    """Until it is closed; not on systems without such locks. Raises Busy where another process has it."""
    try:
        import fcntl
    except ImportError:
        return
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise Busy(f"another process is making the runs of {path} now") from None


def _title(fingerprint: str) -> bytes:
    return f"lag sweep 1 {fingerprint}\n".encode()


def _first_line(file: BinaryIO) -> str | None:
    words = file.readline(200).decode(errors="replace")
    if words.startswith("lag sweep 1 ") and words.endswith("\n"):
        return words.split()[3]
    return None


def _records(file: BinaryIO) -> Iterator[Outcome]:
    """Leaves the file behind the last whole record."""
    while True:
        place = file.tell()
        frame = file.read(_FRAME.size)
        if len(frame) == _FRAME.size:
            head_size, size, checksum = _FRAME.unpack(frame)
            rest = os.fstat(file.fileno()).st_size - file.tell()
            content = file.read(head_size + size) if head_size + size <= rest else b""
            if len(content) == head_size + size and zlib.crc32(content) == checksum:
                yield _outcome(content[:head_size], content[head_size:])
                continue
        file.seek(place)
        return


def _outcome(head: bytes, numbers: bytes) -> Outcome:
    fields = json.loads(head)
    values = np.frombuffer(numbers, dtype="<f8").astype(np.float64).reshape(fields.pop("shape"))
    names, units = tuple(fields.pop("names")), tuple(fields.pop("units"))
    return Outcome(names=names, units=units, values=values, **fields)
