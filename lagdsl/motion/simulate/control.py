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
from lagdsl.motion.simulate.present import Places, Present


@record()
class Control:
    """`function` is called every `every` [s] with the present of the motion; it returns the inputs from then on."""

    every: float
    function: Callable[[Present], Command | None]


def control(every: float | str, function: Callable[[Present], Command | None]) -> Control:
    """A controller: at the start and every `every` (seconds, or a text such as `2 ms`) `function(present)` returns the
    inputs that are held up to the next call: all in the order of the model, one number, some by name, or None to
    change nothing. `present["theta"]` is a value, `present.t` the time [s]. Raises CallRefused."""
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
        self._values: list[Floats] = []

    def instants(self) -> list[tuple[float, list[int]]]:
        """The instants at which some act, with the numbers of these."""
        found: dict[float, list[int]] = {}
        for t, number in merge(*self._calls):
            found.setdefault(t, []).append(number)
        return list(found.items())

    def act(self, numbers: Sequence[int], run: Run, sink: Sink) -> None:
        """The inputs of the run from now on."""
        held, t = run.settings.inputs, run.t
        assert isinstance(held, HeldInputs), "a controlled run holds its inputs"
        k = bisect_right(self._times, t)
        if k == 0 or self._times[k - 1] != t:
            present = Present(self._places)
            present.watch(run, held)
            held.hold.goal = t
            for number in numbers:
                given = self._functions[number](present)
                if given is not None:
                    self._commands.put(given, held.u, sink)
            self._times.append(t)
            self._values.append(held.u.copy())
            k = len(self._times)
        held.u[:] = self._values[k - 1]

    def at(self, t: float, u: Floats) -> Floats:
        """The inputs of a row at time t [s], where those that follow time are as in u (nu,)."""
        k = bisect_left(self._times, t)
        return u if k == 0 else np.where(self._signals.following, u, self._values[k - 1])


def _instants(given: Control, span: tuple[float, float], number: int) -> list[tuple[float, int]]:
    """From the start to before the end."""
    count = max(int(np.ceil((span[1] - span[0]) / given.every)), 1)
    return [(t, number) for t in equidistant(span[0], given.every, count).tolist() if t < span[1]]
