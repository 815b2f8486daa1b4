"""Blows on loops in co-simulation: none is lost, from thirty starts, at tolerances of importers."""

from __future__ import annotations

import fmpy
import numpy as np
import pytest
from attack.regimes import BOB, STARTS, above
from choice import chosen

import lagdsl
from fmi.texts import exported_text

STOP = 1.0


@pytest.mark.parametrize(("version", "tolerance"), chosen([(2, None), (3, 1e-3), (2, 1e-6)], [(2, None)]))
def test_no_blow_is_lost_in_co_simulation(version: int, tolerance: float | None) -> None:
    """The reference is the same bob with its angle as coordinate: it has no constraint that could move its gap."""
    exported = exported_text(BOB, version)
    angle = lagdsl.compile(BY_ANGLE, engine="tape")
    for i in range(STARTS):
        start = above(i)
        found = fmpy.simulate_fmu(
            str(exported.folder),
            fmi_type="CoSimulation",
            stop_time=STOP,
            output_interval=0.05,
            relative_tolerance=tolerance,
            start_values=dict(start),
            output=["y"],
        )
        exact = angle.simulate(
            start={"a": np.arctan2(start["y"], start["x"])}, stop=STOP, interval=0.05, tolerance=1e-10
        )
        rows = np.searchsorted(exact.time, found["time"] - 1e-9)
        assert np.abs(found["y"] - np.sin(exact["a"][rows])).max() < 10 * (tolerance or 1e-6), i


BY_ANGLE = """
model Bob
  coordinate Angle a;
  gravity = -9.81 m/s2*world.y;
  mass 1 kg at {cos(a), sin(a)}*(1 m);
  contact floor: (1 m)*sin(a) >= 0.1 m with restitution = 0.6;
end Bob;
"""
