"""If the inertia of a quaternion's scalar part is almost nothing, its norm must not dwarf the other constraints."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from choice import engines

import lagdsl

TEXT = """
model Plate "Heavy plate on a ball joint, held by a rod"
  coordinate Quaternion e;
  coordinate Length h(start = 0);
  frame plate = world.move({0, h, 0}).quat(e);
  gravity = -g_n*world.y;
  body b(m = 350 kg, com = {0.3, 0.1, 0.2}, I = {9, 11, 10}) on plate;
  constraint rod: norm(plate.point({0.5 m, 0, 0}) - {0.5 m, 0.4 m, 0.1 m}) = 0.41231056256176607 m;
  constraint slide: plate.point({0.2 m, 0, 0.1 m}).y = 0;
end Plate;
"""


@cache
def _model(engine: str) -> lagdsl.Model:
    return lagdsl.compile(TEXT, engine=engine)  # type: ignore[arg-type]


@pytest.mark.parametrize("engine", engines(["tape", "numpy", "c"]))
@pytest.mark.parametrize("size", [0.0, *10.0 ** np.arange(-16, -2)])
def test_accelerations_are_those_of_the_full_system(engine: str, size: float) -> None:
    model = _model(engine)
    q = np.array([1.0, 0.3 * size, -0.5 * size, 0.7 * size, 0.2 * size])
    rest = np.zeros(5)
    mass, rows = model.mass_matrix(0.0, q), model.constraint_jacobian(0.0, q)
    force = -model.inverse_dynamics(0.0, q, rest, rest)
    zeros = np.zeros((len(rows), len(rows)))
    expected = np.linalg.solve(np.block([[mass, -rows.T], [rows, zeros]]), np.concatenate([force, 0 * rows[:, 0]]))
    qdd = model.forward_dynamics(0.0, q, rest)
    np.testing.assert_allclose(qdd, expected[:5], rtol=0, atol=1e-10 * np.max(np.abs(expected[:5])))
