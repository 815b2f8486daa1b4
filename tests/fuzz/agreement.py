"""Do two engines see the same motion with events? The measure is how far each of them is from itself at a tenth of the
tolerance, so that it neither forgives a wrong rule nor asks of a chaotic motion what no arithmetic can give.
"""

from __future__ import annotations

import signal
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType
from typing import Literal

import numpy as np
import pytest
from numpy.typing import NDArray

import lagdsl
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.failure import SimulationFailed

Floats = NDArray[np.float64]
Verdict = Literal["same", "grazing", "differs", "hang", "nan"]

TOLERANCE = 1e-8
# An engine may disagree with itself at a tenth of the tolerance: an event hinges on less than the tolerance.
MOST_GRAZING = 0.1
INTERVAL = 0.01
SECONDS = 20  # of the processor
# States may differ by so many times what an engine differs from itself, or by this part of the tolerance.
FACTOR, PART = 10.0, 0.1
# A motion is followed as long as an engine differs from itself by less than this part of the range.
HORIZON = 1e-3
# Events nearer to each other than this happen at one instant, in no order; so long before something that hinges on
# less than the tolerance the comparison ends.
INSTANT = 1e-7


class HangError(Exception):
    """A run did not end in time."""


@dataclass(frozen=True)
class Run:
    """One motion, complete or up to the failure `code`."""

    motion: Trajectory
    code: str | None

    @property
    def end(self) -> float:
        return float(self.motion.time[-1])


@dataclass(frozen=True)
class Report:
    verdict: Verdict
    why: str = ""


@contextmanager
def limited(seconds: int) -> Iterator[None]:
    """Interrupts again and again: what is raised inside a function that C calls may be lost."""

    def stop(_number: int, _frame: FrameType | None) -> None:
        raise HangError

    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds, 0.2)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
        signal.signal(signal.SIGVTALRM, before)


def run(model: lagdsl.Model, tolerance: float) -> Run:
    with limited(SECONDS):
        try:
            return Run(model.simulate(tolerance=tolerance, interval=INTERVAL), None)
        except SimulationFailed as failure:
            return Run(failure.trajectory, failure.diagnostic.code)


def compare(text: str) -> Report:
    """Both engines on one model."""
    runs: dict[EngineName, tuple[Run, Run]] = {}
    engines: tuple[EngineName, EngineName] = ("numpy", "c")
    for engine in engines:
        model = lagdsl.compile(text, engine=engine)
        try:
            runs[engine] = run(model, TOLERANCE), run(model, 0.1 * TOLERANCE)
        except HangError:
            return Report("hang", engine)
        for each in runs[engine]:
            if each.code is None and not all(np.all(np.isfinite(c.values)) for c in each.motion.columns):
                return Report("nan", engine)
    return _judged(runs["numpy"], runs["c"])


def _judged(a: tuple[Run, Run], b: tuple[Run, Run]) -> Report:
    """Compared up to the first time from which an engine does not agree with itself."""
    hinges = [_parting(*own) for own in (a, b)]
    horizon = min(_horizon(*a), _horizon(*b), *(t for t, _ in hinges))
    parting, what = _parting(a[0], b[0])
    if parting < horizon - INSTANT:  # nearer to each other they hinge on the same event
        return Report("differs", f"events at t = {parting:.9g}: {what}")
    wrong = _states(a, b, horizon)
    if wrong:
        return Report("differs", wrong)
    own = [f"t = {t:.6g}: {why}" for t, why in hinges if why]
    return Report("grazing", own[0]) if own else Report("same")


def _parting(a: Run, b: Run) -> tuple[float, str]:
    """When the events of two runs begin to be others, and how; inf where they never do."""
    left, right = _instants(a), _instants(b)
    for (t, events), (s, others) in zip(left, right, strict=False):
        if events != others or abs(t - s) > 1e-3:
            return min(t, s) - INSTANT, f"{events} at {t:.9g} and {others} at {s:.9g}"
    if len(left) != len(right):
        rest = (left if len(left) > len(right) else right)[min(len(left), len(right))]
        return rest[0] - INSTANT, f"{rest[1]} at {rest[0]:.9g} in one only"
    if a.code != b.code:
        return min(a.end, b.end) - INSTANT, f"ends with {a.code} and {b.code}"
    return np.inf, ""


