"""Points and weights of Gauss' quadrature, and the polynomials of Legendre that it comes from, on (0, 1).

Roots of the polynomials by Newton's method from Tricomi's estimate, values by their recurrence, which keeps the digits.
Source: Abramowitz and Stegun, Handbook of Mathematical Functions, 25.4.29, 22.16.6 and 22.7.10.
"""

from __future__ import annotations

from functools import cache
from math import cos, fsum, pi
from operator import mul

_STEPS = 6  # Newton doubles the digits; the estimate has two


@cache
def quadrature(count: int) -> tuple[tuple[float, ...], tuple[float, ...]]:
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
    return tuple(points), tuple(weights)


def quadrature_to(x: float, count: int, power: int) -> list[float]:
    """Weights of the same points for the integral of t^power f(t) from 0 to x: exact for polynomials f up to the degree
    count - 1, which are series of the polynomials of Legendre."""
    within, parts = quadrature((count + power + 1) // 2)
    values = [(x * part * (x * t) ** power, legendre(x * t, count)) for t, part in zip(within, parts, strict=True)]
    moments = [(2 * k + 1) * fsum(factor * found[k] for factor, found in values) for k in range(count)]
    return [weight * fsum(map(mul, moments, found)) for weight, found in _at_points(count)]


@cache
def _at_points(count: int) -> tuple[tuple[float, list[float]], ...]:
    """Each weight, and the polynomials at its point."""
    return tuple((weight, legendre(x, count)) for x, weight in zip(*quadrature(count), strict=True))


def legendre(x: float, count: int) -> list[float]:
    """Values at x of the polynomials of the degrees 0 to count - 1, orthogonal on (0, 1) and 1 at 1."""
    found = [1.0, 2.0 * x - 1.0]
    for k in range(2, count):
        found.append(((2 * k - 1) * found[1] * found[-1] - (k - 1) * found[-2]) / k)
    return found[:count]


def _legendre(degree: int, x: float) -> tuple[float, float]:
    """P(x) and P'(x)."""
    before, value = 0.0, 1.0
    for k in range(1, degree + 1):
        before, value = value, ((2 * k - 1) * x * value - (k - 1) * before) / k
    return value, degree * (x * value - before) / (x * x - 1.0)
