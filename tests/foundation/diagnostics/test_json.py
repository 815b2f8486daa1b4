"""The machine-readable form."""

import json

from lagdsl.foundation.diagnostics import Diagnostic, Label, Severity
from lagdsl.foundation.diagnostics.json import to_json
from lagdsl.foundation.source import SourceFile, Span


def test_all_fields():
    file = SourceFile("a.lag", "one\ntwo three\n")
    diagnostic = Diagnostic(
        code="W0999",
        severity=Severity.WARNING,
        message="m",
        labels=(Label(Span(file, 4, 7), "p"), Label(Span(file, 0, 13), "")),
        notes=("n",),
        help="h",
    )
    place = {"file": "a.lag", "line": 2, "column": 1, "end_line": 2, "end_column": 4}
    other = {"file": "a.lag", "line": 1, "column": 1, "end_line": 2, "end_column": 10}
    assert json.loads(to_json([diagnostic])) == [
        {
            "code": "W0999",
            "severity": "warning",
            "message": "m",
            **place,
            "labels": [{**place, "text": "p"}, {**other, "text": ""}],
            "notes": ["n"],
            "help": "h",
        }
    ]


def test_without_a_place_and_empty():
    (item,) = json.loads(to_json([Diagnostic(code="E0999", severity=Severity.ERROR, message="m")]))
    assert item["file"] is None and item["line"] is None and item["labels"] == []
    assert json.loads(to_json([])) == []
