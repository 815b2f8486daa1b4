"""Ticks of `sample(start, period)`: start + k*period, each computed from k, so that they do not drift."""

from __future__ import annotations

import math

import numpy as np

from lagdsl.mechanics.rank import Floats
from lagdsl.simulate.instants import Instants

# A tick nearer to the present than this part of the period is the present one.
_SAME = 1e-9


class Clocks:
    """Which clock ticks next, and when."""

    def __init__(self, start: Floats, period: Floats, t: float) -> None:
        """`t` is the start of the motion: ticks before it are over."""
        both = list(zip(start.tolist(), period.tolist(), strict=True))
        self._instants = [Instants(first, step) for first, step in both]
        self._near = _SAME * period
        self._count = [max(0, math.ceil((t - first) / step - _SAME)) for first, step in both]

    def next(self) -> float:
        """The next tick of all; inf where there are no clocks."""
        return float(np.min(self._ticks(), initial=np.inf))

    def ticking(self, t: float) -> list[int]:
        """The clocks that tick at t; they go on to their next tick."""
        found: list[int] = np.flatnonzero(self._ticks() <= t + self._near).tolist()
        for index in found:
            self._count[index] += 1
        return found

    def _ticks(self) -> Floats:
        return np.array([at(k) for at, k in zip(self._instants, self._count, strict=True)])
