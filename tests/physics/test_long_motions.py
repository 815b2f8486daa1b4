"""Invariants of long motions."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import lagdsl


def test_a_four_bar_stays_closed(root: Path) -> None:
    """The gap, from the angles alone: the links end to end lead from one bearing to the other."""
    model = lagdsl.compile(root / "models" / "four_bar.lag", engine="c")
    motion = model.simulate(stop=1000.0, interval=0.37, tolerance=1e-8)
    crank = motion["A.q"]
    coupler = crank + motion["B.q"]
    rocker = coupler + motion["C.q"]
    x = 0.4 * np.cos(crank) + 1.0 * np.cos(coupler) + 0.8 * np.cos(rocker) - 1.0
    y = 0.4 * np.sin(crank) + 1.0 * np.sin(coupler) + 0.8 * np.sin(rocker)
    assert np.max(np.hypot(x, y)) < 1e-10
    assert np.ptp(crank) > 1.0  # it moves
