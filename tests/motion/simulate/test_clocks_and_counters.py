"""Clocks alone, clocks that no run could follow, and Integers that lose digits."""

from __future__ import annotations

import time

import pytest

import lagdsl
from lagdsl.foundation.diagnostics import Sink

MODEL = """model M
  parameter Time h = 1 ms;
  coordinate Length x(start = 1 m);
  mass 1 kg at {{x, 0}};
  gravity = 0;
  discrete Integer n(start = 0);
equation
  when sample({first}, h) then n = {value}; end when;
end M;
"""


@pytest.mark.parametrize(
    ("first", "period"), [("0", 1e-300), ("0", 1e-9), ("0.05 s", 1e-8), ("-1 s", 1e-8), ("0", 5e-324)]
)
def test_too_many_ticks_are_told_before_the_motion(first: str, period: float) -> None:
    """A million steps were taken first."""
    model = lagdsl.compile(MODEL.format(first=first, value="pre(n) + 1"), engine="tape")
    begun = time.process_time()
    with pytest.raises(
        lagdsl.CompilationFailed, match="times in this simulation, which has at most 1000000 steps"
    ) as told:
        model.simulate(stop=0.1, parameters={"h": period})
    assert [each.code for each in told.value.diagnostics] == ["E0858"] and time.process_time() - begun < 1.0
    motions = model.simulate_many(parameters={"h": [1e-3, period]}, stop=0.1)
    assert list(motions.failures) == [1] and motions.failures[1].startswith("E0858")


def test_a_clock_that_begins_later_ticks_less_often() -> None:
    model = lagdsl.compile(MODEL.format(first="10 s", value="pre(n) + 1"), engine="tape")
    assert model.simulate(stop=0.1, parameters={"h": 1e-300})["n"].max() == 0


def test_a_controller_alone_ticks() -> None:
    """It has no coordinate and no state: nothing moves between its ticks."""
    text = "model M\n  input Real u = 2;\n  discrete Real s(start = 0);\nequation\n"
    text += "  when sample(0, 0.25 s) then s = pre(s) + u; end when;\nend M;\n"
    motion = lagdsl.compile(text, engine="tape").simulate(stop=1.1, interval=0.1)
    assert motion["s"][-1] == 10.0 and motion["s"][0] == 2.0


@pytest.mark.parametrize(
    ("value", "lost"), [("10*pre(n) + 1", True), ("-10*pre(n) - 1", True), ("mod(10*pre(n) + 1, 1000003)", False)]
)
def test_integers_that_lose_digits(value: str, lost: bool) -> None:
    """10^k/9 is no 64 bit number from k = 17 on; `mod` keeps the counter small."""
    model = lagdsl.compile(MODEL.format(first="0", value=value), engine="tape")
    sink = Sink()
    model.simulate(stop=0.02, sink=sink)
    told = [each for each in sink.diagnostics if each.code == "W0859"]
    assert bool(told) == lost
    if lost:
        assert "at t = 0.016 s" in told[0].message


@pytest.mark.parametrize("text", ["9007199254740992", "9007199254740993", "-9007199254740993", "3*9007199254740993"])
def test_integers_of_the_text(text: str) -> None:
    model = f"model M parameter Integer k = {text}; coordinate Length x; kinetic 1/2*k*(1 kg)*der(x)^2; end M;"
    assert "E0326" in {each.code for each in lagdsl.check(model)}
    assert "E0326" not in {each.code for each in lagdsl.check(model.replace(text, "9007199254740991"))}


def test_integers_that_are_set() -> None:
    model = "model M parameter Integer k = 1; coordinate Length x; kinetic 1/2*k*(1 kg)*der(x)^2; gravity = 0; end M;"
    with pytest.raises(ValueError, match="exact up to"):
        lagdsl.compile(model, engine="tape").simulate(parameters={"k": 2.0**53})
