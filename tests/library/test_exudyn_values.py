"""Beams of the library against twelve values that Exudyn publishes.

Source: J. Gerstmayr, Exudyn, github.com/jgerstmayr/EXUDYN, folder main/pythonDev/TestModels: `runTestSuiteRefSol.py`
and what stands in `geometricallyExactBeamTest.py`. Its planar element is the same; in space it interpolates
rotations by another rule.
"""

from __future__ import annotations

from functools import cache
from math import cos, radians, sin

import numpy as np
import pytest

import lagdsl

# Cantilever2011 of Nachbagauer, Pechstein, Irschik and Gerstmayr: elements, shortening and deflection of the end.
LINEAR = [
    (1, 9.122730637578513e-08, 0.0006166665660910789),
    (2, 1.612930911054633e-07, 0.0007615939560560586),
    (4, 1.8176323512975046e-07, 0.0007978259537503566),
    (8, 1.8706537496804287e-07, 0.0008068839288072378),
]
# The same under a thousandfold force, with 1024 elements.
LARGE = (0.15097102364723924, 0.7105683631862169)


def _told(model: lagdsl.Model, **parameters: float) -> np.ndarray:
    point = model.trim(parameters=parameters).point
    return np.asarray(model.output(0.0, point.q, point.qd, parameters=parameters)).ravel()


def test_a_cantilever_under_a_force_and_a_torque() -> None:
    """geometricallyExactBeam2Dtest."""
    model = lagdsl.compile("""
model Cantilever
  parameter Length h = 0.5 m, b = 0.1 m;
  frame clamp = world.rotz(45 deg);
  Lag.Flexible.ExactBeam beam(n = 16, L = 2 m, A = b*h, I = b*h^3/12, E = 2.07e11 Pa, G = 7.9615e10 Pa, k_s = 13/15.3);
  gravity = 0;
  connect(clamp, beam);
  force -5e8*0.125 N*clamp.y at beam.frame_b;
  torque -5e8 N.m*world.z on beam.frame_b;
  output Length u = beam.frame_b.origin.y - (2 m)*clamp.x.y;
end Cantilever;
""")
    assert _told(model) == pytest.approx(-2.2115028353806547, rel=1e-9)


def test_two_beams_in_the_shape_of_an_L() -> None:
    """LShapeGeomExactBeam2D."""
    model = lagdsl.compile("""
model Angle90
  import Lag.Flexible.ExactBeam;
  parameter Length h = 0.05 m, b = 0.1 m;
  model Bar = ExactBeam(n = 4, L = 1 m, E = 2.1e11 Pa, k_s = 13/15.3);
  Bar first(A = b*h, I = b*h^3/12), second(A = b*h, I = b*h^3/12);
  Lag.Planar.Weld corner(angle = 90 deg);
  gravity = 0;
  connect(world, first, corner, second);
  force 1e6 N*world.x at second.frame_b;
  output Length u = second.frame_b.origin.y - (1 m);
end Angle90;
""")
    assert _told(model) == pytest.approx(-0.9181474510515214, rel=1e-6)


def test_a_thick_cantilever_bends_much() -> None:
    """The error of second order is taken off by two meshes."""
    coarse, fine = (_told(_thick(n), F=62.5e6) for n in (4, 8))
    assert (4 * fine - coarse) / 3 == pytest.approx(LARGE, rel=1e-4)


@pytest.mark.parametrize(("n", "shortening", "deflection"), LINEAR)
def test_a_thick_cantilever_bends_a_little(n: int, shortening: float, deflection: float) -> None:
    assert _told(_thick(n), F=62.5e3) == pytest.approx([shortening, deflection], rel=1e-6)


@cache
def _thick(n: int) -> lagdsl.Model:
    return lagdsl.compile(f"""
model Thick
  parameter Length h = 0.5 m, w = 0.1 m;
  parameter Force F = 0;
  Lag.Flexible.ExactBeam beam(n = {n}, L = 2 m, A = w*h, I = w*h^3/12, E = 2.07e11 Pa, k_s = 13/15.3);
  gravity = 0;
  connect(world, beam);
  force F*world.y at beam.frame_b;
  output Length u = 2 m - beam.frame_b.origin.x, v = beam.frame_b.origin.y;
end Thick;
""")


@pytest.mark.parametrize(
    ("load", "exudyn"),
    [(8.896, [-0.0143664, -0.0089529, 0.1089703]), (13.345, [-0.0303357, -0.0155488, 0.1565214])],
)
def test_the_princeton_beam_at_45_degrees(load: float, exudyn: list[float]) -> None:
    """16 elements there and 8 here: half a percent of discretisation."""
    beta = radians(45)
    told = _told(_princeton(), **{"F[2]": -load * cos(beta), "F[3]": load * sin(beta)})
    assert told == pytest.approx(exudyn, rel=1e-2)


@cache
def _princeton() -> lagdsl.Model:
    return lagdsl.compile("""
model Princeton
  parameter Length h = 12.3777 mm, w = 3.2024 mm;
  parameter Force F[3] = {0, 0, 0};
  parameter Pressure E = 71.7 GPa;
  Lag.Flexible.SpatialExactBeam beam(n = 8, L = 0.508 m, A = w*h, Iy = h*w^3/12, Iz = w*h^3/12,
      J = 0.198*w*h*(w^2 + h^2)/12, E = E, G = E/2.62, k_s = 1);
  gravity = 0;
  connect(world, beam);
  force F at beam.frame_b;
  output Length u[3] = beam.frame_b.origin - {0.508 m, 0, 0};
end Princeton;
""")
