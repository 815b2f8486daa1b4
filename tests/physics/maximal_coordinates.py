"""Mechanisms of rigid bodies by Newton's and Euler's equations: six accelerations of every body, the second rates and
the wrench of every joint are the unknowns of one linear system.

Independent of Lagrange's equations; nothing of lagdsl is used. Source: E. J. Haug, Computer Aided Kinematics and
Dynamics of Mechanical Systems (1989), chapters 9 and 11.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

WORLD, BASE = -1, -2
ZERO = np.zeros(3)
X, Y, Z = np.eye(3)
SIZES = {"e": 4, "r": 3, "angles": 3}


def skew(a):
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def turn(axis, angle):
    """Rotation matrix (Rodrigues)."""
    K = skew(np.asarray(axis, dtype=float) / np.linalg.norm(axis))
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


def turns(angles):
    """About x, the turned y and the turned z."""
    return turn(X, angles[0]) @ turn(Y, angles[1]) @ turn(Z, angles[2])


def turned(e):
    """Rotation matrix of a unit quaternion, scalar first."""
    w, v = e[0], np.asarray(e[1:])
    return (w * w - v @ v) * np.eye(3) + 2 * np.outer(v, v) + 2 * w * skew(v)


def spin_of(e, rate):
    """Angular velocity in axes of the base; with the second rate in place of the rate, the angular acceleration."""
    v = np.asarray(e[1:])
    return 2 * np.c_[-v, e[0] * np.eye(3) + skew(v)] @ rate


def across(n):
    """The library's directions across an axis (Duff et al.)."""
    side = -1.0 if n[2] < 0 else 1.0
    h = 1 / (side + n[2])
    u = np.array([1 - side * h * n[0] ** 2, -side * h * n[0] * n[1], -side * n[0]])
    return u, np.array([-h * n[0] * n[1], side - h * n[1] ** 2, -n[1]])


@dataclass(frozen=True)
class Relative:
    """Motion of frame_b as seen from frame_a: place, attitude, velocity, spin; columns of the rates that are free (or
    of quasi-rates, the spin, where the coordinates are a quaternion), and what is left of the accelerations."""

    p: np.ndarray = field(default_factory=ZERO.copy)
    R: np.ndarray = field(default_factory=lambda: np.eye(3))
    v: np.ndarray = field(default_factory=ZERO.copy)
    w: np.ndarray = field(default_factory=ZERO.copy)
    slides: np.ndarray = field(default_factory=lambda: np.zeros((3, 0)))
    turns: np.ndarray = field(default_factory=lambda: np.zeros((3, 0)))
    rest_v: np.ndarray = field(default_factory=ZERO.copy)
    rest_w: np.ndarray = field(default_factory=ZERO.copy)


def axis_joint(n, lead, q, qd):
    """Joints with one axis; their coordinates in the order s, x, y, q."""
    u, v = across(n)
    h = lead / (2 * np.pi)
    slides = {"s": n, "x": u, "y": v, "q": h * n}
    p = sum((slides[c] * q[c] for c in q), ZERO)
    velocity = sum((slides[c] * qd[c] for c in q), ZERO)
    S = np.column_stack([slides[c] for c in q])
    T = np.column_stack([n if c == "q" else ZERO for c in q])
    return Relative(p, turn(n, q.get("q", 0.0)), velocity, n * qd.get("q", 0.0), S, T)


def relative(joint, q, qd, t):
    n = None if joint.axis is None else joint.axis / np.linalg.norm(joint.axis)
    match joint.kind:
        case "Weld":
            return Relative()
        case "RevoluteDrive" | "PrismaticDrive":
            size, pace, phase = joint.drive
            x = size * np.sin(pace * t + phase)
            xd, xdd = size * pace * np.cos(pace * t + phase), -(pace**2) * x
            if joint.kind == "RevoluteDrive":
                return Relative(R=turn(n, x), w=n * xd, rest_w=n * xdd)
            return Relative(p=n * x, v=n * xd, rest_v=n * xdd)
        case "Universal":
            A = turn(X, q["a"])
            y = A @ Y
            S = np.column_stack([X, y])
            rest = np.cross(X * qd["a"], y) * qd["b"]
            w = X * qd["a"] + y * qd["b"]
            return Relative(R=A @ turn(Y, q["b"]), w=w, slides=np.zeros((3, 2)), turns=S, rest_w=rest)
        case "Spherical":
            w = spin_of(q["e"], qd["e"])
            return Relative(R=turned(q["e"]), w=w, slides=np.zeros((3, 3)), turns=np.eye(3))
        case "FreeQuaternion":
            S, T = np.eye(6)[:3], np.eye(6)[3:]
            return Relative(q["r"], turned(q["e"]), qd["r"], spin_of(q["e"], qd["e"]), S, T)
        case "FreeMotion" if "angles" in q:
            (a, b, _), rates = q["angles"], qd["angles"]
            y, z = turn(X, a) @ Y, turn(X, a) @ turn(Y, b) @ Z
            T = np.column_stack([X, y, z])
            first = X * rates[0]
            rest = np.cross(first, y) * rates[1] + np.cross(first + y * rates[1], z) * rates[2]
            S, wide = np.eye(6)[:3], np.hstack([np.zeros((3, 3)), T])
            return Relative(q["r"], turns(q["angles"]), qd["r"], T @ rates, S, wide, ZERO, rest)
        case "FreeMotion":
            return axis_joint(Z, 0.0, q, qd)
    return axis_joint(n, joint.lead, q, qd)


