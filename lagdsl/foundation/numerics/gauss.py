"""Points and weights of Gauss' quadrature.

Roots of Legendre's polynomials by Newton's method from Tricomi's estimate.
Source: Abramowitz and Stegun, Handbook of Mathematical Functions, 25.4.29 and 22.16.6.
"""

from __future__ import annotations

from math import cos, pi

_STEPS = 6  # Newton doubles the digits; the estimate has two


def quadrature(count: int) -> tuple[list[float], list[float]]:
    """Points in (0, 1) in rising order, and weights of sum 1: exact for polynomials up to the degree 2 count - 1."""
    points, weights = [], []
    for i in range(count, 0, -1):
        x = cos(pi * (i - 0.25) / (count + 0.5))
        if 2 * i == count + 1:
            x = 0.0
        for _ in range(_STEPS):
            value, slope = _legendre(count, x)
            x -= value / slope
        points.append((1.0 + x) / 2.0)
        weights.append(1.0 / ((1.0 - x * x) * _legendre(count, x)[1] ** 2))
    return points, weights


def _legendre(degree: int, x: float) -> tuple[float, float]:
    """P(x) and P'(x)."""
    before, value = 0.0, 1.0
    for k in range(1, degree + 1):
        before, value = value, ((2 * k - 1) * x * value - (k - 1) * before) / k
    return value, degree * (x * value - before) / (x * x - 1.0)
