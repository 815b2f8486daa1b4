"""Outputs that are infinite or no numbers end a run with their name; those of singular positions do not."""

from __future__ import annotations

import numpy as np
import pytest
from compiled_programs import program_of

import lagdsl
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import flatten_file
from lagdsl.motion.simulate.unknown_outputs import UnknownOutputs

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
        model.simulate(stop=2.0, interval=0.4)
    failure = found.value
    assert failure.diagnostic.code == "E0857" and failure.name == "root" and failure.time == pytest.approx(1.2)
    assert failure.state["x"] == pytest.approx(-0.2)
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
      constraint rod: x^2 + y^2 = 1 m2;
      Real pull = multiplier(rod)*(1 m2)/(1 J);
      output Length a = x;
      output Real n = 2*pull, m = der(der(x))/(1 m/s2);
    end P;"""
    pendulum = flatten_file(SourceFile("p.lag", text), Sink())
    assert pendulum is not None
    engine = engine_of(program_of(text), "tape")
    outputs = UnknownOutputs(pendulum, engine)
    nothing = np.zeros(0)

    def first(values: np.ndarray, times: np.ndarray, x: float = np.nan) -> tuple[int, int] | None:
        return outputs.first(values, times, lambda _: (np.array([x, 0.0, 0.0, 0.0]), nothing, nothing))

    lost = np.array([[1.0, 2.0, 3.0], [1.0, np.nan, np.nan], [1.0, np.inf, 1.0], [np.nan, 1.0, 1.0]])
    times = np.arange(4.0)
    assert first(lost[:2], times[:2]) is None
    assert first(lost[:2], times[:2], x=1.0) == (1, 1)  # there the equations have a solution
    assert first(lost, times) == (2, 1)
    assert first(lost[[0, 1, 3]], times[:3]) == (2, 0)
    assert first(lost[[0, 1, 1]], times[:3]) == (1, 1)
    assert first(lost[[0, 1, 1]], np.array([0.0, 1.0, 1.0])) is None  # before and after an event


def test_a_single_row_of_an_output_that_reads_a_multiplier() -> None:
    """It passed for a singular position, which the pendulum has not."""
    text = """model P
      parameter Real most = 100;
      coordinate Length x(start = 1 m), y;
      gravity = {0, -9.81 m/s2};
      mass 1 kg at {x, y};
      constraint rod: x^2 + y^2 = 1 m2;
      output Real pull = sqrt(most + multiplier(rod)/(1 N/m));
    end P;"""
    model = lagdsl.compile(text, engine="tape")
    motion = model.simulate(stop=1.0, interval=0.05)
    lowest, second = np.sort(motion["pull"])[:2] ** 2
    most = 100.0 - (lowest + second) / 2
    with pytest.raises(lagdsl.SimulationFailed) as found:
        model.simulate(stop=1.0, interval=0.05, parameters={"most": most})
    assert found.value.diagnostic.code == "E0857"
    assert found.value.time == motion.time[np.argmin(motion["pull"])]
    assert np.count_nonzero(np.isnan(found.value.trajectory["pull"])) == 1
    motions = model.simulate_many(parameters={"most": [most, 100.0]}, stop=1.0, interval=0.05)
    assert list(motions.failures) == [0] and "E0857" in motions.failures[0]


def test_the_only_output_that_reads_a_multiplier() -> None:
    text = """model P
      coordinate Length x(start = 1 m), y;
      gravity = {0, -9.81 m/s2};
      mass 1 kg at {x, y};
      constraint rod: x^2 + y^2 = 1 m2;
      output Real root = sqrt(10 + multiplier(rod)/(1 N/m));
    end P;"""
    with pytest.raises(lagdsl.SimulationFailed, match="output `root` is not a number at t = 0"):
        lagdsl.compile(text, engine="tape").simulate(stop=1.0, interval=0.05)


HELD = """model H
  parameter Real limit = 0.5;
  coordinate Angle theta(start = 1 rad);
  coordinate Length x(start = sin(1)*(1 m)), y(start = -cos(1)*(1 m));
  gravity = {0, -9.81 m/s2};
  mass 1 kg at {x, y};
  constraint rod: {x, y} = {sin(theta)*(1 m), -cos(theta)*(1 m)};
  output Real root = sqrt(theta + limit);
end H;
"""


def test_the_only_output_of_a_model_with_constraints() -> None:
    model = lagdsl.compile(HELD, engine="tape")
    with pytest.raises(lagdsl.SimulationFailed) as found:
        model.simulate(stop=2.0, interval=0.1)
    assert found.value.diagnostic.code == "E0857" and found.value.name == "root"


def test_a_run_of_many_says_so_of_itself() -> None:
    model = lagdsl.compile(HELD, engine="tape")
    motions = model.simulate_many(parameters={"limit": [2.0, 0.5, 3.0]}, stop=2.0, interval=0.1)
    assert list(motions.failures) == [1] and motions.failures[1].startswith("E0857: output `root` is not a number")
    assert np.isfinite(motions["theta"]).all() and (motions.ended == 2.0).all()
    swept = model.sweep({"limit": [2.0, 0.5, 3.0]}, stop=2.0, interval=0.1)
    assert list(swept["status"].values) == ["ok", "failed", "ok"]
    assert str(swept["message"].values[1]) == motions.failures[1]
