"""Types and constants that every model knows."""

import math
import os

import pytest
from choice import together

from lagdsl.foundation.units.definition import from_si, si_value
from lagdsl.foundation.units.dimension import DIMENSIONLESS, ENERGY, dimension
from lagdsl.foundation.units.naming import unit_text
from lagdsl.foundation.units.parse import parse_unit
from lagdsl.foundation.units.vocabulary import UNITS
from lagdsl.language.semantics.scope.prelude import CONSTANTS, TYPES

QUANTITIES = [
    "Velocity",
    "Acceleration",
    "AngularVelocity",
    "AngularAcceleration",
    "Momentum",
    "AngularMomentum",
    "Force",
    "Torque",
    "Energy",
    "Power",
    "Stiffness",
    "Damping",
    "RotationalStiffness",
    "RotationalDamping",
    "Density",
    "LinearDensity",
    "Pressure",
    "Volume",
    "VolumeFlowRate",
    "Frequency",
    "Charge",
    "Current",
    "Voltage",
    "Resistance",
    "Inductance",
    "Capacitance",
    "MagneticFlux",
    "MagneticFluxDensity",
    "ElectricField",
    "Temperature",
    "Angle",
    "Length",
    "Distance",
    "Position",
    "Mass",
    "Inertia",
    "Time",
    "Area",
    "Real",
    "Integer",
    "Boolean",
    "String",
    "Quaternion",
]


@together("name", QUANTITIES)
def test_named_by_the_language(name):
    assert TYPES[name].name == name


@together("name", TYPES)
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


def quantities() -> str:
    """docs/reference/quantities.md: what the language knows without import."""
    lines = ["# Quantities, constants, units", ""]
    lines += ["Every model knows these without import. Written from `lagdsl/language/semantics/scope/prelude.py` and"]
    lines += ["`lagdsl/foundation/units/vocabulary.py` by `make update`.", "", "## Types", ""]
    lines += ["| type | SI unit | shown in | at least |", "|---|---|---|---|"]
    for known in TYPES.values():
        unit = known.unit if known.base == "Real" else ""
        least = "" if known.minimum is None else f"{known.minimum:g}"
        size = f" ({known.shape[0]} elements)" if known.shape else ""
        lines.append(f"| {known.name}{size} | {unit} | {known.display_unit or ''} | {least} |")
    lines += ["", "## Constants", "", "| name | value | unit | |", "|---|---|---|---|"]
    lines += [f"| {c.name} | {c.value!r} | {c.unit} | {c.doc} |" for c in CONSTANTS.values()]
    lines += ["", "## Units of literals", "", "| unit | in SI |", "|---|---|"]
    for name, unit in UNITS.items():
        pi = {0: "", 1: " pi", -1: " / pi"}[unit.pi_power]
        shift = f", after adding {float(unit.shift):g}" if unit.shift else ""
        lines.append(f"| {name} | {unit.scale}{pi} {unit_text(unit.dimension)}{shift} |")
    return "\n".join(lines) + "\n"


def test_the_documentation_lists_them_all(root):
    path = root / "docs" / "reference" / "quantities.md"
    expected = quantities()
    if os.environ.get("LAGDSL_UPDATE"):
        path.write_text(expected, encoding="utf-8")
    assert path.read_text(encoding="utf-8") == expected
