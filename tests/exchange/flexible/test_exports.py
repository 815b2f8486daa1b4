"""Flexible bodies leave: as FMUs, in C and in NumPy they move as under `simulate`."""

from __future__ import annotations

from functools import cache
from itertools import product

import numpy as np
import pytest
from choice import chosen
from fmi.exported import quickly

import lagdsl
from flexible.bar import carried
from lagdsl.exchange.fmi.round_trip import motion_by_fmpy

ROWS, STOP = 41, 0.02
EXPERIMENT = f"annotation(experiment(StopTime = {STOP}, Tolerance = 1e-10));"
BODIES = {
    "Beam": "Lag.Flexible.Beam body(L = 1 m, A = 1 cm^2, I = 833 mm^4, E = 0.1 GPa, q(start = {0.1, 0.02}))",
    "ExactBeam": "Lag.Flexible.ExactBeam body(L = 1 m, A = 40 cm^2, I = 533 cm^4, E = 0.5 MPa, n = 1)",
    "SpatialExactBeam": "Lag.Flexible.SpatialExactBeam body(L = 1 m, A = 40 cm^2, Iy = 127 cm^4, E = 3 MPa, n = 1)",
    "Cable": "Lag.Flexible.Cable body(L = 1 m, A = 1 cm^2, E = 10 MPa, n = 1, s(der(each start = 1)))",
    "Bar": "Bar body(eta(start = {1e-3, 0, 0, 0, 0, 0}))",
}


@cache
def text(name: str) -> str:
    return f"  {BODIES[name]};\n  gravity = -g_n*world.y;\n  connect(world, body);\n  {EXPERIMENT}\n"


@cache
def model(name: str, engine: str = "tape") -> lagdsl.Model:
    source = carried(0, text(name)) if name == "Bar" else f"model Model\n{text(name)}end Model;\n"
    return lagdsl.compile(source, engine=engine)  # type: ignore[arg-type]


@cache
def motion(name: str, engine: str = "tape") -> np.ndarray:
    found = model(name, engine).simulate(interval=STOP / (ROWS - 1))
    return np.stack([found[each] for each in model(name).coordinates], axis=-1)


def same(found: np.ndarray, name: str, part: float) -> None:
    own = motion(name)
    assert found.shape == own.shape and np.ptp(own, axis=0).max() > 1e-4
    assert np.abs(found - own).max(axis=0) == pytest.approx(0.0, abs=part * np.ptp(own, axis=0).max())


@pytest.mark.parametrize(
    ("name", "version", "kind"),
    chosen(product(BODIES, (2, 3), ("cs", "me")), [("Cable", 3, "cs"), ("Bar", 2, "me")]),
)
def test_an_fmu_moves_as_the_model(name: str, version: int, kind: str) -> None:
    compilation = model(name)._compilation
    with quickly():
        times, values = motion_by_fmpy(compilation, version, kind, STOP, ROWS, model(name).coordinates)  # type: ignore[arg-type]
    assert times == pytest.approx(np.linspace(0, STOP, ROWS))
    same(values, name, 1e-8 if kind == "cs" else 1e-4)


@pytest.mark.parametrize(
    ("name", "engine"), chosen(product(BODIES, ("c", "numpy")), [("ExactBeam", "c"), ("SpatialExactBeam", "numpy")])
)
def test_exported_functions_move_it_as_the_tape_does(name: str, engine: str) -> None:
    same(motion(name, engine), name, 1e-9)
