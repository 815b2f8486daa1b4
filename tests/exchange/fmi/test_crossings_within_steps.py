"""Changes that are undone soon: corners, relations, contacts. Co-simulation finds them in steps of any length; in model
exchange an importer sees relations and contacts that last for longer than its own steps, no corners. All by hand."""

from __future__ import annotations

from math import acos, pi, sin
from pathlib import Path

import pytest
from choice import chosen
from fmpy import simulate_fmu

from fmi.texts import export_text

# At two radians a second an angle is within w of whole turns for w seconds: 19 times from -1 to 119 rad.
PEAKS = """model Peaks
  coordinate Real a(start = -1, der(start = 2)), x;
  kinetic 1/2*der(a)^2 + 1/2*der(x)^2;
  force max(0, cos(a) - 0.9999) on x;
  output Real v = der(x);
  annotation(units = "none", experiment(StopTime = 60, Tolerance = 1e-10));
end Peaks;
"""
W, COUNT = acos(0.9999), 19
PEAK = COUNT * (sin(W) - 0.9999 * W)

# The same as a relation, a tooth counter, and a wheel that is thrown back each time it comes near to a whole turn.
SWITCHES = """model Switches
  coordinate Real a(start = -1, der(start = 2)), y, b(start = -1, der(start = 2));
  discrete Integer n(start = 0);
  kinetic 1/2*der(a)^2 + 1/2*der(y)^2 + 1/2*der(b)^2;
  force if cos(a) > 0.9999 then 1 else 0 on y;
  contact stop: cos(b) <= 0.9999 with restitution = 1;
  output Real v = der(y);
  output Real count = n;
  output Real wheel = b;
  annotation(units = "none", experiment(StopTime = 60, Tolerance = 1e-10));
equation
  when sin(5*a) > 0 then n = pre(n) + 1; end when;
end Switches;
"""


def _wheel(time: float) -> float:
    """Between -2 pi + W and -W, from -1 upward."""
    span = 2 * pi - 2 * W
    way = (2 * time - 1 + 2 * pi - W) % (2 * span)
    return -2 * pi + W + min(way, 2 * span - way)


# Rows between which nothing changes twice: CVODE looks for zeros from one row to the next.
SHORT = 0.005


@pytest.mark.parametrize("version", chosen([2, 3], [2]))
def test_corners_within_steps(version: int, tmp_path: Path) -> None:
    path = tmp_path / "peaks.fmu"
    export_text(PEAKS, path, version)
    rows = simulate_fmu(
        str(path), fmi_type="CoSimulation", stop_time=60.0, output_interval=30.0, relative_tolerance=1e-10
    )
    assert rows["v"][-1] == pytest.approx(PEAK, abs=1e-11)


@pytest.mark.parametrize("version", chosen([2, 3], [3]))
def test_relations_and_contacts_within_steps(version: int, tmp_path: Path) -> None:
    path = tmp_path / "switches.fmu"
    export_text(SWITCHES, path, version)
    # sin(5 a) passes zero upward where 5 a is a multiple of 2 pi: from -5 to 595
    teeth = int(595 // (2 * pi)) + 1
    for kind, interval in (("ModelExchange", SHORT), ("CoSimulation", 30.0)):
        rows = simulate_fmu(
            str(path), fmi_type=kind, stop_time=60.0, output_interval=interval, relative_tolerance=1e-10
        )
        assert rows["count"][-1] == teeth, kind
        assert rows["v"][-1] == pytest.approx(COUNT * W, abs=1e-7), kind
        assert rows["wheel"][-1] == pytest.approx(_wheel(60.0), abs=1e-6), kind
