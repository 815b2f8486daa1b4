"""Reads model texts from files."""

from __future__ import annotations

from pathlib import Path

from lagdsl.diagnostics import Sink
from lagdsl.source import SourceFile
from lagdsl.syntax.limits import MAX_CHARACTERS

_MAX_BYTES = 4 * MAX_CHARACTERS  # a character of UTF-8 takes at most four


def read_source(path: Path, sink: Sink) -> SourceFile | None:
    """The text of a file, its line ends normalised to `\\n` and a byte order mark removed.

    What keeps a file from being a model text is reported to `sink`, and None returned: a name that is none, a
    directory, no permission, too large (no more than the limit is read), not UTF-8, the character NUL.
    """
    name = str(path)
    content = _content(path, name, sink)
    if content is None:
        return None
    if len(content) > _MAX_BYTES:
        sink.report("E0130", None, name=name, limit=MAX_CHARACTERS)
        return None
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError as fault:
        sink.report("E0131", None, name=name, position=fault.start)
        return None
    if "\0" in text:
        sink.report("E0136", None, name=name, position=text.index("\0"))
        return None
    return SourceFile(name, text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n"))


def _content(path: Path, name: str, sink: Sink) -> bytes | None:
    """At most one byte more than the limit, so that a device without end is no danger."""
    try:
        if path.is_dir():
            sink.report("E0132", None, name=name)
            return None
        with path.open("rb") as file:
            return file.read(_MAX_BYTES + 1)
    except FileNotFoundError:
        sink.report("E0133", None, name=name)
    except (OSError, ValueError) as fault:  # ValueError: a name that no file can have
        reason = fault.strerror if isinstance(fault, OSError) and fault.strerror else str(fault)
        sink.report("E0134", None, name=name, reason=reason)
    return None
