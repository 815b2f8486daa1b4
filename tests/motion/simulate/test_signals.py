"""Inputs as functions of time: steps for what counts, lines, monotone cubics where two derivatives are needed.
References are integrals of the rows by hand."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.motion.signals.inputs import Signals, signals

TRAPEZOID = ([0.0, 1.0, 3.0, 4.0], [0.0, 1.0, 1.0, 0.0])
DRIVEN = """
model M
  import Lag.Rotational.*;
  {source};
  Rotor load(J = 2 kg.m2);
  input {input};
  connect(drive.phi, load.phi);
  output Angle angle = load.phi;
  output AngularVelocity speed = der(load.phi);
  annotation(experiment(StopTime = 4));
end M;
"""
SPEED = DRIVEN.format(source="SpeedSource drive(w = w)", input="AngularVelocity w(smooth = 1)")
ANGLE = DRIVEN.format(source="PositionSource drive(phi_ref = w)", input="Angle w(smooth = 2)")


def sums(declaration: str, text: str = "u") -> lagdsl.Model:
    """z with der(z) = the input."""
    return lagdsl.compile(f"""
    model M
      {declaration};
      state Real z(unit = "s");
      output Real y = {text};
    equation
      der(z) = {text};
    end M;
    """)


def given(model: lagdsl.Model, sink: Sink | None = None, stop: float = 4.0, **inputs: Any) -> Signals:
    flat = model._compilation.flat
    own = Sink() if sink is None else sink
    found = signals(flat, np.zeros(len(flat.inputs)), inputs, (0.0, stop), own)
    if sink is None:
        own.raise_if_errors()
    return found


def values(found: Signals, times: NDArray[np.float64], index: int = 0) -> NDArray[np.float64]:
    return np.array([found.at(t)[index] for t in times])


# ---- smooth inputs ---------------------------------------------------------------------------------------------------


def test_a_table_of_speeds_turns_by_its_integral() -> None:
    motion = lagdsl.compile(SPEED).simulate(inputs={"w": TRAPEZOID})
    assert motion["angle"][-1] == pytest.approx(3.0, abs=1e-9)
    assert np.max(motion["speed"]) <= 1.0 + 1e-9
    assert motion["speed"] == pytest.approx(np.interp(motion.time, *TRAPEZOID), abs=1e-8)


@pytest.mark.parametrize("seed", range(10))
def test_speeds_of_random_tables_are_straight_lines(seed: int) -> None:
    random = np.random.default_rng(seed)
    times = np.concatenate([[0.0], np.sort(random.uniform(0.1, 3.9, 4)), [4.0]])
    rows = random.uniform(-2, 2, 6)
    found = given(lagdsl.compile(SPEED), w=(times, rows))
    at = np.linspace(0, 4, 400, endpoint=False)
    assert values(found, at) == pytest.approx(np.interp(at, times, rows), abs=1e-12)
    slopes = np.diff(rows) / np.diff(times)
    assert values(found, times[:-1], 1) == pytest.approx(slopes)
    assert [found.at(t, before=True)[1] for t in times[1:]] == pytest.approx(slopes)
    assert found.breaks == tuple(times[1:-1])


@pytest.mark.parametrize("seed", range(10))
def test_positions_have_no_extremum_between_the_rows(seed: int) -> None:
    random = np.random.default_rng(seed)
    times = np.concatenate([[0.0], np.sort(random.uniform(0.1, 3.9, 6)), [4.0]])
    rows = np.round(random.uniform(-2, 2, 8), 1)
    found = given(lagdsl.compile(ANGLE), w=(times, rows))
    for t0, t1, y0, y1 in zip(times, times[1:], rows, rows[1:], strict=False):
        at = np.linspace(t0, t1, 50)
        inside = values(found, at[:-1])
        assert np.all(np.diff(inside) * np.sign(y1 - y0) >= -1e-12)
        assert found.at(t1)[0] == pytest.approx(y1, abs=1e-12)
        # Each derivative is that of the one before, by central differences within the piece.
        h = (t1 - t0) * 1e-4
        middle = (t0 + t1) / 2
        for order in (0, 1):
            slope = (found.at(middle + h)[order] - found.at(middle - h)[order]) / (2 * h)
            assert found.at(middle)[order + 1] == pytest.approx(slope, rel=1e-5, abs=1e-6)
    for t in times[1:-1]:
        assert found.at(t)[1] == pytest.approx(found.at(t, before=True)[1], abs=1e-9)
    assert found.breaks == tuple(times[1:-1])


def test_positions_are_followed_and_the_curve_is_told() -> None:
    sink = Sink()
    motion = lagdsl.compile(ANGLE).simulate(inputs={"w": TRAPEZOID}, sink=sink)
    assert np.max(motion["angle"]) <= 1.0 + 1e-9
    assert motion["angle"][-1] == pytest.approx(0.0, abs=1e-9)
    inside = (motion.time >= 1) & (motion.time <= 3)
    assert motion["angle"][inside] == pytest.approx(1.0, abs=1e-9)
    assert [d.code for d in sink.diagnostics if d.code == "N0848"] == ["N0848"]


def test_a_row_that_stands_twice_for_another_column_counts_once() -> None:
    times = [0.0, 1.0, 2.0, 2.0, 3.0, 4.0]
    model = lagdsl.compile("""
    model M
      import Lag.Rotational.*;
      SpeedSource drive(w = w);
      Rotor load(J = 2 kg.m2);
      input AngularVelocity w(smooth = 1);
      input Force F;
      coordinate Length x;
      kinetic 1/2*(1 kg)*der(x)^2;
      force F on x;
      connect(drive.phi, load.phi);
      output Angle angle = load.phi;
    end M;
    """)
    rows = ([0.0, 1.0, 1.0, 1.0, 1.0, 0.0], [0.0, 0.0, 0.0, 2.0, 2.0, 2.0])
    motion = model.simulate(stop=4, inputs={"w": (times, rows[0]), "F": (times, rows[1])})
    assert motion["angle"][-1] == pytest.approx(3.0, abs=1e-9)
    assert motion["x"][-1] == pytest.approx(2.0 * 2.0**2 / 2, abs=1e-9)


@pytest.mark.parametrize(
    ("text", "inputs", "code"),
    [
        (ANGLE, {"w": ([0, 2, 2, 4], [0, 0, 1, 1])}, "E0847"),
        (ANGLE.replace("smooth = 2", "smooth = 3"), {"w": TRAPEZOID}, "E0846"),
        (SPEED, {"der(w)": 1.0}, "E0849"),
        (SPEED, {"der(w)": TRAPEZOID}, "E0849"),
    ],
)
def test_what_has_no_derivative_is_refused(text: str, inputs: dict[str, Any], code: str) -> None:
    with pytest.raises(CompilationFailed) as failure:
        lagdsl.compile(text).simulate(inputs=inputs)
    assert [d.code for d in failure.value.diagnostics if d.code.startswith("E")] == [code]


def test_a_derivative_comes_from_the_nearest_one_that_is_given() -> None:
    """der(der(w)) is the slope of what is given for der(w), not the curvature of the rows of w."""
    times = np.linspace(0.0, 4.0, 5)
    found = given(lagdsl.compile(ANGLE), **{"w": (times, times**2 / 2), "der(w)": (times, times)})
    at = np.linspace(0.0, 3.9, 14)
    assert values(found, at, 1) == pytest.approx(at)
    assert values(found, at, 2) == pytest.approx(np.ones(14))


# ---- inputs that count -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(5))
def test_integers_hold_from_row_to_row(seed: int) -> None:
    random = np.random.default_rng(seed)
    times = np.concatenate([[0.0], np.sort(random.uniform(0.1, 3.9, 4)), [4.0]])
    rows = random.integers(-3, 4, 6).astype(float)
    motion = sums("input Integer u").simulate(stop=4, inputs={"u": (times, rows)})
    assert set(motion["y"]) <= set(rows)
    assert motion["z"][-1] == pytest.approx(np.sum(rows[:-1] * np.diff(times)), abs=1e-9)


def test_truths_hold_from_row_to_row() -> None:
    model = sums("input Boolean u", "(if u then 1 else 0)")
    motion = model.simulate(stop=4, inputs={"u": ([0.0, 1.0, 3.0, 4.0], [0.0, 1.0, 0.0, 0.0])})
    assert motion["z"][-1] == pytest.approx(2.0, abs=1e-9)


def test_a_jump_counts_from_its_time_on() -> None:
    found = given(sums("input Integer u"), u=([0, 1, 1, 4], [1, 1, 3, 5]))
    assert found.at(1.0)[0] == 3.0 and found.at(1.0, before=True)[0] == 1.0
    assert found.at(3.999)[0] == 3.0 and found.at(4.0)[0] == 5.0
    assert found.breaks == (1.0,)


@pytest.mark.parametrize("signal", [1.5, ([0, 4], [1, 1.25])])
def test_parts_of_integers_are_refused(signal: Any) -> None:
    with pytest.raises(CompilationFailed) as failure:
        sums("input Integer u").simulate(stop=4, inputs={"u": signal})
    assert [d.code for d in failure.value.diagnostics] == ["E0845"]
