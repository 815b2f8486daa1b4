"""Runs of a model as functions of the unknowns: the one place where a fit asks for motions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from lagdsl.derivation.program.program import Program
from lagdsl.engines.runtime.engines.broadcast import BatchEngine
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.fit.data import Series
from lagdsl.motion.fit.unknowns import Unknown, is_parameter
from lagdsl.motion.signals.inputs import Signal
from lagdsl.motion.signals.trajectory import Event, Trajectory
from lagdsl.motion.simulate.simulate import simulate

Signature = tuple[tuple[str, str], ...]


@record(kw_only=True)
class Rollout:
    """One run: the motion for values of its `unknowns`, and what a measurement of it would be. `p` are the parameters
    that are not free, `times` (rows,) those of the rows, from the start of the run."""

    name: str
    flat: FlatModel
    engine: BatchEngine
    program: Program
    p: Floats
    start: Mapping[str, float]
    inputs: Mapping[str, Signal]
    unknowns: tuple[Unknown, ...]
    series: tuple[Series, ...]
    times: Floats
    tolerance: float
    solver: str

    def motion(
        self, x: Floats, *, tolerance: float | None = None, tangents: Sequence[str] = (), sink: Sink | None = None
    ) -> Trajectory:
        """With x (unknowns,), differentiated by `tangents`. Raises as `simulate`."""
        p, start = self.p.copy(), dict(self.start)
        places = {slot.name: k for k, slot in enumerate(self.engine.layout.parameters)}
        for unknown, value in zip(self.unknowns, x.tolist(), strict=True):
            if is_parameter(unknown):
                p[places[unknown.target.key]] = value
            else:
                start[unknown.target.key] = value
        return simulate(
            self.engine,
            self.flat,
            times=self.times,
            tolerance=self.tolerance if tolerance is None else tolerance,
            p=p,
            inputs=self.inputs,
            start=start,
            solver=self.solver,
            tangents=tangents,
            sink=Sink() if sink is None else sink,
        )

    def observed(self, motion: Trajectory) -> Floats:
        """Values (n,) of all series; nan for an event that does not happen."""
        return np.concatenate([_observed(motion, each) for each in self.series])


@record(kw_only=True)
class Differentiated:
    """A motion with what would be measured of it, `values` (n,), and its derivatives `jacobian` (n, unknowns) by the
    unknowns, SI units. `steady` tells for each unknown that the order of events does not change near its value."""

    motion: Trajectory
    values: Floats
    jacobian: Floats
    steady: tuple[bool, ...]


class Derivatives(Protocol):
    """A way to derivatives of a run by its unknowns. `error` is their relative error."""

    error: float

    def __call__(self, rollout: Rollout, x: Floats, *, exact: bool = False) -> Differentiated:
        """At x (unknowns,); with `exact` as well as this way can. Raises as `Rollout.motion`."""
        ...


def happened(motion: Trajectory, series: Sequence[Series]) -> Signature:
    """Kinds and names of the events in their order, up to the last value of the series; one that repeats itself, as
    bounces do, once, and without clocks, whose instants are known ahead."""
    last = max(float(np.max(each.times, initial=-np.inf)) for each in series)
    found = [(e.kind, e.name) for e in motion.events if e.kind not in ("tick", "jump") and e.time <= last]
    return tuple(each for k, each in enumerate(found) if k == 0 or each != found[k - 1])


def rows_at(motion: Trajectory, times: Floats) -> NDArray[np.intp]:
    """Places of the rows at `times`; of two at an event that of the one after it."""
    return np.asarray(np.searchsorted(motion.time, times, side="right") - 1)


def instants(motion: Trajectory, name: str) -> list[Event]:
    """Events at which something happened to `name`: of a contact its impacts."""
    found = [event for event in motion.events if event.name == name]
    return [event for event in found if event.kind == "impact"] or found


def rows_of(series: Sequence[Series], first: float, last: float | None = None) -> Floats:
    """Times of rows from `first` on that hold all series, up to `last` where that is later."""
    times = [each.times for each in series if not each.event]
    ends = [np.array([first]), *times, np.array([] if last is None else [last])]
    return np.unique(np.concatenate(ends))


def _observed(motion: Trajectory, series: Series) -> Floats:
    if not series.event:
        return np.asarray(motion[series.name][rows_at(motion, series.times)])
    found = [event.time for event in instants(motion, series.name)[: len(series.values)]]
    return np.array([*found, *[np.nan] * (len(series.values) - len(found))])