def _instants(run: Run) -> list[tuple[float, list[tuple[str, str]]]]:
    """Events by instant, those of one instant sorted."""
    found: list[tuple[float, list[tuple[str, str]]]] = []
    for event in run.motion.events:
        if not found or event.time - found[-1][0] > INSTANT:
            found.append((event.time, []))
        found[-1][1].append((event.name, event.kind))
    return [(t, sorted(events)) for t, events in found]


def _horizon(a: Run, b: Run) -> float:
    """Up to where the second run stays near the first."""
    times, left, right = _common(a, b)
    beyond = np.flatnonzero(np.any(np.abs(left - right) > HORIZON * _scale(left), axis=1))
    return float(times[beyond[0]]) if len(beyond) else np.inf


def _states(a: tuple[Run, Run], b: tuple[Run, Run], horizon: float) -> str:
    """The column that differs by more than it may, before the horizon."""
    own = [_departure(*each) for each in (a, b)]
    times, left, right = _common(a[0], b[0])
    limit = np.maximum(*(values[np.searchsorted(at, times).clip(max=len(at) - 1)] for at, values in own))
    limit = np.maximum(FACTOR * limit, PART * TOLERANCE * _scale(left))
    wrong = (np.abs(left - right) > limit) & (times < horizon)[:, None]
    if not wrong.any():
        return ""
    row = int(np.argmax(np.any(wrong, axis=1)))
    column = int(np.argmax(wrong[row]))
    name = a[0].motion.columns[1 + column].name
    difference = abs(left[row, column] - right[row, column])
    return f"{name} at t = {times[row]:.6g}: {difference:.2g} where {limit[row, column]:.2g} is allowed"


def _departure(a: Run, b: Run) -> tuple[Floats, Floats]:
    """The largest difference of two runs so far, by time and column."""
    times, left, right = _common(a, b)
    return times, np.maximum.accumulate(np.abs(left - right), axis=0)


def _common(a: Run, b: Run) -> tuple[Floats, Floats, Floats]:
    """States at the requested times that no event comes near in either run; outputs and discretes are functions of
    states and events."""
    clear = [_clear_rows(each) for each in (a, b)]
    times = np.intersect1d(*clear)
    return times, *(_table(each)[np.searchsorted(each.motion.time, times)] for each in (a, b))  # type: ignore[return-value]


def _clear_rows(run: Run) -> Floats:
    times = run.motion.time
    events = np.array([event.time for event in run.motion.events])
    if len(events):
        near = np.min(np.abs(times[:, None] - events), axis=1) <= INSTANT
        times = times[~near]
    return times


def _table(run: Run) -> Floats:
    columns = [c.values for c in run.motion.columns if c.kind in ("coordinate", "rate", "state", "discrete")]
    return np.column_stack(columns)


def _scale(values: Floats) -> Floats:
    """Range of each column, at least one."""
    return np.maximum(1.0, np.max(values, axis=0, initial=-np.inf) - np.min(values, axis=0, initial=np.inf))


def told(
    engine: str, reports: Mapping[int, Report], capsys: pytest.CaptureFixture[str]
) -> tuple[dict[int, Report], dict[int, str]]:
    """Prints the verdicts. Reports that are wrong, and why others hinge on less than the tolerance, by seed."""
    wrong = {seed: report for seed, report in reports.items() if report.verdict not in ("same", "grazing")}
    grazing = {seed: report.why for seed, report in reports.items() if report.verdict == "grazing"}
    with capsys.disabled():
        counts = Counter(report.verdict for report in reports.values())
        print(f"\n{engine}: {dict(counts)}", *(f"grazing {seed}: {why}" for seed, why in grazing.items()), sep="\n")
    return wrong, grazing
