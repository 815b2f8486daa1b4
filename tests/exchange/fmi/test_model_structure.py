"""The model structure: what closed forms say, and the same entry by entry in both versions."""

from __future__ import annotations

import numpy as np
import pytest
from choice import spread

from fmi.described import of_text, table_of, table_of_model, table_of_text
from fmi.test_descriptions import EVERYTHING, SAMPLE
from lagdsl.exchange.fmi.variables.names import named
from lagdsl.exchange.fmi.variables.scalar import Role, Variable
from lagdsl.exchange.fmi.variables.variables import Table

VERSIONS = pytest.mark.parametrize("version", [2, 3])
Told = dict[str, dict[str, str]]

OSCILLATORS = """model Oscillators
  parameter Mass m = 2 kg;
  parameter Stiffness k = 3 N/m;
  parameter Length ahead = 0.1 m;
  parameter Boolean pushed = true;
  input Force F;
  coordinate Length a(start = 1 m), b(start = ahead), c;
  state Real z(start = 1);
  output Force spring = k*a;
  output Length middle = (a + b)/2;
  output Velocity speed = der(c)*z;
  output Acceleration pull = der(der(a));
  output Length road = 0.1*m*sin(time/(1 s))*(1 m/kg);
  output Boolean far = a > 1 m;
  kinetic 1/2*m*(der(a)^2 + der(b)^2 + der(c)^2);
  potential 1/2*k*a^2 + 1/4*(1 N/m3)*b^4;
  gravity = 0;
  dissipation 1/2*(1 N.s/m)*der(c)^2;
  force (if pushed then F else 2*F) on c;
equation
  der(z) = -z/(1 s);
end Oscillators;
"""


def told(given: Table, part: str) -> Told:
    names = [variable.name for variable in given.variables]
    return {
        names[unknown.variable]: {names[other]: kind for other, kind in unknown.dependencies}
        for unknown in getattr(given.structure, part)
    }


@VERSIONS
def test_what_depends_on_what(version: int) -> None:
    given = table_of(of_text(OSCILLATORS), 2 if version == 2 else 3)
    assert told(given, "derivatives") == {
        "der(a)": {"der(a)": "constant"},
        "der(b)": {"der(b)": "constant"},
        "der(c)": {"der(c)": "constant"},
        "der(a,2)": {"a": "tunable"},
        "der(b,2)": {"b": "dependent"},
        "der(c,2)": {"der(c)": "tunable", "F": "tunable"},
        "der(z)": {"z": "constant"},
    }
    assert told(given, "outputs") == {
        "spring": {"a": "tunable"},
        "middle": {"a": "constant", "b": "constant"},
        "speed": {"der(c)": "dependent", "z": "dependent"},
        "pull": {"a": "tunable"},
        "road": {"time": "dependent"},
        "far": {"a": "dependent"},
    }


@VERSIONS
def test_what_the_start_depends_on(version: int) -> None:
    """States with start values of their own are given; that of b is a parameter."""
    given = table_of(of_text(OSCILLATORS), 2 if version == 2 else 3)
    found = told(given, "initial")
    assert found["b"] == {"ahead": "constant"}
    assert found["middle"] == {"a": "constant", "ahead": "constant"}
    assert found["spring"] == {"k": "dependent", "a": "dependent"}
    assert found["der(a,2)"] == {"m": "dependent", "k": "dependent", "a": "dependent"}
    assert found["der(c,2)"] == {
        "m": "dependent",
        "pushed": "dependent",
        "der(c)": "dependent",
        "F": "dependent",
    }
    assert found["der(z)"] == {"z": "constant"}
    assert found["road"] == {"time": "dependent", "m": "dependent"}
    assert "der(a)" not in found and "a" not in found


def test_starts_that_constraints_move_depend_on_all_of_them() -> None:
    text = """model Tied
      parameter Length l = 1 m; parameter Mass m = 1 kg;
      coordinate Length x(start = 0.6 m), y(start = 0.8 m), free(start = 1 m);
      mass m at {x, y}; mass m at {free, 0}; gravity = 0;
      constraint rod: x^2 + y^2 = l^2;
      output Length out = x;
    end Tied;"""
    found = told(table_of(of_text(text), 2), "initial")
    for name in ("x", "y", "out"):
        assert {"l", "m"} <= set(found[name])
        assert set(found[name].values()) == {"dependent"}
    assert "free" not in found or "l" not in found["free"]


def scalars(given: Table) -> list[list[str]]:
    """Names of the entries of each variable, as FMI 2 has them."""
    return [_entries(variable) for variable in given.variables]


def _entries(variable: Variable) -> list[str]:
    if not variable.shape:
        return [variable.name]
    name = named(variable.name)  # der(q,2) is one of q
    plain = variable.name.removeprefix("der(").removesuffix(")").removesuffix(",2")
    order = 0 if plain == variable.name else 2 if variable.name.endswith(",2)") else 1
    assert name.path
    indices = np.ndindex(*variable.shape)
    return [named(f"{plain}[{','.join(str(i + 1) for i in index)}]", order).text for index in indices]


def expanded(given: Table) -> set[tuple[str, str, str]]:
    """Pairs of entries with kinds, from what is told entry by entry."""
    names = scalars(given)
    found = set()
    for index, own in enumerate(given.structure.elements):
        for d in own:
            ones = names[index] if d.element == 0 else [names[index][d.element - 1]]
            others = names[d.other] if d.other_element == 0 else [names[d.other][d.other_element - 1]]
            found |= {(one, other, d.kind) for one in ones for other in others}
    return found


@pytest.mark.parametrize("name", [*spread(SAMPLE, 5), None])
def test_arrays_depend_as_their_entries_do(name: str | None) -> None:
    flat, arrays = (
        table_of_text(EVERYTHING, version) if name is None else table_of_model(name, version) for version in (2, 3)
    )
    indicators = {entry for _, v in arrays.of(Role.INDICATOR) for entry in _entries(v)}
    assert expanded(flat) == {pair for pair in expanded(arrays) if pair[0] not in indicators}
    entry_by_entry: Told = {}
    for one, other, kind in expanded(flat):
        entry_by_entry.setdefault(one, {})[other] = kind
    for part in ("outputs", "derivatives"):
        assert all(row == entry_by_entry.get(one, {}) for one, row in told(flat, part).items())
        of_arrays = told(arrays, part)
        names = {v.name: _entries(v) for v in arrays.variables}
        for one, row in of_arrays.items():
            union = {other for entry in names[one] for other in entry_by_entry.get(entry, {})}
            assert {entry for other in row for entry in names[other]} >= union
            assert all(set(names[other]) & union for other in row)
