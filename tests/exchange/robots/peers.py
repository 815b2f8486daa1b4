"""Pinocchio and MuJoCo at a state of an imported robot, in the coordinates of the import.

qd = T v and qdd = T a + bias map velocities of the peer; v are those of the joints that imitate no other.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import lagdsl
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.plan import Plan, Style, coordinate_of, frame_of, planned
from lagdsl.exchange.robots.reach import reach_of
from lagdsl.exchange.robots.urdf.read import read_urdf
from lagdsl.exchange.robots.xml_tree import read_xml
from lagdsl.foundation.diagnostics import Sink

G = 9.80665
SEEN = 3  # links at the ends of the robot whose places are compared


@dataclass
class Compared:
    """Largest differences by what is compared, of the size."""

    worst: dict[str, float]

    def note(self, what: str, found: np.ndarray, expected: np.ndarray, size: float = 0.0) -> None:
        size = max(size, float(np.abs(expected).max(initial=0.0)), 1e-300)
        error = float(np.abs(found - expected).max(initial=0.0)) / size
        self.worst[what] = max(self.worst.get(what, 0.0), error)


def half_turn_rates(e: np.ndarray) -> np.ndarray:
    """de/dt = E(e) w, w in the axes of the body; scalar first."""
    w, x, y, z = e
    return 0.5 * np.array([[-x, -y, -z], [w, -z, y], [z, w, -x], [-y, x, w]])


def plan_of(path: Path, lenient: bool, *, floating: bool = False) -> Plan:
    sink = Sink()
    root = read_xml(path, sink)
    assert root is not None
    robot = read_urdf(path, root, reach_of(path, None), Findings(sink, lenient))
    sink.raise_if_errors()
    assert robot is not None
    return planned(robot, Style(actuators="none", floating=floating), Findings(Sink(), lenient))


def with_places(text: str, plan: Plan, names: list[str]) -> str:
    """The text with position, velocity, angular velocity and two axes of some links as outputs."""
    links = {link.name: link for link in plan.robot.links}
    lines = []
    for index, name in enumerate(names):
        frame = frame_of(plan, links[name])
        lines.append(f"output Length p{index}[3] = {frame}.origin; output Velocity v{index}[3] = der({frame}.origin);")
        lines.append(f"output AngularVelocity w{index}[3] = omega({frame});")
        lines.append(f"output Real x{index}[3] = {frame}.x, y{index}[3] = {frame}.y;")
    end = f"\nend {plan.model};"
    return text.replace(end, "\n" + "\n".join(lines) + end)


class Pinocchio:
    """A URDF file in Pinocchio. Where Pinocchio refuses the order of joints that imitate, S ties them instead."""

    def __init__(self, path: Path, plan: Plan, model: lagdsl.Model) -> None:
        import pinocchio

        self.pin: Any = pinocchio
        self.plan = plan
        self.joints = {joint.name: joint for joint in plan.robot.joints}
        self.place = {name: index for index, name in enumerate(model.coordinates)}
        rigid = {name for name, joint in self.joints.items() if joint.kind == "fixed"}
        full = pinocchio.buildModelFromUrdf(str(path))
        locked = [index for index in range(1, full.njoints) if full.names[index] in rigid]
        self.m = pinocchio.buildReducedModel(full, locked, pinocchio.neutral(full)) if locked else full
        self.m.gravity.linear = np.array([0.0, 0.0, -G])
        self.d = self.m.createData()

    def at(self, random: np.random.Generator) -> None:
        """A random state: `q` of the peer, `Q`, `T`, `bias` of the import, `S` from free velocities to all."""
        m = self.m
        self.q = self.pin.neutral(m)
        self.Q, self.bias = np.zeros((2, len(self.place)))
        T, self.S, self.v = np.zeros((len(self.place), m.nv)), np.eye(m.nv), random.normal(size=m.nv)
        values: dict[str, tuple[float, dict[int, float]]] = {}
        rows = sorted(range(1, m.njoints), key=lambda index: self.joints[m.names[index]].mimic is not None)
        for index in rows:
            joint, iq, iv = self.joints[m.names[index]], m.joints[index].idx_q, m.joints[index].idx_v
            if joint.kind == "floating":
                self._floating(joint.name, iq, iv, T, random)
                continue
            if joint.mimic is None:
                values[joint.name] = random.uniform(-1, 1) * (3 if joint.kind == "revolute" else 0.3), {iv: 1.0}
            value, rates = self._value(joint.name, values)
            self.q[iq : iq + m.joints[index].nq] = [np.cos(value), np.sin(value)][: m.joints[index].nq]
            if m.joints[index].nq == 1:
                self.q[iq] = value
            row = self.place[coordinate_of(self.plan, joint)]
            self.Q[row] = value
            if joint.mimic is not None:
                self.S[iv] = 0.0
            for at, rate in rates.items():
                T[row, at], self.S[iv, at] = rate, rate
        followers = [m.joints[i].idx_v for i in rows if self.joints[m.names[i]].mimic is not None]
        free = [at for at in range(m.nv) if at not in followers]
        self.T, self.S, self.v = T[:, free], self.S[:, free], self.v[free]

    def _value(self, name: str, values: dict[str, Any]) -> tuple[float, dict[int, float]]:
        mimic = self.joints[name].mimic
        if mimic is None:
            return values[name]
        value, rates = self._value(mimic.joint, values)
        return mimic.multiplier * value + mimic.offset, {at: mimic.multiplier * rate for at, rate in rates.items()}

    def _floating(self, name: str, iq: int, iv: int, T: np.ndarray, random: np.random.Generator) -> None:
        """Pinocchio has velocities in the axes of the body and quaternions with the scalar last."""
        e, r = random.normal(size=4), random.normal(size=3)
        e /= np.linalg.norm(e)
        self.q[iq : iq + 7] = [*r, *e[1:], e[0]]
        rotation = self.pin.Quaternion(e[0], e[1], e[2], e[3]).toRotationMatrix()
        own, w = self.plan.joints[name], self.v[iv + 3 : iv + 6]
        at_r = [self.place[f"{own}.r[{k}]"] for k in (1, 2, 3)]
        at_e = [self.place[f"{own}.e[{k}]"] for k in (1, 2, 3, 4)]
        self.Q[at_r], self.Q[at_e] = r, e
        T[at_r, iv : iv + 3], T[at_e, iv + 3 : iv + 6] = rotation, half_turn_rates(e)
        self.bias[at_r] = rotation @ np.cross(w, self.v[iv : iv + 3])
        self.bias[at_e] = half_turn_rates(half_turn_rates(e) @ w) @ w


def passive(plan: Plan, place: dict[str, int], QD: np.ndarray) -> np.ndarray:
    """Dampers, which Pinocchio leaves out; friction has no force as long as no direction is given."""
    found = np.zeros(len(QD))
    for joint in plan.robot.joints:
        if joint.kind in ("revolute", "prismatic"):
            at = place[coordinate_of(plan, joint)]
            found[at] = joint.passive.damping * QD[at]
    return found


def compare_with_pinocchio(path: Path, lenient: bool, states: int) -> dict[str, float]:
    """Differences of mass matrix, efforts, gravity, accelerations, places and Jacobians, of their size.

    Accelerations count by what they leave of the equations, of the size of the terms: some robots of the world have
    mass matrices whose condition is 1e9.
    """
    plan = plan_of(path, lenient)
    parents = {joint.parent for joint in plan.robot.joints}
    seen = [link.name for link in plan.robot.links if link.name not in parents][:SEEN]
    text = lagdsl.import_robot(path, lenient=lenient, actuators="none")
    model = lagdsl.compile(with_places(text, plan, seen), engine="tape")
    peer, random, compared = Pinocchio(path, plan, model), np.random.default_rng(1), Compared({})
    for _ in range(states):
        peer.at(random)
        pin, m, d, q, S, T, Q = peer.pin, peer.m, peer.d, peer.q, peer.S, peer.T, peer.Q
        a = random.normal(size=T.shape[1])
        QD, QDD = T @ peer.v, T @ a + peer.bias
        losses = T.T @ passive(plan, peer.place, QD)
        mass = pin.crba(m, d, q)
        mass = S.T @ (np.triu(mass) + np.triu(mass, 1).T) @ S
        compared.note("mass matrix", T.T @ model.mass_matrix(0.0, Q) @ T, mass)
        rates = ((peer.v, a), (peer.v, 0 * a), (0 * a, 0 * a))
        efforts, bias, gravity = (S.T @ pin.rnea(m, d, q, S @ v, S @ acc) for v, acc in rates)
        compared.note("inverse dynamics", T.T @ model.inverse_dynamics(0.0, Q, QD, QDD) - losses, efforts)
        still = model.inverse_dynamics(0.0, Q, 0 * QD, 0 * QD)
        compared.note("gravity", T.T @ still, gravity, 1e-3 * float(np.abs(efforts).max()))
        own = np.linalg.lstsq(T, model.forward_dynamics(0.0, Q, QD) - peer.bias, rcond=None)[0]
        size = max(float((np.abs(mass) @ np.abs(own)).max()), float(np.abs(bias + losses).max()))
        compared.note("forward dynamics", mass @ own, -bias - losses, size)
        _places(compared, model, peer, seen)
    return compared.worst


def _places(compared: Compared, model: lagdsl.Model, peer: Pinocchio, seen: list[str]) -> None:
    pin, m, d = peer.pin, peer.m, peer.d
    pin.computeJointJacobians(m, d, peer.q)
    pin.updateFramePlacements(m, d)
    columns = model.output(0.0, np.tile(peer.Q, (peer.T.shape[1], 1)), peer.T.T.copy()).reshape(-1, len(seen), 5, 3)
    for index, name in enumerate(seen):
        frame = m.getFrameId(name, pin.FrameType.BODY)
        position, _, _, x, y = columns[0, index]
        compared.note("position", position, d.oMf[frame].translation, 1.0)
        compared.note("axes", np.stack([x, y], axis=1), d.oMf[frame].rotation[:, :2])
        jacobian = pin.getFrameJacobian(m, d, frame, pin.LOCAL_WORLD_ALIGNED).reshape(6, -1) @ peer.S
        compared.note("Jacobian", columns[:, index, 1:3].reshape(-1, 6).T, jacobian)
