"""Dimensions as vectors of rational exponents over the seven SI base units."""

from fractions import Fraction
from operator import add, sub
from typing import TypeAlias

from lagdsl.foundation.record import record

BASE_UNITS = ("kg", "m", "s", "A", "K", "mol", "cd")


Exponent: TypeAlias = int | Fraction
"""A whole number is an `int`: nearly all are, and fractions take ten times as long."""


@record()
class Dimension:
    """Exponents of kg, m, s, A, K, mol, cd. `rad` is dimensionless."""

    exponents: tuple[Exponent, ...]

    def __mul__(self, other: "Dimension") -> "Dimension":
        return Dimension(tuple(map(add, self.exponents, other.exponents)))

    def __truediv__(self, other: "Dimension") -> "Dimension":
        return Dimension(tuple(map(sub, self.exponents, other.exponents)))

    def __pow__(self, exponent: Exponent) -> "Dimension":
        exponent = _whole(exponent)
        return Dimension(tuple(_whole(a * exponent) for a in self.exponents))

    @property
    def is_dimensionless(self) -> bool:
        return not any(self.exponents)


def _whole(exponent: Exponent) -> Exponent:
    return exponent.numerator if exponent.denominator == 1 else exponent


def dimension(**exponents: Exponent) -> Dimension:
    """`dimension(kg=1, m=2, s=-2)` is an energy."""
    unknown = set(exponents) - set(BASE_UNITS)
    assert not unknown, unknown
    return Dimension(tuple(_whole(exponents.get(base, 0)) for base in BASE_UNITS))


DIMENSIONLESS = dimension()
LENGTH = dimension(m=1)
MASS = dimension(kg=1)
TIME = dimension(s=1)
VELOCITY = dimension(m=1, s=-1)
ACCELERATION = dimension(m=1, s=-2)
FORCE = dimension(kg=1, m=1, s=-2)
ENERGY = dimension(kg=1, m=2, s=-2)
POWER = dimension(kg=1, m=2, s=-3)
INERTIA = dimension(kg=1, m=2)
CHARGE = dimension(A=1, s=1)
