"""From a path or a text to a Model."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from lagdsl.api.model import Model
from lagdsl.diagnostics import Sink
from lagdsl.pipeline import Derivation, EngineName, engine_of, front, middle, read


def compile(
    source: Path | str,
    *,
    model: str | None = None,
    engine: EngineName = "numpy",
    derivation: Derivation = "graph",
    structural: Mapping[str, float] | None = None,
) -> Model:
    """The model in `source`: a path, or a text (a string with a line end or a semicolon).

    `model` names one of several; the default is the last complete one that no other uses. `structural` replaces
    structural parameters. Raises CompilationFailed with everything that was found wrong.
    """
    sink = Sink()
    file = read(source, sink)
    flat = front(file, sink, model=model, structural=structural) if file is not None else None
    compilation = middle(flat, sink, derivation) if flat is not None else None
    sink.raise_if_errors()
    assert compilation is not None, "internal error: a stage gave up without saying why"
    return Model(compilation, engine_of(compilation.program, engine), file)
