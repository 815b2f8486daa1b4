"""Formatting, as `lag fmt` does it."""

from __future__ import annotations

from lsprotocol import types as lsp

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import Span
from lagdsl.interfaces.lsp.positions import range_of
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.syntax.printer import format_text


def formatting(snapshot: Snapshot) -> list[lsp.TextEdit]:
    """The change from the first to the last line that differs; none for a text with errors."""
    text = snapshot.text
    wanted = format_text(snapshot.file, Sink())
    if wanted is None or wanted == text:
        return []
    old, new = text.splitlines(keepends=True), wanted.splitlines(keepends=True)
    first = next((k for k, (a, b) in enumerate(zip(old, new, strict=False)) if a != b), min(len(old), len(new)))
    rest = min(len(old), len(new)) - first
    tail = next((k for k in range(rest) if old[-1 - k] != new[-1 - k]), rest)
    start = sum(map(len, old[:first]))
    end = len(text) - sum(map(len, old[len(old) - tail :]))
    return [lsp.TextEdit(range_of(Span(snapshot.file, start, end)), "".join(new[first : len(new) - tail]))]
