"""Values that parameters make infinite, negative or nothing: said before the first step, whoever gives the values."""

from __future__ import annotations

import pytest
from choice import together
from flattening import run

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import check

_PHYSICS = "coordinate Length x; mass 1 kg at {x, 0}; gravity = 0;"


def told(statements: str) -> dict[str, str]:
    """Codes and messages before anything is derived."""
    flat, sink = run(f"model M {statements} end M;")
    if flat is not None:
        from lagdsl.language.semantics.wellformed.check import check as check_physics

        check_physics(flat, sink)
    return {each.code: each.message for each in sink.diagnostics}


@together(
    ("declarations", "message"),
    [
        ("parameter Real k = 0; parameter Real g = 1/k;", "`g` has no finite value with k = 0"),
        ("parameter Real k = 0; parameter Real g = k/k;", "`g` has no finite value with k = 0"),
        ("parameter Real k = -1; parameter Real g = sqrt(k);", "`g` has no finite value with k = -1"),
        ("parameter Real k = 0; parameter Real g = log(k);", "`g` has no finite value with k = 0"),
        ("parameter Real k = 2; parameter Angle g = asin(k);", "`g` has no finite value with k = 2"),
        ("parameter Real k = 800; parameter Real g = exp(k);", "`g` has no finite value with k = 800"),
        ("parameter Real k = 1e200; parameter Real g = k^2;", "`g` has no finite value with k = 1e+200"),
        ("parameter Length l = 0 m; parameter Real g = 1 m/l;", "`g` has no finite value with l = 0 m"),
        ("parameter Real k[2] = {1, 0}; parameter Real g[2] = {1/k[1], 1/k[2]};", "`g[2]` has no finite value"),
        ("function f(Real a) -> Real = 1/a; parameter Real k = 0, g = f(k);", "`g` has no finite value with k = 0"),
        ("parameter Real k = 0, g = 1/k, h = 2*g;", "`g` has no finite value with k = 0"),
        ("parameter Real k = 0, g = (k - 1)^0.5;", "`g` has no finite value with k = 0"),
        ("parameter Real k = 0, g = atan2(1/k, 1);", "`g` has no finite value with k = 0"),
        ("parameter Real k = 0; mass 1 kg/k at {x, 1 m};", "mass has no finite value with k = 0"),
        ("parameter Real k = 0; discrete Real n(start = 1/k);", "the start of `n` has no finite value with k = 0"),
        ("parameter Mass m = inf; mass m at {x, 1 m};", "mass has no finite value with m = inf kg"),
        (
            "parameter Real k = 0; body b(m = 1 kg, Izz = 1 kg.m2/k) on world.move({x, 0, 0});",
            "moment of inertia has no",
        ),
    ],
)
def test_no_finite_value(declarations: str, message: str) -> None:
    found = told(f"{_PHYSICS} {declarations}")
    assert found["E0329"].startswith(message)


def test_gravity_is_finite() -> None:
    found = told("coordinate Length x; mass 1 kg at {x, 0}; parameter Real k = 0; gravity = -1 m/s2/k*world.x;")
    assert found["E0329"] == "gravity has no finite value with k = 0"


@pytest.mark.parametrize(
    "declarations",
    [
        "parameter Real k = 0, g = if k > 0 then 1/k else 0;",
        "parameter Real high = inf, low = -high, w = 2*high, part = 1/high, none = high - high;",
        "parameter Real k = 1e300, g = k/1e300;",
        "parameter Real k = 0, g = atan2(k, k);",
    ],
)
def test_finite_or_unbounded_by_intent(declarations: str) -> None:
    assert "E0329" not in told(f"{_PHYSICS} {declarations}")


@pytest.mark.parametrize("value", ["1e308*100", "exp(1000)", "1e200^2", "-1e308*100"])
def test_number_beyond_the_range(value: str) -> None:
    """Some became an infinite parameter."""
    assert told(f"{_PHYSICS} parameter Real k = {value};")["E0323"].endswith("the number is too large")


