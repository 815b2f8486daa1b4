"""Standard deviations of what was measured: those that are given, and those that residuals show."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.suggest import listing
from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.units.dimension import TIME
from lagdsl.foundation.units.parse import parse_unit
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.literal import literal, require_dimension
from lagdsl.motion.fit.data import Series, events_of
from lagdsl.motion.fit.problem import Problem
from lagdsl.motion.fit.statistics import deviation_of
from lagdsl.motion.simulate.table import called_heads


def sigmas_of(
    flat: FlatModel, given: Mapping[str, float | str], series: Sequence[Series], sink: Sink
) -> dict[str, float]:
    """By the names of series: what the text states, and what is `given` instead. E1109 for what no data have; raises
    as `sigma_in_si`."""
    found = {each.of: each.sigma for each in flat.measurements if each.sigma is not None}
    names = {each.name for each in series}
    for name, value in given.items():
        found[name] = sigma_in_si(flat, name, value)
        if name not in names:
            sink.report("E1109", None, name=name, known=listing(name, sorted(names)))
    return found


def sigma_in_si(flat: FlatModel, name: str, value: float | str) -> float:
    """A standard deviation of a column, or of the times of an event. Raises ValueError for what is none,
    UnknownName."""
    heads = called_heads(flat)
    events = events_of(flat)
    if name not in heads and name not in events:
        raise unknown_among("column or contact", name, [*heads, *events])
    unit = heads[name][1] if name in heads else "s"
    if isinstance(value, str):
        given = literal(f"sigma of {name}", value)
        if given.dimension is None and unit != "1":
            shown = heads[name][3].unit if name in heads else unit
            raise ValueError(f"sigma of `{name}`: write it with a unit, as in `{value.strip()} {shown}`")
        require_dimension(f"sigma of {name}", given, parse_unit(unit).dimension if name in heads else TIME, unit)
        value = given.value
    if not (np.isfinite(value) and value > 0.0):
        raise ValueError(f"the standard deviation of `{name}` must be positive, not {value:g}")
    return float(value)


def first_sigmas(
    problem: Problem, given: Mapping[str, float], values: Floats | None = None, robust: bool = False
) -> dict[str, float]:
    """By the names of series: `given` ones; else, where `values` (n,) are computed, what their residuals show, else the
    spread of the data."""
    data = problem.measured if values is None else values - problem.measured
    parts: dict[str, list[Floats]] = {}
    first = 0
    for series in problem.all_series:
        part = data[first : first + len(series.values)]
        if values is None:
            part = np.diff(part) if series.event else part - np.mean(part)
        parts.setdefault(series.name, []).append(part)
        first += len(series.values)
    found = {}
    for name, each in parts.items():
        whole = np.concatenate(each)
        deviation = deviation_of(whole, robust and values is not None) if len(whole) else 0.0
        found[name] = given.get(name, max(deviation, np.finfo(float).eps * _size(problem, name)))
    return found


def _size(problem: Problem, name: str) -> float:
    return max(float(np.max(np.abs(s.values), initial=0.0)) for s in problem.all_series if s.name == name) or 1.0


def with_sigmas(problem: Problem, sigmas: Mapping[str, float]) -> Problem:
    """The problem with these standard deviations."""
    each = [np.full(len(series.values), sigmas[series.name]) for series in problem.all_series]
    return replace(problem, sigmas=np.concatenate(each))
