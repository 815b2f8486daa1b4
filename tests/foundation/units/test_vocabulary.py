"""The checked-in vocabulary against the grammar and against pint."""

import math
import re
from pathlib import Path

import pytest
from choice import together
from hypothesis import given
from hypothesis import strategies as st

from lagdsl.foundation.units import generate
from lagdsl.foundation.units.definition import PI, from_si, si_value
from lagdsl.foundation.units.parse import parse_unit
from lagdsl.foundation.units.vocabulary import UNITS


@pytest.fixture(scope="module")
def registry():
    return generate.pint_registry()


def test_vocabulary_is_the_list_of_the_grammar():
    assert list(UNITS) == generate.unit_names()


def test_checked_in_file_is_what_the_generator_writes(registry):
    definitions = {name: generate.definition_from_pint(registry, name) for name in generate.unit_names()}
    assert generate.TARGET.read_text(encoding="utf-8") == generate.render(definitions)


def test_main_writes_the_target(registry, tmp_path, monkeypatch):
    monkeypatch.setattr(generate, "TARGET", tmp_path / "vocabulary.py")
    generate.main()
    assert "degC" in (tmp_path / "vocabulary.py").read_text(encoding="utf-8")


@together("name", UNITS)
def test_conversion_agrees_with_floating_pint(name):
    import pint

    registry = pint.get_application_registry()
    unit = UNITS[name]
    spelled = "revolution" if name == "rev" else name.replace("Ohm", "ohm")
    for number in (0.0, 1.0, 36.6):
        quantity = registry.Quantity(number, spelled).to_base_units()
        kilograms = unit.dimension.exponents[0]  # pint's base unit of mass is the kilogram here too
        assert kilograms == quantity.dimensionality.get("[mass]", 0)
        expected = quantity.magnitude
        assert si_value(number, unit) == pytest.approx(expected, rel=1e-14, abs=1e-300)
        assert number * unit.factor + unit.offset == pytest.approx(expected, rel=1e-14, abs=1e-300)


def test_no_unit_is_a_keyword_of_the_language():
    text = generate.GRAMMAR.read_text(encoding="utf-8")
    words = set(re.findall(r'"([a-z]+)"', text.split("\nUNIT:")[0]))
    words |= set(re.findall(r"[a-z]+", " ".join(re.findall(r"\(\?:([a-z|]+)\)", text))))
    assert {"from", "with", "mass", "partial", "force", "end"} <= words
    assert not words & set(UNITS)
    assert not {"l", "L", "in"} & set(UNITS)


def test_values_are_rounded_once():
    assert si_value("45", UNITS["mm"]) == 0.045
    assert si_value("0.3", UNITS["mm"]) == 0.0003
    assert si_value("60", UNITS["deg"]) == math.pi / 3
    assert si_value("900", UNITS["rpm"]) == float(30 * PI)
    assert si_value("20", UNITS["degC"]) == 293.15
    assert si_value("1e400", UNITS["km"]) == math.inf
    assert si_value("1e-400", UNITS["km"]) == 0.0
    assert si_value("1" + "0" * 300 + "e-300", UNITS["km"]) == 1000.0
    assert si_value("0." + "1" * 5000, UNITS["m"]) == pytest.approx(1 / 9)
    assert from_si(293.15, UNITS["degC"]) == 20.0
    assert from_si(math.inf, UNITS["mm"]) == math.inf


def test_customary_units_by_their_definitions():
    """International yard and pound (1959), standard gravity, thermochemical calorie, SI 2019."""
    foot, pound, gravity = 0.3048, 0.45359237, 9.80665
    known = {
        "ft": foot, "yd": 3 * foot, "inch": foot / 12, "mile": 5280 * foot, "kn": 1852 / 3600, "lb": pound,
        "lbf": pound * gravity, "psi": pound * gravity / (foot / 12) ** 2, "atm": 101325.0, "cal": 4.184,
        "kcal": 4184.0, "hp": 550 * foot * pound * gravity, "eV": 1.602176634e-19, "arcmin": math.pi / 180 / 60,
        "arcsec": math.pi / 180 / 3600, "%": 0.01, "lbf.ft": foot * pound * gravity, "mile/h": 0.44704,
    }  # fmt: skip
    for name, factor in known.items():
        assert parse_unit(name).factor == pytest.approx(factor, rel=1e-15)
    assert parse_unit("lb").dimension == parse_unit("kg").dimension
    assert parse_unit("lbf").dimension == parse_unit("N").dimension


@given(st.sampled_from(sorted(UNITS)), st.floats(-1e9, 1e9))
def test_there_and_back(name, number):
    unit = UNITS[name]
    assert from_si(si_value(number, unit), unit) == pytest.approx(number, rel=1e-14, abs=1e-12)


def test_offset_is_lost_in_products():
    assert parse_unit("degC").offset == 273.15
    assert parse_unit("W/degC").offset == 0.0
    assert parse_unit("W/degC") == parse_unit("W/K")


def test_run_time_does_not_import_pint():
    package = Path(generate.__file__).parent
    for path in package.glob("*.py"):
        if path.name != "generate.py":
            assert "pint" not in re.sub(r'""".*?"""', "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
