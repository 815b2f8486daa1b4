"""Every text in tests/corpus/reject draws the diagnostics that it announces, at the columns it announces.

`x = 3 m + 2 s;   //! E0401 7-16` expects E0401 with its caret under columns 7 to 15 of this line; several are separated
by commas. `//! 12: E0113 1-6` speaks of line 12, for faults that swallow what follows them; `7-12:5` ends on line 12,
column 5; a code alone has no place. Nothing else may be found in the text. The rendered form stands beside it in
`.txt`; LAGDSL_UPDATE=1 rewrites it.
"""

import os
import re
from pathlib import Path

import pytest
from choice import repeats

from lagdsl.foundation.diagnostics import Diagnostic
from lagdsl.foundation.diagnostics.render import render_all
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import check

CASES = sorted((Path(__file__).parents[2] / "corpus" / "reject").glob("*.lag"))

_MARKER = re.compile(r"//! *(?:(?P<line>\d+): *)?(?P<items>[A-Z]\d{4}.*)")
_ITEM = re.compile(r"(?P<code>[A-Z]\d{4})(?: (?P<start>\d+)-(?P<end>(?:\d+:)?\d+))?")


def announced(text: str) -> list[str]:
    found = []
    for number, line in enumerate(text.split("\n"), 1):
        for marker in _MARKER.finditer(line):
            at = int(marker["line"] or number)
            items = [_ITEM.fullmatch(item.strip()) for item in marker["items"].split(",")]
            assert None not in items, f"line {number}: no expectation is written like this"
            found += [_expectation(at, item) for item in items if item is not None]
    return sorted(found)


def _expectation(line: int, item: re.Match[str]) -> str:
    return (
        f"{line}: {item['code']} {item['start']}-{item['end']}" if item["start"] else f"{item['code']} without a place"
    )


def drawn(diagnostics: tuple[Diagnostic, ...]) -> list[str]:
    found = []
    for diagnostic in diagnostics:
        if not diagnostic.labels:
            found.append(f"{diagnostic.code} without a place")
            continue
        span = diagnostic.labels[0].span
        end = f"{span.last.column}" if span.last.line == span.first.line else f"{span.last.line}:{span.last.column}"
        found.append(f"{span.first.line}: {diagnostic.code} {span.first.column}-{end}")
    return sorted(found)


LONG = ("E0602_array", "E0602_guide", "E0603_loops")  # a hundred loops; many parts


@pytest.mark.parametrize(
    "path",
    [pytest.param(path, marks=[repeats("E0602")] if path.stem in LONG else [], id=path.stem) for path in CASES],
)
def test_reject(path, monkeypatch):
    monkeypatch.chdir(path.parent)  # packages lie beside the texts
    text = path.read_text(encoding="utf-8")
    diagnostics, _ = check(SourceFile(path.name, text))
    assert drawn(diagnostics) == announced(text)
    assert path.stem[:5] in {diagnostic.code for diagnostic in diagnostics}
    rendered = render_all(diagnostics)
    expectation = path.with_suffix(".txt")
    if os.environ.get("LAGDSL_UPDATE") or not expectation.exists():
        expected = expectation.read_text(encoding="utf-8") if expectation.exists() else None
        expectation.write_text(rendered, encoding="utf-8")
        assert expected is not None, f"{expectation.name} was missing and has been written: read it"
    assert rendered == expectation.read_text(encoding="utf-8")


def test_there_are_cases():
    assert len(CASES) > 40


def test_every_error_and_warning_has_a_way_out() -> None:
    """Read from the rendered forms: help comes from the catalog or from where the fault is seen."""
    lacking = []
    for path in CASES:
        for found in re.split(
            r"^(?=(?:error|warning|note)\[)", path.with_suffix(".txt").read_text("utf-8"), flags=re.MULTILINE
        ):
            if found.startswith(("error", "warning")) and "\nhelp: " not in found:
                lacking.append((path.stem, found.partition("\n")[0]))
    assert lacking == []
