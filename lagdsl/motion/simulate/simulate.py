"""Motion from an initial state: the entry of the simulator."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from math import floor, isfinite

import numpy as np

from lagdsl.derivation.program.program import Layout
from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.engines.runtime.library import FIXED_METHODS, METHODS
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import remembered
from lagdsl.language.flat.limits import check_clocks, check_limits
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.signals.inputs import Signal, report_missing, signals
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.commands import Commands
from lagdsl.motion.simulate.control import Control, Controls
from lagdsl.motion.simulate.derivatives import check_controlled, check_differentiable, differentiate, directions_of
from lagdsl.motion.simulate.initialize import find_start
from lagdsl.motion.simulate.instants import equidistant
from lagdsl.motion.simulate.islands.motion import motion_of_islands
from lagdsl.motion.simulate.motion import Asked, Motion, Task
from lagdsl.motion.simulate.placed import placed, start_values
from lagdsl.motion.simulate.resolution import DEFAULT_ROWS, Resolution
from lagdsl.motion.simulate.stepping import MOST_STEPS

SOLVERS = ("auto", *METHODS, *FIXED_METHODS)
# Solvers of SciPy and SUNDIALS that there were, and what takes their place.
_GONE = {"rk45": "dop853", "bdf": "radau", "cvode": "radau"}
LARGEST_ROWS = 20_000_000

_UNKNOWN = Resolution(())


def _number(name: str, value: object) -> float:
    return float(value)  # type: ignore[arg-type]


def simulate(
    engine: Engine,
    flat: FlatModel,
    *,
    stop: float | None = None,
    interval: float | None = None,
    times: Floats | None = None,
    tolerance: float | None = None,
    p: Floats | None = None,
    inputs: Mapping[str, Signal] | None = None,
    start: Mapping[str, float] | None = None,
    solver: str = "auto",
    step: float | None = None,
    max_steps: int = MOST_STEPS,
    control: Sequence[Control] = (),
    tangents: Sequence[str] = (),
    extremes: bool = True,
    read: Callable[[str, object], float] = _number,
    progress: Callable[[float], None] | None = None,
    sink: Sink | None = None,
) -> Trajectory:
    """Integrate from the model's start time to `stop` and return rows every `interval`; what is left out comes from
    the experiment. With `times`, which increase from the start time on, the rows are there and the last one is the end.

    `p` are the independent parameters, `inputs` constants, functions of time or (times, values) by name, `start`
    further start values; SI units. `step` is the length of the steps of rk4, leapfrog and ros2. The controllers of
    `control` set inputs on the way; `read` makes a number of a value that they give an input by name.
    `tangents` names what the motion is differentiated by. Without `extremes` nobody looks between rows for the lowest
    and highest values of columns, nor counts where they turn around: for many outputs that costs more than the motion.
    `progress` is called with the part of the time that is done. An error before the first step raises CompilationFailed
    (warnings go to `sink`), a failure on the way SimulationFailed, a bad option ValueError.
    """
    experiment = flat.experiment
    t0 = experiment.start_time
    if times is not None:
        stop = _last_of(times, t0, stop, interval)
    end = experiment.stop_time if stop is None else float(stop)
    relative = experiment.tolerance if tolerance is None else float(tolerance)
    wanted = experiment.interval if interval is None else float(interval)
    check_options(t0, end, relative, solver, step)
    if tangents:
        check_differentiable(flat, engine.layout, tangents)
    own = Sink() if sink is None else sink
    parameters = np.array(engine.layout.defaults, dtype=np.float64) if p is None else np.array(p, dtype=np.float64)
    with np.errstate(all="ignore"):
        _check_parameters(flat, engine.layout, parameters, (t0, end), max_steps, own)
        q, defaults = start_values(engine, t0, parameters)
        given = signals(flat, defaults, inputs or {}, (t0, end), own, speeds=engine.layout.speeds)
        own.raise_if_errors()
        controls = None
        if control:
            if tangents:
                check_controlled(engine.layout.speeds, given.following)
            commands = Commands(flat, given.following, engine.layout.speeds, read)
            controls = Controls(control, flat, given, commands, (t0, end))
        else:
            report_missing(flat, inputs or {}, own)
        asked = Asked(
            flat=flat,
            engine=engine,
            p=parameters,
            q=q,
            signals=given,
            start=start or {},
            tolerance=relative,
            solver=solver,
            step=step,
            max_steps=max_steps,
            controls=controls,
            tangents=tuple(tangents),
            extremes=extremes,
        )
        if times is not None:
            return _Finer(asked, (t0, end)).made(times, progress, own)
        return _shown(asked, (t0, end), wanted, progress, own)


def _last_of(times: Floats, t0: float, stop: float | None, interval: float | None) -> float:
    """The end of a motion with rows at `times` (rows,). Raises ValueError for times that are no rows of it."""
    if stop is not None or interval is not None:
        raise ValueError("give either the times of the rows, or the stop time and the interval")
    if times.ndim != 1 or not 2 <= len(times) < LARGEST_ROWS or not np.all(np.diff(times) > 0.0):
        raise ValueError(f"the times of the rows must be at least two and at most {LARGEST_ROWS} numbers that increase")
    if times[0] != t0:
        raise ValueError(f"the first row is that of the start time, {t0:g} s, not of {times[0]:g} s")
    return float(times[-1])


def _check_parameters(
    flat: FlatModel, layout: Layout, p: Floats, span: tuple[float, float], max_steps: int, sink: Sink
) -> None:
    """Raises CompilationFailed for values that parameters, or what follows from them, must not have."""
    known, key = _sound(flat), p.tobytes()
    if known == [key] and not flat.events.clocks:
        return
    values = dict(zip((slot.name for slot in layout.parameters), p.tolist(), strict=True))
    check_limits(flat, values, sink)
    sink.raise_if_errors()
    check_clocks(flat, values, span, max_steps, sink)
    known[:] = [key]


@remembered
def _sound(flat: FlatModel) -> list[bytes]:
    """The last parameters that were found sound; none at first."""
    return []


class _Finer:
    """Makes the motion that was `asked` for with rows that show it; `resolution` and the number of `intervals` that it
    has are known when it has been made once."""

    def __init__(self, asked: Asked, span: tuple[float, float]) -> None:
        self._asked, self._span = asked, span
        self._made: dict[int, Trajectory] = {}
        self.resolution, self.intervals = _UNKNOWN, 0

    def made(self, times: Floats, progress: Callable[[float], None] | None, sink: Sink) -> Trajectory:
        """With rows at `times`."""
        motion, turns = _motion(self._asked, times, progress, sink, self)
        self.resolution, self.intervals = Resolution(turns), len(times) - 1
        return motion

    def again(self, intervals: int) -> Trajectory:
        """With so many intervals between rows."""
        if intervals not in self._made:
            times = grid(*self._span, (self._span[1] - self._span[0]) / intervals)
            with np.errstate(all="ignore"):
                self._made[intervals] = _motion(self._asked, times, None, Sink(), None)[0]
        return self._made[intervals]

    def __call__(self, smooth: bool) -> Trajectory | None:
        needed = self.resolution.smooth if smooth else self.resolution.rows
        return None if self.intervals >= needed else self.again(needed)


def _shown(
    asked: Asked,
    span: tuple[float, float],
    interval: float | None,
    progress: Callable[[float], None] | None,
    sink: Sink,
) -> Trajectory:
    """With rows as they are asked for; where nobody asks, with as many as show the motion."""
    finer = _Finer(asked, span)
    motion = finer.made(grid(*span, interval), progress, sink)
    if interval is None and finer.intervals < finer.resolution.rows:
        finer.intervals = finer.resolution.rows
        motion = replace(finer.again(finer.intervals), finer=finer)
    return motion


def _motion(
    asked: Asked,
    times: Floats,
    progress: Callable[[float], None] | None,
    sink: Sink,
    finer: Callable[[bool], Trajectory | None] | None,
) -> tuple[Trajectory, list[float]]:
    """With rows at `times`; and how often every number of the state turns around."""
    flat, engine, given, t0 = asked.flat, asked.engine, asked.signals, float(times[0])
    inputs = given.course(t0) if asked.controls is None else given.held(t0)
    run = placed(
        flat,
        engine,
        asked.p,
        inputs,
        t0=t0,
        q=asked.q,
        times=times,
        tolerance=asked.tolerance,
        solver=asked.solver,
        step=asked.step,
    )
    if not asked.extremes:
        run.results.leave_out_extremes()
    u = inputs if isinstance(inputs, np.ndarray) else given.at(t0)
    initial = find_start(flat, engine, run, t0, u, asked.start, sink)
    sink.raise_if_errors()
    if asked.tangents:
        differentiate(flat, run, initial, asked.start, asked.tangents, directions_of(flat, engine, asked.tangents))
    task = Task(asked=asked, run=run, initial=initial, times=times, sink=sink, progress=progress, finer=finer)
    apart = motion_of_islands(task)
    found, turns = apart if apart is not None else (Motion(task).trajectory(), run.results.turns(run.size))
    run.leave()
    return found, turns


def grid(t0: float, stop: float, interval: float | None) -> Floats:
    """t0, t0 + interval, ...; the stop time is always the last."""
    step = (stop - t0) / DEFAULT_ROWS if interval is None else interval
    if not step > 0.0 or not (stop - t0) / step < LARGEST_ROWS:
        raise ValueError(f"the interval must be positive and give at most {LARGEST_ROWS} rows")
    count = floor((stop - t0) / step * (1.0 + 1e-12))
    if count == 0:
        return np.array([t0, stop])
    if count == 1 and stop - (t0 + step) <= 1e-9 * step:
        return np.array([t0, stop])
    times = equidistant(t0, step, count + 1)
    if stop - times[-1] > 1e-9 * step:
        return np.append(times, stop)
    times[-1] = stop
    return times


def check_options(t0: float, stop: float, tolerance: float, solver: str, step: float | None = None) -> None:
    """Raise ValueError for options that make no sense."""
    if not isfinite(stop) or not stop > t0:
        raise ValueError(f"the stop time {stop:g} s must be after the start time {t0:g} s")
    if not 1e-13 <= tolerance <= 0.1:
        raise ValueError(f"the tolerance {tolerance:g} must be between 1e-13 and 0.1")
    if solver in _GONE:
        raise ValueError(f"the solver `{solver}` was removed: use `{_GONE[solver]}`")
    if solver not in SOLVERS:
        raise ValueError(f"there is no solver `{solver}`; there are {', '.join(SOLVERS)}")
    _check_step(solver, step, stop - t0)


def _check_step(solver: str, step: float | None, span: float) -> None:
    fixed = solver in FIXED_METHODS
    if fixed and step is None:
        raise ValueError(f"the solver `{solver}` does not choose the length of its steps: give a step, in seconds")
    if step is not None and not fixed:
        names = ", ".join(FIXED_METHODS)
        raise ValueError(f"the solver `{solver}` chooses the length of its steps; give a step to {names} only")
    if step is not None and not 0.0 < step <= span:
        raise ValueError(f"the step {step:g} s must be positive and no longer than the simulation, {span:g} s")
    if step is not None and step < 1e-9 * span:
        raise ValueError(f"the step {step:g} s is too short: {span:g} s would take {span / step:.3g} steps")
