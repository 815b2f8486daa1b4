"""Units as FMI defines them: exponents of SI base units, and units to show numbers in."""

from __future__ import annotations

import re
from collections.abc import Iterable
from fractions import Fraction

from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import BASE_UNITS
from lagdsl.foundation.units.parse import parse_unit

_RADIANS = re.compile(r"(?<![A-Za-z])rad(?:\^?(?P<power>-?[0-9]+))?(?![A-Za-z])")


@record(kw_only=True)
class DisplayUnit:
    """A number shown in it is factor * number in the unit + offset."""

    name: str
    factor: float
    offset: float


@record(kw_only=True)
class UnitDefinition:
    """`exponents` by base unit of FMI (kg, m, s, A, K, mol, cd, rad), zeros left out; None where one of them is no
    whole number, which FMI cannot tell. SI value = factor * number in the unit."""

    name: str
    exponents: tuple[tuple[str, int], ...] | None
    factor: float
    display_units: tuple[DisplayUnit, ...]


def unit_definitions(used: Iterable[tuple[str | None, str | None]]) -> tuple[UnitDefinition, ...]:
    """Of pairs of unit and display unit, in the order of first use."""
    shown: dict[str, dict[str, None]] = {}
    for unit, display_unit in used:
        if unit is not None:
            names = shown.setdefault(unit, {})
            if display_unit is not None:
                names[display_unit] = None
    return tuple(_definition(unit, tuple(names)) for unit, names in shown.items())


def _definition(name: str, display_units: tuple[str, ...]) -> UnitDefinition:
    unit = parse_unit(name)
    powers = [*zip(BASE_UNITS, unit.dimension.exponents, strict=True), ("rad", Fraction(_radians(name)))]
    whole = all(power.denominator == 1 for _, power in powers)
    return UnitDefinition(
        name=name,
        exponents=tuple((base, int(power)) for base, power in powers if power) if whole else None,
        factor=unit.factor,
        display_units=tuple(_display_unit(shown, name) for shown in display_units),
    )


def _display_unit(name: str, unit: str) -> DisplayUnit:
    shown, base = parse_unit(name), parse_unit(unit)
    # SI value = factor * (number + shift), the same for both.
    ratio = base.exact_factor / shown.exact_factor
    return DisplayUnit(name=name, factor=float(ratio), offset=float(base.shift * ratio - shown.shift))


def _radians(name: str) -> int:
    """The exponent of `rad` in a unit text, in which everything after the one slash divides."""
    above, _, below = name.partition("/")
    counts = [sum(int(found["power"] or 1) for found in _RADIANS.finditer(part)) for part in (above, below)]
    return counts[0] - counts[1]
