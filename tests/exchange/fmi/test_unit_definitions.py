"""Units in the words of FMI: exponents of base units, and how numbers are shown."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lagdsl.exchange.fmi.description.unit_definitions import UnitDefinition, unit_definitions
from lagdsl.foundation.units.definition import from_si
from lagdsl.foundation.units.naming import unit_text
from lagdsl.foundation.units.parse import parse_unit
from lagdsl.foundation.units.vocabulary import UNITS


def defined(unit: str, shown: str | None = None) -> UnitDefinition:
    (found,) = unit_definitions([(unit, shown)])
    return found


@pytest.mark.parametrize(
    ("unit", "exponents"),
    [
        ("1", {}),
        ("rad", {"rad": 1}),
        ("rad/s2", {"s": -2, "rad": 1}),
        ("N.m", {"kg": 1, "m": 2, "s": -2}),
        ("N.m/rad", {"kg": 1, "m": 2, "s": -2, "rad": -1}),
        ("N.m/(s.rad)", {"kg": 1, "m": 2, "s": -3, "rad": -1}),
        ("rad2/s", {"s": -1, "rad": 2}),
        ("rad-1", {"rad": -1}),
        ("V.s/rad", {"kg": 1, "m": 2, "s": -2, "A": -1, "rad": -1}),
        ("W/(m.K)", {"kg": 1, "m": 1, "s": -3, "K": -1}),
        ("mol/s", {"mol": 1, "s": -1}),
        ("cd", {"cd": 1}),
        ("Hz", {"s": -1}),
        ("mrad", {}),  # not the unit rad, and not its thousandth in the sense of a base unit
    ],
)
def test_exponents(unit: str, exponents: dict[str, int]) -> None:
    found = defined(unit)
    assert found.exponents is not None and dict(found.exponents) == exponents
    assert found.factor == (1e-3 if unit == "mrad" else 1.0)


def test_a_root_has_no_exponents_in_fmi() -> None:
    assert defined("m^(1/2)").exponents is None


@given(st.sampled_from(sorted(UNITS)), st.floats(-1e6, 1e6).filter(lambda value: value == 0.0 or abs(value) > 1e-6))
def test_a_number_is_shown_as_in_results(name: str, value: float) -> None:
    """Display value = factor * value + offset, as both standards have it."""
    coherent = unit_text(parse_unit(name).dimension)
    (shown,) = defined(coherent, name).display_units
    expected = from_si(value, parse_unit(name))
    assert shown.factor * value + shown.offset == pytest.approx(expected, rel=1e-13, abs=1e-13 * abs(shown.offset))


def test_units_are_told_once() -> None:
    found = unit_definitions([("m", None), ("rad", "deg"), ("m", "mm"), (None, None), ("rad", "rev"), ("rad", "deg")])
    assert [(unit.name, [shown.name for shown in unit.display_units]) for unit in found] == [
        ("m", ["mm"]),
        ("rad", ["deg", "rev"]),
    ]
