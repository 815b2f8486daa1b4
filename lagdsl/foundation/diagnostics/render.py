"""Diagnostics as text: header, place, source excerpt with carets, notes, help."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import groupby

from lagdsl.foundation.diagnostics.diagnostic import Diagnostic, Label, Severity
from lagdsl.foundation.diagnostics.excerpt import Excerpt, Piece, excerpt, printable
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile

_COLORS = {Severity.ERROR: "1;31", Severity.WARNING: "1;33", Severity.NOTE: "1;36"}
_BLUE = "1;34"
_BOLD = "1"


def render_all(diagnostics: Iterable[Diagnostic], color: bool = False) -> str:
    """All diagnostics in their order, a blank line between them; empty text for none.

    `color` adds ANSI colors; deciding whether the reader is a terminal is for the caller.
    """
    return "\n".join(render(diagnostic, color) for diagnostic in diagnostics)


def render(diagnostic: Diagnostic, color: bool = False) -> str:
    """One diagnostic, ending in a newline."""
    return "".join(f"{line}\n" for line in _Painter(diagnostic.severity, color).diagnostic(diagnostic))


@record()
class _Mark:
    """Marks under one line: a piece of a label, the label's text on its last line only."""

    piece: Piece
    text: str
    primary: bool
    joins: bool  # the label began on an earlier line


@record()
class _Painter:
    severity: Severity
    color: bool

    def diagnostic(self, diagnostic: Diagnostic) -> list[str]:
        name = self._paint(f"{diagnostic.severity}[{diagnostic.code}]", _COLORS[self.severity])
        lines = [f"{name}{self._paint(': ' + printable(diagnostic.message), _BOLD)}"]
        files = list(dict.fromkeys(label.span.file for label in diagnostic.labels))
        width = max((len(str(_last_line(label))) for label in diagnostic.labels), default=1)
        for index, file in enumerate(files):
            labels = [label for label in diagnostic.labels if label.span.file is file]
            primary = diagnostic.labels[0] if index == 0 else None
            lines += self._file(labels, primary, width)
        for text in diagnostic.notes:
            lines += self._remark("note", text)
        if diagnostic.help is not None:
            lines += self._remark("help", diagnostic.help)
        return lines

    def _file(self, labels: list[Label], primary: Label | None, width: int) -> list[str]:
        place = labels[0].span
        line, column = place.file.line_number(_clamped(place.file, place.start)), _column(place.file, place.start)
        arrow = "-->" if primary is not None else ":::"
        lines = [
            f"{' ' * width}{self._paint(arrow, _BLUE)} {printable(place.file.name)}:{line}:{column}",
            self._gutter("", width),
        ]
        marks = [mark for label in labels for mark in _marks(label, label is primary)]
        marks.sort(key=lambda mark: mark.piece.line)
        before = 0
        for number, group in groupby(marks, key=lambda mark: mark.piece.line):
            on_line = list(group)
            if before and number > before + 1 and any(mark.joins for mark in on_line):
                lines.append(self._paint("...", _BLUE))
            lines += self._line(place.file, number, on_line, width)
            before = number
        return lines

    def _line(self, file: SourceFile, number: int, marks: list[_Mark], width: int) -> list[str]:
        """One source line and the marks under it; of a clipped line as many windows as the marks need."""
        lines: list[str] = []
        rest = sorted(marks, key=lambda mark: not mark.primary)
        while rest:
            shown = excerpt(file, number, rest[0].piece.start)
            fitting = [mark for mark in rest if shown.holds(mark.piece)]
            rest = [mark for mark in rest if not shown.holds(mark.piece)]
            lines.append(f"{self._gutter(str(number), width)} {shown.text}".rstrip())
            for layer in _layers(fitting):
                lines += [f"{self._gutter('', width)} {row}" for row in self._rows(layer, shown)]
        return lines

    def _rows(self, layer: list[_Mark], shown: Excerpt) -> list[str]:
        """The row of carets with the text of the rightmost mark, then the other texts from right to left."""
        row, at = "", 0
        for mark in layer:
            start, end = shown.marked(mark.piece)
            row += " " * (start - at) + self._marked(mark, ("^" if mark.primary else "-") * (end - start))
            at = end
        *others, last = layer
        rows = [f"{row} {self._marked(last, printable(last.text))}" if last.text else row]
        for mark in reversed(others):
            if mark.text:
                rows.append(" " * shown.marked(mark.piece)[0] + self._marked(mark, printable(mark.text)))
        return rows

    def _remark(self, kind: str, text: str) -> list[str]:
        first, *more = text.split("\n")
        head = f"{self._paint(kind + ':', _BOLD)} {printable(first)}"
        return [head, *(" " * (len(kind) + 2) + printable(line) for line in more)]

    def _gutter(self, number: str, width: int) -> str:
        return self._paint(f"{number:>{width}} |", _BLUE)

    def _marked(self, mark: _Mark, text: str) -> str:
        return self._paint(text, _COLORS[self.severity] if mark.primary else _BLUE)

    def _paint(self, text: str, style: str) -> str:
        return f"\x1b[{style}m{text}\x1b[0m" if self.color else text


def _layers(marks: list[_Mark]) -> list[list[_Mark]]:
    """Marks that can share a row, each row from left to right; the primary one comes in the first row."""
    layers: list[list[_Mark]] = []
    for mark in marks:
        for layer in layers:
            if all(mark.piece.end < other.piece.start or other.piece.end < mark.piece.start for other in layer):
                layer.append(mark)
                break
        else:
            layers.append([mark])
    return [sorted(layer, key=lambda mark: mark.piece.start) for layer in layers]


def _marks(label: Label, primary: bool) -> list[_Mark]:
    """A label on one line, or on the first and the last of its lines."""
    file = label.span.file
    start = _clamped(file, label.span.start)
    end = max(start, _clamped(file, label.span.end))
    if end > start and file.text[end - 1] == "\n":
        end -= 1
    first, last = file.line_number(start), file.line_number(end)
    begin = start - file.line_starts[first - 1]
    stop = end - file.line_starts[last - 1]
    if first == last:
        return [_Mark(Piece(first, begin, stop), label.text, primary, False)]
    indent = len(file.line(last)) - len(file.line(last).lstrip())
    return [
        _Mark(Piece(first, begin, len(file.line(first))), "", primary, False),
        _Mark(Piece(last, min(indent, stop), stop), label.text, primary, True),
    ]


def _last_line(label: Label) -> int:
    return max(mark.piece.line for mark in _marks(label, False))


def _clamped(file: SourceFile, offset: int) -> int:
    return min(max(offset, 0), len(file.text))


def _column(file: SourceFile, offset: int) -> int:
    clamped = _clamped(file, offset)
    return clamped - file.line_starts[file.line_number(clamped) - 1] + 1
