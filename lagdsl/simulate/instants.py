"""Equidistant instants: those of clocks and of rows, the same numbers where they mean the same time."""

from __future__ import annotations

from fractions import Fraction
from math import lcm

import numpy as np

from lagdsl.mechanics.rank import Floats

# First and period are taken for the short fractions that they are to the last bit; whole numbers up to here are exact.
_LARGEST_DENOMINATOR = 10**6
_LARGEST_WHOLE = 2**53


class Instants:
    """first + k*period, rounded once where both are short fractions."""

    def __init__(self, first: float, period: float) -> None:
        self._first, self._period = first, period
        a, b = (Fraction(x).limit_denominator(_LARGEST_DENOMINATOR) for x in (first, period))
        self._whole = None
        if float(a) == first and float(b) == period:
            whole = lcm(a.denominator, b.denominator)
            self._whole = int(a * whole), int(b * whole), whole

    def __call__(self, k: int) -> float:
        return float(self.up_to(np.array([k]))[0])

    def up_to(self, k: np.ndarray) -> Floats:
        """Those of whole numbers k (n,)."""
        if self._whole is not None and len(k):
            first, period, denominator = self._whole
            if abs(first) + abs(period) * int(np.max(k)) < _LARGEST_WHOLE:
                return np.asarray((first + period * k.astype(np.int64)) / denominator)
        return np.asarray(self._first + k * self._period)
