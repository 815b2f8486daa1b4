"""Numbers as a person writes them, and always the same floats when they are read."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction

_FULL_TURN = 360


def number(value: float) -> str:
    """The shortest text of this float: `2`, `0.333`, `1e-6`."""
    if value == int(value) and abs(value) < 1e6:
        return str(int(value))
    mantissa, separator, exponent = repr(value).partition("e")
    return f"{mantissa.removesuffix('.0')}e{int(exponent)}" if separator else mantissa


def angle(value: float) -> str:
    """In degrees where they are whole and give this very float, `90 deg`; else a bare number in radians."""
    degrees = round(math.degrees(value))
    if degrees and abs(degrees) <= _FULL_TURN and float(degrees * Fraction(math.pi) / 180) == value:
        return f"{degrees} deg"
    return number(value)


def quantity(value: float, unit: str) -> str:
    """With its unit; a zero fits everything by itself."""
    return f"{number(value)} {unit}" if value else "0"


def array(texts: Iterable[str]) -> str:
    """`{a, b, c}`."""
    return f"{{{', '.join(texts)}}}"


def vector(values: Iterable[float]) -> str:
    """Of bare numbers, which take the unit of what they are bound to."""
    return array(map(number, values))
