"""The motion of a model with its scene, or rows of given states: what pages and pictures show."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np

from lagdsl.derivation.program.program import Layout
from lagdsl.derivation.scene.drawings import meshes_of
from lagdsl.derivation.scene.living import START, Living, living
from lagdsl.derivation.scene.machine import up_of
from lagdsl.derivation.scene.shapes import Scene
from lagdsl.derivation.scene.stage import Stage, stage_of
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.engines.runtime.engines.engine import Engine, SingularSystem
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.listing import computed_outputs
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.analysis.point import Point
from lagdsl.motion.pipeline import Compilation, compile_flat, compile_observed
from lagdsl.motion.signals.trajectory import Column, Event, Statistics, Trajectory
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.simulate import simulate
from lagdsl.motion.simulate.table import heads_of


@record(kw_only=True)
class Prepared:
    """A model with its scene among its outputs, compiled. Columns are those of the runtime's rows: discrete outputs are
    discrete variables only."""

    own: FlatModel
    living: Living
    compilation: Compilation
    engine: Engine


@record(kw_only=True)
class Recording:
    """A motion whose last columns are the scalars of the scene; `p` (np,) are its parameters, `span` its time [s] as it
    was asked for, `ended` why it ended early, if it did."""

    prepared: Prepared
    p: Floats
    span: tuple[float, float]
    tolerance: float
    motion: Trajectory
    ended: str

    @property
    def scene(self) -> Scene:
        return self.prepared.living.scene


def prepare(flat: FlatModel, starts: Collection[str] = (), compilation: Compilation | None = None) -> Prepared:
    """Start values that depend on parameters stay so, but for those named in `starts`. Where `flat` is compiled by the
    graph, `compilation` is not made again."""
    own = replace(flat, outputs=computed_outputs(flat))
    shown = living(own, starts)
    if compilation is not None and compilation.route == "graph":
        made = compile_observed(compilation, shown.flat)
    else:
        found = compile_flat(shown.flat, Sink())
        assert found is not None, "a model that compiles does so with further outputs"
        made = found
    return Prepared(own=own, living=shown, compilation=made, engine=engine_of(made.program))


def recorded(prepared: Prepared, wishes: Wishes, rows: int, sink: Sink | None = None) -> Recording:
    """The motion with `rows` rows of equal distance, and two at the time of an event.

    Notes of the run and of meshes go to `sink`, and so do the errors of a run that ends early: the motion so far is
    the result. Raises CompilationFailed where there is no motion at all, ValueError for options that make no sense.
    """
    meshes_of(prepared.living.scene.shapes, sink)
    experiment = prepared.own.experiment
    p = parameters_of(prepared.engine.layout, wishes)
    t = experiment.start_time
    end = experiment.stop_time if wishes.stop is None else wishes.stop
    tolerance = experiment.tolerance if wishes.tolerance is None else wishes.tolerance
    ended = ""
    try:
        motion = simulate(
            prepared.engine,
            prepared.compilation.flat,
            stop=end,
            interval=(end - t) / (rows - 1),
            tolerance=tolerance,
            p=p,
            inputs=wishes.inputs,
            extremes=False,
            sink=sink,
        )
    except SimulationFailed as failure:
        told = Sink() if sink is None else sink
        for diagnostic in failure.diagnostics:
            told.add(diagnostic)
        motion, ended = failure.trajectory, failure.diagnostics[0].message
    return Recording(prepared=prepared, p=p, span=(t, end), tolerance=tolerance, motion=motion, ended=ended)


def recording_of(prepared: Prepared, points: Sequence[Point], origin: str, events: Sequence[float] = ()) -> Recording:
    """A row for each of `points` in the order of their times, with the parameters of the prepared model; outputs that
    are not determined there are nan. `origin` tells where they are from; `events` [s] are between rows of one time."""
    table = np.array([_row(prepared, point) for point in points])
    flat = prepared.compilation.flat
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


def parameters_of(layout: Layout, wishes: Wishes) -> Floats:
    """The independent parameters (np,) of a living model, start values among them."""
    names = [slot.name for slot in layout.parameters]
    p = np.array(layout.defaults, dtype=np.float64)
    starts = {name + START: value for name, value in wishes.start.items()}
    for name, value in {**wishes.parameters, **starts}.items():
        p[names.index(name)] = value
    return p


def staged(flat: FlatModel, scene: Scene, motions: Sequence[Trajectory]) -> Stage:
    """The stage of a model for all that its motions show: their last columns are those of the scene."""
    tables = [[column.values for column in each.columns[len(each.columns) - len(scene.columns) :]] for each in motions]
    rows = np.concatenate([np.array(table).reshape(len(scene.columns), -1) for table in tables], axis=1).T
    return stage_of(scene, rows, up_of(flat, planar=scene.planar))
