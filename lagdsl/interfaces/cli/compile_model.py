"""From FILE and `--set` to a compiled model, for the commands that compute with it."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.interfaces.cli.model_file import ModelFile, leave_with_errors
from lagdsl.interfaces.cli.progress import progress
from lagdsl.language.settings.settings import Settings, settings
from lagdsl.motion.pipeline import Compilation, Route, compile_flat, findings, flatten_for_runs


def compile_or_leave(
    model_file: ModelFile, source: SourceFile, sink: Sink, pairs: dict[str, str], derivation: Route = "graph"
) -> tuple[Compilation, Settings]:
    """The model with structural parameters as set, and what else was set; leaves where it is wrong. Warnings and notes
    go to `sink`. Raises SettingError."""
    try:
        with progress("compile"):
            flat = flatten_for_runs(source, sink, model=model_file.model, pairs=pairs)
            chosen = settings(flat, pairs, sink) if flat is not None else Settings()
            compilation = compile_flat(flat, sink, derivation) if flat is not None else None
    except CompilationFailed as failure:
        leave_with_errors(findings(sink, failure), model_file.style)
    if compilation is None:
        leave_with_errors(sink.diagnostics, model_file.style)
    return compilation, chosen
