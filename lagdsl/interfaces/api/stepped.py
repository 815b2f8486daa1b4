"""Motions of a model by steps."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from numpy.typing import ArrayLike

from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.api.inputs.values import signals_of
from lagdsl.interfaces.api.names import Value, listed, number
from lagdsl.interfaces.api.small_motions import SmallMotions
from lagdsl.interfaces.api.unknowns import with_starts
from lagdsl.language.settings.aliases import by_own_names

if TYPE_CHECKING:
    from lagdsl.motion.sessions.many import Sessions
    from lagdsl.motion.sessions.opening import Opening
    from lagdsl.motion.sessions.session import Session
    from lagdsl.motion.signals.inputs import Signal

# The arguments `tolerance`, `solver` and `step`.
_Options: TypeAlias = "tuple[float | None, str, float | None]"


class Stepped(SmallMotions):
    """A model whose motion goes on step by step."""

    @with_starts
    def session(
        self,
        *,
        start: Mapping[str, Value] | None = None,
        parameters: Mapping[str, Value] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        tolerance: float | None = None,
        solver: str = "auto",
        step: float | None = None,
        record: bool = True,
        tangents: Sequence[str] | str = (),
        sink: Sink | None = None,
    ) -> Session:
        """The motion in your hands: `run = model.session()`, then `run.step(0.002, u=...)`, `run["theta"]`, `run.t`,
        `run.events`, `run.motion`, `run.save()`, `run.restore(state)`, `run.reset()`.

        Arguments are those of `simulate`; `inputs` are those at the start, which steps change, and signals that follow
        time. With record=False it keeps neither rows nor the events of earlier steps, so that it may go on for ever.
        `run.derivative("theta", "l")` is that of the present value by what `tangents` names. Warnings go to `sink`.
        Raises CompilationFailed before the first step, CallRefused for an engine without sessions; KeyError,
        ValueError.
        """
        from lagdsl.motion.sessions.session import Session

        opening = self._opening(start or {}, parameters or {}, inputs, (tolerance, solver, step), tangents, sink)
        return Session(opening, record=record)

    @with_starts
    def sessions(
        self,
        count: int,
        *,
        start: Mapping[str, ArrayLike] | None = None,
        parameters: Mapping[str, ArrayLike] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        tolerance: float | None = None,
        solver: str = "auto",
        step: float | None = None,
        threads: int | None = None,
        tangents: Sequence[str] | str = (),
        sink: Sink | None = None,
    ) -> Sessions:
        """So many motions by steps, which one call moves, on all cores: `runs = model.sessions(1000)`, then
        `runs.step(0.02, u=forces)`, `runs["theta"]` (count,), `runs.reset(runs.ended)`.

        Values are numbers for all, or sequences with one for each session; the rest is as for `session`. Functions of
        Python among `inputs` are called by one thread. Raises as `session`.
        """
        from lagdsl.engines.runtime.engines.cores import cores
        from lagdsl.motion.sessions.many import Sessions, spread

        if count < 1 or (threads is not None and threads < 1):
            raise ValueError(f"count and threads must be at least 1, not {count} and {threads}")
        opening = self._opening({}, {}, inputs, (tolerance, solver, step), tangents, sink)
        words = opening.asked.words
        starts = spread(words.starts(start or {}), count)
        own = spread(words.many_parameters(parameters or {}), count)
        single = opening.signals.is_called
        return Sessions(opening, starts, own, 1 if single else cores() if threads is None else threads)

    def _opening(
        self,
        start: Mapping[str, Any],
        parameters: Mapping[str, Any],
        inputs: Mapping[str, Signal | str] | Path | str | None,
        options: _Options,
        tangents: Sequence[str] | str,
        sink: Sink | None,
    ) -> Opening:
        """The common part of all sessions of one call."""
        from lagdsl.interfaces.api.motions import values_of_runs
        from lagdsl.interfaces.api.trajectory import Trajectory
        from lagdsl.motion.sessions.opening import Asked, Method, Opening, Words

        flat = self._compilation.flat
        tolerance, solver, step = options
        words = Words(
            parameters=self._parameter_vector,
            start=self._start_values,
            many_parameters=lambda given: values_of_runs("parameter", given, self._named("parameter")),
            starts=lambda given: values_of_runs("start value", by_own_names(flat, given), self._named("start")),
            input=self._input_value,
            motion=Trajectory.of,
        )
        asked = Asked(
            flat=flat,
            program=self._compilation.program,
            engine=self._engine,
            words=words,
            method=Method(
                tolerance=flat.experiment.tolerance if tolerance is None else float(tolerance), solver=solver, step=step
            ),
            start=start,
            parameters=parameters,
            tangents=tuple(listed(tangents)),
        )
        return Opening(asked, signals_of(flat, inputs), Sink() if sink is None else sink)

    def _input_value(self, name: str, value: object) -> float:
        """In SI units. Raises ValueError."""
        return number(self._named("input")[name], value)
