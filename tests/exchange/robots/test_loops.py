"""Loops of URDF files: `<loop_joint>`, and joints of SDFormat in `<gazebo>`.

Newton-Euler equations of the tree, and closures written here by places of links, give the accelerations; derivatives of
closures are those of complex steps.
"""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from choice import chosen
from scipy.spatial.transform import Rotation

import lagdsl
from robots.imported import imported, refusal
from robots.world_newton_euler import Robot, fixed_angles

LINK = """<link name="{0}"><inertial><origin xyz="0.15 0.02 {1}"/><mass value="{2}"/>
<inertia ixx="0.02" iyy="0.03" izz="0.025" ixy="0.002" ixz="0" iyz="0.001"/></inertial></link>"""
HINGE = """<joint name="to_{1}" type="continuous"><parent link="{0}"/><child link="{1}"/><origin xyz="{2}" rpy="{3}"/>
<axis xyz="{4}"/></joint>"""
AXES = ("0 0 1", "0 1 0", "1 0 0", "0 1 1", "1 0 1", "0 0 1", "1 1 0")
ONE, OTHER = ("a1", "a2", "a3", "a4"), ("b1", "b2", "b3")
AT = np.array([0.1, 0.2, -0.05])  # the joint in the frame of the last link of the first arm
TILT = np.array([0.3, -0.2, 0.4])
AXIS, AXIS_2 = np.array([0.0, 0.6, 0.8]), np.array([1.0, 0.0, 0.0])


def tree() -> str:
    """Two arms of four and three hinges on one base."""
    text, axes = ['<link name="base"/>'], iter(AXES)
    for arm, side in ((ONE, -0.4), (OTHER, 0.4)):
        text += [LINK.format(name, 0.01 * k, 1 + 0.3 * k) for k, name in enumerate(arm)]
        text.append(HINGE.format("base", arm[0], f"0 {side} 0.5", f"0.1 0.2 {side}", next(axes)))
        text += [HINGE.format(before, name, "0.3 0 0.05", "0 0 0", next(axes)) for before, name in pairwise(arm)]
    return "".join(text)


def words(vector: np.ndarray) -> str:
    return " ".join(map(repr, map(float, vector)))


class Closed:
    """A robot whose arms a joint joins where all angles are zero."""

    def __init__(self, path: Path) -> None:
        path.write_text(f'<robot name="two_arms">{tree()}</robot>')
        self.robot = Robot(path)
        place = self.places(dict.fromkeys(self.robot.moved, 0.0))
        (R, o), (S, p) = place["a4"], place["b3"]
        turned, at = R @ fixed_angles(TILT), o + R @ AT
        self.behind, self.at_behind = S.T @ turned, S.T @ (at - p)  # the same frame, seen from the other link

    def places(self, q: dict) -> dict:
        still = dict.fromkeys(q, 0.0)
        return {name: each[:2] for name, each in self.robot.motion(q, still, still).items()}

    def rows(self, kind: str, q: np.ndarray) -> np.ndarray:
        """Conditions of the joint between both frames."""
        place = self.places(dict(zip(self.robot.moved, q, strict=True)))
        (R, o), (S, p) = place["a4"], place["b3"]
        A, B = R @ fixed_angles(TILT), S @ self.behind
        gap = A.T @ (p + S @ self.at_behind - o - R @ AT)
        C = A.T @ B  # turn of the second frame against the first
        u = np.cross(AXIS, [1.0, 0.0, 0.0])
        u /= np.linalg.norm(u)
        v = np.cross(AXIS, u)
        across, skew = [u @ C @ AXIS, v @ C @ AXIS], [C[2, 1] - C[1, 2], C[0, 2] - C[2, 0], C[1, 0] - C[0, 1]]
        match kind:
            case "spherical" | "ball":
                return gap
            case "revolute" | "continuous":
                return np.array([*gap, *across])
            case "prismatic":
                return np.array([gap @ u, gap @ v, *skew])
            case "planar":
                return np.array([gap @ AXIS, *across])
            case "universal":
                return np.array([*gap, AXIS @ C @ AXIS_2])
            case "screw":  # a turn by a about the axis has the entries sin(a) and cos(a) across it
                angle = np.arctan(v @ C @ u / (u @ C @ u))
                return np.array([gap @ u, gap @ v, *across, gap @ AXIS - 0.3 / (2 * np.pi) * angle])
            case _:
                return np.array([*gap, *skew])

    def accelerations(self, kind: str, q: np.ndarray, qd: np.ndarray, damping: float = 0.0) -> np.ndarray:
        """Of all hinges, by Newton's and Euler's equations and multipliers."""
        names, n, h = self.robot.moved, len(q), 1e-30

        def efforts(rates: np.ndarray, accelerations: np.ndarray, gravity: bool = True) -> np.ndarray:
            given = (dict(zip(names, each, strict=True)) for each in (q, rates, accelerations))
            found = self.robot.efforts(*given, *([] if gravity else [np.zeros(3)]))
            return np.array([found[name] for name in names])

        def rate(at: np.ndarray, along: np.ndarray) -> np.ndarray:
            return self.rows(kind, at + 1j * h * along).imag / h

        mass = np.array([efforts(0 * qd, unit, gravity=False) for unit in np.eye(n)])
        J = np.array([rate(q, unit) for unit in np.eye(n)]).T
        gamma = (rate(q + 1e-5 * qd, qd) - rate(q - 1e-5 * qd, qd)) / 2e-5
        system = np.block([[mass, J.T], [J, np.zeros((len(J), len(J)))]])
        return np.linalg.lstsq(system, np.concatenate([-efforts(qd, 0 * qd), -gamma]), rcond=1e-12)[0][:n]


