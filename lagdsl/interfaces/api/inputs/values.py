"""Inputs as they are given in Python: signals by name, or a table in a file."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.api.names import quantity
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.target import targets

if TYPE_CHECKING:
    from lagdsl.motion.signals.inputs import Signal


def signals_of(flat: FlatModel, inputs: Mapping[str, Signal | str] | Path | str | None) -> dict[str, Signal]:
    """The inputs by name; those of a file are read, texts such as `2 N` are constants. Raises CompilationFailed where a
    file cannot be read, ValueError for a text that is no value of its input."""
    if inputs is None:
        return {}
    if not isinstance(inputs, (Path, str)):
        return {name: _signal(flat, name, signal) for name, signal in inputs.items()}
    return signals_of_file(flat, Path(inputs))


def signals_of_file(flat: FlatModel, path: Path) -> dict[str, Signal]:
    """The tables of a file by name. Raises CompilationFailed where it cannot be read."""
    from lagdsl.motion.signals.table_io import in_si, read_inputs

    sink = Sink()
    tables = read_inputs(path, sink)
    found = in_si(tables or {}, flat, sink)
    sink.raise_if_errors()
    return found


def inputs_at(flat: FlatModel, inputs: Mapping[str, Signal | str] | Path | str | None, t: float) -> dict[str, float]:
    """The values at time t of the inputs that are given as for a simulation. Raises CompilationFailed for unknown names
    and tables that do not reach t."""
    from lagdsl.motion.signals.inputs import given_inputs, signals

    sink = Sink()
    given = signals_of(flat, inputs)
    found = signals(flat, np.zeros(len(flat.inputs)), given, (t, t), sink)
    sink.raise_if_errors()
    told = zip(flat.inputs, found.at(t).tolist(), given_inputs(flat, given), strict=True)
    return {item.name: value for item, value, flag in told if flag}


def _signal(flat: FlatModel, name: str, signal: Signal | str) -> Signal:
    if not isinstance(signal, str):
        return signal
    known = targets(flat, ("input",))
    return quantity(known[name], signal) if name in known else 0.0  # unknown names are told with all others
