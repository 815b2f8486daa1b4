"""Outputs that are infinite or no numbers end a run with their name; those of singular positions do not."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl
from lagdsl.diagnostics import Sink
from lagdsl.pipeline import flatten_file
from lagdsl.simulate.unknown_outputs import first_unknown
from lagdsl.source import SourceFile

MODEL = """model M
  parameter Length x0 = 1 m;
  coordinate Length x(start = x0, der.start = -1 m/s);
  kinetic 1/2*(1 kg)*der(x)^2;
  output Length ok = x;
  output Real root = sqrt(x/(1 m));
end M;
"""


def test_an_output_that_gets_lost_on_the_way() -> None:
    model = lagdsl.compile(MODEL, engine="tape")
    assert np.isfinite(model.simulate(stop=0.9)["root"]).all()
    with pytest.raises(lagdsl.SimulationFailed) as found:
        model.simulate(stop=2.0, interval=0.25)
    failure = found.value
    assert failure.diagnostic.code == "E0857" and failure.name == "root" and failure.time == 1.25
    assert failure.state["x"] == pytest.approx(-0.25)
    assert failure.trajectory["ok"][-1] == pytest.approx(-1.0)


def test_an_output_that_is_none_at_the_start() -> None:
    text = MODEL.replace("sqrt(x/(1 m))", "(1 m)/(x - x0)")
    (error,) = lagdsl.check(text)
    assert error.code == "E0857" and "infinite at t = 0 s" in error.message
    with pytest.raises(lagdsl.SimulationFailed, match="output `root` is infinite at t = 0 s"):
        lagdsl.compile(text, engine="tape").simulate(stop=0.1)


def test_rows_without_accelerations_are_left_alone() -> None:
    text = """model P
      coordinate Length x(start = 1 m), y;
      kinetic 1/2*(1 kg)*(der(x)^2 + der(y)^2);
      constraint x^2 + y^2 = 1 m2;
      output Length a = x, b = y;
    end P;"""
    pendulum = flatten_file(SourceFile("p.lag", text), Sink())
    assert pendulum is not None
    lost = np.array([[1.0, 2.0], [np.nan, np.nan], [1.0, np.inf]])
    assert first_unknown(pendulum, lost[:2]) is None
    assert first_unknown(pendulum, lost) == (2, 1)
