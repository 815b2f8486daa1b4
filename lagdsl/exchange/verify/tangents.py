"""A line on the derivatives of the motion: tangents against differences of whole runs, one quantity after the other."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate, pairwise
from typing import TypeAlias

import numpy as np

from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.exchange.verify.certificate import Line
from lagdsl.exchange.verify.first_steps import first_steps
from lagdsl.foundation.diagnostics import CallRefused, CompilationFailed, Sink
from lagdsl.foundation.numerics.connected_blocks import Flags
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
LIMIT = 1e-6
# At most so many parameters and starts.
_PARAMETERS, _STARTS = 3, 2
_ROWS = 21
# Rows end at this part of the motion: what happens at a round time is between two of them.
_PART = 0.99
# They end where the motion has taken so many steps.
_STEPS = 3000
# Of all these runs.
_TOLERANCE = 1e-12
# Of the largest derivative of its kind: errors of so many steps add up in each, as random ones do.
_RIGHT = float(np.sqrt(_STEPS)) * _TOLERANCE
# A column whose derivative is below this part of the values of its kind rests: differences are of rounding there.
_RESTS = 1e-2
# Steps of the differences, as parts of each value: long ones have little rounding, short ones stay among the same
# events, and where the motion is nearly linear. The first one decides about most motions.
_PARTS = (2.0**-8, 2.0**-5, 2.0**-11, 2.0**-14, 2.0**-17)
# Differences of the sixth order, (45 a - 9 b + c)/60, have so many times the rounding of their distance to those of the
# fourth, (5 a - 4 b + c)/60; three standard deviations of it.
_WEIGHT = 3.0 * float(np.sqrt((45**2 + 9**2 + 1) / (5**2 + 4**2 + 1)))
_PLACES = (-3, -2, -1, 1, 2, 3)
_KINDS = ("coordinate", "rate", "state")
_Events: TypeAlias = list[tuple[str, str]]


@record()
class _Quantity:
    """A parameter or a start with its value, by whose size it changes."""

    target: str
    is_start: bool
    value: float

    @property
    def name(self) -> str:
        return f"{self.target}.start" if self.is_start else self.target

    @property
    def size(self) -> float:
        return abs(self.value) or 1.0


@record(kw_only=True)
class ComparedTangent:
    """Derivatives by the quantity `name` at `rows` of `all_rows` times. `figure` is the largest difference as a part of
    the largest derivative, that of the column `where`; None where no row could be compared. `reason`: why rows are left
    out."""

    name: str
    rows: int
    all_rows: int
    figure: float | None
    where: str = ""
    reason: str = ""


def motion_tangents(compilation: Compilation, engine: Engine) -> Line:
    """By a few parameters and starts; left out where the motion has no derivatives."""
    try:
        found = compared_tangents(compilation.flat, engine)
    except (CallRefused, CompilationFailed, SimulationFailed) as failure:
        return Line(name=_NAME, says=_SAYS, note=failure.diagnostics[0].message)
    figures = [(each.figure, each.where, each.name) for each in found if each.figure is not None]
    if not figures:
        note = found[0].reason if found else "there is nothing to differentiate by"
        return Line(name=_NAME, says=_SAYS, note=note)
    figure, where, by = max(figures)
    return Line(name=_NAME, says=_SAYS, figure=figure, limit=LIMIT, note=f"largest for `{where}` by `{by}`")


def compared_tangents(flat: FlatModel, engine: Engine) -> list[ComparedTangent]:
    """Each quantity by itself. Raises SimulationFailed, CompilationFailed where there is no motion."""
    runs = _Runs(flat, engine)
    return [_compared(runs, quantity) for quantity in runs.quantities()]


class _Runs:
    """Motions with one quantity moved, over the time in which the motion takes _STEPS steps."""

    def __init__(self, flat: FlatModel, engine: Engine) -> None:
        self.flat, self.engine = flat, engine
        self.initial: InitialState = initial_state(flat, engine)
        begin = flat.experiment.start_time
        end = first_steps(engine, flat, _STEPS, _TOLERANCE)
        self.grid = np.linspace(begin, begin + _PART * (end - begin), _ROWS)

    def quantities(self) -> list[_Quantity]:
        """The first parameters that are not zero nor found with the start; starts that are written and hold, else
        those of states, else any."""
        flat, p = self.flat, self.initial.p.tolist()
        free = {parameter.name for parameter in flat.parameters if parameter.free}
        named = zip((slot.name for slot in self.engine.layout.parameters), p, strict=True)
        parameters = [_Quantity(name, False, value) for name, value in named if value != 0.0 and name not in free]
        moved = {row.name for row in self.initial.moved}
        written = [c.name for c in flat.coordinates if c.start_explicit and c.name not in moved]
        others = [state.name for state in flat.states] + [c.name for c in flat.coordinates]
        starts, places = list(dict.fromkeys(written + others)), places_of(flat)
        at = [_Quantity(name, True, float(self.initial.x[places[name]])) for name in starts[:_STARTS]]
        return parameters[:_PARAMETERS] + at

    def motion(self, quantity: _Quantity, by: float = 0.0, tangents: Sequence[str] = ()) -> Trajectory:
        """With the quantity moved by so much of its size."""
        value = quantity.value + by * quantity.size
        p = self.initial.p.copy()
        for number, slot in enumerate(self.engine.layout.parameters):
            p[number] = value if slot.name == quantity.target and not quantity.is_start else p[number]
        return simulate(
            self.engine,
            self.flat,
            stop=float(self.grid[-1]),
            interval=float(self.grid[1] - self.grid[0]),
            tolerance=_TOLERANCE,
            p=p,
            start={quantity.target: value} if quantity.is_start else {},
            tangents=tangents,
            sink=Sink(),
        )

    def so_far(self, quantity: _Quantity, by: float) -> Trajectory | None:
        """The same, up to where it fails; None: it does not begin."""
        try:
            return self.motion(quantity, by)
        except SimulationFailed as failure:
            return failure.trajectory
        except (CallRefused, CompilationFailed):
            return None


def _compared(runs: _Runs, quantity: _Quantity) -> ComparedTangent:
    reason = ""
    try:
        middle = runs.motion(quantity, 0.0, [quantity.name])
    except (CallRefused, SimulationFailed) as failure:
        reason = failure.diagnostics[0].message
        if not isinstance(failure, SimulationFailed) or failure.trajectory.sensitivities is None:
            return ComparedTangent(name=quantity.name, rows=0, all_rows=_ROWS, figure=None, reason=reason)
        middle = failure.trajectory
    table = _Table(runs.grid, middle, quantity, bool(reason))
    for part in _PARTS:
        sides = [runs.so_far(quantity, place * part) for place in _PLACES]
        there = [side for side in sides if side is not None]
        if len(there) == len(_PLACES):
            table.add(there, part)
        if table.is_decided:
            break
    return table.told(quantity.name, reason)


class _Table:
    """Distances of derivatives from differences at rows of the grid, the least one of all steps, as parts of sizes."""

    def __init__(self, grid: Floats, middle: Trajectory, quantity: _Quantity, ended: bool) -> None:
        self.grid, self.middle = grid, middle
        self.names = [(column.name, column.kind) for column in middle.columns if column.kind in _KINDS]
        self.derivative = quantity.size * self._at(middle, quantity.name)
        # A motion that ended early has none in its last row.
        self.differentiated = np.all(np.isfinite(self.derivative), axis=0) | (not ended)
        self.same: Flags = np.zeros((len(self.names), len(grid)), dtype=np.bool_)
        self.distance = np.full((len(self.names), len(grid)), np.inf)

    def _at(self, motion: Trajectory, by: str = "") -> Floats:
        """(columns, rows) values, or derivatives, of the last rows at the times of the grid; nan behind its end."""
        rows = np.searchsorted(motion.time, self.grid + self._together) - 1
        there = self.grid <= (motion.time[-1] if len(motion) else -np.inf) + self._together
        found: Floats = np.full((len(self.names), len(self.grid)), np.nan)
        for row, (name, _) in zip(found, self.names, strict=True):
            values = motion.derivative(name, by) if by else motion[name]
            row[there] = values[rows[there]]
        return found

    @property
    def _together(self) -> float:
        return 1e-9 * float(self.grid[-1] - self.grid[0])

    def _before(self, motion: Trajectory, t: float) -> _Events:
        """Up to t; of what happens together, as in islands that move by themselves, none is the first."""
        events = [event for event in motion.events if event.time <= t + self._together]
        later = (self._together < after.time - event.time for event, after in pairwise(events))
        instants = accumulate(later, initial=0)
        return [
            told
            for _, told in sorted((k, (event.kind, event.name)) for k, event in zip(instants, events, strict=False))
        ]

    def add(self, sides: Sequence[Trajectory], part: float) -> None:
        """Differences of the sixth order of rows that have the same events behind them; those of the fourth order tell
        in which columns they converge: stiff ones have more rounding, others are less linear."""
        values = [self._at(side) for side in sides]
        a, b, c = (values[5 - k] - values[k] for k in (2, 1, 0))
        sixth = (45.0 * a - 9.0 * b + c) / (60.0 * part)
        rough = np.abs(sixth - (8.0 * a - b) / (12.0 * part))
        behind = [self._before(self.middle, t) for t in self.grid.tolist()]
        same = np.array(
            [all(self._before(side, t) == behind[k] for side in sides) for k, t in enumerate(self.grid.tolist())]
        )
        same &= np.all(np.isfinite(sixth), axis=0) & self.differentiated
        size = np.max(np.abs(np.where(same, sixth, 0.0)), axis=1, initial=0.0)
        size = np.maximum(size, _RIGHT / LIMIT * self._largest_of_kind(size))
        size = np.maximum(size, _RESTS * self._usual)[:, None]
        so_far = np.maximum.accumulate(np.where(same, rough, 0.0), axis=1)  # one entry may be small by chance
        converged = same & (_WEIGHT * so_far <= LIMIT * size)
        distance = np.where(converged, np.abs(sixth - self.derivative) / size, np.inf)
        self.distance = np.fmin(self.distance, np.where(np.isnan(distance), np.inf, distance))
        self.same |= converged

    def _largest_of_kind(self, sizes: Floats) -> Floats:
        """Of each column (columns,): the largest of the sizes of its kind."""
        kinds = np.array([kind for _, kind in self.names])
        return np.array([np.max(sizes[kinds == kind]) for kind in kinds])

    @property
    def _usual(self) -> Floats:
        """(columns,) the largest values of their kinds; of rates at least the coordinates in a second."""
        largest = dict.fromkeys(_KINDS, float(np.finfo(float).tiny))
        for name, kind in self.names:
            largest[kind] = max(largest[kind], float(np.max(np.abs(self.middle[name]), initial=0.0)))
        largest["rate"] = max(largest["rate"], largest["coordinate"])
        return np.array([largest[kind] for _, kind in self.names])

    @property
    def is_decided(self) -> bool:
        return bool(np.all(self.same)) and bool(np.all(self.distance <= LIMIT))

    def told(self, name: str, reason: str) -> ComparedTangent:
        """`reason` is that of the motion with derivatives, which ended early."""
        rows = int(np.sum(np.all(self.same, axis=0)))
        distance = np.where(self.same, self.distance, 0.0)
        worst = np.unravel_index(int(np.argmax(distance)), distance.shape) if distance.size and rows else None
        if rows < len(self.grid) and not reason:
            reason = "neighbours have other events, or differences do not converge"
        return ComparedTangent(
            name=name,
            rows=rows,
            all_rows=len(self.grid),
            figure=None if worst is None else float(distance[worst]),
            where="" if worst is None else self.names[int(worst[0])][0],
            reason=reason,
        )
