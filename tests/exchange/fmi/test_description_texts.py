"""The description of any text is XML that reads back, with names on one line."""

from __future__ import annotations

import math
import re
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from fmi.described import description, of_text, table_of, table_of_text, tree
from fmi.test_descriptions import SCHEMA
from lagdsl.exchange.fmi.description.xml import document, element, number, text
from lagdsl.exchange.fmi.variables.variables import Version

STILL = "model Still coordinate Length x; gravity = 0; mass 1 kg at {x, 0}; end Still;"
# Characters that XML 1.0 can hold, section 2.2, and those that stand for the rest.
POSSIBLE = re.compile("[\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def held(written: str) -> str:
    return "".join(c if POSSIBLE.fullmatch(c) else "\ufffd" for c in written)


@given(st.text(max_size=40), st.sampled_from([2, 3]))
def test_any_text_of_a_model_reads_back(doc: str, version: Version) -> None:
    still = table_of_text(STILL, version)
    coordinate = next(v for v in still.variables if v.name == "x")
    told = replace(coordinate, attributes=replace(coordinate.attributes, doc=doc))
    variables = tuple(told if v is coordinate else v for v in still.variables)
    root = tree(replace(still, flat=replace(still.flat, doc=doc, name=f"A{doc}"), variables=variables))
    assert root.attrib["description"] == held(doc)
    (found,) = (v for v in root.iter() if v.get("name") == "x" and "valueReference" in v.attrib)
    assert found.attrib["description"] == held(doc)
    assert not re.search(r"[\t\n\r]", root.attrib["modelName"])


@pytest.mark.parametrize("version", [2, 3])
def test_hostile_texts_are_valid_by_schema(version: Version) -> None:
    doc = "]]> <!-- & \\ \" ' \x00 \x1b \ud800 \uffff \U0001f600\n\t" + "x" * 10_000
    still = table_of_text(STILL, version)
    written = description(replace(still, flat=replace(still.flat, doc=doc)))
    SCHEMA[version].assertValid(etree.fromstring(written.encode()))


@given(st.floats())
def test_numbers_read_back(value: float) -> None:
    written = number(value)
    assert re.fullmatch(r"-?[0-9]+(\.[0-9]+)?(e[+-]?[0-9]+)?|-?INF|NaN", written)  # xs:double
    assert math.isnan(float(written)) if math.isnan(value) else float(written) == value


def test_truth_is_written_as_schemas_want_it() -> None:
    assert [text(value) for value in (True, False, 1, 0, 1.0)] == ["true", "false", "1", "0", "1.0"]
    assert document(element("a", b_=None, c=True)) == '<?xml version="1.0" encoding="UTF-8"?>\n<a c="true" />\n'


@pytest.mark.parametrize("version", [2, 3])
def test_other_defaults_are_told(version: Version) -> None:
    """A model that is exported with other parameters than its text has."""
    compilation = of_text(STILL.replace("mass 1 kg", "parameter Mass m = 1 kg; mass m"))
    layout = replace(compilation.program.layout, defaults=(2.5,))
    changed = replace(compilation, program=replace(compilation.program, layout=layout))
    (found,) = (v for v in table_of(changed, version).variables if v.name == "m")
    assert found.starts == (2.5,)


@pytest.mark.parametrize(
    ("declared", "shown", "rates"),
    [
        ("Angle x", "deg", ["deg/s", "deg/s2"]),
        ('Length x(displayUnit = "mm")', "mm", ["mm/s", "mm/s2"]),
        ('Real x(unit = "m/s", displayUnit = "km/h")', "km/h", [None, None]),
        ("Length x", None, [None, None]),
    ],
)
def test_rates_are_shown_in_units_of_their_own(declared: str, shown: str | None, rates: list[str | None]) -> None:
    kinetic = {"Angle x": "1 kg.m2", "Real": "1 kg.s2"}.get(declared[:7], {"Real": "1 kg.s2"}.get(declared[:4], "1 kg"))
    text = f"model Shown coordinate {declared}; gravity = 0; kinetic 1/2*({kinetic})*der(x)^2; end Shown;"
    units = {v.name: v.attributes.display_unit for v in table_of(of_text(text), 3).variables}
    assert [units[name] for name in ("x", "der(x)", "der(x,2)")] == [shown, *rates]
