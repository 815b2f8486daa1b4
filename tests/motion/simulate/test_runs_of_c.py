"""Motions as the runtime in C integrates them, whichever engine has filled the model."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from choice import chosen
from scipy.integrate import solve_ivp

import lagdsl
from lagdsl.motion.simulate.simulate import simulate

MODELS = Path(__file__).parents[3] / "models"
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


def _difference(a: lagdsl.Trajectory, b: lagdsl.Trajectory) -> float:
    assert [c.name for c in a.columns] == [c.name for c in b.columns]
    np.testing.assert_array_equal(a.time, b.time)
    return max(float(np.max(np.abs(a[c.name] - c.values)) / max(1e-3, np.max(np.abs(c.values)))) for c in b.columns[1:])


@pytest.mark.parametrize(
    "name",
    chosen(
        ("double_pendulum", "four_bar", "pendulum_two_dependent_constraints", "rolling_sphere", "motor_pendulum"),
        ("double_pendulum", "four_bar", "motor_pendulum"),
    ),
)
def test_functions_of_python_give_the_same_motion(name: str) -> None:
    ours, theirs = (
        lagdsl.compile(MODELS / f"{name}.lag", engine=engine).simulate(stop=1, tolerance=TOLERANCE)
        for engine in ("c", "numpy")
    )
    assert _difference(ours, theirs) < 100 * TOLERANCE
    np.testing.assert_allclose(ours.energy, theirs.energy, rtol=100 * TOLERANCE, atol=1e-6)
    assert ours.position_residual.max() <= 2e-3 * TOLERANCE
    assert ours.velocity_residual.max() <= 5e-2 * TOLERANCE
    assert [i.name for i in ours.invariants] == [i.name for i in theirs.invariants]


def test_steps_take_as_many_evaluations_as_they_have_stages() -> None:
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


@pytest.mark.parametrize("engine", ["numpy", "c"])
@pytest.mark.parametrize(
    ("force", "bends"),
    [(3.0, ()), (lambda t: 2.0 * np.cos(3.0 * t), ()), (([0.0, 0.4, 0.4, 1.0], [0.0, 1.0, -2.0, 3.0]), (0.4,))],
    ids=["constant", "function", "table"],
)
def test_inputs_of_every_kind(engine: str, force: object, bends: tuple[float, ...]) -> None:
    """Against SciPy over the equation written here, piece by piece."""
    motion = lagdsl.compile(DRIVEN, engine=engine).simulate(stop=1, tolerance=TOLERANCE, inputs={"F": force})  # type: ignore[dict-item, arg-type]
    value = _force(force)
    x, pieces = np.array([0.3, 0.0]), [0.0, *bends, 1.0]
    for first, last in pairwise(pieces):
        found = solve_ivp(
            lambda t, x, last=last: [x[1], value(t, t < last) / 2.0 - 25.0 * x[0]],
            (first, last),
            x,
            method="DOP853",
            rtol=1e-12,
            atol=1e-13,
        )
        x = found.y[:, -1]
    assert [motion["x"][-1], motion["der(x)"][-1]] == pytest.approx(x.tolist(), abs=10 * TOLERANCE)


def _force(force: object):  # type: ignore[no-untyped-def]
    """The force at a time: of a table, before its jump at 0.4 s or behind it."""
    if callable(force):
        return lambda t, _: force(t)
    if isinstance(force, tuple):
        return lambda t, inside: t / 0.4 if t < 0.4 or (inside and t == 0.4) else -2.0 + 5.0 * (t - 0.4) / 0.6
    return lambda t, _: force


def test_what_an_input_raises_comes_through() -> None:
    def force(t: float) -> float:
        if t > 0.5:
            raise ZeroDivisionError("no force")
        return 1.0

    with pytest.raises(ZeroDivisionError, match="no force"):
        lagdsl.compile(DRIVEN, engine="c").simulate(stop=1, inputs={"F": force})


def test_a_failure_is_told_alike() -> None:
    times = []
    for engine in ("numpy", "c"):
        with pytest.raises(lagdsl.SimulationFailed) as caught:
            lagdsl.compile(MODELS / "sliding_ladder.lag", engine=engine).simulate(stop=2)
        assert caught.value.diagnostic.code == "E0810"
        times.append(caught.value.time)
        assert len(caught.value.trajectory) > 10
    assert times[0] == pytest.approx(times[1], abs=0.05)


def test_too_many_steps_are_told() -> None:
    with pytest.raises(lagdsl.SimulationFailed) as caught:
        model = lagdsl.compile(MODELS / "double_pendulum.lag", engine="c")
        simulate(model._engine, model._compilation.flat, stop=100, max_steps=50)
    assert caught.value.diagnostic.code == "E0812"
    assert caught.value.trajectory.statistics.steps == 50


def test_progress_is_told() -> None:
    told: list[float] = []
    model = lagdsl.compile(MODELS / "double_pendulum.lag", engine="c")
    model.simulate(stop=200, progress=told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0
    assert len(told) > 2


@pytest.mark.parametrize(("solver", "instead"), [("rk45", "dop853"), ("bdf", "radau"), ("cvode", "radau")])
def test_solvers_of_others_name_what_takes_their_place(solver: str, instead: str) -> None:
    with pytest.raises(ValueError, match=f"`{solver}` was removed: use `{instead}`"):
        lagdsl.compile(DRIVEN).simulate(stop=1, solver=solver)
