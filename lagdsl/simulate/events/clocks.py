"""Ticks of `sample(start, period)`: start + k*period, each computed from k, so that they do not drift."""

from __future__ import annotations

import math

import numpy as np

from lagdsl.mechanics.rank import Floats

# A tick nearer to the present than this part of the period is the present one.
_SAME = 1e-9


class Clocks:
    """Which clock ticks next, and when."""

    def __init__(self, start: Floats, period: Floats, t: float) -> None:
        """`t` is the start of the motion: ticks before it are over."""
        self._start, self._period = start, period
        self._count = np.array(
            [max(0, math.ceil((t - first) / step - _SAME)) for first, step in zip(start, period, strict=True)],
            dtype=np.int64,
        )

    def next(self) -> float:
        """The next tick of all; inf where there are no clocks."""
        return float(np.min(self._ticks(), initial=np.inf))

    def ticking(self, t: float) -> list[int]:
        """The clocks that tick at t; they go on to their next tick."""
        found = np.flatnonzero(self._ticks() <= t + _SAME * self._period).tolist()
        self._count[found] += 1
        return found

    def _ticks(self) -> Floats:
        return np.asarray(self._start + self._count * self._period)
