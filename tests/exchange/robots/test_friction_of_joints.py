"""Dry friction of joints and tendons sticks: the `friction` of URDF, the `frictionloss` of MJCF."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import lagdsl
from robots.imported import imported

G = 9.80665  # m/s2

SLIDE = """<robot name="r">
  <link name="base"/>
  <link name="sled"><inertial><mass value="2"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="wheel"><inertial><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="0.5"/></inertial></link>
  <joint name="rail" type="prismatic">
    <parent link="base"/><child link="sled"/><axis xyz="0 0 1"/>
    <limit lower="-9" upper="9" effort="100" velocity="9"/><dynamics friction="{friction}"/>
  </joint>
  <joint name="axle" type="continuous">
    <parent link="base"/><child link="wheel"/><axis xyz="0 0 1"/><dynamics friction="0.3"/>
  </joint>
</robot>
"""
TENDON = """<mujoco>
  <worldbody>
    <body name="one"><joint name="a" type="slide" axis="1 0 0" frictionloss="0.4"/>
      <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body>
    <body name="two"><joint name="b" type="slide" axis="1 0 0"/>
      <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body>
  </worldbody>
  <tendon><fixed name="t" frictionloss="1.5"><joint joint="a" coef="1"/><joint joint="b" coef="-2"/></fixed></tendon>
</mujoco>
"""


def _urdf(folder: Path, friction: float) -> str:
    path = folder / "robot.urdf"
    path.write_text(SLIDE.format(friction=friction))
    text, _ = imported(path, actuators="none")
    assert f"friction rail_friction: der(rail.s) with limit = {friction:g} N;" in text
    return text


@pytest.mark.parametrize(("friction", "acceleration"), [(25.0, 0.0), (12.0, 6.0 - G)])
def test_a_joint_of_urdf_holds_its_weight_or_slides(tmp_path: Path, friction: float, acceleration: float) -> None:
    """A weight of 19.6 N; the wheel stops after 5 rad/s over 0.6 rad/s2."""
    motion = lagdsl.compile(_urdf(tmp_path, friction), engine="tape").simulate(stop=10.0, start={"der(axle.q)": 5.0})
    np.testing.assert_allclose(motion["rail.s"], acceleration * motion.time**2 / 2, rtol=1e-9, atol=1e-12)
    (told,) = [event for event in motion.events if event.name == "axle_friction" and event.time > 0]
    assert (told.kind, told.time) == ("sticks", pytest.approx(5.0 / 0.6, rel=1e-9))
    assert motion["axle.q"][-1] == pytest.approx(5.0**2 / 1.2, rel=1e-9)


def test_a_tendon_of_mjcf_rubs(tmp_path: Path) -> None:
    """Its force F along a - 2 b brakes a with F and b with -2 F: with the slide's own 0.4 N, until a - 2 b rests."""
    pytest.importorskip("mujoco")
    path = tmp_path / "robot.xml"
    path.write_text(TENDON)
    text, _ = imported(path)
    assert "friction t_friction: der(t) with limit = 1.5 N;" in text
    motion = lagdsl.compile(text, engine="tape").simulate(stop=3.0, start={"der(a.s)": 4.0})
    # a' = -1.9, b' = 3: the slip 4 - 7.9 t ends; then b = a/2, and 5/4 a' = -0.4
    first = 4.0 / 7.9
    rate = 4.0 - 1.9 * first
    assert rate == pytest.approx(2 * 3.0 * first)
    expected = np.where(motion.time < first, 4.0 - 1.9 * motion.time, rate - 0.32 * (motion.time - first))
    np.testing.assert_allclose(motion["der(a.s)"], expected, atol=1e-9)
