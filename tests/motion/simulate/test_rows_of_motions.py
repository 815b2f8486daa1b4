"""Rows tell the truth: lowest and highest are those of the motion, and rows that hide it are told."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from choice import engines

import lagdsl
from lagdsl.documents.plot.terminal import sketch
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.interfaces.cli.summary import summary
from lagdsl.motion.pipeline import compile_flat, flatten_file
from lagdsl.motion.simulate.simulate import simulate

FAST = """
model Fast "100 Hz, and half a kilohertz of current"
  coordinate Length x(start = 1 mm);
  parameter Real f = 100;
  kinetic 1/2*(1 kg)*der(x)^2;
  potential 1/2*(1 kg)*(2*pi*f*(1 Hz))^2*x^2;
  output Length twice = 2*x;
  annotation(experiment(StopTime = 5));
end Fast;
"""

BALL = """
model Ball
  coordinate Length h(start = 1 m);
  gravity = -g_n*world.y;
  mass 0.1 kg at {0, h};
  contact floor: h >= 0 with restitution = 0.8;
end Ball;
"""


@pytest.mark.parametrize("engine", engines(["tape", "numpy"]))
def test_rows_that_nobody_asked_for_show_the_motion(engine: EngineName) -> None:
    """Rows every hundredth of a second would show a mass that stands still."""
    motion = lagdsl.compile(FAST, engine=engine).simulate(stop=0.5)
    assert len(motion) - 1 >= 4 * 100  # turning points
    assert np.max(np.abs(motion["x"] - 1e-3 * np.cos(200.0 * np.pi * motion.time))) < 1e-8
    assert np.ptp(motion["x"]) > 1.99e-3
    assert not motion.statistics.notes


def test_a_slow_motion_has_the_usual_rows() -> None:
    motion = lagdsl.compile(FAST).simulate(stop=10.0, parameters={"f": 1.0})
    assert len(motion) == 501 and motion.drawn().time is motion.time


def test_lowest_and_highest_lie_between_rows() -> None:
    """All rows are alike: ten whole periods apart."""
    motion = lagdsl.compile(FAST).simulate(interval=0.1, tolerance=1e-8)
    assert np.ptp(motion["x"]) < 1e-7
    x, rate, twice = (motion.column(name) for name in ("x", "der(x)", "twice"))
    assert (x.lowest, x.highest) == pytest.approx((-1e-3, 1e-3), rel=1e-5)
    assert (rate.lowest, rate.highest) == pytest.approx((-0.2 * np.pi, 0.2 * np.pi), rel=1e-5)
    assert 1.8e-3 < twice.highest <= 2e-3 * (1.0 + 1e-6)  # outputs are looked at after steps
    assert "  -0.001  " in summary(motion, freedom=1, loops=(), curves=False)


def test_rows_that_hide_the_motion_are_told() -> None:
    motion = lagdsl.compile(FAST).simulate(interval=0.1)
    (note,) = motion.statistics.notes
    assert note.startswith("the rows do not show `x`, which turns around 1000 times: they are 0.1 s apart, ")
    assert not lagdsl.compile(FAST).simulate(interval=1e-3, stop=1.0).statistics.notes


def test_who_wants_no_extremes_has_the_same_rows_and_theirs() -> None:
    """Pictures have many outputs and look at rows alone."""
    apart = "  coordinate Length y(start = 1 m);\n  kinetic 1/2*(1 kg)*der(y)^2;\n"  # an island of its own
    for text in (FAST, FAST.replace("  output", f"{apart}  output")):
        flat = flatten_file(SourceFile("fast.lag", text), Sink())
        made = None if flat is None else compile_flat(flat, Sink())
        assert made is not None
        engine = engine_of(made.program)
        whole, rows = (simulate(engine, made.flat, stop=1.0, interval=0.07, extremes=each) for each in (True, False))
        for one, other in zip(whole.columns, rows.columns, strict=True):
            assert np.array_equal(one.values, other.values)
            assert (other.lowest, other.highest) == (np.min(one.values), np.max(one.values))
        assert whole.columns[1].lowest < rows.columns[1].lowest


def test_drawings_show_what_rows_do_not() -> None:
    motion = lagdsl.compile(FAST).simulate(interval=0.1, stop=1.0)
    assert np.ptp(motion.drawn()["x"]) > 1.99e-3
    assert motion.drawn() is motion.drawn()
    assert len(motion.drawn(smooth=True)) - 1 >= 32 * 200  # turning points
    assert sketch(motion, width=60) == sketch(motion.drawn(), width=60)


def test_the_highest_point_of_a_bounce_lies_between_rows() -> None:
    """0.64 m, half a bounce behind the first impact."""
    motion = lagdsl.compile(BALL).simulate(stop=1.0, start={"h": 0.5}, interval=1.0, tolerance=1e-10)
    after = lagdsl.compile(BALL).simulate(stop=1.0, start={"h": 1e-9, "der(h)": 2.0}, interval=1.0, tolerance=1e-10)
    assert motion.column("h").lowest == pytest.approx(0.0, abs=1e-12)
    assert after.column("h").highest == pytest.approx(1e-9 + 2.0**2 / (2.0 * 9.80665), rel=1e-10)


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-10])
def test_extremes_are_those_of_a_fine_grid(tolerance: float) -> None:
    """Rows do not depend on the steps: of a beat, whose peaks grow."""
    text = """
    model Beat
      coordinate Length x(start = 1 m), y;
      kinetic 1/2*(1 kg)*(der(x)^2 + der(y)^2);
      potential 1/2*(50 N/m)*(x^2 + y^2) + 1/2*(2 N/m)*(x - y)^2;
    end Beat;
    """
    coarse = lagdsl.compile(text).simulate(stop=20.0, interval=20.0, tolerance=tolerance)
    fine = lagdsl.compile(text).simulate(stop=20.0, interval=1e-3, tolerance=tolerance)
    for name in ("x", "y", "der(x)", "der(y)"):
        column = coarse.column(name)
        assert column.highest == pytest.approx(np.max(fine[name]), rel=1e-4)
        assert column.lowest == pytest.approx(np.min(fine[name]), rel=1e-4)


@pytest.mark.parametrize("settings", [{}, {"tolerance": 1e-5}, {"solver": "radau"}, {"solver": "rk4", "step": 0.01}])
def test_extremes_of_outputs_lie_between_rows(settings: dict[str, Any]) -> None:
    """x = cos 10 t: products of states, an acceleration, peaks narrower than a step, and a function of time alone."""
    text = """
    model Peaks
      coordinate Length x(start = 1 m);
      kinetic 1/2*(1 kg)*der(x)^2;
      potential 1/2*(100 N/m)*x^2;
      output Power P = -100 N/m*x*der(x);
      output Acceleration a = der(der(x));
      output Real rest = 1 - 2/(1 + (x/(0.1 mm))^2);
      output Length beside = 3 m - 2 m*exp(-((x - 0.3 m)/(2 cm))^2);
      output Real fast = sin(200 rad/s*time);
    end Peaks;
    """
    motion = lagdsl.compile(text).simulate(stop=3.0, interval=1.0, **settings)
    known = {"P": (-500, 500), "a": (-100, 100), "rest": (-1, 1), "beside": (1, 3), "fast": (-1, 1)}
    for name, (lowest, highest) in known.items():
        column = motion.column(name)
        assert column.lowest == pytest.approx(lowest, rel=1e-3)
        assert column.highest == pytest.approx(highest, rel=1e-3)
