"""Everything that can be said of a model before the first time step."""

from __future__ import annotations

from pathlib import Path

from lagdsl.foundation.diagnostics import Diagnostic, Sink
from lagdsl.motion import pipeline


def check(source: Path | str, *, model: str | None = None) -> list[Diagnostic]:
    """All diagnostics of the model in `source`, a path or a text; a bad model raises nothing."""
    sink = Sink()
    file = pipeline.read(source, sink)
    if file is None:
        return list(sink.diagnostics)
    diagnostics, _ = pipeline.check(file, model=model)
    return list(diagnostics)
