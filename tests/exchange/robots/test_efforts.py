"""Inputs of a robot with one actuator a joint: arrays, in the order of the joints."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import lagdsl

LINK = (
    '<link name="{name}"><inertial><origin xyz="1 0 0"/><mass value="2"/>'
    '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>'
)
JOINT = (
    '<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/><axis xyz="0 0 1"/>'
    "{rest}</joint>"
)
LIMIT = '<limit lower="-1" upper="1" effort="{effort}" velocity="0"/>'


def urdf(*joints: tuple[str, str, str], more: str = "") -> str:
    """A chain of joints (name, type, what stands in them)."""
    names = ["base", *(f"link_of_{name}" for name, _, _ in joints)]
    parts = [f'<link name="{names[0]}"/>', *(LINK.format(name=name) for name in names[1:])]
    for (name, kind, rest), parent, child in zip(joints, names, names[1:], strict=False):
        parts.append(JOINT.format(name=name, kind=kind, parent=parent, child=child, rest=rest))
    return f'<robot name="chain">{"".join(parts)}{more}</robot>'


def imported(folder: Path, text: str, **style: str) -> lagdsl.Model:
    path = folder / "chain.urdf"
    path.write_text(text, encoding="utf-8")
    return lagdsl.compile(lagdsl.import_robot(path, **style), engine="tape")  # type: ignore[arg-type]


def limits(model: lagdsl.Model) -> list[tuple[str, object, object]]:
    return [(each.name, each.minimum, each.maximum) for each in model._compilation.flat.inputs]


def test_efforts_are_arrays_in_the_order_of_the_joints(tmp_path: Path) -> None:
    joints = [
        ("turn", "revolute", LIMIT.format(effort=5)),
        ("lift", "prismatic", LIMIT.format(effort=40)),
        ("swing", "continuous", ""),
        ("reach", "prismatic", LIMIT.format(effort=40)),
    ]
    model = imported(tmp_path, urdf(*joints))
    assert model.coordinates == ["turn.q", "lift.s", "swing.q", "reach.s"]
    assert limits(model) == [
        ("tau[1]", -5.0, 5.0), ("tau[2]", -np.inf, np.inf), ("f[1]", -40.0, 40.0), ("f[2]", -40.0, 40.0),
    ]  # fmt: skip
    q, qd = np.array([0.3, 0.1, -0.4, 0.2]), np.zeros(4)
    without = model.inverse_dynamics(0.0, q, qd, np.zeros(4))
    efforts = {"tau": [1.0, 2.0], "f": [3.0, 4.0]}
    np.testing.assert_allclose(without - model.inverse_dynamics(0.0, q, qd, np.zeros(4), u=efforts), [1, 3, 2, 4])


def test_one_effort_of_a_kind_has_the_name_of_its_joint(tmp_path: Path) -> None:
    joints = [("turn", "revolute", LIMIT.format(effort=5)), ("lift", "prismatic", LIMIT.format(effort=40))]
    assert limits(imported(tmp_path, urdf(*joints))) == [("tau_turn", -5.0, 5.0), ("f_lift", -40.0, 40.0)]


def test_some_joints_without_an_actuator_leave_the_names_of_the_others(tmp_path: Path) -> None:
    """`tau[2]` would not be the torque of the second joint."""
    inside = '<type>SimpleTransmission</type><joint name="{name}"/><actuator name="m{k}"/>'
    drive = f'<transmission name="d{{k}}">{inside}</transmission>'
    joints = [(name, "revolute", LIMIT.format(effort=5)) for name in ("a", "b", "c")]
    two = "".join(drive.format(k=k, name=name) for k, name in enumerate("ac"))
    assert [name for name, _, _ in limits(imported(tmp_path, urdf(*joints, more=two)))] == ["tau_a", "tau_c"]
    every = "".join(drive.format(k=k, name=name) for k, name in enumerate("cab"))
    model = imported(tmp_path, urdf(*joints, more=every))
    assert [name for name, _, _ in limits(model)] == ["tau[1]", "tau[2]", "tau[3]"]
    left = np.zeros(3) - model.inverse_dynamics(0.0, [0, 0, 0], [0, 0, 0], [0, 0, 0], u={"tau": [1.0, 2.0, 3.0]})
    np.testing.assert_allclose(left, [1.0, 2.0, 3.0])  # gravity is along the axes


def test_an_array_has_a_free_name(tmp_path: Path) -> None:
    model = imported(
        tmp_path, urdf(("tau", "revolute", LIMIT.format(effort=5)), ("b", "revolute", LIMIT.format(effort=5)))
    )
    assert [name for name, _, _ in limits(model)] == ["tau_input[1]", "tau_input[2]"]


@pytest.mark.parametrize("style", ["all", "none"])
def test_wanted_actuators(tmp_path: Path, style: str) -> None:
    joints = [(name, "revolute", LIMIT.format(effort=5)) for name in ("a", "b")]
    assert len(imported(tmp_path, urdf(*joints), actuators=style).inputs) == (2 if style == "all" else 0)
