"""Exported loops: Bennett's linkage, two rows of which suffice in general but not everywhere, through CVODE; angles of
cut joints, which may start anywhere and turn on."""

from __future__ import annotations

from itertools import product
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from choice import chosen
from fmpy import extract, simulate_fmu
from physics import linkages

import lagdsl
from fmi.test_fmpy_simulation import Method, cvode
from fmi.texts import export_text

TURNS = """model DoubleCrank "The frame is the shortest link: both cranks turn; the last pin starts beyond a turn"
  import Lag.Planar.*;
  Link crank(l = 1 m, m = 1 kg), coupler(l = 0.9 m, m = 1 kg), rocker(l = 1 m, m = 1 kg);
  Revolute A(q(start = 90 deg, fixed = true, der(start = 8 rad/s))), B(q(start = -100 deg)), C(q(start = -60 deg)),
    D(q(start = 560 deg));
  Fixed pin(r = {0.3 m, 0});
  gravity = 0;
  connect(world, A, crank, B, coupler, C, rocker, D, pin);
  annotation(experiment(StopTime = 3, Tolerance = 1e-8));
end DoubleCrank;
"""


def exported(text: str, folder: Path) -> str:
    export_text(text, folder / "it.fmu")
    return str(extract(str(folder / "it.fmu"), str(folder / "it")))


def through(fmu: str, kind: str, tolerance: float, stop: float, output: list[str]) -> Any:
    return simulate_fmu(
        fmu,
        fmi_type=kind,
        stop_time=stop,
        output_interval=stop / 300.0,
        relative_tolerance=tolerance,
        output=output,
    )


@pytest.fixture(scope="module")
def bennett(tmp_path_factory: pytest.TempPathFactory) -> str:
    return exported(linkages.bennett(), tmp_path_factory.mktemp("bennett"))


@pytest.mark.parametrize(
    ("tolerance", "method"), chosen(product([1e-6, 1e-8], Method), list(zip([1e-6, 1e-8], Method, strict=True)))
)
def test_bennetts_linkage_moves_under_cvode(bennett: str, tolerance: float, method: Method) -> None:
    """The origin rows depend on each other at 1.25 and 1.75 s. Errors are measured by the range of a coordinate."""
    with cvode(method):
        rows = through(bennett, "ModelExchange", tolerance, 3.0, ["q1", "q2", "q3"])
    expected = np.array([linkages.bennett_second_angle(q1) for q1 in rows["q1"]])
    assert np.max(np.abs(np.sin((rows["q2"] - expected) / 2.0))) < 100.0 * tolerance
    last = through(bennett, "CoSimulation", 1e-10, 3.0, ["q1", "q2", "q3"])[-1]
    for name in ("q1", "q2", "q3"):
        assert rows[name][-1] == pytest.approx(last[name], abs=1e3 * tolerance * float(np.ptp(rows[name])))


def test_the_angle_of_a_cut_joint_goes_on_where_it_starts(tmp_path: Path) -> None:
    model = lagdsl.compile(TURNS)
    fmu = exported(TURNS, tmp_path)
    motion = model.simulate(interval=0.01, tolerance=1e-9)
    assert abs(motion["D.q"][0] - np.radians(560.0)) < pi and np.ptp(motion["D.q"]) > 2.0 * pi
    for kind in ("ModelExchange", "CoSimulation"):
        rows = through(fmu, kind, 1e-9, 3.0, ["D.q"])
        assert rows["D.q"] == pytest.approx(np.interp(rows["time"], motion["time"], motion["D.q"]), abs=1e-2)
        assert rows["D.q"][-1] == pytest.approx(motion["D.q"][-1], abs=1e-5)
