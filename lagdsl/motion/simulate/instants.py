"""Equidistant instants of rows: the same numbers as those of clocks where they mean the same time."""

from __future__ import annotations

from fractions import Fraction
from math import lcm

import numpy as np

from lagdsl.foundation.numerics.rank import Floats

# First and period are taken for the short fractions that they are to the last bit; whole numbers up to here are exact.
_LARGEST_DENOMINATOR = 10**6
_LARGEST_WHOLE = 2**53


def equidistant(first: float, period: float, count: int) -> Floats:
    """first + k*period for k = 0 to count - 1, rounded once where both are short fractions."""
    k = np.arange(count)
    a, b = (Fraction(x).limit_denominator(_LARGEST_DENOMINATOR) for x in (first, period))
    if float(a) == first and float(b) == period:
        whole = lcm(a.denominator, b.denominator)
        start, step = int(a * whole), int(b * whole)
        if abs(start) + abs(step) * (count - 1) < _LARGEST_WHOLE:
            return np.asarray((start + step * k) / whole)
    return np.asarray(first + k * period)
