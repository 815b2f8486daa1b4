"""Programs compiled from model texts, as an engine gets them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from lagdsl.derivation.program.program import Program
from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.pipeline import compile_flat, flatten_file, read


def program_of(source: str | Path, structural: Mapping[str, float] | None = None) -> Program:
    """The program of a text or of a file that must be sound."""
    sink = Sink()
    file = read(source, sink)
    assert file is not None, sink.diagnostics
    flat = flatten_file(file, sink, structural=structural)
    assert flat is not None, sink.diagnostics
    compilation = compile_flat(flat, sink)
    assert compilation is not None, sink.diagnostics
    return compilation.program