@dataclass
class Joint:
    """Between hubs `a` and `b`; `at_a` and `at_b` place its frames on them: origin and axes. `start` has a value for
    each coordinate, `loads` of some: (constant, stiffness, rest, damping)."""

    name: str
    kind: str
    a: int
    b: int
    at_a: tuple
    at_b: tuple
    axis: np.ndarray | None = None
    lead: float = 0.0
    drive: tuple = ()
    start: dict = field(default_factory=dict)
    loads: dict = field(default_factory=dict)

    @property
    def freedom(self):
        return sum(3 if c == "e" else SIZES.get(c, 1) for c in self.start)

    def load(self, q, qd):
        """Generalized forces (freedom,)."""
        parts = []
        for c in self.start:
            constant, stiffness, rest, damping = self.loads.get(c, (0.0, 0.0, 0.0, 0.0))
            parts.extend([0.0] * 3 if c in SIZES else [constant - stiffness * (q[c] - rest) - damping * qd[c]])
        return np.array(parts)

    def second_rates(self, q, qdd):
        parts = [spin_of(q["e"], qdd["e"]) if c == "e" else np.atleast_1d(qdd[c]) for c in self.start]
        return np.concatenate(parts) if parts else np.zeros(0)


@dataclass
class Mechanism:
    """Bodies (mass, mass center, inertia) on hubs 0, 1, ...; springs (hub, point, hub, point, stiffness, rest,
    damping); loads (hub, point, force in world axes, torque in axes of the hub); `base`: how hub BASE moves."""

    bodies: list
    joints: list
    base: tuple = ()
    springs: list = field(default_factory=list)
    loads: list = field(default_factory=list)
    gravity: np.ndarray = field(default_factory=lambda: np.array([0, -9.80665, 0]))


def base_motion(base, t):
    """Place, axes, velocity, spin and their rates."""
    way, pace, axis, angle = base
    n = axis / np.linalg.norm(axis)
    s, c = np.sin(pace * t), np.cos(pace * t)
    moved = way * s, turn(n, angle * s), way * pace * c, n * angle * pace * c
    return *moved, -way * pace**2 * s, -n * angle * pace**2 * s


def _onward(hub, at, rel):
    """Hub b of a joint from its hub a: at = (at_a, at_b)."""
    (r, R, v, w), ((da, Da), (db, Db)) = hub, at
    A = R @ Da
    d = R @ da + A @ rel.p
    spin = w + A @ rel.w
    B = A @ rel.R @ Db.T
    velocity = v + np.cross(w, d) + A @ rel.v
    return r + d - B @ db, B, velocity - np.cross(spin, B @ db), spin


def _backward(hub, at, rel):
    """Hub a of a joint from its hub b."""
    (r, R, v, w), ((da, Da), (db, Db)) = hub, at
    A = R @ Db @ rel.R.T
    spin = w - A @ rel.w
    H = A @ Da.T
    p = A @ rel.p
    origin = r + R @ db - p
    velocity = v + np.cross(w, R @ db) - np.cross(spin, p) - A @ rel.v
    return origin - H @ da, H, velocity - np.cross(spin, H @ da), spin


def hubs(mechanism, q, qd, t):
    """Place, axes, velocity and spin of every hub from the coordinates of the joints, and by how much the joints that
    close loops miss."""
    found = {WORLD: (ZERO, np.eye(3), ZERO, ZERO)}
    if mechanism.base:
        found[BASE] = base_motion(mechanism.base, t)[:4]
    left, misfit = list(mechanism.joints), 0.0
    while left:
        joint = next(j for j in left if j.a in found or j.b in found)
        left.remove(joint)
        rel, at = relative(joint, q[joint.name], qd[joint.name], t), (joint.at_a, joint.at_b)
        forward = joint.a in found
        new = _onward(found[joint.a], at, rel) if forward else _backward(found[joint.b], at, rel)
        there = joint.b if forward else joint.a
        if there in found:
            misfit = max(misfit, *(np.abs(x - y).max() for x, y in zip(found[there], new, strict=True)))
        found[there] = new
    return found, misfit


