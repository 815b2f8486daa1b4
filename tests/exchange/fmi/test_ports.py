"""Variables that an FMU shows: chosen outputs, hidden variables, coordinates where a model declares no output."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from fmpy import read_model_description, simulate_fmu
from models.corpus import MODELS, compiled, path_of

import lagdsl
from fmi.described import of_text, table_of, tree
from fmi.description_rules import broken
from fmi.test_descriptions import SCHEMA
from lagdsl.exchange.fmi.variables.ports import Ports
from lagdsl.exchange.fmi.variables.variables import Table, Version
from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.cli.main import lag
from lagdsl.motion.pipeline import Compilation

VERSIONS = pytest.mark.parametrize("version", [2, 3])
ARMS = """model Link
  parameter Length l = 1 m;
  parameter Mass m(min = 0.1 kg) = 1 kg;
  coordinate Angle q(start = 1);
  mass m at {l*sin(q), -l*cos(q)};
  Velocity tip = l*der(q);
protected
  Angle double = 2*q;
  parameter Stiffness k = 1 N/m;
  potential 1/2*k*q^2*l^2;
  discrete Integer ups(start = 0);
equation
  when q > 0 then
    ups = pre(ups) + 1;
  end when;
end Link;

model Arms
  gravity = {0, -g_n};
  Link left, right(q(start = 0.5));
  coordinate Angle w[2](each start = 1);
  kinetic 1/2*(1 kg.m2)*(der(w)*der(w));
protected
  Link inner;
