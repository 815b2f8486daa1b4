"""The way out of a reader: a file that cannot be imported, with the place and the words of the catalog."""

from __future__ import annotations

from typing import Any

from lagdsl.foundation.source import SourceFile, Span


class Refused(Exception):  # noqa: N818 it leaves the readers, and `body_text` alone sees it
    """Diagnostic `code` at `span`, with the arguments of its words."""

    def __init__(self, code: str, span: Span | None, help: str | None = None, **arguments: Any) -> None:
        super().__init__(code)
        self.code = code
        self.span = span
        self.help = help
        self.arguments = arguments


def line_span(file: SourceFile, number: int) -> Span:
    """The 1-based line without the blanks around it."""
    text = file.line(number)
    start = file.line_starts[number - 1] + len(text) - len(text.lstrip())
    return Span(file, start, max(start + len(text.strip()), start))


def end_span(file: SourceFile) -> Span:
    """The last line that has a character."""
    number = file.line_number(len(file.text.rstrip()))
    return line_span(file, number)
