"""Every text in tests/corpus/announced draws from the semantics exactly what its comments announce, at those columns.

The notation is that of tests/corpus/reject (`x = l + m;   //! E0401 7-8`); these texts hold many faults of one topic.
"""

from __future__ import annotations

import re
from pathlib import Path

from choice import together
from flattening import run

from lagdsl.foundation.diagnostics import Diagnostic

CORPUS = Path(__file__).parents[2] / "corpus" / "announced"


def announced(text: str) -> list[str]:
    found = []
    for number, line in enumerate(text.split("\n"), 1):
        _, marker, items = line.partition("//!")
        if marker:
            found += [f"{number}: {item.strip()}" for item in items.split(",")]
    return sorted(found)


def drawn(diagnostic: Diagnostic) -> str:
    if not diagnostic.labels:
        return f"1: {diagnostic.code}"
    span = diagnostic.labels[0].span
    last = "" if span.last.line == span.first.line else f"{span.last.line}:"
    return f"{span.first.line}: {diagnostic.code} {span.first.column}-{last}{span.last.column}"


@together("path", sorted(CORPUS.glob("*.lag")))
def test_announced(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    flat, sink = run(text)
    assert sorted(drawn(diagnostic) for diagnostic in sink.diagnostics) == announced(text)
    assert (flat is None) == sink.has_errors


@together("path", sorted(CORPUS.glob("*.lag")))
def test_words_are_filled_in(path: Path) -> None:
    _, sink = run(path.read_text(encoding="utf-8"))
    for diagnostic in sink.diagnostics:
        texts = [
            diagnostic.message,
            diagnostic.help or "",
            *diagnostic.notes,
            *(label.text for label in diagnostic.labels),
        ]
        assert not any(re.search(r"\bNone\b|<[a-z]|Fraction|\bobject\b", text) for text in texts), texts