end Arms;
"""


@cache
def arms() -> Compilation:
    return of_text(ARMS)


def shown(version: Version, **wishes: Any) -> tuple[Table, list[str]]:
    """The table, and codes of what is said of it."""
    sink = Sink()
    found = table_of(arms(), version, ports=Ports(**wishes), sink=sink)
    return found, [diagnostic.code for diagnostic in sink.diagnostics]


def names(table: Table, causality: str | None = None) -> list[str]:
    return [v.name for v in table.variables if causality in (None, v.attributes.causality)]


@VERSIONS
def test_what_is_protected_is_hidden_but_for_states(version: Version) -> None:
    """Also everything in a protected component."""
    told = names(shown(version)[0])
    assert {"left.l", "left.m", "left.q", "left.tip", "inner.q", "der(inner.q)"} <= set(told)
    assert not [name for name in told if name.startswith("inner") and name != "inner.q"]
    assert not [name for name in told if name.endswith((".double", ".k", ".ups"))]


@VERSIONS
def test_coordinates_are_outputs_where_a_model_declares_none(version: Version) -> None:
    table, told = shown(version)
    assert told == ["N0927"]
    arrays = ["w"] if version == 3 else ["w[1]", "w[2]"]
    assert set(names(table, "output")) == {*arrays, "left.q", "right.q", "inner.q"}
    assert broken(tree(table)) == []
    SCHEMA[version].assertValid(tree_of(table))


def tree_of(table: Table) -> Any:
    from lxml import etree

    from fmi.described import description

    return etree.fromstring(description(table).encode())


@VERSIONS
def test_chosen_outputs(version: Version) -> None:
    """By the names of the language or of the FMU, by patterns, of any kind; an array of FMI 3 is one output."""
    table, told = shown(version, outputs=("der(der(left.q))", "der(right.q,2)", "*.tip", "der(w[2])", "energy.total"))
    assert told == []
    arrays = ["der(w)"] if version == 3 else ["der(w[2])"]
    expected = {"der(left.q,2)", "der(right.q,2)", "left.tip", "right.tip", "inner.tip", "energy.total", *arrays}
    assert set(names(table, "output")) == expected
    assert broken(tree(table)) == []
    SCHEMA[version].assertValid(tree_of(table))
    by_name = {table.variables[u.variable].name: u for u in table.structure.outputs}
    tip = {table.variables[known].name for known, _ in by_name["left.tip"].dependencies}
    assert tip == {"der(left.q)"}


@VERSIONS
def test_hidden_variables(version: Version) -> None:
    table, told = shown(version, hidden=("left.*", "energy.*"), outputs=("left.tip",))
    assert told == []
    assert "left.l" not in names(table)
    assert "left.tip" not in names(table)
    assert "left.q" in names(table)
    assert not [name for name in names(table) if name.startswith("energy")]
    assert broken(tree(table)) == []


def test_hidden_inputs_are_told() -> None:
    """They were left out without a word, and the FMU ran without force."""
    sink = Sink()
    text = ARMS.replace("  Link left", "  input Force u, ux[2];\n  input Real other;\n  Link left")
    table = table_of(of_text(text), 2, ports=Ports(outputs=("w",), hidden=("u", "u*")), sink=sink)
    assert names(table, "input") == ["other"]
    told = [(each.code, each.message.partition(";")[0].partition(": ")[2]) for each in sink.diagnostics]
    assert told == [("N0929", "`u`"), ("N0929", "`ux[1]`, `ux[2]`")]


@pytest.mark.parametrize(
    ("wishes", "codes"),
    [
        ({"outputs": ("left.z",)}, ["E0925"]),
        ({"outputs": ("left.l",)}, ["E0925"]),  # a parameter
        ({"outputs": ("w[3]",)}, ["E0925"]),
        ({"outputs": ("",)}, ["E0925"]),
        ({"outputs": ("w[?]", "left.q"), "hidden": ("arm.*",)}, ["E0926"]),
        ({"outputs": ("w",), "hidden": ("left.q", "der(left.q)")}, ["E0926", "E0926"]),
        ({"outputs": ("w",), "hidden": ("time",)}, ["E0926"]),
    ],
)
def test_wishes_that_nothing_fulfils(wishes: dict[str, Any], codes: list[str]) -> None:
    assert shown(2, **wishes)[1] == codes


def test_entries_of_arrays_instead_of_arrays() -> None:
    table, _ = shown(3, scalar=True)
    assert all(variable.shape == () for variable in table.variables)
    assert {"w[1]", "der(w[2])", "der(w[2],2)"} <= set(names(table))
    assert broken(tree(table)) == []
    SCHEMA[3].assertValid(tree_of(table))


@pytest.mark.parametrize("name", [name for name in MODELS if not name.startswith("library/")][::9])
def test_every_model_has_an_output(name: str) -> None:
    table = table_of(compiled(name).compilation, 2)
    assert table.structure.outputs


def test_the_command(tmp_path: Path) -> None:
    """The FMU with chosen variables runs; its description says whose it is."""
    path = tmp_path / "d.fmu"
    attribution = ["--author", "A & B", "--license", "MIT", "--model-version", "1 <2>"]
    options = ["--output", "der(a)", "--hide", "energy.*", *attribution, "-o", str(path)]
    done = CliRunner().invoke(lag, ["fmu", str(path_of("double_pendulum")), *options])
    assert done.exit_code == 0, done.output
    description = read_model_description(str(path))
    assert (description.author, description.license, description.version) == ("A & B", "MIT", "1 <2>")
    rows = simulate_fmu(str(path), stop_time=1.0, relative_tolerance=1e-10)
    assert rows.dtype.names == ("time", "der(a)")
    motion = lagdsl.compile(path_of("double_pendulum"), engine="tape").simulate(stop=1.0, tolerance=1e-10)
    assert rows["der(a)"][-1] == pytest.approx(motion["der(a)"][-1], abs=1e-8)


def test_a_file_is_no_output() -> None:
    done = CliRunner().invoke(lag, ["fmu", str(path_of("double_pendulum")), "--output", "x.fmu"])
    assert done.exit_code == 2
    assert "-o x.fmu" in done.output


TYPES = """type Way = enumeration(off "no <way>", on) "ways to go";
type Level = Integer(min = 0, max = 7) "of a lift";
type Load = Force(min = 0) "what it carries";

model Lift
  input Way way;
  input Level level;
  input Mass extra;
  input Load load;
  output Load carried = load;
  output Level next(max = 5) = level;
  coordinate Length h(start = 1 m);
  kinetic 1/2*(1 kg)*der(h)^2;
  force extra*(1 m/s2) on h;
  force (if way == Way.on then level*(1 N) else load) on h;
end Lift;
"""


@VERSIONS
def test_types_with_their_texts_and_bounds(version: Version) -> None:
    """Bounds of a type are those of its variables, also of types of the language: a mass is not negative."""
    table = table_of(of_text(TYPES), version)
    SCHEMA[version].assertValid(tree_of(table))
    assert broken(tree(table)) == []
    bounds = {v.name: (v.attributes.minimum, v.attributes.maximum) for v in table.variables}
    assert bounds["level"] == (0.0, 7.0)
    assert bounds["next"] == (0.0, 5.0)
    assert bounds["load"] == bounds["carried"] == bounds["extra"] == (0.0, None)
    definitions = tree(table).find("TypeDefinitions")
    assert definitions is not None
    texts = {kind.get("name"): kind.get("description") for kind in definitions}
    assert (
        texts.items()
        >= {
            "Way": "ways to go",
            "Load": "what it carries",
        }.items()
    )
    items = [(item.get("name"), item.get("description")) for item in definitions.iter("Item")]
    assert items == [("off", "no <way>"), ("on", None)]
