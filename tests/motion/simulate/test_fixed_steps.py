"""Steps of one length: orders, what they keep, rows, events, and what the options ask for."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import engines

import lagdsl

# Driven, with friction that is not linear and a state: everything that a formula may forget.
DRIVEN = """model Driven
  coordinate Length x(start = 1 m);
  state Real s(start = 1);
  kinetic T = 1/2*(1 kg)*der(x)^2;
  potential V = 1/2*(4 N/m)*x^2;
  force -0.3*s*der(x)*(1 N.s/m) + 0.5*cos(time/(1 s))*(1 N) on x;
equation
  der(s) = -s*(1 + 0.5*sin(time/(1 s)))*(1 Hz);
end Driven;
"""

BALL = """model Ball
  coordinate Length h(start = 1 m);
  mass 1 kg at h*world.y;
  gravity = -9.81*world.y*(1 m/s2);
  contact h >= 0 with restitution = 0.5;
end Ball;
"""

PENDULUM = """model Pendulum
  coordinate Length x(start = 0.6 m), y(start = -0.8 m);
  mass 1 kg at {x, y};
  gravity = -9.81*world.y*(1 m/s2);
  constraint rod: x^2 + y^2 = 1 m2;
end Pendulum;
"""


def _end(model: lagdsl.Model, **options: object) -> np.ndarray:
    motion = model.simulate(stop=2.0, interval=2.0, **options)  # type: ignore[arg-type]
    return np.array([motion[name][-1] for name in ("x", "der(x)", "s")])


@pytest.mark.parametrize(("solver", "order"), [("rk4", 4), ("leapfrog", 2), ("ros2", 2)])
@pytest.mark.parametrize("engine", engines(["numpy", "c"]))
def test_the_order_is_what_is_told(solver: str, order: int, engine: str) -> None:
    model = lagdsl.compile(DRIVEN, engine=engine)
    exact = _end(model, solver="dop853", tolerance=1e-12)
    errors = [np.max(np.abs(_end(model, solver=solver, step=2.0 / n) - exact)) for n in (40, 80)]
    assert order - 0.2 < np.log2(errors[0] / errors[1]) < order + 0.5


def test_leapfrog_keeps_the_energy_for_long(root: Path) -> None:
    model = lagdsl.compile(
        "model Spring coordinate Length x(start = 1 m); kinetic T = 1/2*(1 kg)*der(x)^2; "
        "potential V = (1 N/m)*x^2/2 + (1 N/m3)*x^4/4; end Spring;"
    )

    def drift(solver: str) -> tuple[float, float]:
        motion = model.simulate(stop=80.0, interval=0.5, solver=solver, step=0.1)
        x, v = motion["x"], motion["der(x)"]
        energy = v**2 / 2 + x**2 / 2 + x**4 / 4 - 0.75
        return float(np.max(np.abs(energy[:80]))), float(np.max(np.abs(energy[-80:])))

    early, late = drift("leapfrog")
    assert 1e-4 < early < 1e-2
    assert late < 1.1 * early
    early, late = drift("ros2")
    assert late > 1.3 * early  # which damps


def test_rows_lie_between_the_steps() -> None:
    """On cubic polynomials through both ends of a step: their error is at most h^4/384 of the fourth derivative."""
    motion = lagdsl.compile(DRIVEN).simulate(stop=1.0, interval=0.01, solver="rk4", step=0.04)
    exact = lagdsl.compile(DRIVEN).simulate(stop=1.0, interval=0.01, tolerance=1e-11)
    assert motion.statistics.steps == 25
    assert motion.statistics.evaluations < 25 * 5
    third = np.gradient(np.gradient(exact["der(x)"], 0.01, edge_order=2), 0.01, edge_order=2)
    fourth = float(np.max(np.abs(np.gradient(third, 0.01, edge_order=2))))
    off = np.abs(motion["x"] - exact["x"])
    assert 0.0 < np.max(off[::4]) < (2 * 0.04) ** 5 / 120 / 0.04  # ends of steps: terms of Taylor's series left out
    assert np.max(off) <= np.max(off[::4]) + 0.04**4 / 384 * fourth


def test_steps_end_on_the_constraints() -> None:
    motion = lagdsl.compile(PENDULUM).simulate(stop=3.0, interval=0.1, solver="rk4", step=0.02, tolerance=1e-8)
    np.testing.assert_allclose(motion["x"] ** 2 + motion["y"] ** 2, 1.0, atol=1e-10)


def test_events_are_found_within_steps() -> None:
    motion = lagdsl.compile(BALL).simulate(stop=0.6, interval=0.1, solver="rk4", step=0.05)
    fall = np.sqrt(2 / 9.81)
    assert next(event.time for event in motion.events) == pytest.approx(fall, abs=1e-9)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"solver": "rk4"}, "`rk4` does not choose the length of its steps: give a step"),
        (
            {"solver": "radau", "step": 0.1},
            "chooses the length of its steps; give a step to rk4, leapfrog, ros2 only",
        ),
        ({"step": 0.1}, "chooses the length of its steps"),
        ({"solver": "rk4", "step": 0.0}, "must be positive"),
        ({"solver": "rk4", "step": 3.0}, "no longer than the simulation"),
    ],
)
def test_options_that_make_no_sense(options: dict[str, object], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        lagdsl.compile(DRIVEN).simulate(stop=2.0, **options)  # type: ignore[arg-type]
