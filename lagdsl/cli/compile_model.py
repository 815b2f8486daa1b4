"""From FILE and `--set` to a compiled model, for the commands that compute with it."""

from __future__ import annotations

from lagdsl.cli.assignments import Settings, settings
from lagdsl.cli.model_file import Format, leave_with_errors
from lagdsl.diagnostics import CompilationFailed, Sink
from lagdsl.pipeline import Compilation, Route, compile_flat, findings, flatten_file
from lagdsl.source import SourceFile


def compile_or_leave(
    source: SourceFile,
    sink: Sink,
    style: Format,
    name: str | None,
    derivation: Route,
    pairs: dict[str, str],
) -> tuple[Compilation, Settings]:
    """The model with structural parameters as set, and what else was set; leaves where it is wrong."""
    try:
        flat = flatten_file(source, sink, model=name)
        chosen = settings(flat, pairs) if flat is not None else Settings()
        if flat is not None and chosen.structural:
            sink = Sink()
            flat = flatten_file(source, sink, model=name, structural=chosen.structural)
            chosen = settings(flat, pairs) if flat is not None else chosen
        compilation = compile_flat(flat, sink, derivation) if flat is not None else None
        if compilation is None:
            leave_with_errors(sink.diagnostics, style)
    except CompilationFailed as failure:
        leave_with_errors(findings(sink, failure), style)
    return compilation, chosen
