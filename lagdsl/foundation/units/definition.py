"""Definition of a unit: a dimension and an exact conversion to the coherent SI unit."""

import math
from fractions import Fraction

from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import DIMENSIONLESS, Dimension

# The float that `pi` is in a model: so `60 deg` and `pi/3` are the same number.
PI = Fraction(math.pi)


@record()
class UnitDefinition:
    """value in SI = (number + shift) * scale * pi**pi_power. Only `degC` has a shift."""

    dimension: Dimension
    scale: Fraction = Fraction(1)
    pi_power: int = 0
    shift: Fraction = Fraction(0)

    @property
    def exact_factor(self) -> Fraction:
        """The factor, with pi as the nearest float."""
        return self.scale * PI**self.pi_power

    @property
    def factor(self) -> float:
        """value in SI = number * factor + offset."""
        return float(self.exact_factor)

    @property
    def offset(self) -> float:
        return float(self.shift * self.exact_factor)


ONE = UnitDefinition(DIMENSIONLESS)


def product(factors: list[tuple[UnitDefinition, Fraction]]) -> UnitDefinition:
    """The product of powers. A shift survives only in a unit that stands alone: `W/degC` is `W/K`."""
    if len(factors) == 1 and factors[0][1] == 1:
        return factors[0][0]
    dimension, scale, pi_power = DIMENSIONLESS, Fraction(1), 0
    for unit, exponent in factors:
        dimension = dimension * unit.dimension**exponent
        if unit.scale != 1 or unit.pi_power:
            assert exponent.denominator == 1, "a root of a converted unit has no exact factor"
            scale *= unit.scale ** int(exponent)
            pi_power += unit.pi_power * int(exponent)
    return UnitDefinition(dimension, scale, pi_power)


def si_value(number: str | float, unit: UnitDefinition) -> float:
    """The SI value of `number` in `unit`, rounded once: `45 mm` is the same float as `0.045 m`.

    A decimal number whose exponent leaves the range of floats gives inf or 0 as `float` does.
    """
    value = float(number)
    if not 1e-250 < abs(value) < 1e250 or (isinstance(number, str) and len(number) > 400):
        return value * unit.factor + unit.offset
    return float((_decimal(number) + unit.shift) * unit.exact_factor)


def from_si(value: float, unit: UnitDefinition) -> float:
    """The number that stands before `unit` for an SI value."""
    if not 1e-250 < abs(value) < 1e250:
        return (value - unit.offset) / unit.factor
    return float(_decimal(value) / unit.exact_factor - unit.shift)


def _decimal(number: str | float) -> Fraction:
    """The decimal number that people read, not the binary one nearest to it."""
    return Fraction(number if isinstance(number, str) else repr(float(number)))
