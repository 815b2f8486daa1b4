"""A place in a source text: half-open character range."""

from typing import NamedTuple

from lagdsl.foundation.record import record
from lagdsl.foundation.source.file import SourceFile


class Position(NamedTuple):
    """1-based line and column, as people and editors count."""

    line: int
    column: int


@record()
class Span:
    """Characters `start` to `end` (exclusive) of `file`."""

    file: SourceFile
    start: int
    end: int

    @property
    def first(self) -> Position:
        return _position(self.file, self.start)

    @property
    def last(self) -> Position:
        """Position one past the last character."""
        return _position(self.file, self.end)

    @property
    def text(self) -> str:
        return self.file.text[self.start : self.end]

    def to(self, other: "Span") -> "Span":
        """The span from the start of this one to the end of `other`."""
        return Span(self.file, self.start, other.end)


def _position(file: SourceFile, offset: int) -> Position:
    line = file.line_number(offset)
    return Position(line, offset - file.line_starts[line - 1] + 1)
