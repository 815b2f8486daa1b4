"""Many motions of one model by steps: one call moves them all."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from time import perf_counter
from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.engines.runtime.engines.auto_engine import AutoEngine
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.structures import Status
from lagdsl.foundation.diagnostics import refused
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.motion.sessions.opening import Opening
from lagdsl.motion.sessions.session import Session
from lagdsl.motion.simulate.commands import Command
from lagdsl.motion.simulate.control import seconds
from lagdsl.motion.simulate.stepping import MOST_STEPS, STEPS

# Fewer runs than this in one thread are not worth the time that it takes to wake it.
_FEWEST = 32


@record()
class _Holds:
    """Addresses of lag_hold, and how their steps ended, a lag_status each."""

    addresses: NDArray[np.uintp]
    status: NDArray[np.intc]


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
        self._table = np.zeros((len(starts), self._sessions[0].width))

    # ---- on they go --------------------------------------------------------------------------------------------------

    def step(self, h: float | str, u: Command | None = None) -> None:
        """All on by h (seconds, or a text such as `2 ms`), with the inputs u from its beginning on: (runs, inputs),
        (inputs,) for all alike, (runs,) where there is one input, or by name a number or (runs,). Without u they stay.
        Raises CallRefused for what does not fit."""
        length = seconds("the step", h)
        ends = self._opening.last < np.inf
        self._go("step", length, float(np.max(self.t)) + length if ends else length, u)

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
        holds = _Holds(self._addresses(), np.where(self.ended, Status.STOPPED, Status.OK).astype(np.intc))
        before = holds.status.copy()
        started = perf_counter()
        self._each(holds, f"holds_{what}", amount)
        for _ in range(MOST_STEPS // STEPS - 1):
            if not (holds.status == Status.TOO_LONG).any():
                break
            self._each(holds, "holds_go")
        self._hasten(perf_counter() - started)
        for k in np.flatnonzero(holds.status != before).tolist():
            try:
                self._sessions[k].finish(Status(holds.status[k]))
            except Exception as failure:  # `failures` tells it
                assert self._sessions[k].failure, failure

    def _hasten(self, seconds: float) -> None:
        """Work of so many seconds was done: where that pays, all go on in C as soon as there is C."""
        engine = self._opening.asked.engine
        if isinstance(engine, AutoEngine) and not engine.is_compiled:
            engine.worked(seconds)
            engine.hasten()
            if engine.is_compiled:
                for session in self._sessions:
                    session.hasten()

    def _each(self, holds: _Holds, name: str, *amount: float) -> None:
        """One function of C for all, in threads that share them."""
        function, count = getattr(self._library, name), len(self)
        parts = max(1, min(self._threads, count // _FEWEST))
        ends = [count * part // parts for part in range(parts + 1)]

        def work(part: int) -> None:
            first, end = ends[part], ends[part + 1]
            status = holds.status.ctypes.data + holds.status.itemsize * first
            addresses = holds.addresses.ctypes.data + holds.addresses.itemsize * first
            function(addresses, end - first, *amount, STEPS, status)

        others = [_workers(self._threads).submit(work, part) for part in range(1, parts)]
        work(0)
        for other in others:
            other.result()

    def _addresses(self) -> NDArray[np.uintp]:
        """Of the lag_hold of each; one that begins again may have another."""
        return np.array([session.address for session in self._sessions], dtype=np.uintp)

    # ---- what has become of them -------------------------------------------------------------------------------------

    @property
    def t(self) -> Floats:
        """The time of each [s], (runs,)."""
        return self._states()[:, 0]

    @property
    def ended(self) -> NDArray[np.bool_]:
        """True for each that does not go on, (runs,)."""
        return np.array([session.ended for session in self._sessions])

    @property
    def failures(self) -> dict[int, str]:
        """Why motions failed, by the number of the session."""
        return {k: session.failure for k, session in enumerate(self._sessions) if session.failure}

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
        """Time and state of each."""
        found, addresses = np.empty((len(self), self._opening.places.states)), self._addresses()
        self._library.holds_state(addresses.ctypes.data, len(self), found.ctypes.data)
        return found

    def _rows(self) -> Floats:
        """The row of each; they are made where one is not known."""
        if any(session.row is None for session in self._sessions):
            addresses = self._addresses()
            self._library.holds_row(addresses.ctypes.data, len(self), self._table.ctypes.data)
            for session, row in zip(self._sessions, self._table.tolist(), strict=True):
                session.row = row
        return self._table

    def derivative(self, of: str, by: str) -> Floats:
        """(runs,): as `Session.derivative` of each."""
        return np.array([session.derivative(of, by) for session in self._sessions])

    def jacobian(self, of: Sequence[str]) -> Floats:
        """(runs, variables, tangents): as `Session.jacobian` of each."""
        return np.array([session.jacobian(of) for session in self._sessions])

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

    def save(self) -> list[bytes]:
        """The state of each, as `Session.save`."""
        return [session.save() for session in self._sessions]

    def restore(self, states: Sequence[bytes]) -> None:
        """Goes back to the states that `save` returned. Raises CallRefused."""
        if len(states) != len(self):
            raise refused("E0891", why=f"there are {len(self)} sessions and {len(states)} states", way="give one each")
        for session, state in zip(self._sessions, states, strict=True):
            session.restore(state)


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
