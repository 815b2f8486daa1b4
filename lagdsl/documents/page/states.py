"""Rows of given states: what the model and its scene say there, without integrating anything."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.documents.plot.picture.recording import Prepared, Recording
from lagdsl.engines.runtime.engines.engine import SingularSystem
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.analysis.point import Point
from lagdsl.motion.signals.trajectory import Column, Event, Statistics, Trajectory
from lagdsl.motion.simulate.table import heads_of


def recording_of(prepared: Prepared, points: Sequence[Point], origin: str, events: Sequence[float] = ()) -> Recording:
    """A row for each of `points` in the order of their times, with the parameters of the prepared model; outputs that
    are not determined there are nan. `origin` tells where they are from; `events` [s] are between rows of one time."""
    table = np.array([_row(prepared, point) for point in points])
    flat: FlatModel = prepared.compilation.flat
    zeros = np.zeros(len(table))
    motion = Trajectory(
        model=flat.name,
        columns=tuple(
            Column(name=name, unit=unit, kind=kind, display=display, values=np.ascontiguousarray(values))
            for (name, unit, kind, display), values in zip(heads_of(flat), table[:, :-1].T, strict=True)
        ),
        checks=np.array([table[:, -1], zeros, zeros]),
        invariants=(),
        moved=(),
        statistics=Statistics(solver=origin),
        events=tuple(Event(time=t, name="event", kind="recorded") for t in events),
    )
    span = (float(motion.time[0]), float(motion.time[-1]))
    tolerance = prepared.own.experiment.tolerance
    return Recording(prepared=prepared, p=points[0].p, span=span, tolerance=tolerance, motion=motion, ended="")


def _row(prepared: Prepared, point: Point) -> list[float]:
    engine = prepared.engine
    layout = engine.layout
    with np.errstate(all="ignore"):
        try:
            qdd, lam = engine.solve(*point.arguments)
        except SingularSystem:
            qdd, lam = np.full(len(layout.coordinates), np.nan), np.full(len(layout.constraints), np.nan)
        (y,) = engine.evaluate("output", *point.arguments, qdd, lam)
        energy = engine.evaluate("energies", *point.arguments)[0]
    moving = [*point.q.tolist(), *point.qd.tolist(), *point.z.tolist()]
    count = len(heads_of(prepared.compilation.flat)) - 1 - len(moving) - len(y)
    return [point.t, *moving, *point.w.tolist()[:count], *y.tolist(), float(np.ravel(energy)[0])]
