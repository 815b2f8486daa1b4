"""Values by name in Python: texts with units, arrays by their name, one exception for unknown names."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lagdsl

ROOT = Path(__file__).parents[3]
TEXT = """model Two
  parameter Mass m[2] = {1 kg, 2 kg};
  parameter Real gain = 1;
  coordinate Angle q[2](start = {10 deg, 20 deg});
  input Torque tau;
  potential (3 N.m/rad^2)*(q[1]^2 + q[2]^2)*gain;
  kinetic 1/2*(1 m2)*(m[1]*der(q[1])^2 + m[2]*der(q[2])^2);
  torque tau on q[1];
end Two;
"""
SHORT: dict[str, Any] = {"stop": 0.2, "interval": 0.1}


@pytest.fixture(scope="module")
def two() -> lagdsl.Model:
    return lagdsl.compile(TEXT)


def test_texts_and_arrays(two: lagdsl.Model) -> None:
    plain = {"m[1]": 0.5, "m[2]": 3.0}
    start = {"q[1]": np.radians(30), "q[2]": 0.1, "der(q[1])": np.radians(5)}
    expected = two.simulate(parameters=plain, start=start, inputs={"tau": 2.0}, **SHORT)
    found = two.simulate(
        parameters={"m": ["500 g", 3]},
        start={"q[1].start": "30 deg", "q[2]": 0.1, "der(q[1]).start": "5 deg/s"},
        inputs={"tau": "0.002 kN.m"},
        **SHORT,
    )
    for name in expected.names:
        np.testing.assert_array_equal(found[name], expected[name])
    state = two.initial_state(parameters={"m": np.array([1, 2])}, start={"q": ["30 deg", "40 deg"]})
    np.testing.assert_allclose(state.q, np.radians([30, 40]), rtol=1e-15)


def test_an_array_in_braces(two: lagdsl.Model) -> None:
    """As on the command line, for settings and for vectors by name."""
    listed = two.initial_state(parameters={"m": ["1 kg", "500 g"]}, start={"q": ["30 deg", "20 deg"]})
    braced = two.initial_state(parameters={"m": "{1 kg, 500 g}"}, start={"q.start": "{30, 20} deg"})
    np.testing.assert_array_equal(braced.q, listed.q)
    np.testing.assert_array_equal(braced.p, listed.p)
    found = two.mass_matrix(0.0, {"q": "{30, 20} deg"}, p={"m": "{1, 0.5} kg"})
    np.testing.assert_array_equal(found, two.mass_matrix(0.0, listed.q, p=listed.p))
    with pytest.raises(ValueError, match="has 2 elements"):
        two.mass_matrix(0.0, {"q": "{30, 20, 10} deg"})


GEARED = """model Geared
  type Gear = enumeration(reverse, neutral, forward);
  parameter Gear first = Gear.forward;
  input Gear gear;
  coordinate Length x;
  mass 1 kg at {x, 0};
  gravity = 0;
  force if gear == first then 3 N else 0 on x;
