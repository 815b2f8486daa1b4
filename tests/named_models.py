"""Models compiled with everything that has a name, as they are exported."""

from __future__ import annotations

from pathlib import Path

from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.pipeline import Compilation, compile_flat, flatten_file, read


def compiled(source: str | Path) -> Compilation:
    """Of a text or a file that must be sound."""
    sink = Sink()
    file = read(source, sink)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None, sink.diagnostics
    compilation = compile_flat(flat, sink)
    assert compilation is not None, sink.diagnostics
    return compilation