@pytest.mark.parametrize(
    "statement",
    [
        "parameter Damping d = -1 N.s/m; force -d*der(x) on x;",
        'parameter RotationalDamping d = -0.1 N.m.s/rad; parameter Real s = value(d, "N.m.s"); force s*1 N on x;',
        "parameter Real k = -2; parameter Damping d = k*(1 N.s/m); force -d*der(x) on x;",
        "dissipation -1/2*(1 N.s/m)*der(x)^2;",
        "parameter Real k = -1; dissipation 1/2*k*(1 N.s/m)*der(x)^2;",
    ],
)
def test_negative_damping(statement: str) -> None:
    assert "W0522" in told(f"{_PHYSICS} {statement}")
    assert "W0522" not in told(f"{_PHYSICS} {statement.replace('-2', '2').replace('-1', '1').replace('-0.1', '0.1')}")


@pytest.mark.parametrize(
    ("statement", "code"),
    [
        ("parameter Mass m = 0 kg; mass m at {x, 1 m};", "N0523"),
        ("mass 0 kg at {x, 1 m};", "W0514"),
        ("parameter Mass m = 0 kg; body b(m = m, Izz = m*(1 m2)) on world.move({x, 0, 0});", "N0523"),
        ("body b(m = 0) on world.move({x, 0, 0});", "W0514"),
        ("parameter Inertia J = 0; body b(m = 0, Izz = J) on world.move({x, 0, 0});", "N0523"),
    ],
)
def test_body_without_mass_and_inertia(statement: str, code: str) -> None:
    assert code in told(f"{_PHYSICS} {statement}")


def test_body_with_one_of_them() -> None:
    found = told(f"{_PHYSICS} body b(m = 0, Izz = 1 kg.m2) on world.move({{x, 0, 0}});")
    assert not {"W0514", "N0523"} & {code for code, message in found.items() if "neither" in message}


_GIVEN = """
model M
  parameter Real k = 1, g = 1/k, rho = 1;
  coordinate Length x;
  gravity = 0;
  mass rho*(1 kg) at {x, 0};
  output Real told = g;
end M;
"""


@pytest.fixture(scope="module")
def given() -> lagdsl.Model:
    return lagdsl.compile(_GIVEN)


@pytest.mark.parametrize(("values", "code"), [({"k": 0.0}, "E0329"), ({"rho": -1.0}, "E0506")])
def test_values_given_to_a_run(given: lagdsl.Model, values: dict[str, float], code: str) -> None:
    """The first gave a column of nan, the second a mass of -1 kg, both without a word."""
    with pytest.raises(CompilationFailed) as failure:
        given.simulate(stop=0.1, parameters=values)
    assert [each.code for each in failure.value.diagnostics] == [code]


def test_values_after_others_are_looked_at_as_those_of_a_new_model() -> None:
    """Only what changed parameters decide is computed anew: definitions of definitions, sums of both, bounds that are
    none, and back."""
    text = """model M
  parameter Real a = 1, b = 1, most = inf;
  parameter Real c = 1/a, d = c/b, e = 2*most;
  parameter Mass m = 1 kg;
  coordinate Length x;
  mass m*(c + d) at {x, 0};
  gravity = -1 m/s2/b*world.x;
end M;
"""
    kept = lagdsl.compile(text, engine="tape")
    given = [{}, {"a": 0.0}, {"a": 2.0}, {"b": 0.0}, {"a": 2.0, "b": 0.0}, {"m": -1.0}, {"a": -2.0}, {"a": 2.0}]
    given += [{"most": 3.0}, {"most": float("nan")}, {"b": 2.0}, {}, {"m": -1.0, "a": 0.0}]

    def codes(model: lagdsl.Model, values: dict[str, float]) -> list[str]:
        try:
            model.simulate(stop=0.01, interval=0.01, parameters=values)
        except CompilationFailed as failure:
            return [f"{each.code} {each.message}" for each in failure.diagnostics]
        except ValueError as error:
            return [str(error)]
        return []

    found = [codes(kept, values) for values in given]
    assert found == [codes(lagdsl.compile(text, engine="tape"), values) for values in given]
    assert [len(each) > 0 for each in found] == [bool(k in (1, 3, 4, 5, 6, 9, 12)) for k in range(len(given))]


def test_values_given_to_many_motions(given: lagdsl.Model) -> None:
    motions = given.simulate_many(stop=0.1, parameters={"k": [1.0, 0.0, 2.0]})
    assert list(motions.failures) == [1] and "`g` has no finite value with k = 0" in motions.failures[1]


def test_values_of_the_text() -> None:
    found, _ = check(SourceFile("M.lag", _GIVEN.replace("k = 1", "k = 0")))
    assert [each.code for each in found] == ["E0329"]
