"""A line on the derivatives of the motion: tangents against differences of whole runs."""

from __future__ import annotations

import numpy as np

from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.exchange.verify.certificate import Line
from lagdsl.foundation.diagnostics import CallRefused, CompilationFailed, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.initialize import InitialState, initial_state, places_of
from lagdsl.motion.simulate.simulate import simulate

_NAME = "tangents of the motion"
_SAYS = "derivatives of the motion by parameters and starts equal differences of whole runs; as a part of the largest"
_LIMIT = 1e-5
# At most so many parameters and starts.
_PARAMETERS, _STARTS = 3, 2
_ROWS = 21
# Of all these runs: differences of theirs keep six digits.
_TOLERANCE = 1e-11
# Rows are farther than this part of the motion from events.
_NEAR = 1e-3
# A column below this part of the largest one rests.
_RESTS = 1e-3
# Steps of the differences, as parts of each value.
_STEP = 1e-5


@record()
class _Direction:
    """All quantities at once: names of parameters and starts with the sizes by which they change."""

    parameters: dict[str, float]
    starts: dict[str, float]

    @property
    def names(self) -> list[str]:
        return [*self.parameters, *(f"{name}.start" for name in self.starts)]

    @property
    def sizes(self) -> Floats:
        return np.array([*self.parameters.values(), *self.starts.values()])


def motion_tangents(compilation: Compilation, engine: Engine) -> Line:
    """Along one direction of a few parameters and starts; left out where the motion has no derivatives there."""
    flat = compilation.flat
    sink = Sink()
    try:
        initial = initial_state(flat, engine)
        direction = _direction(flat, engine, initial)
        found = _motion(flat, engine, initial, direction, 0.0, direction.names, sink)
        sides = [_motion(flat, engine, initial, direction, by * _STEP, (), sink) for by in (-2.0, -1.0, 1.0, 2.0)]
    except (CallRefused, CompilationFailed, SimulationFailed) as failure:
        return Line(name=_NAME, says=_SAYS, note=failure.diagnostics[0].message)
    orders = [[(event.kind, event.name) for event in each.events] for each in (found, *sides)]
    if any(order != orders[0] for order in orders) or any(d.code == "W0883" for d in sink.diagnostics):
        return Line(name=_NAME, says=_SAYS, note="the order of events changes beside the motion")
    if not direction.names:
        return Line(name=_NAME, says=_SAYS, note="there is nothing to differentiate by")
    return _compared(found, sides, direction)


def _direction(flat: FlatModel, engine: Engine, initial: InitialState) -> _Direction:
    """The first parameters that are not zero nor found with the start, and starts that are written."""
    free = {parameter.name for parameter in flat.parameters if parameter.free}
    values = dict(zip((slot.name for slot in engine.layout.parameters), initial.p.tolist(), strict=True))
    parameters = {name: value for name, value in values.items() if value != 0.0 and name not in free}
    places = places_of(flat)
    written = [c.name for c in flat.coordinates if c.start_explicit and not initial.moved]
    starts = {name: float(initial.x[places[name]]) or 1.0 for name in written[:_STARTS]}
    return _Direction(dict(list(parameters.items())[:_PARAMETERS]), starts)


def _motion(
    flat: FlatModel,
    engine: Engine,
    initial: InitialState,
    direction: _Direction,
    by: float,
    tangents: tuple[str, ...] | list[str],
    sink: Sink,
) -> Trajectory:
    """Moved along the direction by so much of the sizes."""
    p, places = initial.p.copy(), places_of(flat)
    for number, slot in enumerate(engine.layout.parameters):
        p[number] += by * direction.parameters.get(slot.name, 0.0)
    start = {name: float(initial.x[places[name]]) + by * size for name, size in direction.starts.items()}
    experiment = flat.experiment
    return simulate(
        engine,
        flat,
        interval=(experiment.stop_time - experiment.start_time) / (_ROWS - 1),
        tolerance=_TOLERANCE,
        p=p,
        start=start,
        tangents=tangents,
        sink=sink,
    )


def _compared(found: Trajectory, sides: list[Trajectory], direction: _Direction) -> Line:
    """At rows of the grid that are no events but ticks, for coordinates, rates and states."""
    events = [event.time for each in (found, *sides) for event in each.events if event.kind != "tick"]
    columns = [column for column in found.columns if column.kind in ("coordinate", "rate", "state")]
    usual = max((float(np.max(np.abs(column.values), initial=0.0)) for column in columns), default=0.0)
    grid = np.linspace(found.time[0], found.time[-1], _ROWS)
    span = float(grid[-1] - grid[0])
    near = np.array([min((abs(t - event) for event in events), default=span) for t in grid])
    grid = grid[near > _NEAR * span]
    largest, where = 0.0, ""
    if not len(grid):
        return Line(name=_NAME, says=_SAYS, note="events are as close together as rows")
    for column in columns:
        far_before, before, behind, far_behind = (_at(each, each[column.name], grid, span) for each in sides)
        difference = (8.0 * (behind - before) - (far_behind - far_before)) / (12.0 * _STEP)
        tangent = sum(
            size * _at(found, found.derivative(column.name, name), grid, span)
            for name, size in zip(direction.names, direction.sizes.tolist(), strict=True)
        )
        own = float(np.max(np.abs(difference))), float(np.max(np.abs(column.values), initial=0.0))
        scale = max(*own, _RESTS * usual, np.finfo(float).tiny)
        part = float(np.max(np.abs(tangent - difference))) / scale
        if not float(np.max(np.abs(difference - 0.5 * (behind - before) / _STEP))) <= _LIMIT * scale:
            return Line(name=_NAME, says=_SAYS, note=f"differences of `{column.name}` do not converge")
        largest, where = max((largest, where), (part, column.name))
    return Line(name=_NAME, says=_SAYS, figure=largest, limit=_LIMIT, note=f"largest for `{where}`" if where else "")


def _at(motion: Trajectory, values: Floats, grid: Floats, span: float) -> Floats:
    """Of the rows at the times of the grid."""
    rows = np.searchsorted(motion.time, grid + 1e-9 * span) - 1
    return np.asarray(values[rows])
