"""A run on its way: in calls of C that do not take long, with compiled C where that pays."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from time import perf_counter

import numpy as np

from lagdsl.engines.runtime.engines.auto_engine import AutoEngine
from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.engines.runtime.run import Run
from lagdsl.engines.runtime.structures import Status

# Steps in one call of C, so that an interrupt from the keyboard does not wait for long, and progress is told.
STEPS = 1000
# Of the first call, after which it is known what a step takes.
FIRST_STEPS = 50
MOST_STEPS = 1_000_000  # of a motion, unless said otherwise
# First steps are short, and those of another method may be much longer: the work so far foretells at most so many times
# as much. So the compiler starts a hundredth of the work later for which it pays.
FORETOLD = 100


class Stepping:
    """`span` is the first and the last time; `steps` are those so far, at most `most`. `told` is called at times."""

    def __init__(
        self, engine: Engine, run: Run, span: tuple[float, float], most: int, told: Callable[[], None] | None = None
    ) -> None:
        self._engine, self._run, self._span = engine, run, span
        self._most, self._told = most, told
        self.steps = 0
        self._worked = 0.0  # s

    def over(self, breaks: Sequence[float]) -> Status:
        """Up to the last of them, at which inputs may jump. It is known behind the first one how long a step takes."""
        if not breaks:
            return Status.OK
        stops = np.array(breaks)
        status = self.segment(self._run.over(stops[:1]))
        return self.segment(self._run.over(stops[1:])) if status is Status.OK and len(stops) > 1 else status

    def to(self, stop: float) -> Status:
        """Up to there."""
        return self.segment(partial(self._run.to, stop))

    def segment(self, on: Callable[[int], Status]) -> Status:
        """As far as `on` leads, which takes at most so many steps."""
        while True:
            steps = min(STEPS if self.steps > 0 else FIRST_STEPS, self._most - self.steps)
            status = self._on(on, steps) if steps > 0 else Status.TOO_LONG
            if self._told is not None:
                self._told()
            if status is not Status.TOO_LONG or steps <= 0:
                return status

    def _on(self, on: Callable[[int], Status], steps: int) -> Status:
        """At most so many steps; those that follow are taken in C where that pays and there is C by then."""
        engine, run = self._engine, self._run
        if not isinstance(engine, AutoEngine):
            status = on(steps)
            self.steps += run.report.steps
            return status
        first, last = self._span
        before, started = run.t, perf_counter()
        status = on(steps)
        report = run.report
        self.steps += report.steps
        if status in (Status.OK, Status.TOO_LONG):
            seconds, reached = perf_counter() - started, max(report.t - before, 1e-9 * (last - first))
            self._worked += seconds
            engine.worked(seconds, left=min(seconds * (last - report.t) / reached, FORETOLD * self._worked))
            compiled = engine.hasten()
            if compiled is not None:
                run.change(compiled)
        return status
