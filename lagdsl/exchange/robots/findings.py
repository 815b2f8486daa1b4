"""Diagnostics of the readers of robots: errors, which a lenient import turns into warnings."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.foundation.diagnostics.diagnostic import Severity
from lagdsl.foundation.source import Span

_LENIENT = "import the rest of it with `--lenient` (in Python `lenient=True`)"


class Findings:
    """Reports errors; where a lenient import has a way to go on, they are warnings that tell the way."""

    def __init__(self, sink: Sink, lenient: bool) -> None:
        self.sink = sink
        self.lenient = lenient

    def error(self, code: str, span: Span | None, *labels: Label, instead: str | None = None, **arguments: Any) -> None:
        """Report `code`. `instead` is what a lenient import writes; without it there is no way to go on."""
        own = Sink()
        own.report(code, span, *labels, **arguments)
        for diagnostic in own.diagnostics:
            if instead is None:
                self.sink.add(diagnostic)
            elif self.lenient:
                notes = (*diagnostic.notes, instead)
                self.sink.add(replace(diagnostic, severity=Severity.WARNING, notes=notes, help=None))
            else:
                ways = [*([diagnostic.help] if diagnostic.help else []), _LENIENT]
                self.sink.add(replace(diagnostic, help=", or ".join(ways)))

    def note(self, code: str, span: Span | None, **arguments: Any) -> None:
        """Report a note."""
        self.sink.report(code, span, **arguments)
