"""Sweeps of models with events: all runs share the times of the grid; of two rows at an event the later one is kept."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lagdsl

pytest.importorskip("xarray")

G = 9.80665
BALL = """
model Ball
  parameter Real e = 0.5;
  coordinate Length h(start = 1 m);
  discrete Integer n(start = 0);
  gravity = -g_n*world.y;
  mass 1 kg at {0, h};
  contact floor: h >= 0 with restitution = e;
equation
  when impacts(floor) > 1 and e > 0.6 then
    terminate("enough");
  end when;
  when sample(0.25 s, 0.25 s) then
    n = pre(n) + 1;
  end when;
end Ball;
"""


def test_runs_share_their_times() -> None:
    found = lagdsl.compile(BALL).sweep({"e": [0.3, 0.5, 0.8]}, stop=2.0, interval=0.25)
    np.testing.assert_allclose(found["time"], np.arange(9) * 0.25)
    assert found["n"].values[:2].tolist() == [list(range(9))] * 2  # counted at the tick itself
    first = math.sqrt(2.0 / G)
    t = found["time"].values
    for row, e in enumerate([0.3, 0.5]):
        flight = (t > first) & (t < first * (1 + 2 * e))
        tau = t[flight] - first
        expected = e * G * first * tau - G * tau**2 / 2
        np.testing.assert_allclose(found["h"].values[row][flight], expected, atol=1e-7)
    ended = first * (1 + 2 * 0.8)
    assert found["ended"].values == pytest.approx([2.0, 2.0, ended], abs=1e-8)
    assert np.isnan(found["h"].values[2][t > ended]).all()
    assert np.isfinite(found["h"].values[2][t <= ended]).all()
