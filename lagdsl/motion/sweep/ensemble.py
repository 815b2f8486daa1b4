"""Runs of one model that differ in numbers only: all of them in one call of C."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from functools import partial
from itertools import groupby

import numpy as np

from lagdsl.engines.runtime.engines.broadcast import BatchEngine
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.ensemble import Bench, EnsembleSettings, Stop
from lagdsl.engines.runtime.signal_tables import TabledInputs
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.connected_blocks import Flags
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.admissible import certainly_allowed
from lagdsl.language.flat.limits import certainly_within, check_clocks, check_limits
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.signals.inputs import given_inputs, is_allowed, signals
from lagdsl.motion.simulate.initial_words import FAR
from lagdsl.motion.simulate.initialize import places_of
from lagdsl.motion.simulate.placed import settings_of
from lagdsl.motion.simulate.simulate import grid
from lagdsl.motion.simulate.stepping import FIRST_STEPS, MOST_STEPS, STEPS
from lagdsl.motion.simulate.table import asked, heads_of, places_of_columns
from lagdsl.motion.simulate.unknown_outputs import UnknownOutputs
from lagdsl.motion.sweep.failure_words import FailureWords
from lagdsl.motion.sweep.plan import Task
from lagdsl.motion.sweep.run import Options, Outcome, failed, first_error, parameters_of

# In the rows of one call of C.
_NUMBERS = 4_000_000


class Ensemble:
    """The runs of one flat model, with the options that all of them share.

    Raises ValueError and CompilationFailed for options that no run can be made with.
    """

    def __init__(self, flat: FlatModel, engine: BatchEngine, options: Options) -> None:
        self._flat, self._engine, self._options = flat, engine, options
        self._lock = threading.Lock()  # of the engine, which serves one thread at a time
        heads = heads_of(flat)[1:]
        names = [name for name, *_ in heads]
        rows = len(grid(flat.experiment.start_time, options.stop, options.interval))
        self._most = max(1, _NUMBERS // (rows * (len(heads) + 1)))
        chosen = [(k, name) for k, each in enumerate(names) for name in asked(flat, each, options.columns)]
        places = places_of_columns(flat)[1:]
        columns = [places[k] - 1 for k, _ in chosen]
        whole = columns == list(range(len(heads)))
        self._columns: list[int] | slice = slice(None) if whole else columns  # a copy of some of them, or all
        self._unknown = UnknownOutputs(flat, engine)
        self._names = tuple(name for _, name in chosen)
        self._units = tuple(heads[k][1] for k, _ in chosen)

    def run(self, tasks: Sequence[Task], bench: Bench, stop: Stop) -> list[Outcome | None]:
        """The outcome of every task, None for one that has to be made by itself to tell what is wrong with it; fewer
        outcomes where `stop` was set. All tasks set the same names."""
        outcomes: list[Outcome | None] = []
        for _, group in groupby(tasks, key=_form):
            alike = list(group)
            for first in range(0, len(alike), self._most):
                outcomes += self._run(alike[first : first + self._most], bench, stop)
                if stop.is_set:
                    return outcomes
        return outcomes

    def _run(self, tasks: Sequence[Task], bench: Bench, stop: Stop) -> list[Outcome | None]:
        p, tellable = self._parameters(tasks)
        known = [k for k, task in enumerate(tasks) if tellable[k] and self._has_inputs(task)]
        outcomes: list[Outcome | None] = [None] * len(tasks)
        if not known:
            return outcomes
        with self._lock:
            told = self._settings([tasks[k] for k in known], p[known])
            model = self._engine.native
        if told is None:
            return outcomes
        settings, inputs = told
        words = FailureWords(self._flat, self._engine.layout, settings, inputs)
        made = bench.run(model, self._engine.layout, settings, stop, words.hear)
        if made is None:
            return []
        well = made.went_well
        rows, known_outputs = made.rows[:, :, self._columns], self._has_known_outputs(made.rows)
        for row in np.flatnonzero(~well | (made.kept == 0) | self._near(settings, made.rows[:, 0])).tolist():
            index = tasks[known[row]].index
            message: str | None = None
            ended: float | None = float(made.ended[row])
            if well[row]:
                message = words.wrong(made.p[row])
                ended = ended if message is None else None
                if message is None and not known_outputs[row]:
                    message = self._unknown_output(made.rows[row, : made.kept[row]], made.p[row], partial(inputs, row))
            elif row in words.told:
                message, ended = words.told[row]
            else:
                continue
            outcomes[known[row]] = (
                failed(index, message or "")
                if ended is None
                else self._outcome(index, message, ended, rows[row, : made.kept[row]])
            )
        return outcomes

    def _outcome(self, index: int, message: str | None, ended: float, values: Floats) -> Outcome:
        return Outcome(
            index=index,
            status="ok" if message is None else "failed",
            ended=ended,
            message=message or "",
            names=self._names,
            units=self._units,
            values=values,
        )

    def _has_known_outputs(self, rows: Floats) -> Flags:
        """True of runs of rows (runs, count, width) whose outputs are numbers in all of them, those that are not kept
        too."""
        return np.asarray(np.isfinite(rows[:, :, rows.shape[2] - len(self._flat.outputs) :]).all(axis=(1, 2)))

    def _near(self, settings: EnsembleSettings, first: Floats) -> Flags:
        """True of runs (runs,) whose first row (runs, width) is not so far from the start values that the search for
        the start may have run away (E0802), which a run that is made by itself tells."""
        n = len(self._flat.coordinates)
        with self._lock, np.errstate(all="ignore"):
            q = self._engine.evaluate_many("start", settings.t, settings.settings.p)[0]
        starts = np.where(settings.given[:n], settings.x[:, :n], q)
        farthest = FAR * settings.settings.measures.natural[:, :n]
        return np.asarray(np.all(np.abs(first[:, :n] - starts) <= farthest, axis=1))

    def worked(self, seconds: float, left: float) -> int:
        """So many seconds the last runs took, so many the others will: where that pays, the model is compiled. Returns
        how many runs go on together."""
        if not isinstance(self._engine, CEngine):
            return 1
        with self._lock:
            self._engine.worked(seconds, left)
            return self._engine.native.at_once

    def _parameters(self, tasks: Sequence[Task]) -> tuple[Floats, Flags]:
        """The vectors of parameters (runs, np), and True of those that the model allows: the first run is looked at by
        itself, of the others those that comparisons of what is changed do not settle."""
        layout = self._engine.layout
        p = np.tile(np.array(layout.defaults, dtype=np.float64), (len(tasks), 1))
        tellable = np.zeros(len(tasks), dtype=np.bool_)
        places = {slot.name: place for place, slot in enumerate(layout.parameters)}
        changed = {name: np.array([task.parameters[name] for task in tasks]) for name in tasks[0].parameters}
        if not changed.keys() <= places.keys() or any(values.dtype.kind not in "biuf" for values in changed.values()):
            return p, tellable  # each run tells that by itself
        for name, values in changed.items():
            p[:, places[name]] = values
        tellable[0] = self._allows(tasks[0])
        certain = np.broadcast_to(tellable[0] and certainly_within(self._flat, changed), len(tasks))
        for parameter in self._flat.parameters:
            if parameter.name in changed:
                certain = certain & certainly_allowed(parameter, changed[parameter.name])
        tellable |= certain
        for row in np.flatnonzero(~certain).tolist():
            tellable[row] = self._allows(tasks[row])
        return p, tellable

    def _allows(self, task: Task) -> bool:
        """True if the parameters are what the model allows."""
        try:
            values = parameters_of(self._flat, self._engine.layout, task.parameters)
        except (ValueError, TypeError):
            return False
        sink = Sink()
        check_limits(self._flat, values, sink)
        if not sink.diagnostics:
            span = (self._flat.experiment.start_time, self._options.stop)
            check_clocks(self._flat, values, span, MOST_STEPS, sink)
        return not sink.diagnostics

    def _has_inputs(self, task: Task) -> bool:
        """True if the inputs of the run that are numbers are what the model allows."""
        if not task.inputs:
            return True
        numbers = _numbers(task)
        items, sink = {item.name: item for item in self._flat.inputs}, Sink()
        return all(
            name in items and bool(np.isfinite(value)) and is_allowed(items[name], np.array([value]), None, sink)
            for name, value in numbers.items()
        )

    def _settings(
        self, tasks: Sequence[Task], p: Floats
    ) -> tuple[EnsembleSettings, Callable[[int, float], Floats]] | None:
        """Settings for C of runs whose inputs have one form, and the inputs (nu,) of a run at a time; None if each run
        must report errors of its options by itself."""
        flat, engine, options = self._flat, self._engine, self._options
        t0, sink = flat.experiment.start_time, Sink()
        with np.errstate(all="ignore"):
            q, _, _, u = engine.evaluate_many("start", t0, p)
        own = {**options.inputs, **tasks[0].inputs}
        inputs = signals(flat, u[0], own, (t0, options.stop), sink, speeds=engine.layout.speeds)
        places = places_of(flat)
        if sink.has_errors or inputs.tables is None or not all(name in places for name in tasks[0].start):
            return None
        u = np.where(given_inputs(flat, own), inputs.at(t0), u)
        columns = {item.name: k for k, item in enumerate(flat.inputs)}
        numbers = [_numbers(task) for task in tasks]
        for name in numbers[0]:
            u[:, columns[name]] = [each[name] for each in numbers]
        tables = None if inputs.constant else TabledInputs(u, inputs.tables)
        given = np.zeros(len(places), dtype=np.bool_)
        x = np.zeros((len(tasks), len(places)))
        for name in tasks[0].start:
            given[places[name]] = True
            x[:, places[name]] = [task.start[name] for task in tasks]
        settings = settings_of(
            flat,
            engine.layout,
            p,
            q,
            tables or u,
            t=t0,
            times=grid(t0, options.stop, options.interval),
            tolerance=options.tolerance,
            solver=options.solver,
            step=None,
        )
        told = EnsembleSettings(
            settings=settings,
            t=t0,
            stop=float(settings.times[-1]),
            breaks=tuple(b for b in inputs.breaks if b > t0),
            x=x,
            given=given,
            equations=bool(flat.initial_equations),
            first_piece=FIRST_STEPS,
            piece=STEPS,
            most_steps=MOST_STEPS,
        )
        return told, lambda run, t: np.where(inputs.following, inputs.at(t), u[run])

    def _unknown_output(self, rows: Floats, p: Floats, u: Callable[[float], Floats]) -> str | None:
        """Words for the first output that is no number; the motion itself goes on."""
        values, sink = rows[:, rows.shape[1] - len(self._flat.outputs) :], Sink()
        times = grid(self._flat.experiment.start_time, self._options.stop, self._options.interval)[: len(values)]
        size = 2 * len(self._flat.coordinates) + len(self._flat.states)
        with self._lock:
            unknown = self._unknown.first(values, times, lambda row: (rows[row, :size], u(float(times[row])), p))
        if unknown is None:
            return None
        self._unknown.report(unknown[1], float(times[unknown[0]]), float(values[unknown]), sink)
        return first_error(sink.diagnostics)


def _numbers(task: Task) -> dict[str, float]:
    """The inputs of the run that are numbers."""
    return {name: float(signal) for name, signal in task.inputs.items() if isinstance(signal, (int, float))}


def _form(task: Task) -> tuple[tuple[str, int | None], ...]:
    """Equal for runs whose own inputs have the same names and the same tables: one call of C can make them."""
    if not task.inputs:
        return ()
    numbers = _numbers(task)
    return tuple((name, None if name in numbers else id(signal)) for name, signal in task.inputs.items())
