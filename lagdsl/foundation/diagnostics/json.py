"""Diagnostics for machines: the array that `--format json` prints."""

from __future__ import annotations

import json
from collections.abc import Iterable

from lagdsl.foundation.diagnostics.diagnostic import Diagnostic
from lagdsl.foundation.source import Span


def to_json(diagnostics: Iterable[Diagnostic]) -> str:
    """An array of objects `{code, severity, message, file, line, column, end_line, end_column, labels, notes, help}`.

    Lines and columns are 1-based, ends are exclusive; without a place they and `file` are null. `labels` holds every
    place with its text, the primary one first.
    """
    return json.dumps([_object(diagnostic) for diagnostic in diagnostics], indent=2)


def _object(diagnostic: Diagnostic) -> dict[str, object]:
    return {
        "code": diagnostic.code,
        "severity": str(diagnostic.severity),
        "message": diagnostic.message,
        **_place(diagnostic.labels[0].span if diagnostic.labels else None),
        "labels": [{**_place(label.span), "text": label.text} for label in diagnostic.labels],
        "notes": list(diagnostic.notes),
        "help": diagnostic.help,
    }


def _place(span: Span | None) -> dict[str, object]:
    if span is None:
        return dict.fromkeys(("file", "line", "column", "end_line", "end_column"))
    return {
        "file": span.file.name,
        "line": span.first.line,
        "column": span.first.column,
        "end_line": span.last.line,
        "end_column": span.last.column,
    }
