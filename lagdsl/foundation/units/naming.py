"""Words and unit texts for dimensions, as diagnostics and reports show them."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from lagdsl.foundation.units.definition import from_si
from lagdsl.foundation.units.dimension import BASE_UNITS, TIME, Dimension, Exponent
from lagdsl.foundation.units.parse import parse_unit

# Name of a quantity of this unit, and the unit text it is shown in. If quantities share a dimension (energy and moment,
# stiffness and surface tension), mechanics comes first.
_NAMED = (
    ("1", "a number"),
    ("m", "a length"),
    ("kg", "a mass"),
    ("s", "a time"),
    ("A", "an electric current"),
    ("K", "a temperature"),
    ("mol", "an amount of substance"),
    ("cd", "a luminous intensity"),
    ("m2", "an area"),
    ("m3", "a volume"),
    ("1/s", "an angular velocity"),
    ("1/s2", "an angular acceleration"),
    ("1/m", "a curvature"),
    ("m/s", "a velocity"),
    ("m/s2", "an acceleration"),
    ("m/s3", "a jerk"),
    ("N", "a force"),
    ("J", "an energy"),
    ("W", "a power"),
    ("kg.m/s", "a momentum"),
    ("kg.m2/s", "an angular momentum"),
    ("kg.m2", "a moment of inertia"),
    ("kg.m", "a first moment of mass"),
    ("kg/m", "a mass per length"),
    ("kg/m2", "a mass per area"),
    ("kg/m3", "a density"),
    ("N/m", "a stiffness"),
    ("N.s/m", "a damping"),
    ("Pa", "a pressure"),
    ("Pa.s", "a viscosity"),
    ("m2/s", "a kinematic viscosity"),
    ("m3/s", "a volume flow rate"),
    ("C", "an electric charge"),
    ("V", "a voltage"),
    ("Ohm", "a resistance"),
    ("S", "a conductance"),
    ("F", "a capacitance"),
    ("H", "an inductance"),
    ("Wb", "a magnetic flux"),
    ("T", "a magnetic flux density"),
    ("V/m", "an electric field"),
    ("A/m", "a magnetic field"),
    ("J/kg", "a specific energy"),
    ("J/K", "a heat capacity"),
    ("J/(kg.K)", "a specific heat capacity"),
    ("W/(m.K)", "a thermal conductivity"),
    ("S/m", "a conductivity"),
    ("A.m2", "a magnetic moment"),
    ("m4", "a second moment of area"),
)

_DERIVED = ("N", "J", "W", "Pa", "V", "C", "Ohm", "F", "H", "Wb", "T", "S")


@lru_cache(maxsize=1)
def _named() -> dict[Dimension, tuple[str, str]]:
    return {parse_unit(unit).dimension: (unit, words) for unit, words in _NAMED}


def describe(dimension: Dimension) -> str:
    """The quantity in words: `an energy`, `a number`; `a quantity in N.m3` for what has no name."""
    named = _named().get(dimension)
    return named[1] if named is not None else f"a quantity in {unit_text(dimension)}"


@lru_cache(maxsize=1024)
def unit_text(dimension: Dimension) -> str:
    """The coherent SI unit with the nicest name: `J`, `m/s`, `kg.m2/s`, `V.s/m`; `1` for a number."""
    named = _named().get(dimension)
    if named is not None:
        return named[0]
    choices = [_powers(dimension)]
    for name in _DERIVED:
        unit = parse_unit(name).dimension
        choices.append({name: Fraction(1), **_powers(dimension / unit)})
        choices.append({**_powers(dimension * unit), name: Fraction(-1)})
    return _text(min(choices, key=_length))


def base_text(dimension: Dimension) -> str:
    """The unit in base units only: `kg.m2/s2`."""
    return _text(_powers(dimension))


def rate_text(dimension: Dimension, unit: str) -> str:
    """The unit of the time derivative of a quantity shown in `unit`: `rad` gives `rad/s`, `m/s` gives `m/s2`."""
    if unit.isalpha() and unit not in ("s", "N", "J", "C"):
        return f"{unit}/s"
    return "rad/s2" if unit == "rad/s" else unit_text(dimension / TIME)


def to_display(value: float, unit: str | None) -> float:
    """The number to show for an SI value in the unit text `unit`; None leaves it as it is."""
    return value if unit is None else from_si(value, parse_unit(unit))


def _powers(dimension: Dimension) -> dict[str, Exponent]:
    return {base: power for base, power in zip(BASE_UNITS, dimension.exponents, strict=True) if power}


def _length(powers: dict[str, Exponent]) -> Fraction:
    """Length of the text: number of factors, and the size of exponents beyond 1."""
    denominators = sum(1 for power in powers.values() if power.denominator > 1)
    return sum((abs(Fraction(power)) for power in powers.values()), Fraction(len(powers) + 5 * denominators))


def _text(powers: dict[str, Exponent]) -> str:
    above = [_factor(name, power) for name, power in powers.items() if power > 0]
    below = [_factor(name, -power) for name, power in powers.items() if power < 0]
    if not below:
        return ".".join(above) or "1"
    divisor = below[0] if len(below) == 1 else f"({'.'.join(below)})"
    return f"{'.'.join(above) or '1'}/{divisor}"


def _factor(name: str, power: Exponent) -> str:
    if power == 1:
        return name
    return f"{name}{power}" if power.denominator == 1 and power < 100 else f"{name}^({power})"
