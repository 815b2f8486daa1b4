"""Many motions of one model by steps: one call moves them all."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from time import perf_counter
from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.diagnostics import refused
from lagdsl.numerics.rank import Floats
from lagdsl.runtime.engines.auto_engine import AutoEngine
from lagdsl.runtime.library import runtime_library
from lagdsl.runtime.structures import Status
from lagdsl.sessions.opening import Opening
from lagdsl.sessions.session import Session
from lagdsl.simulate.commands import Command
from lagdsl.simulate.control import seconds
from lagdsl.simulate.failure import SimulationFailed
from lagdsl.simulate.motion import MOST_STEPS, STEPS

# Fewer runs than this in one thread are not worth the time that it takes to wake it.
_FEWEST = 32


class Sessions(Sequence[Session]):
    """Motions of one model that go on together. `sessions["theta"]` has the present value of each, shape (runs,), that
    of an array (runs, elements); `sessions[3]` is one of them as a `Session`.

    A session whose motion has ended, by a `terminate` or a failure, stays where it is while the others go on: `ended`
    (runs,) flags it, `failures` says why by its number, and `reset` lets it begin again.
    """

    def __init__(
        self,
        opening: Opening,
        starts: Sequence[Mapping[str, Any]],
        parameters: Sequence[Mapping[str, Any]],
        threads: int,
    ) -> None:
        self._opening, self._threads = opening, threads
        self._u = np.zeros((len(starts), len(opening.asked.flat.inputs)))
        self._sessions = [
            Session(opening, record=False, u=u, start=start, parameters=own)
            for u, start, own in zip(self._u, starts, parameters, strict=True)
        ]
        self._library = runtime_library()
        self._status = np.zeros(len(starts), dtype=np.intc)
        self._addresses = np.zeros(len(starts), dtype=np.uintp)
        self.failures: dict[int, str] = {}
        for k in range(len(starts)):
            self._renew(k)

    def _renew(self, k: int) -> None:
        """Session k has begun again."""
        session = self._sessions[k]
        self._addresses[k] = session.address
        self._status[k] = Status.STOPPED if session.ended else Status.OK
        self.failures.pop(k, None)
        self._known: dict[str, Floats] = {}

    # ---- on they go --------------------------------------------------------------------------------------------------

    def step(self, h: float | str, u: Command | None = None) -> None:
        """All on by h (seconds, or a text such as `2 ms`), with the inputs u from its beginning on: (runs, inputs),
        (inputs,) for all alike, (runs,) where there is one input, or by name a number or (runs,). Without u they stay.
        Raises CallRefused for what does not fit."""
        length = seconds("the step", h)
        self._go("step", length, float(np.max(self.t, initial=0.0)) + length, u)

    def advance(self, until: float | str, u: Command | None = None) -> None:
        """All on to the time `until` [s], otherwise as `step`."""
        target = seconds("the time", until)
        latest = float(np.max(self.t[~self.ended], initial=-np.inf))
        if target < latest:
            raise refused("E0890", time=f"{latest:.6g}", asked=f"{target:.6g}")
        self._go("to", target, target, u)

    def _go(self, what: str, amount: float, latest: float, u: Command | None) -> None:
        if latest > self._opening.last:
            raise self._opening.beyond()
        if u is not None:
            self._opening.commands.put_many(u, self._u, self._opening.sink)
        for session in self._sessions:
            session.forget()
        before = self._status.copy()
        self._known = {}
        started = perf_counter()
        self._each(f"holds_{what}", amount)
        for _ in range(MOST_STEPS // STEPS - 1):
            if not (self._status == Status.TOO_LONG).any():
                break
            self._each("holds_go")
        self._hasten(perf_counter() - started)
        for k in np.flatnonzero(self._status != before).tolist():
            self._end(k, Status(self._status[k]))

    def _hasten(self, seconds: float) -> None:
        """Work of so many seconds was done: where that pays, all go on in C as soon as there is C."""
        engine = self._opening.asked.engine
        if isinstance(engine, AutoEngine) and not engine.is_compiled:
            engine.worked(seconds)
            engine.hasten()
            if engine.is_compiled:
                for session in self._sessions:
                    session.hasten()

    def _each(self, name: str, *amount: float) -> None:
        """One function of C for all, in threads that share them."""
        function, count = getattr(self._library, name), len(self)
        parts = max(1, min(self._threads, count // _FEWEST))
        ends = [count * part // parts for part in range(parts + 1)]

        def work(part: int) -> None:
            first, end = ends[part], ends[part + 1]
            status = self._status.ctypes.data + self._status.itemsize * first
            holds = self._addresses.ctypes.data + self._addresses.itemsize * first
            function(holds, end - first, *amount, STEPS, status)

        others = [_workers(self._threads).submit(work, part) for part in range(1, parts)]
        work(0)
        for other in others:
            other.result()

    def _end(self, k: int, status: Status) -> None:
        try:
            self._sessions[k].finish(status)
        except SimulationFailed as failure:
            self.failures[k] = failure.diagnostic.message
        except Exception as problem:
            self.failures[k] = f"an input raised {type(problem).__name__}: {problem}"

    # ---- what has become of them -------------------------------------------------------------------------------------

    @property
    def t(self) -> Floats:
        """The time of each [s], (runs,)."""
        return self._states()[:, 0].copy()

    @property
    def ended(self) -> NDArray[np.bool_]:
        """True for each that does not go on, (runs,)."""
        return np.asarray(self._status != Status.OK)

    def __len__(self) -> int:
        return len(self._sessions)

    def __iter__(self) -> Iterator[Session]:
        return iter(self._sessions)

    @overload
    def __getitem__(self, key: str) -> Floats: ...
    @overload
    def __getitem__(self, key: int) -> Session: ...
    @overload
    def __getitem__(self, key: slice) -> list[Session]: ...
    def __getitem__(self, key: str | int | slice) -> Floats | Session | list[Session]:
        """Raises UnknownName with the nearest name."""
        if not isinstance(key, str):
            return self._sessions[key]
        place = self._opening.places.of(key)
        places = np.atleast_1d(place)
        table = self._states() if (places < self._opening.places.states).all() else self._rows()
        return table[:, place].copy()

    def _states(self) -> Floats:
        return self._table("holds_state", self._opening.places.states)

    def _rows(self) -> Floats:
        return self._table("holds_row", self._sessions[0].width)

    def _table(self, name: str, width: int) -> Floats:
        """Numbers of each, as they are now."""
        if name not in self._known:
            self._known[name] = np.empty((len(self), width))
            getattr(self._library, name)(self._addresses.ctypes.data, len(self), self._known[name].ctypes.data)
        return self._known[name]

    # ---- back and again ----------------------------------------------------------------------------------------------

    def reset(
        self,
        which: ArrayLike | None = None,
        *,
        start: Mapping[str, ArrayLike] | None = None,
        parameters: Mapping[str, ArrayLike] | None = None,
    ) -> None:
        """The sessions `which` (numbers, or flags (runs,); left out: all) begin again, as they did, or with values for
        all alike or one for each of them. Raises as `Model.sessions`."""
        chosen = np.arange(len(self)) if which is None else np.atleast_1d(np.asarray(which))
        chosen = np.flatnonzero(chosen) if chosen.dtype == np.bool_ else chosen
        starts = spread(self._opening.asked.words.starts(start or {}), len(chosen))
        own = spread(self._opening.asked.words.many_parameters(parameters or {}), len(chosen))
        for k, start_of, parameters_of in zip(chosen.tolist(), starts, own, strict=True):
            self._sessions[k].reset(start=start_of, parameters=parameters_of)
            self._renew(k)

    def save(self) -> list[bytes]:
        """The state of each, as `Session.save`."""
        return [session.save() for session in self._sessions]

    def restore(self, states: Sequence[bytes]) -> None:
        """Goes back to the states that `save` returned. Raises CallRefused."""
        if len(states) != len(self):
            raise refused("E0891", why=f"there are {len(self)} sessions and {len(states)} states", way="give one each")
        for k, state in enumerate(states):
            self._sessions[k].restore(state)
            self._renew(k)


def spread(given: Mapping[str, ArrayLike], count: int) -> list[dict[str, float]]:
    """The values of each of so many. Raises CallRefused (E0893) where there are not as many."""
    every = {}
    for name, values in given.items():
        array = np.asarray(values, dtype=np.float64)
        if array.shape not in ((), (count,)):
            why = f"`{name}` has values of the shape {array.shape}"
            raise refused("E0893", why=why, way=f"give one value, or {count}, one for each session")
        every[name] = np.broadcast_to(array, count).tolist()
    return [{name: values[k] for name, values in every.items()} for k in range(count)]


@cache
def _workers(count: int) -> ThreadPoolExecutor:
    return ThreadPoolExecutor(max_workers=count, thread_name_prefix="lagdsl-sessions")