end Geared;
"""


def test_values_of_an_enumeration_by_name() -> None:
    model = lagdsl.compile(GEARED, engine="tape")
    for gear, first, acceleration in (("forward", 3, 3.0), ("Gear.reverse", "reverse", 3.0), (2, "Gear.forward", 0.0)):
        motion = model.simulate(inputs={"gear": gear}, parameters={"first": first}, **SHORT)
        assert motion["x"][-1] == pytest.approx(acceleration / 2 * 0.2**2, abs=1e-12)
    assert model.forward_dynamics(0.0, [0], [0], u={"gear": "forward"}, w=[1.0]).shape == (1,)
    with pytest.raises(ValueError, match="gear=sideways: `gear` is one of reverse, neutral, forward"):
        model.simulate(inputs={"gear": "sideways"}, **SHORT)


def test_the_value_of_an_enumeration_that_is_not_given_is_told() -> None:
    sink = lagdsl.foundation.diagnostics.Sink()
    lagdsl.compile(GEARED, engine="tape").simulate(sink=sink, **SHORT)
    (note,) = [each for each in sink.diagnostics if each.code == "N0875"]
    assert "it is reverse" in note.message and note.help is not None and "gear=forward" in note.help


def test_sweeps_take_the_same(two: lagdsl.Model) -> None:
    pytest.importorskip("xarray")
    swept = two.sweep({"m": [0.5, 3.0], "q[1].start": "0:10:20 deg", "gain": [1.0, 2.0]}, inputs={"tau": 0.0}, **SHORT)
    assert swept["q[1]"].dims == ("q[1].start", "gain", "time")
    np.testing.assert_allclose(swept["q[1].start"].values, np.radians([0, 10, 20]), rtol=1e-15)
    assert float(swept["m[2]"]) == 3.0
    many = two.simulate_many(parameters={"m": [[1, 2], [0.5, 3]]}, start={"q[1].start": ["5 deg", 0.2]}, **SHORT)
    one = two.simulate(parameters={"m": [0.5, 3]}, start={"q[1]": 0.2}, **SHORT)
    np.testing.assert_array_equal(many["q[2]"][1], one["q[2]"])


def test_small_motions_take_the_same(two: lagdsl.Model) -> None:
    here = two.linearize(q={"q": ["0 deg", "0 deg"]}, p={"m": ["1 kg", "2 kg"]}, u={"tau": "0 N.m"})
    np.testing.assert_array_equal(here.A, two.linearize(q=[0, 0]).A)
    column = lagdsl.compile(ROOT / "models" / "ziegler_column.lag")
    threshold = [column.vary("P", text, q=[0, 0]).thresholds[0].value for text in ("0:0.5:3 N", "linspace(0, 3, 7) N")]
    assert threshold == [column.vary("P", np.arange(7) * 0.5, q=[0, 0]).thresholds[0].value] * 2


@pytest.mark.parametrize(
    "ask",
    [
        lambda model: model.simulate(parameters={"mm": 1}),
        lambda model: model.simulate(start={"qq": 1}),
        lambda model: model.simulate(parameters={"m": 1}),
        lambda model: model.simulate(inputs={"tauu": 1}),
        lambda model: model.simulate(inputs={"tauu": "1 N.m"}),
        lambda model: model.initial_state(start={"m.start": 1}),
        lambda model: model.simulate_many(parameters={"mm": [1]}),
        lambda model: model.simulate_many(start={"qq": [1]}),
        lambda model: model.sweep({"mm": [1, 2]}),
        lambda model: model.sweep({"q[1]": [1, 2]}),
        lambda model: model.linearize(q={"qq": 1}),
        lambda model: model.linearize(u={"tauu": 1}),
        lambda model: model.linearize(p={"mm": 1}),
        lambda model: model.modes(z={"s": 1}),
        lambda model: model.trim(free=["zz"]),
        lambda model: model.trim(hold=["zz"]),
        lambda model: model.vary("zz", [1, 2]),
        lambda model: model.export_fmu("x.fmu", parameters={"mm": 1}),
        lambda model: lagdsl.compile(TEXT, structural={"mm": 1}),
    ],
)
def test_unknown_names_raise_one_exception(two: lagdsl.Model, ask: Any) -> None:
    pytest.importorskip("xarray")
    with pytest.raises(lagdsl.UnknownName) as raised:
        ask(two)
    assert isinstance(raised.value, KeyError) and isinstance(raised.value, lagdsl.CompilationFailed)
    assert raised.value.diagnostics and "error[E" in str(raised.value)


@pytest.mark.parametrize(
    ("ask", "words"),
    [
        (lambda model: model.simulate(parameters={"m[1]": "500"}), "write the text with a unit, '500 kg'"),
        (lambda model: model.simulate(parameters={"m[1]": "1 m"}), "is a mass"),
        (lambda model: model.simulate(parameters={"m": [1]}), "has 2 elements"),
        (lambda model: model.simulate(parameters={"m": [1, 2], "m[1]": 3}), "given twice"),
        (lambda model: model.simulate(start={"q[1]": 1, "q[1].start": 2}), "given twice"),
        (lambda model: model.simulate(parameters={"m[1]": [1, 2]}), "must be a number"),
        (lambda model: model.simulate(inputs={"tau": "2"}), "write the text with a unit"),
        (lambda model: model.vary("m[1]", "1:2:5"), "not from:to:count"),
        (lambda model: model.vary("m[1]", "1:2"), "or give numbers in SI units"),
        (lambda model: model.sweep({"m[1]": "1, 2"}), "or give numbers in SI units"),
        (lambda model: model.sweep({"m[1]": "1 kg:2 kg:4"}), "linspace"),
        (lambda model: model.simulate_many(parameters={"m": [1, 2, 3]}), "has 2 elements"),
    ],
)
def test_values_that_do_not_fit(two: lagdsl.Model, ask: Any, words: str) -> None:
    pytest.importorskip("xarray")
    with pytest.raises(ValueError, match=words.replace("(", r"\(")):
        ask(two)


def test_the_nearest_name_is_proposed(two: lagdsl.Model) -> None:
    with pytest.raises(lagdsl.UnknownName, match=r"E0874.*no parameter `gian`; did you mean `gain`"):
        two.simulate(parameters={"gian": 2})


def test_notes_go_to_the_sink(two: lagdsl.Model) -> None:
    from lagdsl.foundation.diagnostics import Sink

    for ask in (two.simulate, two.linearize):
        sink = Sink()
        ask(sink=sink)
        assert "N0875" in [each.code for each in sink.diagnostics]
