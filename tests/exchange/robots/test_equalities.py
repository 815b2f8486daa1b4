"""Equalities of MJCF files, which MuJoCo holds by stiff springs and the text exactly.

Places, mass matrices and forces are those of MuJoCo, with the multipliers of rigid rows.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import chosen

import lagdsl
from robots.imported import imported, refusal
from robots.mujoco_peer import compare_with_mujoco

mujoco = pytest.importorskip("mujoco")

FORM = """<mujoco model="arms">
<compiler angle="radian"/><option gravity="0.3 0 -9.81"><flag contact="disable"/></option>
<worldbody>
  <site name="ground" pos="0.3 0.1 0.2" euler="0.2 0.1 -0.3"/>
  <body name="a" pos="0 0 1"><joint name="p" axis="0 1 0" ref="0.1"/><joint name="q" axis="1 0 0"/>
    <inertial pos="0.15 0.02 0" mass="1.1" diaginertia="0.01 0.02 0.015"/>
    <body name="b" pos="0.3 0 0"><joint name="r" axis="0 0 1"/><joint name="s" type="slide" axis="1 0 0" ref="0.2"/>
      <inertial pos="0.2 0 0.1" mass="0.7" diaginertia="0.02 0.01 0.02"/>
      <site name="tip" pos="0.3 0.1 0"/></body></body>
  <body name="c" pos="0.5 0 0.4"><joint name="t" axis="0 1 0" pos="0.1 0 0"/><joint name="u" axis="1 0 0"/>
    <inertial pos="0 0.1 0.3" mass="0.9" diaginertia="0.02 0.02 0.01"/>
    <body name="d" pos="0 0 0.3">
      <joint name="v" axis="0 1 0"/><joint name="w" axis="0 0 1"/><joint name="x" axis="1 0 0"/>
      <inertial pos="0.1 0 0.1" mass="0.4" diaginertia="0.01 0.01 0.01"/>
      <site name="hook" pos="0 0.1 0.2"/></body></body>
</worldbody>
<tendon>
  <fixed name="long"><joint joint="p" coef="0.3"/><joint joint="s" coef="2"/></fixed>
  <fixed name="short"><joint joint="t" coef="1"/><joint joint="u" coef="-0.5"/></fixed>
</tendon>
<equality>
{}
</equality>
</mujoco>"""
NAMES = {"p": "p.q", "q": "q.q", "r": "r.q", "s": "s.s", "t": "t.q", "u": "u.q", "v": "v.q", "w": "w.q", "x": "x.q"}


class Peer:
    """MuJoCo's terms, with the rows of an equality made rigid."""

    def __init__(self, path: Path) -> None:
        self.m = mujoco.MjModel.from_xml_path(str(path))
        self.m.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_EQUALITY)
        self.d = mujoco.MjData(self.m)

    def at(self, q: np.ndarray, qd: np.ndarray) -> None:
        self.d.qpos[:], self.d.qvel[:] = q, qd
        mujoco.mj_forward(self.m, self.d)

    def gap(self, q: np.ndarray, kind: str) -> np.ndarray:
        """Differences that the equality makes zero, by MuJoCo's places."""
        self.at(q, np.zeros_like(q))
        d, p0 = self.d, self.m.qpos0
        match kind:
            case "connect":  # the anchor of both bodies, which coincide where the file shows them
                return (
                    d.xpos[2]
                    + d.xmat[2].reshape(3, 3) @ self.m.eq_data[0][:3]
                    - (d.xpos[4] + d.xmat[4].reshape(3, 3) @ self.m.eq_data[0][3:6])
                )
            case "connect sites":
                return d.site("tip").xpos - d.site("hook").xpos
            case "weld sites":
                one, two = d.site("tip"), d.site("hook")
                turn = one.xmat.reshape(3, 3).T @ two.xmat.reshape(3, 3)
                skew = [turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]
                return np.concatenate([one.xpos - two.xpos, skew])
            case "joint":
                y = q[5] - p0[5]
                return np.array([q[3] - p0[3] - (0.05 + 0.4 * y - 0.3 * y**2 + 0.1 * y**4)])
            case "lock":
                return np.array([q[3] - p0[3] - 0.05])
            case _:
                long, short = 0.3 * q[0] + 2 * q[3], q[4] - 0.5 * q[5]
                y = short - (p0[4] - 0.5 * p0[5])
                return np.array([long - (0.3 * p0[0] + 2 * p0[3]) - (0.7 * y + 0.2 * y**2)])

    def accelerations(self, q: np.ndarray, qd: np.ndarray, kind: str) -> np.ndarray:
        n, h = len(q), 1e-4

        def rows(at: np.ndarray) -> np.ndarray:  # differences of fourth order
            steps = [(8, h), (-8, -h), (-1, 2 * h), (1, -2 * h)]
            columns = [sum(k * self.gap(at + s * unit, kind) for k, s in steps) / (12 * h) for unit in np.eye(n)]
            return np.array(columns).T

        J = rows(q)
        gamma = (rows(q + h * qd) - rows(q - h * qd)) @ qd / (2 * h)
        self.at(q, qd)
        mass = np.zeros((n, n))
        mujoco.mj_fullM(self.m, self.d, mass)
        system = np.block([[mass, J.T], [J, np.zeros((len(J), len(J)))]])
        right = np.concatenate([self.d.qfrc_passive - self.d.qfrc_bias, -gamma])
        return np.linalg.lstsq(system, right, rcond=1e-9)[0][:n]


