"""From FILE and `--set` to a compiled model, for the commands that compute with it."""

from __future__ import annotations

from lagdsl.cli.model_file import Format, leave_with_errors
from lagdsl.diagnostics import CompilationFailed, Sink
from lagdsl.flat.model import FlatModel
from lagdsl.pipeline import Compilation, Route, compile_flat, findings, flatten_file
from lagdsl.settings.settings import Settings, settings
from lagdsl.source import SourceFile


def compile_or_leave(
    source: SourceFile,
    sink: Sink,
    style: Format,
    name: str | None,
    derivation: Route,
    pairs: dict[str, str],
) -> tuple[Compilation, Settings]:
    """The model with structural parameters as set, and what else was set; leaves where it is wrong. Warnings and notes
    go to `sink`. Raises SettingError."""
    try:
        flat, chosen = _flatten(source, sink, name, pairs)
        compilation = compile_flat(flat, sink, derivation) if flat is not None else None
        if compilation is None:
            leave_with_errors(sink.diagnostics, style)
    except CompilationFailed as failure:
        leave_with_errors(findings(sink, failure), style)
    return compilation, chosen


def _flatten(
    source: SourceFile, sink: Sink, name: str | None, pairs: dict[str, str]
) -> tuple[FlatModel | None, Settings]:
    """The model says which names are structural; with other values of these it is flattened anew, and what was said of
    the first one counts no more."""
    first = Sink()
    flat = flatten_file(source, first, model=name)
    chosen = settings(flat, pairs, sink) if flat is not None else Settings()
    if flat is None or not chosen.structural:
        for diagnostic in first.diagnostics:
            sink.add(diagnostic)
        return flat, chosen
    flat = flatten_file(source, sink, model=name, structural=chosen.structural)
    return flat, settings(flat, pairs, sink) if flat is not None else chosen
