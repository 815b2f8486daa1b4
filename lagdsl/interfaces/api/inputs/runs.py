"""Inputs of many runs: those that all share, and those that each run has of its own."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.foundation.record import record
from lagdsl.interfaces.api.inputs.values import signals_of
from lagdsl.interfaces.api.names import number
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.target import Target, targets
from lagdsl.motion.signals.hold import Hold
from lagdsl.motion.signals.inputs import KINDS, Signal

# One signal for all runs, or a sequence with one for each.
_OfRuns: TypeAlias = "Signal | str | Sequence[Signal | str] | ArrayLike"
# All inputs by name, in one mapping or in one file; or a sequence of these, one for each run.
GivenOfRuns: TypeAlias = (
    "Mapping[str, _OfRuns] | Path | str | Sequence[Mapping[str, Signal | str]] | Sequence[Path | str] | None"
)


@record()
class InputsOfRuns:
    """Signals by name: `shared` by all runs; entry k of those in `own` belongs to run k."""

    shared: dict[str, Signal] = field(default_factory=dict)
    own: dict[str, list[Signal]] = field(default_factory=dict)

    @property
    def calls_python(self) -> bool:
        """True if an input of a single run is a function of Python."""
        return any(callable(signal) for signals in self.own.values() for signal in signals)


def inputs_of_runs(flat: FlatModel, inputs: GivenOfRuns) -> InputsOfRuns:
    """Raises UnknownName for a name that is no input, ValueError for what is no signal and for runs that do not give
    the same inputs, CompilationFailed where a file cannot be read."""
    known = targets(flat, ("input",))
    if inputs is None or isinstance(inputs, (Path, str)):
        return InputsOfRuns(known_inputs(known, signals_of(flat, inputs)))
    if isinstance(inputs, Mapping):
        known_inputs(known, inputs)
        runs = {name: signals_of_runs(known[name], given) for name, given in inputs.items()}
        own = {name: signals for name, signals in runs.items() if signals is not None}
        alone: dict[str, Any] = {name: given for name, given in inputs.items() if name not in own}
        return InputsOfRuns(signals_of(flat, alone), own)
    return InputsOfRuns({}, _by_name([known_inputs(known, signals_of(flat, each)) for each in inputs]))


def signals_of_runs(target: Target, given: Any) -> list[Signal] | None:
    """The signal of each run, numbers in SI units; None for one signal of all runs. A pair of columns of numbers is one
    table. Raises ValueError for an entry that is no signal."""
    if isinstance(given, (str, Hold)) or not isinstance(given, Iterable) or getattr(given, "shape", None) == ():
        return None
    entries = list(given)
    if _is_table(entries):
        return None
    return [_signal(target, k, entry) for k, entry in enumerate(entries)]


def _signal(target: Target, run: int, entry: Any) -> Signal:
    if isinstance(entry, Hold) or callable(entry):
        signal: Signal = entry
        return signal
    if np.isscalar(entry) or getattr(entry, "shape", None) == ():
        return number(target, entry)
    columns = list(entry) if isinstance(entry, Iterable) else []
    if not _is_table(columns):
        raise ValueError(f"entry {run} of input `{target.name}` must be {KINDS}")
    return columns[0], columns[1]


def _is_table(entries: list[Any]) -> bool:
    return len(entries) == 2 and all(_is_column(each) for each in entries)


def _is_column(given: Any) -> bool:
    if hasattr(given, "ndim"):
        return bool(given.ndim == 1)
    return isinstance(given, (list, tuple)) and all(isinstance(each, (int, float)) for each in given)


def known_inputs(known: Mapping[str, Target], given: Mapping[str, Any]) -> Any:
    """`given`, each of whose names is that of an input. Raises UnknownName."""
    for name in given:
        if name not in known:
            raise unknown_among("input", name, list(known))
    return given


def _by_name(runs: list[dict[str, Signal]]) -> dict[str, list[Signal]]:
    """Signals of every run by name, from the inputs of every run. Raises ValueError."""
    if not runs:
        raise ValueError("`inputs` is empty: give the inputs of one run at least")
    names = list(runs[0])
    for k, each in enumerate(runs):
        if set(each) != set(names):
            other = next(name for name in (*names, *each) if (name in each) != (name in names))
            lacking = 0 if other in each else k
            raise ValueError(f"all runs must give the same inputs: `{other}` is missing in run {lacking}")
    return {name: [each[name] for each in runs] for name in names}
