"""MuJoCo at a state of an imported robot, in the coordinates of the import.

qd = T v and qdd = T a + bias map velocities of the peer. Contacts, limits, dry friction and equalities are off in both.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import lagdsl
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.mjcf.read import read_mjcf
from lagdsl.exchange.robots.plan import Plan, Style, coordinate_of, planned
from lagdsl.exchange.robots.reach import reach_of
from lagdsl.exchange.robots.xml_tree import read_xml
from lagdsl.foundation.diagnostics import Sink
from robots.peers import Compared, half_turn_rates, with_places

SEEN = 4  # bodies whose places are compared


class MuJoCo:
    """An MJCF file in MuJoCo, and states of both."""

    def __init__(self, path: Path, plan: Plan, model: lagdsl.Model) -> None:
        import mujoco

        self.mujoco: Any = mujoco
        self.m = mujoco.MjModel.from_xml_path(str(path))
        for flag in ("CONTACT", "LIMIT", "FRICTIONLOSS", "EQUALITY"):
            self.m.opt.disableflags |= int(getattr(mujoco.mjtDisableBit, f"mjDSBL_{flag}"))
        self.m.opt.density = self.m.opt.viscosity = 0.0
        self.d: Any = mujoco.MjData(self.m)
        self.plan, self.model = plan, model
        self.place = {name: index for index, name in enumerate(model.coordinates)}
        joints = {joint.name: joint for joint in plan.robot.joints}
        self.joints = [joints[self._joint(index)] for index in range(self.m.njnt)]

    def _joint(self, index: int) -> str:
        body = int(self.m.jnt_bodyid[index])
        number = index - int(self.m.body_jntadr[body])
        own = self.m.body(body).name or f"body_{body}"
        return str(self.m.joint(index).name) or f"{own}_joint{f'_{number + 1}' if number else ''}"

    def inputs(self) -> list[int]:
        """The place of the input of each actuator."""
        named = {actuator.name: name for name, actuator in self.plan.drives}
        named |= {each.servo.name: each.input for each in self.plan.servos}
        inputs = list(self.model.inputs)
        found = []
        for index in range(self.m.nu):
            own = str(self.m.actuator(index).name) or f"u_{self._joint(int(self.m.actuator_trnid[index][0]))}"
            found.append(inputs.index(named[own]))
        return found

    def at(self, random: np.random.Generator) -> None:
        """A random state, controls and activations."""
        d, m = self.d, self.m
        d.qpos[:] = random.uniform(-1, 1, size=m.nq)
        d.qvel[:] = random.normal(size=m.nv)
        ranges = np.where(m.actuator_ctrllimited[:, None], m.actuator_ctrlrange, [-1.0, 1.0])
        d.ctrl[:] = random.uniform(*ranges.T)
        d.act[:] = random.normal(size=m.na)
        self.q, self.bias = np.zeros((2, len(self.place)))
        self.T = np.zeros((len(self.place), m.nv))
        for index, joint in enumerate(self.joints):
            at, dof, own = int(m.jnt_qposadr[index]), int(m.jnt_dofadr[index]), self.plan.joints[joint.name]
            if joint.kind in ("revolute", "prismatic"):
                row = self.place[coordinate_of(self.plan, joint)]
                self.q[row], self.T[row, dof] = d.qpos[at], 1.0
                continue
            if joint.kind == "floating":
                rows = [self.place[f"{own}.r[{k}]"] for k in (1, 2, 3)]
                self.q[rows] = d.qpos[at : at + 3]
                self.T[rows, dof : dof + 3] = np.eye(3)
                at, dof = at + 3, dof + 3
            e = d.qpos[at : at + 4] / np.linalg.norm(d.qpos[at : at + 4])
            d.qpos[at : at + 4] = e
            w, rows = d.qvel[dof : dof + 3], [self.place[f"{own}.e[{k}]"] for k in (1, 2, 3, 4)]
            self.q[rows], self.T[rows, dof : dof + 3] = e, half_turn_rates(e)
            self.bias[rows] = half_turn_rates(half_turn_rates(e) @ w) @ w

    def mass(self) -> np.ndarray:
        mass = np.zeros((self.m.nv, self.m.nv))
        self.mujoco.mj_fullM(self.m, self.d, mass)
        return mass


def plan_of_mjcf(path: Path, lenient: bool, style: Style = Style()) -> Plan:  # noqa: B008 it is immutable
    sink = Sink()
    root = read_xml(path, sink)
    assert root is not None
    robot = read_mjcf(path, root, reach_of(path, None), Findings(sink, lenient))
    sink.raise_if_errors()
    assert robot is not None
    return planned(robot, style, Findings(Sink(), lenient))


def compare_with_mujoco(path: Path, states: int, lenient: bool = False) -> dict[str, float]:
    """Differences of mass matrix, efforts, gravity, accelerations, activations, places and Jacobians, of their size."""
    plan = plan_of_mjcf(path, lenient)
    robot = plan.robot
    carried = [joint.child for joint in robot.joints if joint.kind != "fixed"]
    seen = [name for name in carried if not name.endswith(tuple(f"after joint {k}" for k in range(9)))][-SEEN:]
    text = lagdsl.import_robot(path, lenient=lenient)
    model = lagdsl.compile(with_places(text, plan, seen), engine="tape")
    peer, random, compared = MuJoCo(path, plan, model), np.random.default_rng(1), Compared({})
    order, d, m = peer.inputs(), peer.d, peer.m
    for _ in range(states):
        peer.at(random)
        peer.mujoco.mj_forward(m, d)
        u = np.zeros(len(model.inputs))
        u[order] = d.ctrl
        z, T, q = np.array(d.act), peer.T, peer.q
        mass, acceleration, driven = peer.mass(), np.array(d.qacc), np.array(d.qfrc_actuator)
        compared.note("mass matrix", T.T @ model.mass_matrix(0.0, q) @ T, mass)
        qd = T @ d.qvel
        found = model.forward_dynamics(0.0, q, qd, z=z, u=u)
        own = np.linalg.lstsq(T, found - peer.bias, rcond=None)[0]
        size = float((np.abs(mass) @ np.abs(acceleration)).max())
        compared.note("forward dynamics", mass @ own, mass @ acceleration, size)
        a = random.normal(size=m.nv)
        d.qacc[:] = a
        peer.mujoco.mj_inverse(m, d)
        efforts = np.array(d.qfrc_inverse)
        qdd = T @ a + peer.bias
        inverse = T.T @ model.inverse_dynamics(0.0, q, qd, qdd, z=z, u=u) + driven
        compared.note("inverse dynamics", inverse, efforts, float(np.abs(driven).max(initial=0.0)))
        if m.na:  # equations of activations are linear in activations and controls
            by_state = model.state_jacobian(0.0, q, qd, z=z, u=u)[-m.na :, -m.na :]
            rates = by_state @ z + model.input_jacobian(0.0, q, qd, z=z, u=u)[-m.na :] @ u
            compared.note("activations", rates, np.array(d.act_dot))
        _places(compared, model, peer, seen, (z, u))
    return compared.worst


def _places(compared: Compared, model: lagdsl.Model, peer: MuJoCo, seen: list[str], others: tuple[Any, ...]) -> None:
    m, d = peer.m, peer.d
    z, u = others
    rows = model.output(0.0, np.tile(peer.q, (m.nv, 1)), peer.T.T.copy(), z=z, u=u)
    columns = rows[:, -15 * len(seen) :].reshape(-1, len(seen), 5, 3)
    jacobian = np.zeros((2, 3, m.nv))
    for index, name in enumerate(seen):
        body = int(m.body(name).id) if not name.startswith("body_") else int(name.removeprefix("body_"))
        peer.mujoco.mj_jacBody(m, d, jacobian[0], jacobian[1], body)
        position, _, _, x, y = columns[0, index]
        compared.note("position", position, d.xpos[body], 1.0)
        compared.note("axes", np.stack([x, y], axis=1), d.xmat[body].reshape(3, 3)[:, :2])
        compared.note("Jacobian", columns[:, index, 1:3].reshape(-1, 6).T, jacobian.reshape(6, -1))
