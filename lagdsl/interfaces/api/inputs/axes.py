"""Inputs that differ between the runs of a sweep, as its axes."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record
from lagdsl.interfaces.api.inputs.runs import GivenOfRuns, inputs_of_runs, known_inputs, signals_of_runs
from lagdsl.interfaces.api.inputs.values import signals_of
from lagdsl.interfaces.api.names import number
from lagdsl.interfaces.api.texts import require_units
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.target import Target, targets
from lagdsl.motion.signals.inputs import Signal
from lagdsl.motion.sweep.plan import Axis
from lagdsl.motion.sweep.values import axis, axis_of, axis_of_tables, labels_of


@record()
class SweptInputs:
    """Signals that all runs share by name; axes with one number, and axes with many numbers or signals."""

    shared: dict[str, Signal]
    fixed: list[Axis]
    many: list[Axis]


def input_axes(flat: FlatModel, inputs: GivenOfRuns) -> SweptInputs:
    """An axis for each input that differs, or `input` for a sequence of files or mappings. Raises as `inputs_of_runs`,
    and SettingError for a text that is no value, range or list."""
    if isinstance(inputs, Mapping):
        return _by_name(flat, inputs)
    found = inputs_of_runs(flat, inputs)
    if isinstance(inputs, (Path, str)) or inputs is None:
        return SweptInputs(found.shared, [], [])
    count = len(next(iter(found.own.values())))
    runs = [{name: signals[k] for name, signals in found.own.items()} for k in range(count)]
    paths = [Path(each) for each in inputs if isinstance(each, (str, Path))]
    labels = labels_of(paths) if len(paths) == count else tuple(f"entry {k}" for k in range(count))
    return SweptInputs(found.shared, [], [axis_of_tables("input", labels, runs)])


def _by_name(flat: FlatModel, inputs: Mapping[str, Any]) -> SweptInputs:
    known, sink = targets(flat, ("input",)), Sink()
    known_inputs(known, inputs)
    shared: dict[str, Any] = {}
    found: list[Axis] = []
    for name, given in inputs.items():
        target = known[name]
        if isinstance(given, str):
            found.append(axis_of(target, given, sink))
        elif isinstance(given, (int, float)):
            found.append(axis(target, (number(target, given),)))
        elif (signals := signals_of_runs(target, given)) is None:
            shared[name] = given
        else:
            found.append(_axis(target, signals))
    require_units(sink)
    alone = [name for name, given in inputs.items() if isinstance(given, (str, int, float))]
    fixed = [each for each in found if len(each.values) == 1 and each.name in alone]
    return SweptInputs(signals_of(flat, shared), fixed, [each for each in found if each not in fixed])


def _axis(target: Target, signals: list[Signal]) -> Axis:
    values = tuple(signal for signal in signals if isinstance(signal, float))
    if len(values) == len(signals):
        return axis(target, values)
    labels = tuple(f"entry {k}" for k in range(len(signals)))
    return axis_of_tables(target.name, labels, [{target.key: signal} for signal in signals])
