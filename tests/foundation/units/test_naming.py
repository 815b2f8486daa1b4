"""Words and texts of dimensions."""

import pytest
from choice import together

from lagdsl.foundation.units.dimension import dimension
from lagdsl.foundation.units.naming import base_text, describe, rate_text, to_display, unit_text
from lagdsl.foundation.units.parse import parse_unit


@together(
    ("unit", "text", "words"),
    [
        ("N.m", "J", "an energy"),
        ("m", "m", "a length"),
        ("rad", "1", "a number"),
        ("m/s", "m/s", "a velocity"),
        ("N.m.s", "kg.m2/s", "an angular momentum"),
        ("kg/s2", "N/m", "a stiffness"),
        ("kg/s", "N.s/m", "a damping"),
        ("V.s/m", "N/A", "a quantity in N/A"),
        ("H.m", "H.m", "a quantity in H.m"),
        ("1/mol", "1/mol", "a quantity in 1/mol"),
        ("m3.s", "m3.s", "a quantity in m3.s"),
        ("Ohm/K", "Ohm/K", "a quantity in Ohm/K"),
        ("A/N", "A/N", "a quantity in A/N"),
    ],
)
def test_names(unit, text, words):
    value = parse_unit(unit).dimension
    assert unit_text(value) == text
    assert describe(value) == words


def test_base_units_only():
    assert base_text(parse_unit("J").dimension) == "kg.m2/s2"
    assert base_text(parse_unit("N.s/m").dimension) == "kg/s"
    assert base_text(dimension()) == "1"
    assert base_text(dimension(m=120)) == "m^(120)"


@pytest.mark.parametrize(
    ("unit", "rate"),
    [
        ("rad", "rad/s"),
        ("rad/s", "rad/s2"),
        ("m", "m/s"),
        ("m/s", "m/s2"),
        ("C", "A"),
        ("J", "W"),
        ("s", "1"),
        ("1", "1/s"),
    ],
)
def test_rates(unit, rate):
    dimension_of_rate = parse_unit(unit).dimension / dimension(s=1)
    assert rate_text(parse_unit(unit).dimension, unit) == rate
    assert parse_unit(rate).dimension == dimension_of_rate


def test_display():
    assert to_display(1.0, None) == 1.0
    assert to_display(0.045, "mm") == 45.0
    assert to_display(273.15, "degC") == 0.0
