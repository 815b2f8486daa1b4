"""A motion by steps."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import isfinite
from time import perf_counter
from typing import Any, NoReturn

import numpy as np

from lagdsl.engines.runtime.engines.auto_engine import AutoEngine
from lagdsl.engines.runtime.held_inputs import HeldInputs
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.run import Run
from lagdsl.engines.runtime.structures import Status
from lagdsl.foundation.diagnostics import Sink, refused
from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.motion.sessions.opening import Method, Opening
from lagdsl.motion.sessions.saved import packed, unpacked
from lagdsl.motion.signals.moved import MovedRow
from lagdsl.motion.signals.trajectory import Event, Statistics, Trajectory
from lagdsl.motion.simulate.commands import Command
from lagdsl.motion.simulate.control import seconds
from lagdsl.motion.simulate.derivatives import report_no_derivative, tell_one_sided
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.messages import Course, report_fault
from lagdsl.motion.simulate.present import Present
from lagdsl.motion.simulate.state_words import state_values, time_text
from lagdsl.motion.simulate.stepping import MOST_STEPS, STEPS
from lagdsl.motion.simulate.table import differentiated, events_of, recorded_by, trajectory


@record(kw_only=True)
class _Given:
    """A session as it was made: start values and parameters beside those of all, by name; inputs u (nu,) at the start;
    whether it keeps its motion."""

    start: Mapping[str, Any]
    parameters: Mapping[str, Any]
    u: Floats
    record: bool


@record()
class _End:
    """Why a session does not go on."""

    why: str
    failed: bool = True


class Session(Present):
    """A motion that goes on as its caller says: `step`, `advance`, `reset`; `save` and `restore`.

    `session["theta"]` is the present value of a variable or an output, `session.t` the time, `events` is what has
    happened and `motion` the rows so far. Inputs are held over a step and jump where the next one begins, unless a
    signal tells them. Not to be used by several threads at once.
    """

    def __init__(
        self,
        opening: Opening,
        *,
        record: bool,
        u: Floats | None = None,
        start: Mapping[str, Any] | None = None,
        parameters: Mapping[str, Any] | None = None,
    ) -> None:
        """`u` (nu,) is the place of the inputs; `start` and `parameters` are beside those of the opening."""
        super().__init__(opening.places)
        held = opening.signals.held(opening.t0)
        if u is not None:
            u[:] = held.u
            held = held.beside(u)
        self._opening, self._library = opening, runtime_library()
        self._given = _Given(start=start or {}, parameters=parameters or {}, u=held.u.copy(), record=record)
        self._end: _End | None = None
        self._first: tuple[bytes, list[tuple[float, str, int]]] | None = None
        self._begin(held, {}, {})
        self._first = (b"" if self._end else self.save(), list(self._run.results.notes))

    def _begin(self, held: HeldInputs, parameters: Mapping[str, Any], start: Mapping[str, Any]) -> None:
        opening, given = self._opening, self._given
        p = opening.parameters({**given.parameters, **parameters})
        starts = opening.starts({**given.start, **start})
        held.u[:] = given.u
        self._attach(self._renewed(p) or opening.run(p, held, opening.asked.method), held, opening.asked.method, ())
        self._end = _End("no start was found")
        initial = opening.start(self._run, held, starts)
        self._made, self._end = (opening.asked.method, initial.moved), None
        status = self._run.begin(opening.t0, initial.x)
        self.finish(status)
        if status is Status.OK:
            self._library.hold_to(self._address, opening.t0, 0)

    def _renewed(self, p: Floats) -> Run | None:
        """The present run, to begin anew with the parameters p (np,), where it was made with these."""
        if self._first is None or self._made[0] != self._opening.asked.method:
            return None
        again = np.array_equal(self._run.settings.p, p) and self._run.settings.inputs is self._held
        return self._run if again and self._run.renew() else None

    def _attach(self, run: Run, held: HeldInputs, method: Method, moved: tuple[MovedRow, ...]) -> None:
        """The session is this run from now on."""
        self._run, self._made = run, (method, moved)
        self._address = held.address
        held.begin(run.address, self._opening.t0)
        held.hold.rows = run.results.keeps = self._given.record
        self._told: list[Event] = []
        self._end = None
        engine = self._opening.asked.engine
        going_over = isinstance(engine, AutoEngine) and not (engine.is_compiled and engine.native is run.model)
        self._auto = engine if isinstance(engine, AutoEngine) and going_over else None
        self.watch(run, held)

    # ---- on it goes --------------------------------------------------------------------------------------------------

    def step(self, h: float | str, u: Command | None = None) -> None:
        """On by h (seconds, or a text such as `2 ms`), with the inputs u from its beginning on; without u they stay.

        u has all that a step can set in the order of `model.inputs`, is one number, or has some by name. Events are
        found where they happen within the step. Raises CallRefused for what does not fit, SimulationFailed where the
        motion cannot go on, with the motion so far.
        """
        if type(h) is not float or not 0.0 < h < 1e300:
            h = seconds("the step", h)
        self._go(self._library.hold_step, h, h, u)

    def advance(self, until: float | str, u: Command | None = None) -> None:
        """On to the time `until` [s], otherwise as `step`. At that time nothing moves; u counts from there on."""
        target = until if type(until) is float and isfinite(until) else self._time(until)
        if not target >= self.t:
            raise refused("E0890", time=time_text(self.t), asked=time_text(target))
        if target > self.t:
            self._go(self._library.hold_to, target, target - self.t, u)
        elif u is not None:
            self._opening.commands.put(u, self._held.u, self._opening.sink)

    def _go(self, call: Callable[[int, float, int], int], amount: float, h: float, u: Command | None) -> None:
        held = self._held
        if self._end is not None:
            raise refused("E0892", time=time_text(self.t), why=self._end.why)
        if held.hold.goal + h > self._opening.last:
            raise self._opening.beyond()
        if u is not None:
            self._opening.commands.put(u, held.u, self._opening.sink)
        self.forget()
        status = call(self._address, amount, STEPS) if self._auto is None else self._timed(call, amount)
        if status:
            self._rest(status)

    def _timed(self, call: Callable[[int, float, int], int], amount: float) -> int:
        """The same while the engine has not decided for C."""
        assert self._auto is not None
        started = perf_counter()
        status = call(self._address, amount, STEPS)
        self._auto.worked(perf_counter() - started)
        self.hasten()
        return status

    def hasten(self) -> None:
        """Goes on in C where there is C by now; the motion is the same to the bit."""
        if self._auto is not None:
            self._auto.hasten()
            if self._auto.is_compiled:
                self._run.change(self._auto.native)
                self._auto = None

    def _rest(self, status: int) -> None:
        """The rest of a step that took more than one call, and its end."""
        steps = STEPS
        while status == Status.TOO_LONG and steps < MOST_STEPS:
            status = self._library.hold_go(self._address, STEPS)
            steps += STEPS
        self.finish(Status(status))

    def forget(self) -> None:
        """A step begins: the present is no longer known, nor, without a record, what happened before."""
        self.moved()
        if not self._given.record and self._run.results.notes:
            self._run.results.forget_notes()

    def finish(self, status: Status) -> None:
        """A step has ended like this. Raises SimulationFailed where the motion cannot go on."""
        self.moved()
        problem = self._held.called.problem if self._held.called is not None else None
        if problem is not None:
            self._stay(_End(f"an input raised {type(problem).__name__}: {problem}"))
            raise problem
        if status is Status.STOPPED:
            self._stay(_End(f"`terminate` acted: {self.events[-1].name}", failed=False))
        elif status is not Status.OK:
            self._fail(status)

    def _stay(self, end: _End) -> None:
        self._end = end
        self._held.hold.goal = self._run.t

    def _fail(self, status: Status) -> NoReturn:
        asked, run = self._opening.asked, self._run
        course = Course(asked.flat, asked.engine.layout, run, self._held.hold.goal, MOST_STEPS)
        fault, sink = run.explain(status), Sink()
        signals = self._opening.signals
        u = np.where(signals.following, signals.at(fault.t), self._held.u) if len(self._held.u) else self._held.u
        if status in (Status.GRAZING, Status.NOT_SMOOTH):
            name: str | None = report_no_derivative(asked.flat, run, status, asked.tangents, sink)
        else:
            name = report_fault(course, status, fault, u, sink)
        told = sink.diagnostics[-1]
        self._stay(_End(told.message))
        motion = asked.words.motion(self._so_far())
        raise SimulationFailed(told, fault.t, state_values(asked.flat, fault.x), name, motion)

    # ---- what has become of it ---------------------------------------------------------------------------------------

    @property
    def address(self) -> int:
        """Of its lag_hold."""
        return self._address

    @property
    def width(self) -> int:
        """Numbers of a row of the runtime."""
        return int(self._run.results.width)

    @property
    def ended(self) -> bool:
        """True where a `terminate` has acted or the motion has failed: then it does not go on."""
        return self._end is not None

    @property
    def failure(self) -> str:
        """Why the motion failed; empty where it did not."""
        return self._end.why if self._end is not None and self._end.failed else ""

    @property
    def events(self) -> tuple[Event, ...]:
        """Everything that has happened since the beginning, as in a trajectory; with record=False in the last step."""
        results, asked = self._run.results, self._opening.asked
        results.take()
        known = len(self._told) if self._given.record else 0
        told = events_of(asked.flat, asked.engine.layout, results.notes[known:])
        if asked.tangents:
            told = differentiated(told, asked.tangents, results.derivatives().times()[known:])
        self._told = [*self._told[:known], *told]
        return tuple(self._told)

    @property
    def motion(self) -> Trajectory:
        """The motion so far: a row at the end of each step, two at each event. Raises CallRefused where the session
        keeps none."""
        if not self._given.record:
            raise refused("E0895")
        return self._opening.asked.words.motion(self._so_far())

    def _so_far(self) -> Trajectory:
        run, report = self._run, self._run.report
        run.results.take()
        automatic = "radau" if report.implicit else "dop853"
        statistics = Statistics(
            solver=automatic if self._made[0].solver == "auto" else self._made[0].solver,
            steps=report.counts.steps,
            evaluations=report.counts.evaluations,
            jacobians=report.counts.jacobians,
            projections=report.projections,
        )
        asked = self._opening.asked
        recorded = recorded_by(asked.flat, run, asked.tangents)
        return trajectory(asked.flat, asked.engine.layout, recorded, self._made[1], statistics)

    def derivative(self, of: str, by: str) -> float:
        """Of the present value of the variable or output `of`, at this time, by a quantity that `tangents` named, in SI
        units. Raises UnknownName, and CallRefused (E0884) for a session without `tangents`."""
        return float(self.jacobian([of])[0, self._number(by)])

    def jacobian(self, of: Sequence[str]) -> Floats:
        """(variables, tangents): of several present values by all quantities, likewise."""
        asked, found = self._opening.asked, self._run.results.sensitivities
        if found is None:
            raise refused("E0884", text='a session with `tangents`, such as `model.session(tangents=["m"])`')
        places = [self._opening.places.of(name) for name in of]
        tell_one_sided(self._run, self._opening.sink)
        for name, place in zip(of, places, strict=True):
            if not isinstance(place, int):
                raise unknown_among("variable", name, self._opening.places.names)
        row = found.present(self._run.address)
        time = np.zeros((len(asked.tangents), 1))  # does not change
        return np.concatenate([time, row], axis=1)[:, places].T

    def _number(self, by: str) -> int:
        names = self._opening.asked.tangents
        if names and by not in names:
            raise unknown_among("quantity of `tangents`", by, list(names))
        return names.index(by) if names else 0

    # ---- back and again ----------------------------------------------------------------------------------------------

    def reset(self, *, start: Mapping[str, Any] | None = None, parameters: Mapping[str, Any] | None = None) -> None:
        """Begins again as the session did, with some start values and parameters beside those that it was made with.
        Raises as `Model.session`; where there is no such start, the session has ended."""
        if not start and not parameters and self._first is not None and self._first[0]:
            self.restore(self._first[0])
            self._run.results.notes = list(self._first[1])
            return
        self._begin(self._usable(), parameters or {}, start or {})

    def _usable(self) -> HeldInputs:
        """The inputs, made anew where a function of Python among them has raised."""
        called = self._held.called
        return self._held if called is None or called.problem is None else self._held.beside(self._held.u)

    def save(self) -> bytes:
        """The present state, from which this session or another one of the same model goes on to the bit, in any
        process. Signals are not in it. Raises CallRefused where the session has ended."""
        if self._end is not None:
            raise refused("E0892", time=time_text(self.t), why=self._end.why)
        return packed(self._opening, self._made[0], self._run, self._held)

    def restore(self, state: bytes) -> None:
        """Goes back to a state that was saved, with its inputs, parameters and tolerance; events and rows begin there.
        Raises CallRefused for anything else; the session is then as before."""
        opening, layout = self._opening, self._opening.asked.engine.layout
        sizes = len(layout.parameters), len(layout.inputs), len(layout.invariants)
        saved = unpacked(opening, state, sizes)
        run, held = self._run, self._usable()
        if saved.method != self._made[0] or not np.array_equal(saved.p, run.p) or held is not self._held:
            held = held.beside(held.u)
            run = opening.run(saved.p, held, saved.method)
        status = run.load(saved.run)
        if status is not Status.OK:
            raise refused("E0891", why="the runtime does not know them", way="save the state again")
        held.u[:] = saved.u
        run.results.forget()
        opening.columns(run, saved.columns)
        run.results.drifts[:] = saved.drifts
        self._attach(run, held, saved.method, self._made[1])
        held.before[:] = saved.before
        held.hold.goal = run.t
        held.hold.jumped = saved.jumped
        run.results.structure.after = saved.after
        self._library.hold_to(self._address, run.t, 0)

    # ---- arguments ---------------------------------------------------------------------------------------------------

    def _time(self, given: float | str) -> float:
        if isinstance(given, str):
            return seconds("the time", given)
        try:
            value = float(given)
        except (TypeError, ValueError):
            value = np.nan
        if not isfinite(value):
            raise refused("E0896", what="the time", expected="a time", given=str(given)[:40])
        return value