EQUALITIES = {
    "connect": '<connect name="hold" body1="b" body2="d" anchor="0.3 0.1 0"/>',
    "connect sites": '<connect name="hold" site1="tip" site2="hook"/>',
    "weld sites": '<weld name="hold" site1="tip" site2="hook"/>',
    "joint": '<joint name="hold" joint1="s" joint2="u" polycoef="0.05 0.4 -0.3 0 0.1"/>',
    "lock": '<joint name="hold" joint1="s" polycoef="0.05 9 9 0 0"/>',
    "tendon": '<tendon name="hold" tendon1="long" tendon2="short" polycoef="0 0.7 0.2 0 0"/>',
}


@pytest.mark.parametrize("kind", chosen(list(EQUALITIES), ["connect", "joint", "tendon"]))
def test_equalities_hold_exactly(tmp_path: Path, kind: str) -> None:
    """To 1e-10 along a motion; accelerations are MuJoCo's with rigid rows."""
    path = tmp_path / "arms.xml"
    path.write_text(FORM.format(EQUALITIES[kind]))
    text, told = imported(path)
    assert not told, told
    model = lagdsl.compile(text, engine="tape")
    motion = model.simulate(stop=0.2, tolerance=1e-10, start={"der(t.q)": 0.4})
    peer, names = Peer(path), [NAMES[each] for each in "pqrstuvwx"]
    own = [list(model.coordinates).index(name) for name in names if name in model.coordinates]
    for k in (0, len(motion["time"]) // 2, -1):
        q = np.array([motion[name][k] for name in names])
        assert np.abs(peer.gap(q, kind)).max() < 1e-10
        if kind.startswith("weld"):  # a hinge is cut instead of what is rigid; its rate is no column
            continue
        qd = np.array([motion[f"der({name})"][k] for name in names])
        whole = ([motion[form.format(name)][k] for name in model.coordinates] for form in ("{}", "der({})"))
        found = model.forward_dynamics(0.0, *map(np.array, whole))[own]
        expected = peer.accelerations(q, qd, kind)
        assert np.abs(found - expected).max() < 1e-6 * np.abs(expected).max()


def test_stiff_rows_of_mujoco_come_near(tmp_path: Path) -> None:
    """At rest, with the smallest softness that MuJoCo has, 1e-4."""
    path = tmp_path / "arms.xml"
    hard = EQUALITIES["connect"].replace("/>", ' solimp="0.9999 0.9999 1e-3 0.5 1"/>')
    path.write_text(FORM.format(hard))
    m = mujoco.MjModel.from_xml_path(str(path))
    d = mujoco.MjData(m)
    mujoco.mj_forward(m, d)
    model = lagdsl.compile(imported(path)[0], engine="tape")
    order = [list(model.coordinates).index(NAMES[each]) for each in "pqrstuvwx"]
    q = np.zeros(9)
    q[order] = d.qpos
    found = model.forward_dynamics(0.0, q, np.zeros(9))[order]
    assert np.abs(found - d.qacc).max() < 1e-3 * np.abs(d.qacc).max()


BODIES = """<mujoco model="free">
<compiler angle="radian"/><option gravity="0.2 0 -9.7"><flag contact="disable"/></option>
<worldbody>
  <body name="drone" pos="1 2 3" gravcomp="0.7"><joint name="flight" type="free" damping="0.3" armature="0.04"/>
    <inertial pos="0.1 0 0.05" mass="2" diaginertia="0.02 0.03 0.025"/>
    <body name="bob" pos="0.1 0 -0.1" gravcomp="1.2"><joint name="hip" type="ball" damping="0.2" armature="0.01"/>
      <inertial pos="0.1 0.02 -0.3" mass="1.4" diaginertia="0.02 0.03 0.015"/></body></body>
</worldbody></mujoco>"""


def test_dampers_and_armatures_in_space_and_weights_that_are_carried(tmp_path: Path) -> None:
    path = tmp_path / "free.xml"
    path.write_text(BODIES)
    worst = compare_with_mujoco(path, states=10)
    assert max(worst.values()) < 1e-12, worst


def test_equalities_that_are_off_are_told(tmp_path: Path) -> None:
    path = tmp_path / "arms.xml"
    for text in (
        FORM.format(EQUALITIES["connect"].replace("/>", ' active="false"/>')),
        FORM.format(EQUALITIES["connect"]).replace('contact="disable"', 'contact="disable" equality="disable"'),
    ):
        path.write_text(text)
        model, told = imported(path)
        assert [each.code for each in told] == ["N1019"] and "Spherical" not in model


def test_a_weld_without_torque_holds_a_point(tmp_path: Path) -> None:
    path = tmp_path / "arms.xml"
    path.write_text(FORM.format('<weld name="hold" body1="b" body2="d" torquescale="0"/>'))
    assert "Spherical hold(e(prefer = never));" in imported(path)[0]


CURVED = '<tendon name="hold" tendon1="cord" polycoef="0 1 0 0 0"/>'
CORD = '<tendon><spatial name="cord"><site site="tip"/><site site="hook"/></spatial></tendon><equality>'


@pytest.mark.parametrize(
    "text",
    [
        FORM.format(CURVED).replace("<equality>", CORD),
        FORM.format('<weld body1="m" body2="d"/>').replace("</worldbody>", '<body name="m" mocap="true"/></worldbody>'),
    ],
)
def test_what_has_no_counterpart_is_refused(tmp_path: Path, text: str) -> None:
    assert {each[0] for each in refusal(tmp_path / "arms.xml", text)} == {"E1016"}
    model, _ = imported(tmp_path / "arms.xml", lenient=True)
    assert [each.code for each in lagdsl.check(model) if each.severity == "error"] == []
