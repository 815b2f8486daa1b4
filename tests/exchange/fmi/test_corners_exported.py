"""An exported model with a time event and a corner of place moves as closed forms say, through FMPy. In model exchange
corners of place are no events: an importer finds what its steps show."""

from __future__ import annotations

from math import sqrt
from pathlib import Path

import pytest
from choice import chosen
from fmpy import read_model_description, simulate_fmu

from fmi.texts import export_text

TEXT = """model Exported
  coordinate Real x(der(start = 1));
  kinetic 1/2*der(x)^2;
  force -100*max(0, 1 - abs(x - 1)/0.001) + max(0, 1 - abs(time - 2.5)/1e-3) on x;
  output Real v = der(x);
  annotation(units = "none", experiment(StopTime = 3, Tolerance = 1e-10));
end Exported;
"""


@pytest.mark.parametrize("version", chosen([2, 3], [2]))
def test_corners_of_time_and_place_in_an_fmu(version: int, tmp_path: Path) -> None:
    path = tmp_path / "corners.fmu"
    export_text(TEXT, path, version)
    rows = simulate_fmu(
        str(path), fmi_type="CoSimulation", stop_time=3.0, output_interval=1.5, relative_tolerance=1e-11
    )
    assert rows["v"][-1] == pytest.approx(sqrt(1 - 2 * 0.1) + 1e-3, abs=1e-8)
    assert read_model_description(str(path)).numberOfEventIndicators == 0
