"""Derivatives beside controllers, in sessions and in many motions: closed forms, and those of one motion to the bit."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from choice import engines

import lagdsl
from lagdsl.engines.runtime.engines.engine import EngineName

# x'' = F/m
AXIS = """
model Axis
  parameter Mass m = 2 kg;
  coordinate Length x(start = 1 m);
  input Force F;
  mass m at {x, 0};
  force F*world.x at {x, 0};
end Axis;
"""
KP, KD, H = 20.0, 6.0, 0.01

# A ball that bounces, is pushed by an input and counted by a clock.
BALL = """
model Ball
  parameter Real e = 0.8;
  input Force u = 0 N;
  coordinate Length h(start = 1 m), x(der(start = 1 m/s));
  discrete Length sum(start = 0);
  mass 1 kg at {x, h};
  force u on x;
  gravity = {0, -9.81 m/s2};
  contact floor: h >= 0 with restitution = e;
  output Area y = h*x;
equation
  when sample(0.1, 0.1) then
    sum = pre(sum) + x;
  end when;
end Ball;
"""
NAMES = ["e", "h.start", "u"]
OF = ["h", "der(h)", "x", "y", "sum"]


def pd(now: lagdsl.Present) -> float:
    return -KP * float(now["x"]) - KD * float(now["der(x)"])


def exact(count: int, m: complex, start: complex) -> complex:
    """x+ = x + h v + h^2/(2 m) F, v+ = v + h/m F with F = -KP x - KD v."""
    step = np.array([[1.0, H], [0.0, 1.0]]) - np.outer([H * H / (2.0 * m), H / m], [KP, KD])
    return complex((np.linalg.matrix_power(step, count) @ [start, 0.0])[0])


@pytest.mark.parametrize("engine", engines(["tape", "c", "numpy", "auto"]))
def test_a_sampled_loop_is_differentiated_as_its_discrete_solution(engine: EngineName) -> None:
    model = lagdsl.compile(AXIS, engine=engine)
    motion = model.simulate(stop=1.0, control=lagdsl.control(H, pd), tangents=["m", "x.start"])
    assert motion.derivative("x", "m")[-1] == pytest.approx(exact(100, 2.0 + 1e-30j, 1.0).imag / 1e-30, abs=1e-11)
    assert motion.derivative("x", "x.start")[-1] == pytest.approx(exact(100, 2.0, 1.0).real, abs=1e-11)


def test_what_a_controller_leaves_alone_stays() -> None:
    """F = 2 x(0) from the start on, and is not set again: x = 1 + x0 t^2/m at x0 = 1."""
    model = lagdsl.compile(AXIS, engine="tape")

    def once(now: lagdsl.Present) -> float | None:
        return 2.0 * float(now["x"]) if now.t == 0.0 else None

    motion = model.simulate(stop=1.0, control=lagdsl.control(0.25, once), tangents=["x.start", "F"])
    assert motion.derivative("x", "x.start")[-1] == pytest.approx(1.0 + 0.5, abs=1e-12)
    assert motion.derivative("x", "F")[-1] == pytest.approx(0.25, abs=1e-12)


class Integral:
    """A law that remembers."""

    def __init__(self) -> None:
        self.sum = 0.0

    def __call__(self, now: lagdsl.Present) -> float:
        self.sum += float(now["x"])
        return -self.sum


def test_a_law_that_remembers_or_turns_a_corner_is_told() -> None:
    model = lagdsl.compile(AXIS, engine="tape")
    with pytest.raises(lagdsl.CallRefused, match="E0884"):
        model.simulate(stop=1.0, control=lagdsl.control(H, Integral()), tangents="m, x.start")
    corner = lagdsl.control(H, lambda now: -abs(float(now["x"]) - 1.0))
    with pytest.raises(lagdsl.SimulationFailed, match=r"E0882.*`x\.start`"):
        model.simulate(stop=1.0, control=corner, tangents=["m", "x.start"])


def test_a_session_has_the_derivatives_of_the_motion() -> None:
    model = lagdsl.compile(BALL, engine="tape")
    motion = model.simulate(stop=0.95, interval=0.05, inputs={"u": 0.3}, tangents=NAMES)
    run = model.session(inputs={"u": 0.3}, tangents=NAMES)
    for _ in range(19):
        run.step(0.05)
    for of in OF:
        for by in NAMES:
            assert run.derivative(of, by) == pytest.approx(motion.derivative(of, by)[-1], abs=1e-11)
    assert run.derivative("time", "e") == 0.0
    assert run.motion.derivative("h", "e")[-1] == run.derivative("h", "e")
    (impact,) = [event for event in run.events if event.kind == "impact"][:1]
    assert impact.time_derivative("h.start") == pytest.approx(impact.time / 2.0, abs=1e-12)


@pytest.mark.parametrize("solver", ["dop853", "radau", "rk4"])
def test_columns_go_on_to_the_bit(solver: str) -> None:
    model = lagdsl.compile(BALL, engine="tape")
    step = 0.02 if solver == "rk4" else None
    run = model.session(tangents=NAMES, record=False, solver=solver, step=step)

    def on(session: lagdsl.Session, steps: int) -> np.ndarray:
        for k in range(steps):
            session.step(0.07, u=0.1 * k)
        return session.jacobian(OF)

    on(run, 8)
    saved = run.save()
    later = on(run, 8)
    run.restore(saved)
    assert np.array_equal(on(run, 8), later)
    other = model.session(tangents=NAMES, solver=solver, step=step)
    other.restore(saved)
    assert np.array_equal(on(other, 8), later)
    run.reset()
    on(run, 8)
    assert np.array_equal(on(run, 8), later)


def test_many_sessions_and_motions_are_those_of_one() -> None:
    model = lagdsl.compile(BALL, engine="tape")
    heights = [1.0, 1.1, 1.2]
    runs = model.sessions(3, start={"h": heights}, tangents=NAMES)
    many = model.simulate_many(start={"h": heights}, stop=0.8, interval=0.1, tangents=NAMES)
    for _ in range(7):
        runs.step(0.1)
    for k, height in enumerate(heights):
        alone = model.session(start={"h": height}, tangents=NAMES)
        motion = model.simulate(start={"h": height}, stop=0.8, interval=0.1, tangents=NAMES)
        for _ in range(7):
            alone.step(0.1)
        assert np.array_equal(runs.jacobian(OF)[k], alone.jacobian(OF))
        assert runs.derivative("h", "e")[k] == alone.derivative("h", "e")
        rows = np.searchsorted(motion.time, many.time, side="right") - 1
        assert np.array_equal(many.derivative("h", "e")[k], motion.derivative("h", "e")[rows])


@pytest.mark.parametrize(
    ("call", "error"),
    [
        (lambda model: model.session().derivative("h", "e"), "E0884"),
        (lambda model: model.session(tangents="g"), "E0874"),
        (lambda model: model.session(tangents="e").derivative("h", "u"), "E0874"),
        (lambda model: model.session(tangents="e").derivative("H", "e"), "E0874"),
        (lambda model: model.session(tangents="e").restore(model.session(tangents="u").save()), "E0891.*`u`"),
        (lambda model: model.simulate_many(start={"h": [1.0]}, stop=0.1, tangents="g"), "E0874"),
        (lambda model: model.simulate_many(start={"h": [1.0]}, stop=0.1).derivative("h", "e"), "E0884"),
    ],
)
def test_what_nobody_asked_for_is_refused(call: Callable[[lagdsl.Model], object], error: str) -> None:
    with pytest.raises((lagdsl.CallRefused, KeyError), match=error):
        call(lagdsl.compile(BALL, engine="tape"))


def test_a_session_ends_where_its_derivatives_do() -> None:
    """A wall that is touched and not passed."""
    model = lagdsl.compile(
        """
model Grazing
  coordinate Length x(der(start = 1 m/s));
  mass 1 kg at {x, 0};
  force -2 N on x;
  contact wall: 0.25 m - 1e-10 m - x >= 0 with restitution = 1;
end Grazing;
""",
        engine="tape",
    )
    run = model.session(tangents="der(x).start")
    with pytest.raises(lagdsl.SimulationFailed, match="E0881"):
        run.step(1.0)
    assert "wall" in run.failure
