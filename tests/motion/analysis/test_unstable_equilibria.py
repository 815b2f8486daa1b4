"""An equilibrium that a motion leaves is told, with how fast; far from the start a model falls into a stable one."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest

import lagdsl
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.gradient_flow import fall
from lagdsl.motion.analysis.where import Where, trim

LENGTH, G_N = 0.5, 9.80665


def _pendulum() -> lagdsl.Model:
    return lagdsl.compile("""
model Pendulum
  coordinate Angle theta;
  gravity = -g_n*world.y;
  mass 2 kg at {(0.5 m)*sin(theta), -(0.5 m)*cos(theta), 0};
end Pendulum;
""")


def _found(start: float) -> tuple[float, tuple[float, ...], list[str]]:
    model, sink = _pendulum(), Sink()
    where = Where(p=np.array([]), trim=True, start={"theta": start})
    found = trim(model._system, where, sink)
    return float(found.point.q[0]), found.growth, [f"{each.code}: {each.message}" for each in sink.diagnostics]


def test_a_pendulum_on_its_head_is_told_to_fall() -> None:
    theta, growth, told = _found(3.0)
    assert theta == pytest.approx(pi, abs=1e-12)
    assert growth == pytest.approx([sqrt(G_N / LENGTH)], rel=1e-12)
    assert told == ["W0869: this equilibrium is unstable: 1 growing mode, the fastest as exp(4.43*time)"]


@pytest.mark.parametrize("start", [0.3, 1.7])
def test_from_afar_it_falls(start: float) -> None:
    assert _found(start) == (pytest.approx(0.0, abs=1e-12), (), [])


def test_a_flow_comes_to_rest_in_a_minimum() -> None:
    """V = (x^2 - 1)^2/4 + 1e8 (y - x)^2/2 has minima at (1, 1) and (-1, -1) and a saddle between them."""

    def implicit(x: np.ndarray, before: np.ndarray, step: float) -> tuple[np.ndarray, np.ndarray]:
        slope = np.array([x[0] ** 3 - x[0] - 1e8 * (x[1] - x[0]), 1e8 * (x[1] - x[0])])
        stiffness = np.array([[3 * x[0] ** 2 - 1 + 1e8, -1e8], [-1e8, 1e8]])
        return slope + (x - before) / step, stiffness + np.eye(2) / step

    def growth(x: np.ndarray) -> float:
        return 1 - 3 * float(x[0]) ** 2

    assert fall(implicit, growth, np.array([-0.01, -0.01]), 1e-3) == pytest.approx([-1.0, -1.0], abs=1e-9)
    assert fall(lambda x, before, step: (x - before - step, np.eye(1)), lambda x: 0.0, np.zeros(1), 1e-3) is None
