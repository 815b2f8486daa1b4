"""Descriptions are valid by schema and by rule, in both versions of FMI."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import fmpy
import pytest
from choice import spread
from fmpy.model_description import read_model_description
from fmpy.validation import validate_model_description
from lxml import etree
from models.corpus import MODELS

from fmi.described import description, of_text, table_of, table_of_model, table_of_text, tree
from fmi.description_rules import broken, entries
from fmi.exported import in_versions
from lagdsl.exchange.fmi.variables.builtin_variables import indicator_count
from lagdsl.exchange.fmi.variables.variables import Table, Version

SAMPLE = (
    "andrews_squeezer",  # cut joints
    "bouncing_ball_modelica",  # Integers that change
    "chain",  # arrays, structural parameters
    "excavator",  # nominal values, units to show
    "furuta_swing_up",  # clocks
    "library/blocks_sources",  # texts
    "newtons_cradle",  # arrays of contacts
    "pick_and_place",  # Booleans that change
    "quarter_car",  # a Boolean parameter, inputs
    "rolling_coin",  # rows of velocity level
    "skateboard",
)
EVERY = tuple(MODELS) if os.environ.get("LAGDSL_EXPLORE") else SAMPLE
VERSIONS = pytest.mark.parametrize("version", [2, 3])
SCHEMA = {
    version: etree.XMLSchema(
        etree.parse(Path(fmpy.__file__).parent / "schema" / f"fmi{version}" / f"fmi{version}ModelDescription.xsd")
    )
    for version in (2, 3)
}

EVERYTHING = """
type Gear = enumeration(low, high);
type Choice = Gear;
type Count = Integer;
model Everything "a <model> & \\"more\\""
  parameter Length l = 1 m "<b>&amp;</b>";
  parameter Force most = inf;
  parameter Length start = 0.3 m "of x";
  parameter Gear gear = Gear.high;
  parameter Choice gears[2] = {Gear.low, Gear.high};
  structural parameter Gear built = Gear.low;
  structural parameter Integer n = 2;
  parameter Integer teeth(min = 1, max = 99) = 12;
  parameter Boolean on = true;
  parameter Length twice = 2*l;
  constant Real pair[2] = {1, 2};
  input Force F(start = 2 N);
  input Length road(smooth = 2);
  coordinate Length x(start = start);
  coordinate Length q[2](each start = 1 m, each nominal = 2 m);
  coordinate Length r(start = 1 m, min = 0, max = 0.5 m);
  state Real xi(start = 3, nominal = 10);
  discrete Gear now(start = Gear.low);
  discrete Count hits(start = 0);
  output Boolean up = x > 0;
  output Count many = hits + 1;
  output Gear shown = now;
  output Velocity speed = der(x);
  output Length places[2] = q;
  Real energy = xi;
  Real residual = xi;
  Real solver = 1;
  Real indicator = xi;
  gravity = 0;
  mass 1 kg at {x, road};
  mass teeth*1 kg at {q[1], q[2], r};
  force min(F, most) on x;
  force (if gear == Gear.low or gears[1] == Gear.low or not on then 1 N else 2 N)*twice/l on q[1];
  constraint tie: q[1] - q[2] = 0;
  constraint ties: {q[1], q[2]} = {r, r};
equation
  der(xi) = -xi/(1 s);
  when x > 1 m then
    now = Gear.high;
    hits = pre(hits) + 1;
    reinit(xi, 0);
  end when;
