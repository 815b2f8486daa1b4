"""Many steps at once, by the C runtime: as far as nothing needs a closer look than it takes.

It stops at an event, where rank is about to be lost, where something that must stay true does not, where the
constraints are out of reach and where there are no accelerations. The step loop takes over at the last good state and
finds out what it is.
"""

from __future__ import annotations

from typing import TypeGuard

import numpy as np

from lagdsl.mechanics.rank import Floats
from lagdsl.runtime.c_engine import CEngine
from lagdsl.runtime.c_run import Places, RunSettings
from lagdsl.runtime.load import METHODS
from lagdsl.simulate.accuracy import Accuracy
from lagdsl.simulate.events.discretes import Discretes
from lagdsl.simulate.projection import Projection
from lagdsl.simulate.right_hand_side import RightHandSide
from lagdsl.simulate.singular import Ranks
from lagdsl.simulate.watch import Watch

# Steps in one call, so that an interrupt from the keyboard does not wait for long.
_STEPS = 1000
# lag_status, those after which the length of the next step still means something.
_TOO_LONG, _ATTENTION, _VIOLATED, _HAPPENS = 5, 7, 8, 11


class Leaps:
    """The C side of one simulation. `rows` holds the states recorded so far at the requested times."""

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
        discretes: Discretes,
        slack: Floats,
    ) -> None:
        self.engine = engine
        self._system = system
        self._times = np.ascontiguousarray(times)
        self.rows = np.zeros((len(times), len(accuracy.sizes)))
        constant = system.signals.constant
        lasting = np.ones(len(projection.row_sizes))
        lasting[discretes.rows] = 0.0
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
            places=Places(
                truth=discretes.relations.astype(np.float64),
                strict=discretes.strict.astype(np.float64),
                closed=discretes.contacts.astype(np.float64),
                row=discretes.rows.astype(np.float64),
                slack=slack,
            ),
            times=self._times,
            rows=self.rows,
            invariant_tolerance=np.ascontiguousarray(watch.tolerances),
            invariant_start=watch.start,
            invariant_size=watch.sizes,
            invariant_drift=watch.drift,
        )
        self._run = engine.run(settings)
        self._status = 0
        self._counts = len(discretes.relations), len(discretes.contacts)

    def forward(self, t: float, y: Floats, h: float, end: float, row: int, steps: int) -> bool:
        """As far as it goes towards `end`, in at most so many steps; row number `row` is the next to be recorded.
        Returns whether it wants to go on from there."""
        budget = min(steps, _STEPS)
        if budget <= 0:
            return False
        w = self._system.w
        self._status = self._run.leap(t, np.ascontiguousarray(y), w, h, end, row=row, steps=budget)
        if self._run.trouble is not None:
            raise self._run.trouble
        return self._status == _TOO_LONG and steps > budget

    @property
    def t(self) -> float:
        return float(self._run.report.t)

    @property
    def h(self) -> float:
        """Length of the step that would be next; 0 where it is not known."""
        return float(self._run.report.h) if self._status in (_TOO_LONG, _ATTENTION, _VIOLATED, _HAPPENS) else 0.0

    @property
    def y(self) -> Floats:
        """The state at `t`."""
        return self._run.state()

    @property
    def happened(self) -> tuple[list[int], list[int]] | None:
        """The relations and contacts that changed, if that is why it stopped at `t`."""
        if self._status != _HAPPENS:
            return None
        relations, contacts = self._counts
        flags = self._run.report.changed[: relations + contacts]
        return (
            [i for i, flag in enumerate(flags[:relations]) if flag],
            [i for i, flag in enumerate(flags[relations:]) if flag],
        )

    @property
    def implicit(self) -> bool:
        """Whether the method is implicit now."""
        return bool(self._run.report.implicit)

    @property
    def row(self) -> int:
        """Number of the next row."""
        return int(self._run.report.row)

    @property
    def steps(self) -> int:
        """Steps of the last call."""
        return int(self._run.report.steps)

    @property
    def evaluations(self) -> int:
        return int(self._run.report.evaluations)

    @property
    def jacobians(self) -> int:
        return int(self._run.report.jacobians)

    @property
    def projections(self) -> int:
        return int(self._run.report.projections)

    @property
    def changes(self) -> list[tuple[float, bool]]:
        """Time and kind (implicit) of the first changes of method."""
        report = self._run.report
        return [(float(report.change[i].t), bool(report.change[i].implicit)) for i in range(min(report.changes, 16))]


def can_leap(engine: object, solver: str) -> TypeGuard[CEngine]:
    """Whether the C runtime knows how to do this run."""
    return isinstance(engine, CEngine) and solver in ("auto", *METHODS)
