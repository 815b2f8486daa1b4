"""Types and constants that every model knows."""

import math

import pytest

from lagdsl.semantics.prelude import CONSTANTS, TYPES
from lagdsl.units.definition import from_si, si_value
from lagdsl.units.dimension import DIMENSIONLESS, ENERGY, dimension
from lagdsl.units.parse import parse_unit

RULING_14 = """Velocity Acceleration AngularVelocity AngularAcceleration Momentum AngularMomentum Force Torque Energy Power
Stiffness Damping RotationalStiffness RotationalDamping Density LinearDensity Pressure Volume VolumeFlowRate Frequency
Charge Current Voltage Resistance Inductance Capacitance MagneticFlux MagneticFluxDensity ElectricField Temperature
Angle Length Distance Position Mass Inertia Time Area Real Integer Boolean String Quaternion""".split()


@pytest.mark.parametrize("name", RULING_14)
def test_named_by_the_language(name):
    assert TYPES[name].name == name


@pytest.mark.parametrize("name", TYPES)
def test_units_are_coherent_and_display_units_fit(name):
    known = TYPES[name]
    unit = parse_unit(known.unit)
    assert (unit.factor, unit.offset) == (1.0, 0.0)
    assert known.dimension == unit.dimension
    if known.display_unit is not None:
        shown = parse_unit(known.display_unit)
        assert shown.dimension == known.dimension
        assert from_si(si_value(3.5, shown), shown) == pytest.approx(3.5)
    assert known.minimum in (None, 0.0)


@pytest.mark.parametrize(
    ("name", "exponents"),
    [
        ("Angle", {}),
        ("AngularMomentum", {"kg": 1, "m": 2, "s": -1}),
        ("RotationalDamping", {"kg": 1, "m": 2, "s": -1}),
        ("Capacitance", {"kg": -1, "m": -2, "s": 4, "A": 2}),
        ("ElectricField", {"kg": 1, "m": 1, "s": -3, "A": -1}),
        ("MagneticFluxDensity", {"kg": 1, "s": -2, "A": -1}),
        ("SpecificHeatCapacity", {"m": 2, "s": -2, "K": -1}),
    ],
)
def test_dimensions(name, exponents):
    assert TYPES[name].dimension == dimension(**exponents)


def test_kinds():
    assert TYPES["Torque"].dimension == TYPES["Energy"].dimension == ENERGY
    assert TYPES["Angle"].display_unit == "deg" and TYPES["Temperature"].display_unit == "degC"
    assert TYPES["Mass"].minimum == 0.0 and TYPES["Length"].minimum is None
    assert TYPES["Quaternion"].shape == (4,) and TYPES["Length"].shape == ()
    assert [TYPES[name].base for name in ("Real", "Integer", "Boolean", "String", "Quaternion")] == [
        "Real", "Integer", "Boolean", "String", "Real",
    ]  # fmt: skip


def test_constants():
    assert CONSTANTS["pi"].value == math.pi and CONSTANTS["pi"].dimension == DIMENSIONLESS
    assert CONSTANTS["g_n"].value == 9.80665 and CONSTANTS["g_n"].dimension == dimension(m=1, s=-2)
    assert CONSTANTS["inf"].value == math.inf
    assert all(constant.doc for constant in CONSTANTS.values())


def test_short_names_belong_to_the_user():
    assert not {"c", "e", "G", "R", "k", "h", "F"} & set(CONSTANTS)
