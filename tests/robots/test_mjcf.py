"""An MJCF file as a model: its equations are those that MuJoCo computes from the file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lagdsl
from lagdsl.diagnostics import Sink
from lagdsl.source import SourceFile
from lagdsl.syntax.printer import format_text
from robots.imported import FILES, compiled, imported, refusal

mujoco = pytest.importorskip("mujoco")

MOBILE = FILES / "mobile.xml"
ROWS = {"rail": "rail.s", "swivel": "swivel.q", "elbow": "elbow.q", "follower": "follower.q"}
OUTPUTS = """
  output Length plate_at[3] = plate.frame_a.origin, knot_at[3] = knot.origin, drone_at[3] = drone.frame_a.origin;
  output Velocity knot_v[3] = der(knot.origin);
  output AngularVelocity plate_w[3] = omega(plate.frame_a);
  output Real plate_x[3] = plate.frame_a.x;
"""


class Peer:
    """MuJoCo at a state, with what maps its velocities to rates of our coordinates: qd = T v, qdd = T a + bias."""

    def __init__(self, model: lagdsl.Model, path: Path) -> None:
        self.m = mujoco.MjModel.from_xml_path(str(path))
        for flag in ("CONTACT", "LIMIT", "FRICTIONLOSS", "EQUALITY"):
            self.m.opt.disableflags |= int(getattr(mujoco.mjtDisableBit, f"mjDSBL_{flag}"))
        self.d: Any = mujoco.MjData(self.m)
        self.place = {name: index for index, name in enumerate(model.coordinates)}

    def at(self, random: np.random.Generator) -> None:
        d, m = self.d, self.m
        d.qpos[:] = random.normal(size=m.nq)
        d.qvel[:] = random.normal(size=m.nv)
        self.q, self.T, self.bias = (
            np.zeros(len(self.place)),
            np.zeros((len(self.place), m.nv)),
            np.zeros(len(self.place)),
        )
        for name, ours in ROWS.items():
            joint = m.joint(name)
            self.q[self.place[ours]] = d.qpos[joint.qposadr[0]]
            self.T[self.place[ours], joint.dofadr[0]] = 1.0
        socket, flight = m.joint("socket"), m.joint("flight")
        for axis in range(3):
            self.q[self.place[f"flight.r[{axis + 1}]"]] = d.qpos[flight.qposadr[0] + axis]
            self.T[self.place[f"flight.r[{axis + 1}]"], flight.dofadr[0] + axis] = 1.0
        self._quaternion("socket.e", socket.qposadr[0], socket.dofadr[0])
        self._quaternion("flight.e", flight.qposadr[0] + 3, flight.dofadr[0] + 3)

    def _quaternion(self, name: str, at: int, rate: int) -> None:
        """de/dt = E(e) w/2 with w in the axes of the body; MuJoCo has the same, scalar first."""
        e = self.d.qpos[at : at + 4] / np.linalg.norm(self.d.qpos[at : at + 4])
        self.d.qpos[at : at + 4] = e
        w = self.d.qvel[rate : rate + 3]
        rows = [self.place[f"{name}[{k}]"] for k in range(1, 5)]
        self.q[rows] = e
        self.T[rows, rate : rate + 3] = _half(e)
        self.bias[rows] = _half(_half(e) @ w) @ w


def _half(e: np.ndarray) -> np.ndarray:
    w, x, y, z = e
    return 0.5 * np.array([[-x, -y, -z], [w, -z, y], [z, w, -x], [-y, x, w]])


def test_equations_and_places_are_those_of_mujoco(tmp_path: Path) -> None:
    """Without the gear, whose force MuJoCo makes soft; friction is off in both."""
    path = tmp_path / "mobile.xml"
    text = MOBILE.read_text(encoding="utf-8")
    path.write_text(text[: text.index("<equality>")] + text[text.index("<actuator>") :], encoding="utf-8")
    model = compiled(path, OUTPUTS)
    assert list(model.inputs) == ["drive", "u_elbow"]
    off = model.parameters.index("elbow_friction.tau_c")
    p = np.array(model.initial_state().p)
    p[off] = 0.0
    peer, random = Peer(model, path), np.random.default_rng(5)
    for _ in range(10):
        peer.at(random)
        u = random.uniform(-1, 1, size=2)
        peer.d.ctrl[:] = u
        mujoco.mj_forward(peer.m, peer.d)
        mass = np.zeros((peer.m.nv, peer.m.nv))
        mujoco.mj_fullM(peer.m, peer.d, mass)
        assert np.abs(peer.T.T @ model.mass_matrix(0.0, peer.q) @ peer.T - mass).max() < 1e-12 * np.abs(mass).max()
        qd = peer.T @ peer.d.qvel
        expected = peer.T @ peer.d.qacc + peer.bias
        found = model.forward_dynamics(0.0, peer.q, qd, u=u, p=p)
        assert np.abs(found - expected).max() < 1e-10 * np.abs(expected).max()
        y = model.output(0.0, peer.q, qd, u=u, p=p).reshape(6, 3)
        jacobian = np.zeros((2, 3, peer.m.nv))
        bodies = {name: peer.m.body(name).id for name in ("plate", "knot", "drone")}
        mujoco.mj_jac(peer.m, peer.d, jacobian[0], None, peer.d.xpos[bodies["knot"]], bodies["knot"])
        mujoco.mj_jacBody(peer.m, peer.d, None, jacobian[1], bodies["plate"])
        seen = [*(peer.d.xpos[bodies[name]] for name in bodies), *(jacobian @ peer.d.qvel)]
        seen.append(peer.d.xmat[bodies["plate"]].reshape(3, 3)[:, 0])
        assert np.abs(y - np.array(seen)).max() < 1e-12 * max(1.0, np.abs(y).max())


def test_the_text_is_sound_and_starts_where_the_file_starts() -> None:
    text, told = imported(MOBILE)
    assert format_text(SourceFile("mobile.lag", text), Sink()) == text
    assert [each.code for each in lagdsl.check(text) if each.severity != "note"] == []
    assert {each.code for each in told} <= {"N1020"}
    for line in (
        "connect(world, rail_origin, rail, swivel_origin, swivel, swivel_end, cart);",
        "gravity = {0.5 m/s2, 0, -9.7 m/s2};",
        "FreeQuaternion flight(r(start = {1, 2, 3}), e(start = {0.6, 0, 0.8, 0}));",
        "input Real drive(min = -1, max = 1);",
        "input Real u_elbow(min = -6, max = 8);",
        "Revolute elbow(q(min = -90 deg, max = 45 deg), tau = 2 N.m*u_elbow);",
    ):
        assert f"\n  {line}\n" in text, text
    assert "sphere(radius = 0.05)" not in text  # a shape for collisions
    assert "potential 1/2*15 N/m*(rail.s - 0.5 m)^2;" in text


def test_the_gear_counts_from_the_references_of_both_joints() -> None:
    """q1 - ref1 = 0.1 - 1.5 (q2 - ref2): radians, ref1 = 5 deg, ref2 = 0."""
    text, _ = imported(MOBILE)
    offset = float(np.radians(5)) + 0.1
    assert f"constraint follower_gear: follower.q = -1.5*elbow.q + {offset!r} rad;" in text


def body(inside: str = "", after: str = "", joint: str = '<joint name="j" type="hinge"/>') -> str:
    ball = f'<body name="b">{joint}<geom name="g" size="0.1"/>{inside}</body>'
    return f"<mujoco>\n<worldbody>{ball}</worldbody>\n{after}</mujoco>"


REFUSED = [
    ("drag", body(after='<option density="1.2"/>'), "E1016", 1),
    ("servo", body(after='<actuator>\n<position name="j" joint="j" kp="3"/></actuator>'), "E1016", 1),
    ("weld", body(after='<equality><weld body1="b"/></equality>'), "E1016", 1),
    ("gravity", body().replace('name="b"', 'name="b" gravcomp="1"'), "E1016", 2),
    ("ball damper", body(joint='<joint name="j" type="ball" damping="1"/>'), "E1016", 2),
    ("tendon", body(after='<tendon><fixed stiffness="1"><joint joint="j" coef="1"/></fixed></tendon>'), "E1016", 1),
    ("unknown", body(after="<wheel/>"), "E1015", 1),
    ("no inertia", body().replace('<geom name="g" size="0.1"/>', ""), "E1015", 1),
    ("mesh outside", body(after='<asset><mesh name="m" file="/etc/passwd"/></asset>'), "E1013", 3),
    ("folder outside", body(after='<compiler meshdir="../.."/><asset><mesh file="m.stl"/></asset>'), "E1013", 3),
    ("include outside", body(after='<include file="../other.xml"/>'), "E1013", 3),
    ("include itself", body(after='<include file="robot.xml"/>'), "E1002", 3),
    ("entity", '<!DOCTYPE m [<!ENTITY a "a">]>' + body(), "E1003", 1),
]


@pytest.mark.parametrize(("text", "code", "line"), [pytest.param(*row[1:], id=row[0]) for row in REFUSED])
def test_what_the_text_cannot_have_is_refused(tmp_path: Path, text: str, code: str, line: int) -> None:
    assert [each[:2] for each in refusal(tmp_path / "robot.xml", text)] == [(code, line)]
    if code == "E1016":
        model, told = imported(tmp_path / "robot.xml", lenient=True)
        assert [each.code for each in told if each.severity == "warning"] == ["E1016"]
        assert [each.code for each in lagdsl.check(model) if each.severity == "error"] == []


def test_warnings_of_mujoco_are_notes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "robot.xml"
    path.write_text(body(after='<compiler settotalmass="14"/>'))
    _, told = imported(path)
    assert [each.code for each in told] in (["N1021"], [])  # a later version may say nothing
    assert [each.name for each in tmp_path.iterdir()] == ["robot.xml"]
