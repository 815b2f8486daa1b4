"""Source lines as a terminal shows them: printable characters, their columns, and a window of very long lines."""

from __future__ import annotations

from unicodedata import category, combining, east_asian_width

from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile

TAB = 4
WIDEST = 160  # characters of a line that are shown; what lies beyond is clipped
_BEFORE = 60  # characters kept before the marked place of a clipped line


@record()
class Piece:
    """Part of one source line: 0-based characters `start` to `end` (exclusive)."""

    line: int
    start: int
    end: int


@record()
class Excerpt:
    """A shown line. `columns[i]` is the terminal column of character `first + i`; one entry more than characters."""

    text: str
    first: int
    columns: tuple[int, ...]

    def holds(self, piece: Piece) -> bool:
        """True if the beginning of the piece is shown."""
        return self.first <= piece.start < self.first + len(self.columns)

    def marked(self, piece: Piece) -> tuple[int, int]:
        """Terminal columns (from, to) under the piece; at least one wide, clipped to what is shown."""
        last = len(self.columns) - 1
        start = self.columns[min(max(piece.start - self.first, 0), last)]
        end = self.columns[min(max(piece.end - self.first, 0), last)]
        return start, max(end, start + 1)


def printable(text: str) -> str:
    """The text with control and formatting characters written as escapes: it must not steer a terminal."""
    return "".join(_shown(character) for character in text) if not text.isprintable() else text


def _shown(character: str) -> str:
    if character.isprintable():
        return character
    code = ord(character)
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def _width(character: str) -> int:
    if character.isascii():
        return 1
    if combining(character) or category(character) in ("Mn", "Me"):
        return 0
    return 2 if east_asian_width(character) in "WF" else 1


def excerpt(file: SourceFile, number: int, near: int) -> Excerpt:
    """Line `number` (1-based) with tabs expanded; a very long one is clipped to a window around character `near`."""
    line = file.line(number)
    first, last = 0, len(line)
    if len(line) > WIDEST:
        first = max(0, min(near - _BEFORE, len(line) - WIDEST))
        last = min(len(line), first + WIDEST)
    parts = ["..."] if first else []
    columns = [len(parts) * 3]
    for character in line[first:last]:
        column = columns[-1]
        shown = " " * (TAB - column % TAB) if character == "\t" else _shown(character)
        parts.append(shown)
        columns.append(column + (_width(shown) if len(shown) == 1 else len(shown)))
    return Excerpt("".join(parts) + ("..." if last < len(line) else ""), first, tuple(columns))