end Everything;
"""


def read(text: str, folder: Path) -> Any:
    (folder / "modelDescription.xml").write_text(text, encoding="utf-8")
    return read_model_description(str(folder), validate=False)


@in_versions(spread(EVERY, 4))
def test_descriptions_of_models_are_valid(name: str, version: Version, tmp_path: Path) -> None:
    _assert_valid(table_of_model(name, version), version, tmp_path)


@VERSIONS
def test_a_description_of_everything_is_valid(version: Version, tmp_path: Path) -> None:
    _assert_valid(table_of_text(EVERYTHING, version), version, tmp_path)


def _assert_valid(given: Table, version: Version, tmp_path: Path) -> None:
    text = description(given)
    SCHEMA[version].assertValid(etree.fromstring(text.encode()))
    assert broken(tree(given)) == []
    assert validate_model_description(read(text, tmp_path), True, True) == []
    assert description(given) == text


@VERSIONS
def test_what_is_written_reads_back(version: Version, tmp_path: Path) -> None:
    """Numbers to the last bit, texts letter by letter, by another reader."""
    given = table_of_text(EVERYTHING, version)
    found = read(description(given), tmp_path)
    assert found.description == 'a <model> & "more"'
    assert found.generationTool.startswith("lagdsl ")
    assert (found.guid if version == 2 else found.instantiationToken) == "{0123}"
    by_name = {variable.name: variable for variable in found.modelVariables}
    assert by_name["l"].description == "<b>&amp;</b>"
    assert float(by_name["most"].start) == float("inf") and by_name["most"].max is None
    for variable in given.variables:
        if variable.attributes.type == "REAL" and variable.starts:
            numbers = by_name[variable.name].start
            assert [float(n) for n in str(numbers).split()] == [float(s) for s in variable.starts]


@VERSIONS
def test_each_kind_of_variable(version: Version) -> None:
    variables = {v.name: v for v in entries(tree(table_of_text(EVERYTHING, version)))}

    def told(name: str, *attributes: str) -> tuple[str | None, ...]:
        found = variables[name]
        both = {**found.attributes, **found.values}
        return (found.tag, *(both.get(attribute) for attribute in attributes))

    real = "Real" if version == 2 else "Float64"
    whole = "Integer" if version == 2 else "Int32"
    plain = ("causality", "variability", "initial")
    assert told("time", *plain, "unit") == (real, "independent", "continuous", None, "s")
    assert told("l", *plain, "unit", "start") == (real, "parameter", "tunable", "exact", "m", "1.0")
    assert told("start", *plain) == (real, "parameter", "fixed", "exact")
    assert told("twice", *plain) == (real, "calculatedParameter", "tunable", "calculated")
    assert told("teeth", *plain, "min", "max", "start") == (whole, "parameter", "tunable", "exact", "1", "99", "12")
    assert told("on", *plain, "start") == ("Boolean", "parameter", "tunable", "exact", "true")
    assert told("gear", *plain, "declaredType", "start") == (
        "Enumeration",
        "parameter",
        "tunable",
        "exact",
        "Gear",
        "2",
    )
    assert told("built", *plain, "start") == ("Enumeration", "local", "constant", "exact", "1")
    assert told("n", *plain, "start") == (whole, "local", "constant", "exact", "2")
    assert told("F", *plain, "unit", "start") == (real, "input", "continuous", None, "N", "2.0")
    assert told("der(road,2)", *plain, "unit", "start") == (real, "input", "continuous", None, "m/s2", "0.0")
    # The start of x is that of a parameter, those of q are moved onto the constraints.
    assert told("x", *plain, "start") == (real, "local", "continuous", "approx", "0.3")
    assert told("r", *plain, "min", "max") == (real, "local", "continuous", "approx", "0.0", None)
    assert told("xi", *plain, "nominal", "reinit") == (real, "local", "continuous", "exact", "10.0", "true")
    assert told("der(xi)", *plain, "unit") == (real, "local", "continuous", "calculated", "1/s")
    assert told("der(x,2)", *plain, "unit") == (real, "local", "continuous", "calculated", "m/s2")
    assert told("now", *plain) == ("Enumeration", "local", "discrete", "calculated")
    assert told("hits", *plain) == (whole, "local", "discrete", "calculated")
    assert told("up", *plain) == ("Boolean", "output", "discrete", "calculated")
    assert told("many", *plain) == (whole, "output", "discrete", "calculated")
    assert told("shown", *plain, "declaredType") == ("Enumeration", "output", "discrete", "calculated", "Gear")
    assert told("tie.multiplier", *plain, "unit") == (real, "local", "continuous", "calculated", "N")
    assert told("energy_.total", *plain, "unit") == (real, "local", "continuous", "calculated", "J")
    assert told("residual_.velocity", *plain) == (real, "local", "continuous", "calculated")
    assert told("solver_.step", *plain, "unit", "min") == (real, "parameter", "fixed", "exact", "s", "0.0")
    # The coordinates q follow from r for good: they are no states, and have no derivatives in the sense of FMI.
    assert told("der(r,2)", "derivative") == (real, variables["der(r)"].key)
    assert told("der(r)", "derivative", "reinit") == (real, variables["r"].key, "true")
    if version == 3:
        assert variables["q"].size == variables["der(q)"].size == variables["der(q,2)"].size == 2
        assert variables["ties.multiplier"].size == variables["places"].size == variables["gears"].size == 2
        assert told("der(q,2)", "derivative") == (real, None)
        table = table_of_text(EVERYTHING, 3)
        assert variables["indicator_"].size == indicator_count(table.flat, table.program) > 0
    else:
        assert {"q[2]", "der(q[2])", "der(q[2],2)", "ties.multiplier[2]", "places[1]"} <= set(variables)
        assert told("der(q[2],2)", "derivative") == (real, None)


@VERSIONS
def test_kinds_that_are_left_out(version: Version) -> None:
    compilation = of_text(EVERYTHING)
    both, exchange, simulation = (table_of(compilation, version, kinds) for kinds in (("me", "cs"), ("me",), ("cs",)))

    def interfaces(given: Table) -> set[str]:
        return {tag for tag in ("ModelExchange", "CoSimulation") if tree(given).find(tag) is not None}

    assert interfaces(both) == {"ModelExchange", "CoSimulation"}
    assert interfaces(exchange) == {"ModelExchange"} and interfaces(simulation) == {"CoSimulation"}
    names = [{variable.name for variable in given.variables} for given in (both, exchange, simulation)]
    assert names[0] == names[2] == names[1] | {"solver_.step"}


def test_needless_calls_are_spared() -> None:
    """Only who has constraints, events or something to watch wants to hear of completed steps."""
    items = {
        "": False,
        'equation assert(x < 1 m, "far");': True,
        "invariant p: der(x);": True,
        "coordinate Length y; mass 1 kg at {y, x}; constraint c: x = y;": True,
        "force (if x > 0 then -1 N else 0 N) on x;": True,
    }
    for item, needed in items.items():
        text = f"model Still coordinate Length x; gravity = 0; mass 1 kg at {{x, 0}}; {item} end Still;"
        found = tree(table_of(of_text(text), 3)).find("ModelExchange")
        assert found is not None and found.attrib["needsCompletedIntegratorStep"] == str(needed).lower()
