"""Which states become rows: those at the requested times, two at every event. Tells the progress, too."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lagdsl.mechanics.rank import Floats
from lagdsl.runtime.c_engine import CEngine
from lagdsl.simulate.motion.task import Task, Tools
from lagdsl.simulate.recorder import Recorder

_PROGRESS_STEP = 0.002
Dense = Callable[[float], Floats]


class Rows:
    """`next` is the number of the first requested time that has no row yet."""

    def __init__(self, task: Task, tools: Tools) -> None:
        self._task = task
        self._times = task.times
        self._projection = tools.projection
        self.recorder = Recorder(task.flat, task.engine, tools.system, tools.projection)
        self.next = 0
        self._shown = 0.0

    def start(self, t: float, y: Floats) -> None:
        """The first row."""
        self.recorder.add(t, y)
        self.next = 1

    def inside(self, t: float, dense: Callable[[], Dense], check: Callable[[float, Floats], None]) -> None:
        """Rows at the requested times before `t`; `dense()` gives the states since the last accepted one."""
        first = self.next
        while self.next < len(self._times) and self._times[self.next] < t:
            self.next += 1
        if self.next > first:
            state = dense()
            for time in self._times[first : self.next].tolist():
                y = np.asarray(state(time))
                better = self._projection(time, y)
                row = y if better is None else better
                if self._task.flat.assertions:
                    check(time, row)
                self.recorder.add(time, row)

    def reached(self, t: float, y: Floats) -> None:
        """A row if the time of an accepted state was asked for."""
        if self.next < len(self._times) and self._times[self.next] == t:
            self.recorder.add(t, y)
            self.next += 1
        self.tell(t)

    def before_event(self, t: float, y: Floats) -> None:
        """The row just before an event, unless it is there because its time was asked for."""
        if not (self.next and self._times[self.next - 1] == t):
            self.recorder.add(t, y)
        while self.next < len(self._times) and self._times[self.next] <= t:
            self.next += 1

    def after_event(self, t: float, y: Floats) -> None:
        self.recorder.add(t, y)
        self.tell(t)

    def leapt(self, engine: CEngine, found: tuple[int, Floats, Floats, Floats]) -> None:
        """Somebody else has found rows: `next` after them, times, states (rows, 2 nq + nz), discretes (rows, nw)."""
        self.next, times, states, discretes = found
        self.recorder.add_many(engine, times, states, discretes)

    def last_good(self, t: float, y: Floats) -> None:
        """The state at which the run fails, once there is a first row."""
        if self.next:
            self.recorder.add(t, y)

    def tell(self, t: float) -> None:
        """The progress, now and then."""
        part = (t - self._task.first) / (self._task.last - self._task.first)
        if self._task.progress is not None and (part - self._shown >= _PROGRESS_STEP or part >= 1.0):
            self._shown = part
            self._task.progress(part)
