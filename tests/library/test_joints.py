"""Every joint, cut: the motion is that of the joint in the tree."""

from __future__ import annotations

import numpy as np
import pytest
from choice import spread

import lagdsl

# A body with a rider, on a joint on a tilted base that is turned; the second way to the body makes the compiler cut one
# of the two.
SPATIAL = """
model Spatial
  import Lag.Spatial.*;
  RevoluteDrive base(axis = {{1, 2, -2}}, angle = 3*sin(2*time*(1 /s)));
  Weld seat(r = {{0.3, 0.2, -0.1}}, angles = {{0.3, -0.5, 0.8}});
  {first}
  {second}
  Body b(m = 2 kg, com = {{0.2, 0.1, -0.3}}, I = {{0.05, 0.06, 0.07}});
  Revolute hinge(axis = {{1, 1, 0}});
  Body rider(m = 0.5 kg, com = {{0, 0.2, 0.1}}, I = {{0.01, 0.01, 0.01}});
  gravity = -g_n*world.y;
  connect(world, base, seat);
  {connections}
  connect(b.frame_a, hinge, rider);
  output Length P[3] = b.frame_a.point({{0.1 m, 0.2 m, 0.3 m}});
  output Real X[3] = b.frame_a.x;
  output Force F[3] = reaction(j).force;
  output Torque M[3] = reaction(j).torque;
end Spatial;
"""
PLANAR = """
model Plane
  import Lag.Planar.*;
  RevoluteDrive base(angle = 3*sin(2*time*(1 /s)));
  Weld seat(r = {{0.3, 0.2}}, angle = 20 deg);
  {first}
  {second}
  Body b(m = 2 kg, com = {{0.2, 0.1}}, Izz = 0.05);
  Revolute hinge;
  Body rider(m = 0.5 kg, com = {{0, 0.2}}, Izz = 0.01);
  gravity = -g_n*world.y;
  connect(world, base, seat);
  {connections}
  connect(b.frame_a, hinge, rider);
  output Length P[3] = b.frame_a.point({{0.1 m, 0.2 m}});
  output Real X[3] = b.frame_a.x;
  output Force F[3] = reaction(j).force;
  output Torque M[3] = reaction(j).torque;
end Plane;
"""
JOINTS = [
    (SPATIAL, "Revolute j(axis = {1, 2, 2});", ["q"]),
    (SPATIAL, "Prismatic j(axis = {-2, 1, -2});", ["s"]),
    (SPATIAL, "Cylindrical j(axis = {0, 3, -4});", ["s", "q"]),
    (SPATIAL, "Screw j(axis = {0, 0, -1}, lead = 0.4);", ["q"]),
    (SPATIAL, 'FreeMotion j(sequence = "zxy");', ["r[1]", "r[2]", "r[3]", "angles[1]", "angles[2]", "angles[3]"]),
    (SPATIAL, "Weld j(r = {0.1, 0.2, 0.3}, angles = {1, 0.4, 2});", []),
    (PLANAR, "FreeMotion j;", ["x", "y", "q"]),
    (PLANAR, "Weld j(r = {0.1, 0.2}, angle = 1);", []),
    (SPATIAL, "Universal j;", ["a", "b"]),
    (SPATIAL, "Spherical j;", []),
    (SPATIAL, "Planar j(axis = {1, -2, 2});", ["x", "y", "q"]),
    (SPATIAL, "RevoluteDrive j(axis = {2, 1, 2}, angle = sin(3*time*(1 /s)));", []),
    (SPATIAL, "PrismaticDrive j(axis = {2, 1, 2}, way = (0.2 m)*sin(3*time*(1 /s)));", []),
    (PLANAR, "Revolute j;", ["q"]),
    (PLANAR, "Prismatic j(axis = {3, 4});", ["s"]),
    (PLANAR, "RevoluteDrive j(angle = sin(3*time*(1 /s)));", []),
    (PLANAR, "PrismaticDrive j(axis = {1, -2}, way = (0.2 m)*sin(3*time*(1 /s)));", []),
]
FREE = {SPATIAL: "FreeQuaternion free;", PLANAR: "FreeMotion free;"}


def _name(case: object) -> str:
    return case.partition(" ")[0] if isinstance(case, str) and len(case) < 200 else ""


@pytest.mark.parametrize(("text", "joint", "coordinates"), spread(JOINTS, 6), ids=_name)
def test_cut_and_in_the_tree_a_joint_lets_the_same_motion_through(
    text: str, joint: str, coordinates: list[str]
) -> None:
    chain = "connect(seat.frame_b, j, b);"
    loop = "connect(seat.frame_b, free, b); " + chain
    tree = _motion(text.format(first=joint, second="", connections=chain))
    cut = _motion(text.format(first=FREE[text], second=joint, connections=loop))
    columns = [f"{name}[{k}]" for name in "PXFM" for k in (1, 2, 3)]
    for column in [*columns, *(f"j.{name}" for name in coordinates), "hinge.q"]:
        size = max(1.0, float(np.max(np.abs(tree[column]))))
        np.testing.assert_allclose(cut[column], tree[column], atol=1e-7 * size, err_msg=column)
    assert np.max(np.abs(tree["P[1]"] - tree["P[1]"][0])) > 0.01


def _motion(text: str) -> lagdsl.Trajectory:
    return lagdsl.compile(text).simulate(stop=0.6, interval=0.02, tolerance=1e-9)
