"""Many steps at once, with what happens at instants, by the C runtime: as far as nothing needs a closer look.

It stops where rank is about to be lost, where something that must stay true does not, where the constraints are out of
reach and where there are no accelerations. The step loop takes over at the last good state and finds out what it is.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeGuard

import numpy as np

from lagdsl.mechanics.rank import Floats
from lagdsl.runtime.c_engine import CEngine
from lagdsl.runtime.c_run import RunSettings, Status
from lagdsl.runtime.structures import METHODS
from lagdsl.simulate.accuracy import Accuracy
from lagdsl.simulate.projection import Projection
from lagdsl.simulate.right_hand_side import RightHandSide
from lagdsl.simulate.singular import Ranks
from lagdsl.simulate.watch import Watch

# Steps in one call, so that an interrupt from the keyboard does not wait for long.
_STEPS = 1000
# After these the length of the next step still means something.
_LENGTHS = (Status.TOO_LONG, Status.ATTENTION, Status.VIOLATED)


class Leaps:
    """The C side of one simulation. Rows of constraints that are `loose` come and go."""

    def __init__(
        self,
        engine: CEngine,
        system: RightHandSide,
        projection: Projection,
        accuracy: Accuracy,
        watch: Watch,
        times: Floats,
        tolerance: float,
        solver: str,
        ranks: Ranks,
        loose: Sequence[int],
    ) -> None:
        self.engine = engine
        self._system = system
        self._times = np.ascontiguousarray(times)
        self._rows = np.zeros((len(times), len(accuracy.sizes)))
        constant = system.signals.constant
        lasting = np.ones(len(projection.row_sizes))
        lasting[list(loose)] = 0.0
        settings = RunSettings(
            tolerance=tolerance,
            part=projection.tolerance / tolerance,
            method=None if solver == "auto" else solver,
            p=np.ascontiguousarray(system.p),
            inputs=np.ascontiguousarray(system.inputs(float(times[0]))) if constant else system.inputs,
            group=accuracy.groups.astype(np.float64),
            natural=np.ascontiguousarray(accuracy.sizes),
            cap=np.ascontiguousarray(accuracy.caps),
            row_sizes=np.ascontiguousarray(projection.row_sizes),
            lasting=lasting,
            general=ranks.general,
            length=float(times[-1] - times[0]),
            times=self._times,
            rows=self._rows,
            invariant_tolerance=np.ascontiguousarray(watch.tolerances),
            invariant_start=watch.start,
            invariant_size=watch.sizes,
            invariant_drift=watch.drift,
        )
        self.run = engine.run(settings)
        self.status = 0

    def forward(self, t: float, y: Floats, h: float, end: float, row: int, steps: int) -> bool:
        """As far as it goes towards `end`, in at most so many steps; row number `row` is the next to be recorded.
        Returns whether it wants to go on from there."""
        budget = min(steps, _STEPS)
        if budget <= 0:
            return False
        self._w = self._system.w
        self.status = self.run.leap(t, y, h, end, row=row, steps=budget)
        return self.status == Status.TOO_LONG and steps > budget

    def rows(self, first: int) -> tuple[int, Floats, Floats, Floats]:
        """Number of the next row if `first` was it before, and what became rows: times, states and discretes.

        At an event there are two, one if the time of the first was asked for and is there already.
        """
        found: list[tuple[Floats, Floats, Floats]] = []
        times, w = self._times, self._w

        def up_to(row: int, first: int) -> int:
            if row > first:
                found.append((times[first:row], self._rows[first:row], np.tile(w, (row - first, 1))))
            return max(row, first)

        for told in self.run.told:
            if len(told.y):
                first = up_to(told.row, first)
                w = told.w
                if told.what == "after" or not (first and times[first - 1] == told.t):
                    found.append((np.array([told.t]), told.y[None], w[None]))
                first = max(first, int(np.searchsorted(times, told.t, side="right")))
        row = up_to(int(self.run.report.row), first)
        self._system.with_discretes(self.run.discretes())
        if not found:
            return row, times[:0], self._rows[:0], np.zeros((0, len(w)))
        parts = [np.concatenate(part) for part in zip(*found, strict=True)]
        return row, parts[0], parts[1], parts[2]

    @property
    def t(self) -> float:
        return float(self.run.report.t)

    @property
    def h(self) -> float:
        """Length of the step that would be next; 0 where it is not known."""
        return float(self.run.report.h) if self.status in _LENGTHS else 0.0

    @property
    def y(self) -> Floats:
        """The state at `t`."""
        return self.run.state()

    @property
    def implicit(self) -> bool:
        """Whether the method is implicit now."""
        return bool(self.run.report.implicit)

    @property
    def steps(self) -> int:
        """Steps of the last call."""
        return int(self.run.report.steps)

    @property
    def evaluations(self) -> int:
        return int(self.run.report.evaluations)

    @property
    def jacobians(self) -> int:
        return int(self.run.report.jacobians)

    @property
    def projections(self) -> int:
        return int(self.run.report.projections)

    @property
    def changes(self) -> list[tuple[float, bool]]:
        """Time and kind (implicit) of the first changes of method."""
        report = self.run.report
        return [(float(report.change[i].t), bool(report.change[i].implicit)) for i in range(min(report.changes, 16))]


def can_leap(engine: object, solver: str) -> TypeGuard[CEngine]:
    """Whether the C runtime knows how to do this run."""
    return isinstance(engine, CEngine) and solver in ("auto", *METHODS)
