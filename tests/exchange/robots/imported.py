"""Robot files of the tests, imported."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import lagdsl
from lagdsl.foundation.diagnostics import Diagnostic, Sink

FILES = Path(__file__).parent / "files"
ARM = FILES / "arm.urdf"


def imported(path: Path, **choices: object) -> tuple[str, tuple[Diagnostic, ...]]:
    """The text of a model and what the import says."""
    sink = Sink()
    text = lagdsl.import_robot(path, sink=sink, **choices)  # type: ignore[arg-type]
    return text, sink.diagnostics


@cache
def compiled(path: Path, outputs: str = "", **choices: object) -> lagdsl.Model:
    text, _ = imported(path, **choices)
    head, _, end = text.rstrip().rpartition("\n")
    return lagdsl.compile(f"{head}\n{outputs}\n{end}\n", engine="tape")


def refusal(path: Path, text: str, **choices: object) -> list[tuple[str, int, str]]:
    """Codes, lines and words of the errors and warnings about a text."""
    path.write_text(text, encoding="utf-8")
    sink = Sink()
    try:
        lagdsl.import_robot(path, sink=sink, **choices)  # type: ignore[arg-type]
    except lagdsl.CompilationFailed:
        pass
    else:
        assert choices.get("lenient"), "nothing was refused"
    told = [each for each in sink.diagnostics if each.severity != "note"]
    return [(each.code, each.labels[0].span.first.line if each.labels else 0, each.message) for each in told]
