"""Places as editors count them: lines from 0, columns in units of UTF-16."""

from __future__ import annotations

from pathlib import Path

from lsprotocol import types as lsp
from pygls import uris

from lagdsl.foundation.resources import library_folder
from lagdsl.foundation.source import SourceFile, Span


def position_at(file: SourceFile, offset: int) -> lsp.Position:
    """The position of the character at `offset`; offsets beyond the text are its end."""
    offset = min(max(offset, 0), len(file.text))
    line = file.line_number(offset)
    before = file.text[file.line_starts[line - 1] : offset]
    return lsp.Position(line - 1, len(before) if before.isascii() else len(before.encode("utf-16-le")) // 2)


def offset_at(file: SourceFile, position: lsp.Position) -> int:
    """The offset of a position; one beyond the end of a line is that end."""
    if position.line >= len(file.line_starts):
        return len(file.text)
    start, line = file.line_starts[position.line], file.line(position.line + 1)
    if line.isascii():
        return start + min(position.character, len(line))
    units = line.encode("utf-16-le")[: 2 * position.character]
    return start + len(units.decode("utf-16-le", errors="ignore"))


def range_of(span: Span) -> lsp.Range:
    return lsp.Range(position_at(span.file, span.start), position_at(span.file, span.end))


def location_of(span: Span) -> lsp.Location:
    return lsp.Location(uri_of(span.file), range_of(span))


def uri_of(file: SourceFile) -> str:
    """The address of a text: that of its file, which for the library lies beside the compiler; else its own name."""
    if file.name.startswith("<"):
        return f"untitled:{file.name.strip('<>')}"
    path = Path(file.name)
    if not path.is_absolute():
        own = library_folder() / path
        path = own if own.is_file() else path.resolve()
    return uris.from_fs_path(str(path)) or path.as_uri()


def name_of_uri(uri: str) -> str:
    """The name of the text at an address: its path, or a name that is no file's."""
    path = uris.to_fs_path(uri) if uri.startswith("file:") else None
    return path or f"<{uri}>"
