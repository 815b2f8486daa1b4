"""A text with a name and an index of its lines."""

from bisect import bisect_right
from dataclasses import field
from pathlib import Path

from lagdsl.foundation.record import record


@record()
class SourceFile:
    """One `.lag` text. Line ends are `\\n`; the reader has normalised them before.

    Two files are the same only if they are the same object: spans compare cheaply.
    """

    name: str
    text: str
    line_starts: tuple[int, ...] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        starts = [0]
        starts += [index + 1 for index, character in enumerate(self.text) if character == "\n"]
        object.__setattr__(self, "line_starts", tuple(starts))

    def __eq__(self, other: object) -> bool:
        return self is other

    def __hash__(self) -> int:
        return id(self)

    @property
    def folder(self) -> Path:
        """The folder of the file; that of the process for a text without a file."""
        return Path(self.name).parent

    def line_number(self, offset: int) -> int:
        """1-based number of the line that holds the character at `offset`."""
        return bisect_right(self.line_starts, offset)

    def line(self, number: int) -> str:
        """Text of the 1-based line, without its line end."""
        start = self.line_starts[number - 1]
        end = self.text.find("\n", start)
        return self.text[start:] if end < 0 else self.text[start:end]
