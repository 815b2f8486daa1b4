"""Motions with events, mode by mode: each mode has equations of its own, and guards that end it where they become zero
from above."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.integrate import solve_ivp

from models.references.integrate import Floats

# Rows at an event are recognized by their times: nearer to one than this, twice.
_SAME = 2e-9
# At the start of a mode its guards are zero but for round-off: for so long they are not looked at.
_BLIND = 1e-9

Guard = Callable[[float, Floats], float]
Jump = Callable[[float, Floats], tuple[str, ArrayLike]]


@dataclass(frozen=True)
class Mode:
    """x' = rates(t, x) until a guard is zero; its jump tells the next mode and the state there. `until` ends the mode
    at a time. Guards are looked at once in a `step`."""

    rates: Callable[[float, Floats], ArrayLike]
    ends: Sequence[tuple[Guard, Jump]] = ()
    until: float = np.inf
    then: Jump | None = None
    step: float = np.inf


@dataclass(frozen=True)
class _Piece:
    start: float
    name: str
    dense: Callable[[float], Floats]


class Motion:
    """Rows at the times `t`, of those at the same time the first is that before the event, the others those after:
    `x` (n, len(t)), `modes`."""

    def __init__(self, modes: Callable[[str, float], Mode], mode: str, x: ArrayLike, t: Floats) -> None:
        self._pieces: list[_Piece] = []
        time, state = float(t[0]), np.asarray(x, dtype=float)
        self.events: list[float] = []
        while time < t[-1]:
            time, mode, state = self._advance(modes(mode, time), mode, time, state, float(t[-1]))
        chosen = [self._piece(t, row) for row in range(len(t))]
        self.x = np.array([piece.dense(time) for piece, time in zip(chosen, t, strict=True)]).T
        self.modes = np.array([piece.name for piece in chosen])

    def _advance(self, mode: Mode, name: str, time: float, x: Floats, last: float) -> tuple[float, str, Floats]:
        last = min(last, mode.until)
        time, x, _ = self._solved(mode, name, time, x, min(last, time + _BLIND), ())
        time, x, ended = self._solved(mode, name, time, x, last, [_terminal(guard) for guard, _ in mode.ends])
        jumps = [jump for (_, jump), times in zip(mode.ends, ended, strict=True) if len(times)]
        self.events += [time] * bool(jumps)
        if not jumps and mode.then is not None and time == mode.until:
            jumps = [mode.then]
        if not jumps:
            return time, name, x
        following, after = jumps[0](time, x)
        return time, following, np.asarray(after, dtype=float)

    def _solved(
        self, mode: Mode, name: str, time: float, x: Floats, last: float, guards: Sequence[Guard]
    ) -> tuple[float, Floats, Sequence[Floats]]:
        """Time and state at the end, and the times at which each guard ended it."""
        if time >= last:
            return time, x, [np.zeros(0)] * len(guards)
        found = solve_ivp(
            lambda t, x: np.asarray(mode.rates(t, x), dtype=float),
            (time, last),
            x,
            method="DOP853",
            rtol=1e-12,
            atol=1e-13 * np.maximum(np.abs(x), 1e-3),
            events=list(guards),
            dense_output=True,
            max_step=mode.step,
        )
        assert found.success, found.message
        self._pieces.append(_Piece(time, name, found.sol))
        return float(found.t[-1]), np.asarray(found.y[:, -1]), found.t_events or ()

    def _piece(self, t: Floats, row: int) -> _Piece:
        after = row > 0 and t[row - 1] == t[row]
        before = row + 1 < len(t) and t[row + 1] == t[row] and not after
        latest = t[row] - _SAME if before else t[row] + _SAME if after else t[row]
        return next((piece for piece in reversed(self._pieces) if piece.start <= latest), self._pieces[0])


def _terminal(guard: Guard) -> Guard:
    def function(t: float, x: Floats) -> float:
        return guard(t, x)

    function.terminal = True  # type: ignore[attr-defined]
    function.direction = -1.0  # type: ignore[attr-defined]
    return function
