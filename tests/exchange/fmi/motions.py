"""The motion of an exported model: that of `lag run --engine c`, and the distance of another one from it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from models.corpus import compiled, expectations, path_of

import lagdsl

TOLERANCE = 1e-8
SAME = 1e-6  # of the range of a signal
SAME_NEAR_EVENTS = 1e-4
PREDICTABLE = 1e-7  # agreement of the same engine with itself at a tenth of the tolerance
ROWS = 500
# Of the span: closer to an event than this a row may be before or after it, and closer than that it is beside it: the
# indicators of importers change their sign a little late, by a margin against round-off.
SAME_INSTANT, BESIDE = 1e-6, 4e-4
Floats = np.ndarray


@cache
def model(name: str) -> lagdsl.Model:
    return lagdsl.compile(path_of(name), engine="tape")


def span(name: str) -> tuple[float, float, float]:
    """Start, stop and distance of rows of the experiment."""
    experiment = compiled(name).flat.experiment
    start, stop = experiment.start_time, expectations(name).get("until", experiment.stop_time)
    return start, stop, (stop - start) / ROWS


@cache
def motion(name: str, tolerance: float = TOLERANCE) -> lagdsl.Trajectory:
    """Without columns of protected variables, which an FMU does not show."""
    _, stop, interval = span(name)
    found = model(name).simulate(stop=stop, interval=interval, tolerance=tolerance)
    flat = compiled(name).flat
    hidden = {item.name for item in (*flat.outputs, *flat.events.discretes) if item.protected}
    return found.only([name for name in found.names if name not in hidden])


def signals(reference: lagdsl.Trajectory) -> tuple[str, ...]:
    """Every coordinate, rate, state, discrete variable and output."""
    return reference.names[1:]


@dataclass(frozen=True)
class Deviation:
    """Of rows from a reference, in ranges of the signals: the largest of each row, and which signal that is."""

    time: Floats
    error: Floats
    near: Floats  # bool: rows beside an event
    worst: tuple[str, ...]

    def exceeding(self, far: float, near: float) -> Floats:
        """Indices of rows; a number that is none exceeds everything."""
        return np.flatnonzero(~(self.error <= np.where(self.near, near, far)))

    def first(self, far: float, near: float) -> str:
        rows = self.exceeding(far, near)
        if not len(rows):
            return ""
        row = rows[np.argmax(self.error[rows])]
        return (
            f"{len(rows)} of {len(self.time)} rows; first at {self.time[rows[0]]:.9g} s ({self.worst[rows[0]]}, "
            f"{self.error[rows[0]]:.2g}), worst at {self.time[row]:.9g} s ({self.worst[row]}, {self.error[row]:.2g})"
        )


def deviation(
    reference: lagdsl.Trajectory, time: Floats, columns: Mapping[str, Floats], names: tuple[str, ...] = ()
) -> Deviation:
    """At the times of the reference, of all signals or those named; where an event is, anything between the values
    before and after it will do."""
    names = names or signals(reference)
    missing = [name for name in names if name not in columns]
    assert not missing, missing
    expected = np.stack([reference[name] for name in names], axis=-1).astype(float)
    found = np.stack([np.asarray(columns[name], dtype=float) for name in names], axis=-1)
    scale = scales(reference)[[signals(reference).index(name) for name in names]]
    length = reference.time[-1] - reference.time[0]
    margin = SAME_INSTANT * length
    events = np.array([event.time for event in reference.events])
    rows, errors, near, worst = [], [], [], []
    for row, t in enumerate(time):
        low, high = np.searchsorted(reference.time, [t - margin, t + margin])
        if low == high:
            continue
        around = expected[low:high]
        outside = np.maximum(around.min(axis=0) - found[row], found[row] - around.max(axis=0))
        error = np.where(np.isfinite(found[row]), np.maximum(outside, 0.0), np.inf) / scale
        both_undefined = np.isnan(found[row]) & np.isnan(around).any(axis=0)
        error = np.where(both_undefined, 0.0, error)
        rows.append(t)
        errors.append(np.max(error))
        near.append(high - low > 1 or bool(np.any(np.abs(events - t) <= BESIDE * length)))
        worst.append(names[int(np.argmax(error))])
    return Deviation(np.array(rows), np.array(errors), np.array(near, dtype=bool), tuple(worst))


def scales(reference: lagdsl.Trajectory) -> Floats:
    """Ranges of the signals; at least a thousandth of the largest value of the same kind and unit, of rates at least
    of that of their coordinate over the time of the experiment: what rests but for rounding has no range. A signal that
    keeps its value, as an energy may, has its value for a range."""
    largest: dict[tuple[str, str], float] = {}
    sizes = {column.name: _size(column.values) for column in reference.columns}
    for column in reference.columns[1:]:
        key = (column.kind, column.unit)
        largest[key] = max(largest.get(key, 0.0), sizes[column.name])
    found = []
    for column in reference.columns[1:]:
        known = column.values[np.isfinite(column.values)]
        coordinate = sizes.get(column.name.removeprefix("der(")[:-1], 0.0) if column.kind == "rate" else 0.0
        span = float(reference.time[-1] - reference.time[0])
        floor = 1e-3 * max(largest[column.kind, column.unit], coordinate / span)
        spread = float(np.ptp(known)) if len(known) else 0.0
        conserved = sizes[column.name] if spread <= 1e-6 * sizes[column.name] else 0.0
        found.append(max(spread, conserved, floor, 1e-9))
    return np.array(found)


def _size(values: Floats) -> float:
    return float(np.max(np.abs(values[np.isfinite(values)]), initial=0.0))


@cache
def horizon(name: str, tolerance: float = TOLERANCE) -> float:
    """Up to where the motion is known: from there on the same engine at a tenth of the tolerance mostly disagrees."""
    finer = motion(name, tolerance / 10)
    rows = deviation(motion(name, tolerance), finer.time, {n: finer[n] for n in signals(finer)})
    off = rows.exceeding(PREDICTABLE, SAME_NEAR_EVENTS)
    for count, row in enumerate(off):
        if len(off) - count > 0.5 * (len(rows.time) - row):
            return float(rows.time[max(row - 1, 0)])
    return span(name)[1]


def difference(
    name: str, reference: lagdsl.Trajectory, time: Floats, columns: Mapping[str, Any], until: float = np.inf
) -> str:
    """Signals off by more than 1e-6 of their range up to the horizon, or `until` an earlier time, 1e-4 beside events;
    none: same.

    There must be rows over the whole of it, and it must be worth the name.
    """
    start, _, interval = span(name)
    end = min(horizon(name), until)
    assert end > start + 20 * interval, f"known up to {end} s only"
    rows = np.flatnonzero(np.asarray(time) <= end + 1e-9 * (end - start))
    known = deviation(reference, np.asarray(time)[rows], {n: np.asarray(c)[rows] for n, c in columns.items()})
    assert len(known.time) >= 0.9 * (end - start) / interval
    return known.first(SAME, SAME_NEAR_EVENTS)
