"""The common beginning of sessions of a model."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.derivation.program.digest import digest
from lagdsl.derivation.program.program import Program
from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.engines.runtime.held_inputs import HeldInputs
from lagdsl.engines.runtime.run import Run
from lagdsl.engines.runtime.run_sensitivities import Directions
from lagdsl.foundation.diagnostics import CallRefused, Sink, refused
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.limits import check_clocks, check_limits
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.signals.inputs import Signal, Signals, signals
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.commands import Commands
from lagdsl.motion.simulate.derivatives import check_differentiable, differentiate, directions_of
from lagdsl.motion.simulate.initialize import InitialState, find_start
from lagdsl.motion.simulate.placed import placed
from lagdsl.motion.simulate.present import Places
from lagdsl.motion.simulate.simulate import check_options
from lagdsl.motion.simulate.stepping import MOST_STEPS


@record(kw_only=True)
class Words:
    """Values of callers as numbers in SI units by the names of the model: parameters p (np,), start values, those of
    many sessions, the value of an input; and a motion as callers see it."""

    parameters: Callable[[Mapping[str, Any]], Floats]
    start: Callable[[Mapping[str, Any]], dict[str, float]]
    many_parameters: Callable[[Mapping[str, Any]], dict[str, ArrayLike]]
    starts: Callable[[Mapping[str, Any]], dict[str, ArrayLike]]
    input: Callable[[str, object], float]
    motion: Callable[[Trajectory], Trajectory]


@record(kw_only=True)
class Method:
    """The way in which a session integrates: the arguments of `simulate`."""

    tolerance: float
    solver: str
    step: float | None


@record(kw_only=True)
class Asked:
    """A session before its start: `start` and `parameters` as they were given, by name; `tangents` are what it is
    differentiated by."""

    flat: FlatModel
    program: Program
    engine: Engine
    words: Words
    method: Method
    start: Mapping[str, Any]
    parameters: Mapping[str, Any]
    tangents: tuple[str, ...] = ()


class Opening:
    """Everything that the sessions of one call share. Raises CallRefused (E0894) for an engine without sessions,
    CompilationFailed for inputs that do not fit, ValueError for a bad option."""

    def __init__(self, asked: Asked, inputs: Mapping[str, Signal], sink: Sink) -> None:
        self.asked, self.sink = asked, sink
        flat, engine = asked.flat, asked.engine
        if engine.name == "numpy":
            raise refused("E0894", engine=engine.name)
        self.t0 = flat.experiment.start_time
        method = asked.method
        if asked.tangents:
            check_differentiable(flat, engine.layout, asked.tangents)
        length = max(1.0, 1e3 * (method.step or 0.0))  # a session has no end
        check_options(self.t0, self.t0 + length, method.tolerance, method.solver, method.step)
        defaults = engine.evaluate("start", self.t0, asked.words.parameters(asked.parameters))[3]
        span, own = (self.t0, np.inf), Sink()
        speeds = engine.layout.speeds
        self.signals: Signals = signals(flat, defaults, inputs, span, own, speeds=speeds, covered=self.t0)
        _tell(own, sink)
        self.last = self.signals.last  # tables are not continued beyond
        self.commands = Commands(flat, self.signals.following, speeds, asked.words.input)
        self.places = Places(flat)

    def beyond(self) -> CallRefused:
        """The exception for a step beyond the end of a table."""
        return refused("E0893", why=f"a table in `inputs` ends at {self.last:g} s", way="add rows to the table")

    @cached_property
    def digest(self) -> str:
        return digest(self.asked.program)

    @property
    def arithmetic(self) -> str:
        """Engines of the same name round alike: `auto` computes as the tape, whatever it computes with."""
        return "c" if self.asked.engine.name == "c" else "tape"

    @cached_property
    def _own_parameters(self) -> Floats:
        return self._checked({})

    def parameters(self, more: Mapping[str, Any]) -> Floats:
        """p (np,) with `more` beside what the session was made with. Raises CompilationFailed where a limit does not
        hold."""
        return self._checked(more) if more else self._own_parameters.copy()

    def _checked(self, more: Mapping[str, Any]) -> Floats:
        asked, own = self.asked, Sink()
        p = asked.words.parameters({**asked.parameters, **more})
        values = dict(zip((slot.name for slot in asked.engine.layout.parameters), p.tolist(), strict=True))
        check_limits(asked.flat, values, own)
        own.raise_if_errors()
        check_clocks(asked.flat, values, (self.t0, asked.flat.experiment.stop_time), MOST_STEPS, own)
        _tell(own, self.sink)
        return p

    @cached_property
    def _directions(self) -> Directions:
        return directions_of(self.asked.flat, self.asked.engine, self.asked.tangents)

    def run(self, p: Floats, held: HeldInputs, method: Method) -> Run:
        """A run that has not begun."""
        asked = self.asked
        run = placed(
            asked.flat,
            asked.engine,
            p,
            held,
            t0=self.t0,
            tolerance=method.tolerance,
            solver=method.solver,
            step=method.step,
        )
        run.results.structure.extremes = None  # a step would pay for them
        return run

    def starts(self, more: Mapping[str, Any]) -> dict[str, float]:
        """Start values in SI units, with `more` beside what the sessions were made with. Raises UnknownName."""
        return self.asked.words.start({**self.asked.start, **more})

    def start(self, run: Run, held: HeldInputs, starts: dict[str, float]) -> InitialState:
        """The consistent start. Raises CompilationFailed."""
        asked, own = self.asked, Sink()
        u = np.where(self.signals.following, self.signals.at(self.t0), held.u) if len(held.u) else held.u
        found = find_start(asked.flat, asked.engine, run, self.t0, u, starts, own)
        _tell(own, self.sink)
        if asked.tangents:
            differentiate(asked.flat, run, found, starts, asked.tangents, self._directions)
        return found

    def columns(self, run: Run, saved: bytes) -> None:
        """Lets the run, which has the state of another one, go on with the columns of that one."""
        if self.asked.tangents:
            run.results.differentiate(run.model, self._directions).load(saved)


def _tell(own: Sink, sink: Sink) -> None:
    """Errors are raised, everything else goes on to `sink`."""
    own.raise_if_errors()
    for diagnostic in own.diagnostics:
        sink.add(diagnostic)
