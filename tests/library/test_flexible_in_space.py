"""The spatial beam of the library against closed forms and against the planar one."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import lagdsl

GJ, LENGTH = 210e9 / 2.6 * 100e-12, 2.0


@cache
def _clamped() -> lagdsl.Model:
    return lagdsl.compile("""
model Clamped
  import Lag.Flexible.*;
  parameter Force F[3] = {0, 0, 0};
  parameter Torque M[3] = {0, 0, 0};
  SpatialExactBeam beam(L = 2 m, A = 1 cm^2, Iy = 50 mm^4, n = 3);
  gravity = 0;
  connect(world, beam);
  force F at beam.frame_b;
  torque M on beam.frame_b;
  output Torque m[3] = beam.moment[3];
  output Pressure sigma = beam.stress[1];
end Clamped;
""")


def _end(**loads: object) -> tuple[np.ndarray, np.ndarray]:
    """Place and quaternion of the end."""
    values = {f"{name}[{i + 1}]": x for name, vector in loads.items() for i, x in enumerate(vector)}  # type: ignore[arg-type]
    point = _clamped().trim(parameters=values).point
    return point.q[[2, 5, 8]], point.q[-4:]


def test_a_moment_keeps_its_size_along_the_beam() -> None:
    """A moment at the end, which does not turn with it, is the moment in every section: the beam becomes a helix."""
    model = _clamped()
    moment = np.array([1.0, 0.0, 2.0])
    values = {f"M[{i + 1}]": x for i, x in enumerate(moment)}
    point = model.trim(parameters=values).point
    told = np.asarray(model.output(0.0, point.q, point.qd, parameters=values)).ravel()[:3]
    assert np.linalg.norm(told) == pytest.approx(np.linalg.norm(moment), rel=1e-3)
    # the middle of the last element, by half the turns of its ends
    e = point.q[9:].reshape(3, 4)[-2:].sum(axis=0)
    e = e / np.linalg.norm(e)
    s, v = e[0], e[1:]
    back = moment + 2 * np.cross(v, np.cross(v, moment)) - 2 * s * np.cross(v, moment)
    assert told == pytest.approx(back, rel=2e-3, abs=2e-3)


def test_a_twist() -> None:
    place, e = _end(M=[1.5, 0.0, 0.0])
    assert place == pytest.approx([LENGTH, 0, 0], abs=1e-12)
    assert 2 * np.arctan2(e[1], e[0]) == pytest.approx(1.5 * LENGTH / GJ, rel=1e-7)


def test_it_bends_as_the_planar_beam_in_any_plane() -> None:
    planar = lagdsl.compile("""
model Planar
  Lag.Flexible.ExactBeam beam(L = 2 m, A = 1 cm^2, I = 50 mm^4, n = 3);
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


STATICS = """
model Tip
  import Lag.Flexible.*;
  parameter Force F[3] = {1e-3, 2e-6, -3e-6};
  %s;
  gravity = 0;
  connect(world, beam);
  force F at beam.frame_b;
  output Pressure sigma[4] = beam.stress;
end Tip;
"""
IY, IZ, AREA = 50e-12, 200e-12, 1e-4
SECTION = "L = 2 m, A = 1 cm^2, n = 4"


@pytest.mark.parametrize(
    ("beam", "inertias", "fibre"),
    [
        (f"ExactBeam beam({SECTION}, I = 200 mm^4, fibre = 3 mm)", (IZ, np.inf), (3e-3, 0)),
        (
            f"SpatialExactBeam beam({SECTION}, Iy = 50 mm^4, Iz = 200 mm^4)",
            (IZ, IY),
            np.sqrt([3 * IZ / AREA, 3 * IY / AREA]),
        ),
    ],
    ids=["planar", "in space"],
)
def test_the_stress_of_a_fibre_is_that_of_tension_and_bending(
    beam: str, inertias: tuple[float, float], fibre: tuple[float, float]
) -> None:
    """sigma = N/A - M_z y/I_z + M_y z/I_y with M_z = F_y (L - x) and M_y = -F_z (L - x), in the middle of the elements:
    S. P. Timoshenko and J. N. Goodier, Theory of Elasticity, section 102. Tension straightens by F_x L^2/(E I) = 4e-4.
    """
    model = lagdsl.compile(STATICS % beam)
    point = model.trim().point
    told = np.asarray(model.output(0.0, point.q, point.qd)).ravel()
    arm = LENGTH * (1 - (np.arange(4) + 0.5) / 4)
    bent = 2e-6 * fibre[0] / inertias[0] - 3e-6 * fibre[1] / inertias[1]
    assert told == pytest.approx(1e-3 / AREA - bent * arm, rel=5e-4)


def test_the_stress_of_a_cable_is_that_of_the_outer_fibre() -> None:
    """sigma = N/A + |M| c/I on the side outside of the bend."""
    model = lagdsl.compile(STATICS % f"Cable beam({SECTION}, clamped = true)")
    point = model.trim().point
    told = np.asarray(model.output(0.0, point.q, point.qd)).ravel()
    inertia = AREA**2 / (4 * np.pi)
    arm = LENGTH * (1 - (np.arange(4) + 0.5) / 4)
    bent = np.hypot(2e-6, 3e-6) * np.sqrt(4 * inertia / AREA) / inertia
    assert told == pytest.approx(1e-3 / AREA + bent * arm, rel=1e-3)