def _applied(mechanism, found, centers, b):
    """Forces and torques into the right-hand side."""

    def put(k, at, force, torque=ZERO):
        if k >= 0:
            b[6 * k : 6 * k + 3] += force
            b[6 * k + 3 : 6 * k + 6] += torque + np.cross(at - centers[k], force)

    def point(k, at):
        r, R, v, w = found[k]
        return r + R @ at, v + np.cross(w, R @ at)

    for ka, pa, kb, pb, stiffness, rest, damping in mechanism.springs:
        (P, vP), (Q, vQ) = point(ka, pa), point(kb, pb)
        length = np.linalg.norm(Q - P)
        e = (Q - P) / length
        force = (stiffness * (length - rest) + damping * (vQ - vP) @ e) * e
        put(ka, P, force)
        put(kb, Q, -force)
    for k, at, force, torque in mechanism.loads:
        put(k, point(k, at)[0], force, found[k][1] @ torque)


def equations(mechanism, found, q, qd, t):
    """A x = b for x = accelerations and angular accelerations of the bodies, second rates of the joints, wrenches of
    the joints about frame_b; also where rates and wrenches begin in x."""
    n, joints = len(mechanism.bodies), mechanism.joints
    rates = 6 * n + np.cumsum([0, *(j.freedom for j in joints)])
    first = rates[-1]
    size = first + 6 * len(joints)
    A, b, centers = np.zeros((size, size)), np.zeros(size), {}
    for k, (m, com, inertia) in enumerate(mechanism.bodies):
        r, R, _, w = found[k]
        I = R @ inertia @ R.T
        centers[k] = r + R @ com
        A[6 * k : 6 * k + 3, 6 * k : 6 * k + 3], A[6 * k + 3 : 6 * k + 6, 6 * k + 3 : 6 * k + 6] = m * np.eye(3), I
        b[6 * k : 6 * k + 3], b[6 * k + 3 : 6 * k + 6] = m * mechanism.gravity, -np.cross(w, I @ w)
    _applied(mechanism, found, centers, b)
    row = 6 * n
    for i, joint in enumerate(joints):
        rel = relative(joint, q[joint.name], qd[joint.name], t)
        (ra, Ra, _, wa), (rb, Rb, _, _) = found[joint.a], found[joint.b]
        axes, there = Ra @ joint.at_a[1], rb + Rb @ joint.at_b[0]
        here, d = ra + Ra @ joint.at_a[0], axes @ rel.p
        wrench, free = slice(first + 6 * i, first + 6 * i + 6), slice(rates[i], rates[i + 1])
        forces, moments = row, row + 3
        b[forces:moments] = axes @ rel.rest_v + np.cross(wa, np.cross(wa, d)) + 2 * np.cross(wa, axes @ rel.v)
        b[moments : row + 6] = axes @ rel.rest_w + np.cross(wa, axes @ rel.w)
        A[forces:moments, free], A[moments : row + 6, free] = -axes @ rel.slides, -axes @ rel.turns
        for k, sign in ((joint.a, -1), (joint.b, 1)):
            r, _, _, w = found[k]
            at = there if sign == 1 else here
            if k >= 0:
                body = slice(6 * k, 6 * k + 6)
                lever = skew(there - centers[k])
                A[body, wrench] -= sign * np.block([[np.eye(3), np.zeros((3, 3))], [lever, np.eye(3)]])
                A[forces : row + 6, body] += sign * np.block([[np.eye(3), -lever], [np.zeros((3, 3)), np.eye(3)]])
                b[forces:moments] -= sign * np.cross(w, np.cross(w, at - centers[k]))
            elif k == BASE:
                a, alpha = base_motion(mechanism.base, t)[4:]
                b[forces:moments] -= sign * (a + np.cross(alpha, there - r) + np.cross(w, np.cross(w, at - r)))
                b[moments : row + 6] -= sign * alpha
        row += 6
        A[row : row + joint.freedom, wrench] = np.vstack([axes @ rel.slides, axes @ rel.turns]).T
        b[row : row + joint.freedom] = joint.load(q[joint.name], qd[joint.name])
        row += joint.freedom
    return A, b, rates, first
