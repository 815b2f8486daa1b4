"""A URDF file as a model: its equations are those of Newton and Euler, its text is what a person would write."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from choice import paired

import lagdsl
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.syntax.printer import format_text
from robots.imported import ARM, FILES, compiled, imported
from robots.world_newton_euler import Robot

COORDINATES = {
    "shoulder": "shoulder.q",
    "slide": "slide.s",
    "wrist": "wrist_joint.q",
    "finger_1": "finger_1_joint.q",
    "finger_2": "finger_2_joint.q",
}
DAMPING = {"shoulder": 0.7, "slide": 12.0}
GEAR = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [0, 0, 0, -0.8]])
ROUND = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
OUTPUTS = """
  output Length p[3] = tool.origin;
  output Velocity v[3] = der(tool.origin);
  output AngularVelocity w[3] = omega(tool);
  output Acceleration a[3] = der(der(tool.origin));
  output Real ex[3] = tool.x, ez[3] = tool.z;
"""
STATES = 20


@pytest.fixture(scope="module")
def model() -> lagdsl.Model:
    return compiled(ARM, OUTPUTS)


@pytest.fixture(scope="module")
def robot() -> Robot:
    return Robot(ARM)


def states() -> list[tuple[np.ndarray, ...]]:
    """Angles, rates and accelerations by joint, the second finger as its gear has it."""
    random = np.random.default_rng(3)
    free = random.normal(size=(3, STATES, 4))
    q = free[0] @ GEAR.T
    q[:, 4] += 0.1
    return list(zip(q, free[1] @ GEAR.T, free[2] @ GEAR.T, strict=True))


def by_name(values: np.ndarray) -> dict[str, float]:
    return dict(zip(COORDINATES, values, strict=True))


def sliding(model: lagdsl.Model, qd: np.ndarray) -> list[float]:
    """The discretes with the friction of the shoulder, the first coordinate, against its rate."""
    modes = {"sticks(shoulder_friction)": 0.0, "direction(shoulder_friction)": float(np.sign(qd[0]))}
    return [modes[name] for name in model.discretes]


def test_coordinates_have_the_names_of_the_joints(model: lagdsl.Model) -> None:
    assert list(model.coordinates) == list(COORDINATES.values())
    assert list(model.inputs) == ["tau_shoulder", "f_slide"]


def test_inverse_dynamics_are_newtons_and_eulers_equations(model: lagdsl.Model, robot: Robot) -> None:
    for q, qd, qdd in states():
        efforts = robot.efforts(by_name(q), by_name(qd), by_name(qdd))
        efforts["shoulder"] += 0.7 * qd[0] + 0.1 * np.sign(qd[0])
        efforts["slide"] += 12.0 * qd[1]
        expected = np.array([efforts[name] for name in COORDINATES])
        found = model.inverse_dynamics(0.0, q, qd, qdd, w=sliding(model, qd))
        assert np.abs(found - expected).max() < 1e-12 * np.abs(expected).max()


def test_forward_dynamics_invert_them_along_the_gear(model: lagdsl.Model, robot: Robot) -> None:
    efforts = np.array([7.0, -30.0, 0.0, 0.0, 0.0])
    for q, qd, _ in states():
        qdd = model.forward_dynamics(0.0, q, qd, u=efforts[:2], w=sliding(model, qd))
        assert abs(qdd[4] + 0.8 * qdd[3]) < 1e-10 * np.abs(qdd).max()
        needed = robot.efforts(by_name(q), by_name(qd), by_name(qdd))
        needed["shoulder"] += 0.7 * qd[0] + 0.1 * np.sign(qd[0])
        needed["slide"] += 12.0 * qd[1]
        left = GEAR.T @ (np.array([needed[name] for name in COORDINATES]) - efforts)
        assert np.abs(left).max() < 1e-10 * max(map(abs, needed.values()))


def test_mass_matrix_is_the_response_to_accelerations(model: lagdsl.Model, robot: Robot) -> None:
    for q, _, _ in states():
        zero = np.zeros(5)
        columns = [robot.efforts(by_name(q), by_name(zero), by_name(unit), np.zeros(3)) for unit in np.eye(5)]
        expected = np.array([[column[name] for column in columns] for name in COORDINATES])
        assert np.abs(model.mass_matrix(0.0, q) - expected).max() < 1e-12 * np.abs(expected).max()


def test_the_tool_moves_as_the_links_say(model: lagdsl.Model, robot: Robot) -> None:
    for q, qd, _ in states():
        y = model.output(0.0, q, qd).reshape(6, 3)
        qdd = model.forward_dynamics(0.0, q, qd)
        R, o, w, _, v, a = robot.motion(by_name(q), by_name(qd), by_name(qdd))["tool"]
        for found, expected in zip(y, (o, v, w, a, R[:, 0], R[:, 2]), strict=True):
            assert np.abs(found - expected).max() < 1e-12 * max(1.0, np.abs(expected).max())


def test_the_text_is_the_one_that_was_read_and_found_good() -> None:
    text, _ = imported(ARM)
    assert text == (FILES / "arm.lag").read_text(encoding="utf-8")


@pytest.mark.parametrize(("limits", "actuators"), paired(["range", "contact", "none"], ["file", "all", "none"]))
def test_every_choice_gives_a_formatted_text_without_a_warning(limits: str, actuators: str) -> None:
    text, _ = imported(ARM, limits=limits, actuators=actuators)
    assert format_text(SourceFile("arm.lag", text), Sink()) == text
    assert ("contact" in text, "max = 2)" in text) == (limits == "contact", limits == "range")
    names = {"file": ["tau_shoulder", "f_slide"], "all": ["tau[3]", "f_slide"], "none": []}[actuators]
    assert re.findall(r"\n  input \w+ ([^(;]+)", text) == names
    if actuators == "all":  # the other choices differ in lines that these have
        assert [each.code for each in lagdsl.check(text) if each.severity != "note"] == []


def test_contacts_stop_a_joint_at_its_limit() -> None:
    """Thrown upward, the slide meets its upper limit, 0.5 m, falls, and rests on the lower one, 0.1 m."""
    model = compiled(FILES / "slide.urdf", limits="contact")
    motion = model.simulate(stop=1.0, start={"lift.s": 0.4, "der(lift.s)": 2.0})
    assert 0.5 - 1e-4 < motion["lift.s"].max() < 0.5 + 1e-9
    assert abs(motion["lift.s"][-1] - 0.1) < 1e-9
    assert motion["lift.s"].min() > 0.1 - 1e-9


def test_a_base_that_floats_falls_freely() -> None:
    """The mass center of all links has the acceleration of gravity, whatever the joints do."""
    centers = ("der(der(hull.frame_a.point(hull.com)))", "der(der(arm.frame_a.point(arm.com)))")
    model = compiled(
        FILES / "floater.urdf", f"output Force P[3] = 3 kg*{centers[0]} + 2 kg*{centers[1]};", floating=True
    )
    assert len(model.coordinates) == 8
    random = np.random.default_rng(4)
    for _ in range(5):
        q, qd = random.normal(size=8), random.normal(size=8)
        e = q[3:7] / np.linalg.norm(q[3:7])
        q[3:7], qd[3:7] = e, qd[3:7] - e * (e @ qd[3:7])
        force = model.output(0.0, q, qd)
        assert np.abs(force - [0, 0, -5.0 * 9.80665]).max() < 1e-11


def test_floating_planar_and_turned_joints_inside_of_a_tree() -> None:
    text, _ = imported(FILES / "kinds.urdf")
    assert "FreeQuaternion loose;" in text and "Planar plate_joint(axis = {0, 1, 0});" in text
    assert [each.code for each in lagdsl.check(text) if each.severity != "note"] == []


def test_names_that_the_language_does_not_have_are_told(tmp_path: Path) -> None:
    odd = ["1 foot", "der", "world", "Revolute", "pi", "Länge", "a/b", "a.b", "end", "mass", "Mass", "connect", "///"]
    links = "".join(
        f'<link name="{name}"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
        f"</inertial></link>"
        for name in odd
    )
    joints = "".join(
        f'<joint name="{name}" type="continuous"><parent link="{before}"/><child link="{name}"/></joint>'
        for before, name in pairwise(odd)
    )
    path = tmp_path / "odd.urdf"
    path.write_text(f'<robot name="&#163; odd">{links}{joints}</robot>', encoding="utf-8")
    text, told = imported(path)
    assert [each.code for each in lagdsl.check(text) if each.severity != "note"] == []
    renamed = [each.message for each in told if each.code == "N1020"]
    assert "the link `1 foot` is called `link_1_foot` in the text" in renamed
    assert "the link `a.b` is called `a_b_link` in the text" in renamed
    assert "the joint `Länge` is called `Lange_joint` in the text" in renamed
    assert not any("`mass` is called `mass_link`" in each for each in renamed)


@pytest.mark.parametrize("limits", ["range", "contact"])
def test_what_stands_beside_a_joint_has_a_free_name(tmp_path: Path, limits: str) -> None:
    """Links and joints of the file may be called as the text would call its origin, gear, friction and stops."""
    roles = ["j_origin", "j_gear", "j_friction", "j_lower", "j_upper", "tau_j"]
    names = ["l", *roles, "end_of_chain"]
    rest = '<origin xyz="1 0 0"/><axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="1" velocity="1"/>'
    mimic = '<mimic joint="j_gear_joint" multiplier="2"/><dynamics friction="0.5"/>'
    parts = "".join(f'<link name="{name}"><inertial><mass value="1"/>{ROUND}</inertial></link>' for name in names)
    for before, name in pairwise(names):
        own, more = ("j", mimic) if name == "j_origin" else (f"{name}_joint", "")
        ends = f'<parent link="{before}"/><child link="{name}"/>'
        parts += f'<joint name="{own}" type="revolute">{ends}{rest}{more}</joint>'
    path = tmp_path / "robot.urdf"
    path.write_text(f'<robot name="r">{parts}</robot>')
    text, told = imported(path, limits=limits)
    assert [each.code for each in lagdsl.check(text) if each.severity != "note"] == []
    assert not told  # all names of the file are kept
    assert "FixedTranslation j_origin_part(r = {1, 0, 0});" in text and "constraint j_gear_part: " in text
