"""Motions that the C runtime integrates, against those of SciPy's steppers over the same functions."""

from __future__ import annotations

import ctypes
from pathlib import Path

import numpy as np
import pytest

import lagdsl
from lagdsl.runtime.library import runtime_library
from lagdsl.runtime.structures import RunOptions, RunReport
from lagdsl.simulate.motion import loop
from lagdsl.simulate.simulate import simulate

MODELS = Path(__file__).parents[2] / "models"
TOLERANCE = 1e-8

OSCILLATOR = """
model Oscillator
  parameter Real e = {epsilon};
  parameter Time tau = 1 s;
  state Real x(start = 2), v(start = 0);
  equation
    der(x) = v/tau;
    der(v) = ((1 - x^2)*v - x)/(e*tau);
end Oscillator;
"""

DRIVEN = """
model Driven
  coordinate Length x(start = 0.3);
  input Force F = 1;
  parameter Mass m = 2;
  parameter Stiffness k = 50;
  kinetic m/2*der(x)^2;
  potential k/2*x^2;
  force F on x;
end Driven;
"""


BALL = """
model Ball
  coordinate Length h(start = 1 m);
  gravity = -g_n*world.y;
  mass 0.1 kg at {0, h};
  contact floor: h >= 0 with restitution = 0.8;
end Ball;
"""

HELD = """
model Held
  coordinate Length x(start = 1 m);
  discrete Force F(start = 0);
  kinetic 1/2*(2 kg)*der(x)^2;
  force F on x;
  when sample(0 s, 0.1 s) then
    F = -(8 N/m)*x - (4 N.s/m)*der(x);
  end when;
end Held;
"""


@pytest.fixture
def by_scipy(monkeypatch: pytest.MonkeyPatch):  # type: ignore[no-untyped-def]
    """Runs a simulation step by step in Python."""

    def run(model: lagdsl.Model, **options: object) -> lagdsl.Trajectory:
        with monkeypatch.context() as patch:
            patch.setattr(loop, "can_leap", lambda *_: False)
            return model.simulate(**options)  # type: ignore[arg-type]

    return run


def _difference(a: lagdsl.Trajectory, b: lagdsl.Trajectory) -> float:
    assert [c.name for c in a.columns] == [c.name for c in b.columns]
    np.testing.assert_array_equal(a.time, b.time)
    return max(float(np.max(np.abs(a[c.name] - c.values)) / max(1e-3, np.max(np.abs(c.values)))) for c in b.columns[1:])


@pytest.mark.parametrize(
    "name", ["double_pendulum", "four_bar", "pendulum_two_dependent_constraints", "rolling_sphere", "motor_pendulum"]
)
def test_both_are_the_same_motion(name: str, by_scipy: object) -> None:
    model = lagdsl.compile(MODELS / f"{name}.lag", engine="c")
    ours = model.simulate(stop=1, tolerance=TOLERANCE)
    theirs = by_scipy(model, stop=1, tolerance=TOLERANCE)  # type: ignore[operator]
    assert _difference(ours, theirs) < 100 * TOLERANCE
    np.testing.assert_allclose(ours.energy, theirs.energy, rtol=100 * TOLERANCE, atol=1e-6)
    assert ours.position_residual.max() <= 2e-3 * TOLERANCE
    assert ours.velocity_residual.max() <= 5e-2 * TOLERANCE
    assert [i.name for i in ours.invariants] == [i.name for i in theirs.invariants]


def test_python_is_not_asked_on_the_way() -> None:
    """Three evaluations by Python's right-hand side are those of the start and of the end; all others are C's."""
    statistics = lagdsl.compile(MODELS / "double_pendulum.lag", engine="c").simulate(stop=10).statistics
    assert statistics.solver == "dop853"
    assert 13 * statistics.steps < statistics.evaluations < 17 * statistics.steps + 50


def test_events_of_a_leap_are_on_time() -> None:
    first = lagdsl.compile(BALL, engine="c").simulate(stop=5)
    flight = np.sqrt(2.0 / 9.80665)
    exact = flight + np.concatenate([[0.0], np.cumsum(2.0 * flight * 0.8 ** np.arange(1, 9))])
    np.testing.assert_allclose([e.time for e in first.events][:9], exact, rtol=0, atol=1e-9)
    assert abs(first["h"][-1]) < 1e-9


