"""Controllers in Python: functions that are called at equidistant instants and set inputs, held in between."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Sequence
from heapq import merge
from math import isfinite

import numpy as np

from lagdsl.engines.runtime.held_inputs import HeldInputs
from lagdsl.engines.runtime.run import Run
from lagdsl.foundation.diagnostics import Sink, refused
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import TIME
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.failure import SettingError
from lagdsl.language.settings.literal import literal
from lagdsl.motion.signals.inputs import Signals
from lagdsl.motion.simulate.commands import Command, Commands
from lagdsl.motion.simulate.instants import equidistant
from lagdsl.motion.simulate.law import differences
from lagdsl.motion.simulate.present import Places, Present


@record()
class Control:
    """`function` is called every `every` [s] with the present of the motion; it returns the inputs from then on."""

    every: float
    function: Callable[[Present], Command | None]


def control(every: float | str, function: Callable[[Present], Command | None]) -> Control:
    """A controller: at the start and every `every` (seconds, or a text such as `2 ms`) `function(present)` returns the
    inputs that are held up to the next call: all in the order of the model, one number, some by name, or None to
    change nothing. `present["theta"]` is a value, `present.t` the time [s]. A motion with `tangents` asks it several
    times at an instant, also beside the present. Raises CallRefused."""
    if not callable(function):
        raise refused("E0893", why="`function` is no function", way="give a function of the present: `lambda now: ...`")
    return Control(seconds("`every`", every), function)


def seconds(what: str, given: float | str) -> float:
    """A positive time [s]. Raises CallRefused (E0896)."""
    try:
        value = _time_of(given) if isinstance(given, str) else float(given)
    except (SettingError, TypeError, ValueError):
        value = float("nan")
    if not (isfinite(value) and value > 0.0):
        raise refused("E0896", what=what, expected="a positive time", given=str(given)[:40])
    return value


def _time_of(text: str) -> float:
    found = literal("time", text)
    if found.dimension not in (TIME, None):
        raise SettingError("no time")
    return found.value


@record()
class _Given:
    """Inputs from an instant on, u (nu,), and their derivatives (count, nu) where the motion has some."""

    u: Floats
    derivatives: Floats


class Controls:
    """Controllers of one motion. The inputs that they gave are kept: the same motion with other rows does
    not ask them again."""

    def __init__(
        self, every: Sequence[Control], flat: FlatModel, signals: Signals, commands: Commands, span: tuple[float, float]
    ) -> None:
        self._places, self._signals, self._commands = Places(flat), signals, commands
        self._calls = [_instants(each, span, number) for number, each in enumerate(every)]
        self._functions = [each.function for each in every]
        self._times: list[float] = []
        self._values: list[_Given] = []

    def instants(self) -> list[tuple[float, list[int]]]:
        """The instants at which some act, with the numbers of these."""
        found: dict[float, list[int]] = {}
        for t, number in merge(*self._calls):
            found.setdefault(t, []).append(number)
        return list(found.items())

    def act(self, numbers: Sequence[int], run: Run, sink: Sink) -> int | None:
        """The inputs of the run from now on, with their derivatives. Returns the number of the first quantity by which
        a law has none. Raises CallRefused (E0884) for a law that is no function of the present."""
        held, t = run.settings.inputs, run.t
        assert isinstance(held, HeldInputs), "a controlled run holds its inputs"
        k = bisect_right(self._times, t)
        if k == 0 or self._times[k - 1] != t:
            held.hold.goal = t
            laws = _Laws([self._functions[number] for number in numbers], self._places, self._commands, sink)
            present = Present(self._places)
            present.watch(run, held)
            u, none = laws.inputs(present, held.u), None
            derivatives = np.zeros((0, len(u)))
            if run.results.sensitivities is not None:
                before = self._values[k - 1].derivatives if k else np.zeros_like(run.results.sensitivities.of.u)
                derivatives, none = laws.derivatives(run, held, before, u)
            if none is not None:
                return none
            self._times.append(t)
            self._values.append(_Given(u, derivatives))
            k = len(self._times)
        held.u[:] = self._values[k - 1].u
        if run.results.sensitivities is not None:
            run.results.sensitivities.command(self._values[k - 1].derivatives + run.results.sensitivities.of.u)
        return None

    def at(self, t: float, u: Floats) -> Floats:
        """The inputs of a row at time t [s], where those that follow time are as in u (nu,)."""
        k = bisect_left(self._times, t)
        return u if k == 0 else np.where(self._signals.following, u, self._values[k - 1].u)


class _Laws:
    """Functions that act at one instant, one after the other."""

    def __init__(
        self,
        functions: Sequence[Callable[[Present], Command | None]],
        places: Places,
        commands: Commands,
        sink: Sink,
    ) -> None:
        self._functions, self._places, self._commands, self._sink = functions, places, commands, sink

    def inputs(self, present: Present, before: Floats) -> Floats:
        """u (nu,) in the place of those `before`."""
        u = before.copy()
        for function in self._functions:
            given = function(present)
            if given is not None:
                self._commands.put(given, u, self._sink)
        return u

    def derivatives(self, run: Run, held: HeldInputs, before: Floats, u: Floats) -> tuple[Floats, int | None]:
        """Derivatives (count, nu) of u (nu,), which the laws made of the present, where inputs had those `before`; and
        the number of the first quantity by which there is none."""
        assert run.results.sensitivities is not None, "nobody asked for derivatives"
        columns = run.results.sensitivities.present(run.address)
        present = Present(self._places)
        present.watch(run, held)
        row = np.array(present.values())
        place, width = len(row), columns.shape[1]

        def law(values: Floats) -> Floats:
            present.imagine(values[:place].tolist())
            return self.inputs(present, values[place:])

        here = np.concatenate([row, held.u])
        found = np.zeros_like(before)
        for k, column in enumerate(columns):
            along = np.concatenate([[0.0], column, np.zeros(place - 1 - width), before[k]])
            derivative = differences(law, here, along)
            if derivative is None:
                return found, k
            found[k] = derivative
        if not np.array_equal(law(here), u):
            raise refused("E0884", text="controllers that compute inputs from the present alone")
        return found, None


def _instants(given: Control, span: tuple[float, float], number: int) -> list[tuple[float, int]]:
    """From the start to before the end."""
    count = max(int(np.ceil((span[1] - span[0]) / given.every)), 1)
    return [(t, number) for t in equidistant(span[0], given.every, count).tolist() if t < span[1]]