def loop_joint(kind: str, closed: Closed) -> str:
    behind = Rotation.from_matrix(closed.behind).as_euler("xyz")
    return f"""<loop_joint name="latch" type="{kind}"><link1 link="a4" xyz="{words(AT)}" rpy="{words(TILT)}"/>
<link2 link="b3" xyz="{words(closed.at_behind)}" rpy="{words(behind)}"/><axis xyz="{words(AXIS)}"/></loop_joint>"""


def gazebo(kind: str, closed: Closed, more: str = "") -> str:
    """Its parent is the second arm: the frame of the joint is given in the first one, its child."""
    return f"""<gazebo><joint name="latch" type="{kind}"><parent>b3</parent><child>a4</child>
<pose>{words(AT)} {words(TILT)}</pose>{more}<axis><xyz>{words(AXIS)}</xyz></axis></joint></gazebo>"""


def check_motion(path: Path, text: str, kind: str, closed: Closed) -> lagdsl.Model:
    """Closed to 1e-10 along a motion, with accelerations as here."""
    path.write_text(f'<robot name="two_arms">{tree()}{text}</robot>')
    model_text, told = imported(path, actuators="none")
    assert not told
    model = lagdsl.compile(model_text, engine="tape")
    names = [f"{name}.q" for name in closed.robot.moved]
    own = [list(model.coordinates).index(name) for name in names if name in model.coordinates]
    motion = model.simulate(stop=0.2, tolerance=1e-10, start={f"der({names[0]})": 0.3})

    for k in (0, len(motion["time"]) // 2, -1):
        q = np.array([motion[name][k] for name in names])
        assert np.abs(closed.rows(kind, q)).max() < 1e-10
        if kind == "fixed":  # a hinge is cut instead of what is rigid; its rate is no column
            continue
        qd = np.array([motion[f"der({name})"][k] for name in names])
        assert np.abs(qd).max() > 1e-3
        whole = ([motion[form.format(name)][k] for name in model.coordinates] for form in ("{}", "der({})"))
        found = model.forward_dynamics(0.0, *map(np.array, whole))[own]
        expected = closed.accelerations(kind, q, qd)
        assert np.abs(found - expected).max() < 1e-6 * np.abs(expected).max()
    return model


LOOPS = ("spherical", "revolute", "continuous", "prismatic", "planar", "fixed", "ball")


@pytest.mark.parametrize("kind", chosen(LOOPS, ["spherical"]))
def test_loop_joints_close_the_loop(tmp_path: Path, kind: str) -> None:
    closed = Closed(tmp_path / "robot.urdf")
    check_motion(tmp_path / "robot.urdf", loop_joint(kind, closed), kind, closed)


SDF = ("ball", "revolute", "continuous", "prismatic", "screw", "universal", "revolute2", "fixed")


@pytest.mark.parametrize("kind", chosen(SDF, ["screw"]))
def test_joints_of_gazebo_close_the_loop(tmp_path: Path, kind: str) -> None:
    """Two axes of SDFormat: the first is fixed in the parent, the second in the child."""
    closed = Closed(tmp_path / "robot.urdf")
    more = "<screw_thread_pitch>0.3</screw_thread_pitch>" if kind == "screw" else ""
    if kind in ("universal", "revolute2"):
        more = f"<axis2><xyz>{words(AXIS)}</xyz></axis2>"
    text = gazebo(kind, closed, more)
    if more.startswith("<axis2>"):  # rows() has the second axis of the pair in the frame of the second arm
        text = text.replace(f"<axis><xyz>{words(AXIS)}", f"<axis><xyz>{words(AXIS_2)}")
    check_motion(tmp_path / "robot.urdf", text, "universal" if kind == "revolute2" else kind, closed)


def test_a_damper_and_limits_of_a_loop(tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    closed = Closed(path)
    loop = loop_joint("revolute", closed).replace(
        "</loop_joint>", '<dynamics damping="0.4"/><limit lower="-1" upper="2" effort="3"/></loop_joint>'
    )
    path.write_text(f'<robot name="two_arms">{tree()}{loop}</robot>')
    text, told = imported(path)
    assert not told
    assert "q(prefer = never, min = -1, max = 2), tau = tau[8])" in " ".join(text.split())
    assert "dissipation 1/2*0.4 N.m.s/rad*der(latch.q)^2;" in text
    efforts = [(each.minimum, each.maximum) for each in lagdsl.compile(text, engine="tape")._compilation.flat.inputs]
    assert efforts == [(-np.inf, np.inf)] * 7 + [(-3.0, 3.0)]
    assert [each.code for each in lagdsl.check(text) if each.severity != "note"] == []


def test_places_of_joints_of_gazebo(tmp_path: Path) -> None:
    """A pose in another frame, in degrees, and an axis in the axes of the robot, are the same joint."""
    path = tmp_path / "robot.urdf"
    closed = Closed(path)
    place = closed.places(dict.fromkeys(closed.robot.moved, 0.0))
    (R, o), (S, p) = place["a4"], place["b2"]
    seen = S.T @ R @ fixed_angles(TILT)
    degrees = np.degrees(Rotation.from_matrix(seen).as_euler("xyz"))
    numbers = f"{words(S.T @ (o + R @ AT - p))} {words(degrees)}"
    world = R @ fixed_angles(TILT) @ AXIS
    plain = gazebo("revolute", closed)
    other = plain.replace(
        plain[plain.index("<pose>") : plain.index("</pose>")], f'<pose relative_to="b2" degrees="true">{numbers}'
    )
    other = other.replace(f"<xyz>{words(AXIS)}</xyz>", f'<xyz expressed_in="__model__">{words(world)}</xyz>')
    old = plain.replace(
        f"<xyz>{words(AXIS)}</xyz>", f"<xyz>{words(world)}</xyz><use_parent_model_frame>1</use_parent_model_frame>"
    )
    models = []
    for text in (plain, other, old):
        path.write_text(f'<robot name="two_arms">{tree()}{text}</robot>')
        models.append(lagdsl.compile(imported(path, actuators="none")[0], engine="tape"))
    q = np.random.default_rng(2).normal(size=7) * 0.3
    rows = [np.asarray(model.constraint_jacobian(0.0, q)) for model in models]
    null = [np.linalg.svd(each)[2][-2:] for each in rows]  # motions that the loop lets
    for each in null[1:]:
        assert np.abs(each.T @ each - null[0].T @ null[0]).max() < 1e-9


WRONG = [
    ("type", '<loop_joint name="l" type="hook"><link1 link="a4"/><link2 link="b3"/></loop_joint>', "E1010"),
    ("end", '<loop_joint name="l" type="ball"><link1 link="a4"/></loop_joint>', "E1005"),
    ("link", '<loop_joint name="l" type="ball"><link1 link="a4"/><link2 link="b9"/></loop_joint>', "E1008"),
    ("name", '<loop_joint name="to_a1" type="ball"><link1 link="a4"/><link2 link="b3"/></loop_joint>', "E1007"),
    ("itself", '<loop_joint name="l" type="ball"><link1 link="a4"/><link2 link="a4"/></loop_joint>', "E1017"),
    ("gears", '<gazebo><joint name="l" type="gearbox"><parent>a4</parent><child>b3</child></joint></gazebo>', "E1016"),
    ("sdf type", '<gazebo><joint name="l" type="hook"><parent>a4</parent><child>b3</child></joint></gazebo>', "E1010"),
    ("sdf link", '<gazebo><joint name="l" type="ball"><parent>a4</parent><child>b9</child></joint></gazebo>', "E1008"),
]


@pytest.mark.parametrize(("loop", "code"), [pytest.param(*row[1:], id=row[0]) for row in WRONG])
def test_loops_that_cannot_be_read_are_told(tmp_path: Path, loop: str, code: str) -> None:
    assert [each[0] for each in refusal(tmp_path / "robot.urdf", f"<robot>{tree()}{loop}</robot>")] == [code]
