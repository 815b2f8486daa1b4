"""Inputs as they are given in Python: signals by name, or a table in a file."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from lagdsl.diagnostics import Sink

if TYPE_CHECKING:
    from lagdsl.signals.inputs import Signal


def signals_of(inputs: Mapping[str, Signal] | Path | str | None) -> Mapping[str, Signal] | None:
    """The inputs by name; those of a file are read. Raises CompilationFailed where that cannot be done."""
    if not isinstance(inputs, (Path, str)):
        return inputs
    from lagdsl.signals.table_io import read_inputs

    sink = Sink()
    tables = read_inputs(Path(inputs), sink)
    sink.raise_if_errors()
    return tables