def test_a_sampled_controller_does_not_see_the_rows() -> None:
    model = lagdsl.compile(HELD, engine="c")
    ends = [model.simulate(stop=2, interval=interval) for interval in (2.0, 0.0137, 0.1)]
    assert len({(end["x"][-1], end["der(x)"][-1], end["F"][-1]) for end in ends}) == 1
    other = lagdsl.compile(HELD, engine="numpy").simulate(stop=2)
    assert ends[0]["x"][-1] == pytest.approx(other["x"][-1], abs=1e-9)


@pytest.mark.parametrize(("epsilon", "stiff"), [(1e-5, True), (1.0, False)])
def test_the_method_is_chosen(epsilon: float, stiff: bool) -> None:
    trajectory = lagdsl.compile(OSCILLATOR.format(epsilon=epsilon), engine="c").simulate(stop=2)
    assert (trajectory.statistics.solver == "radau") is stiff
    assert bool(trajectory.statistics.notes) is stiff
    assert trajectory.statistics.evaluations < 20_000


@pytest.mark.parametrize("solver", ["dop853", "radau"])
def test_the_solver_may_be_named(solver: str) -> None:
    trajectory = lagdsl.compile(OSCILLATOR.format(epsilon=0.1), engine="c").simulate(stop=2, solver=solver)
    assert trajectory.statistics.solver == solver
    assert (trajectory.statistics.jacobians > 0) is (solver == "radau")


@pytest.mark.parametrize(
    "force", [3.0, lambda t: 2.0 * np.cos(3.0 * t), ([0.0, 0.4, 0.4, 1.0], [0.0, 1.0, -2.0, 3.0])], ids=["c", "f", "t"]
)
def test_inputs_of_every_kind(force: object, by_scipy: object) -> None:
    model = lagdsl.compile(DRIVEN, engine="c")
    ours = model.simulate(stop=1, tolerance=TOLERANCE, inputs={"F": force})  # type: ignore[dict-item]
    theirs = by_scipy(model, stop=1, tolerance=TOLERANCE, inputs={"F": force})  # type: ignore[operator]
    assert _difference(ours, theirs) < 10 * TOLERANCE


def test_what_an_input_raises_comes_through() -> None:
    def force(t: float) -> float:
        if t > 0.5:
            raise ZeroDivisionError("no force")
        return 1.0

    with pytest.raises(ZeroDivisionError, match="no force"):
        lagdsl.compile(DRIVEN, engine="c").simulate(stop=1, inputs={"F": force})


def test_a_failure_is_told_as_ever(by_scipy: object) -> None:
    model = lagdsl.compile(MODELS / "sliding_ladder.lag", engine="c")
    times = []
    for run in (model.simulate, by_scipy):
        with pytest.raises(lagdsl.SimulationFailed) as caught:
            run(*(() if run == model.simulate else (model,)), stop=2)  # type: ignore[operator]
        assert caught.value.diagnostic.code == "E0810"
        times.append(caught.value.time)
        assert len(caught.value.trajectory) > 10
    assert times[0] == pytest.approx(times[1], abs=0.05)


def test_too_many_steps_are_told() -> None:
    with pytest.raises(lagdsl.SimulationFailed) as caught:
        model = lagdsl.compile(MODELS / "double_pendulum.lag", engine="c")
        simulate(model._engine, model._compilation.flat, stop=100, max_steps=50)
    assert caught.value.diagnostic.code == "E0812"
    assert caught.value.trajectory.statistics.steps == 51


def test_progress_is_told() -> None:
    told: list[float] = []
    model = lagdsl.compile(MODELS / "double_pendulum.lag", engine="c")
    model.simulate(stop=200, progress=told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0
    assert len(told) > 2


def test_structures_are_as_long_in_c_as_here() -> None:
    """A double of one in the place of the other would be read as rubbish."""
    ours = (ctypes.sizeof(RunOptions), ctypes.sizeof(RunReport))
    assert runtime_library().run_layout == ours
