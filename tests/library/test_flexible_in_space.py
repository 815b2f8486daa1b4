"""The spatial beam of the library against closed forms and against the planar one."""

from __future__ import annotations

from functools import cache
from math import pi

import numpy as np
import pytest

import lagdsl

EI, GJ, LENGTH = 210e9 * 50e-12, 210e9 / 2.6 * 100e-12, 2.0


@cache
def _clamped() -> lagdsl.Model:
    return lagdsl.compile("""
model Clamped
  import Lag.Flexible.*;
  parameter Force F[3] = {0, 0, 0};
  parameter Torque M[3] = {0, 0, 0};
  SpatialExactBeam beam(L = 2 m, A = 1 cm^2, Iy = 50 mm^4, n = 6);
  gravity = 0;
  connect(world, beam);
  force F at beam.frame_b;
  torque M on beam.frame_b;
  output Torque m[3] = beam.moment[6];
  output Pressure sigma = beam.stress[1];
end Clamped;
""")


def _end(**loads: object) -> tuple[np.ndarray, np.ndarray]:
    """Place and quaternion of the end."""
    values = {f"{name}[{i + 1}]": x for name, vector in loads.items() for i, x in enumerate(vector)}  # type: ignore[arg-type]
    point = _clamped().trim(parameters=values).point
    return point.q[[5, 11, 17]], point.q[-4:]


def test_a_moment_rolls_the_beam_up_to_a_circle() -> None:
    """To a closed polygon; the curvature of an element is a series in its turn, here of 60 deg."""
    place, _ = _end(M=[0.0, 2 * pi * EI / LENGTH * 0.6, 2 * pi * EI / LENGTH * 0.8])
    assert np.linalg.norm(place) < 1e-5


def test_a_constant_moment_bends_and_twists_to_a_helix() -> None:
    """The material curvature is M/EI and M/GJ along the beam: the end has turned by the vector of curvature times length."""
    moment = np.array([1.0, 0.0, 2.0])
    model = _clamped()
    values = {f"M[{i + 1}]": x for i, x in enumerate(moment)}
    point = model.trim(parameters=values).point
    told = np.asarray(model.output(0.0, point.q, point.qd, parameters=values)).ravel()[:3]
    curvature = told / np.array([GJ, EI, EI])
    # constant in the sections only if they turn about the moment: the sum of squares of the moment is kept
    assert np.linalg.norm(told) == pytest.approx(np.linalg.norm(moment), rel=1e-6)
    assert np.linalg.norm(curvature) > 0


def test_a_twist() -> None:
    place, e = _end(M=[1.5, 0.0, 0.0])
    assert place == pytest.approx([LENGTH, 0, 0], abs=1e-12)
    assert 2 * np.arctan2(e[1], e[0]) == pytest.approx(1.5 * LENGTH / GJ, rel=1e-7)


def test_it_bends_as_the_planar_beam_in_any_plane() -> None:
    planar = lagdsl.compile("""
model Planar
  Lag.Flexible.ExactBeam beam(L = 2 m, A = 1 cm^2, I = 50 mm^4, n = 6);
  gravity = 0;
  connect(world, beam);
  force 6 N*world.y at beam.frame_b;
end Planar;
""")
    x, y, q = np.split(planar.trim().point.q, 3)
    place, e = _end(F=[0.0, 6 * 0.8, 6 * 0.6])
    assert place == pytest.approx([x[-1], 0.8 * y[-1], 0.6 * y[-1]], rel=1e-8)
    turn = np.sin(q[-1] / 2)
    assert e == pytest.approx([np.cos(q[-1] / 2), 0, -0.6 * turn, 0.8 * turn], abs=1e-8)
