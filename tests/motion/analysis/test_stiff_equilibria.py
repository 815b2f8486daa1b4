"""Equilibria of chains that are stiff along and soft across."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl
from lagdsl.foundation.numerics.homotopy import release, settle
from lagdsl.foundation.numerics.levenberg_marquardt import Minimizer


def test_a_stiff_rod_hangs_down_from_the_side() -> None:
    """A point on a spring a million times as stiff as its weight asks for, held by a soft turning spring."""
    model = lagdsl.compile("""
model Rod
  coordinate Length x(start = 1 m), y;
  gravity = -g_n*world.y;
  mass 1 kg at {x, y};
  potential 1/2*(1e7 N/m)*(sqrt(x^2 + y^2) - 1 m)^2 + 1/2*(5 N.m)*atan2(y, x)^2;
end Rod;
""")
    x, y = model.trim().point.q
    angle = np.arctan2(y, x)
    assert np.hypot(x, y) == pytest.approx(1 + 9.80665 * np.sin(-angle) / 1e7, abs=1e-12)
    assert 5 * angle == pytest.approx(-9.80665 * x, rel=1e-9)


def test_a_thin_beam_on_a_pin_hangs() -> None:
    """Beside the accelerations by its strains that of the pin is as small as their rounding; its torque is not."""
    model = lagdsl.compile("""
model Hanging
  import Lag.Flexible.ExactBeam;
  import Lag.Planar.Revolute;
  Revolute pin;
  ExactBeam arm(L = 0.8 m, A = 60 mm^2, I = 45 mm^4, E = 70 GPa, density = 2700 kg/m3);
  gravity = -g_n*world.y;
  connect(world, pin, arm);
end Hanging;
""")
    q = dict(zip((c.name for c in model._compilation.flat.coordinates), model.trim().point.q, strict=True))
    assert q["pin.q"] == pytest.approx(-np.pi / 2, abs=1e-9)
    assert q["arm.x[8]"] - 0.8 == pytest.approx(2700 * 9.80665 * 0.8**2 / 2 / 70e9, rel=1e-2)


def test_a_path_ends_at_the_root_and_a_false_one_is_far() -> None:
    def equations(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return np.array([x[0] ** 3 - 8.0, 1e-9 * (x[1] - 1.0)]), np.array([[3 * x[0] ** 2, 0.0], [0.0, 1e-9]])

    every = lambda x: np.eye(2)  # noqa: E731
    start = np.array([5.0, 0.0])
    found = release(equations, every, start)
    assert found.point == pytest.approx([2.0, 1.0], rel=1e-9)
    near = Minimizer(point=np.array([2.0, 0.0]), residual=np.array([0.0, -1e-9]), size=1e-9)
    settled, rest = settle(equations, every, near)
    assert settled.point == pytest.approx([2.0, 1.0]) and rest < 1e-9
