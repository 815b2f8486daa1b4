"""Rigid bodies with six coordinates each, Newton's and Euler's equations, joints as constraints on accelerations.

Nothing is shared with Lagrange's equations: no generalized coordinates, no energies (Haug, Computer Aided Kinematics
and Dynamics of Mechanical Systems, chapters 9 and 11). Without stabilization, which tight tolerances and short motions
do not need.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from models.references.integrate import Floats, solve

GROUND = -1


@dataclass(frozen=True)
class Body:
    """Mass, principal or full inertia about the mass center in body axes, and the state at the start."""

    mass: float
    inertia: Floats
    position: Floats
    attitude: Floats
    velocity: Floats
    spin: Floats


@dataclass(frozen=True)
class Point:
    """Coordinates `at` in the axes of a body, from its mass center."""

    body: int
    at: Floats


@dataclass(frozen=True)
class State:
    """Position, rotation matrix, velocity and angular velocity of every body, in world axes."""

    r: Floats
    R: Floats
    v: Floats
    w: Floats

    def place(self, p: Point) -> Floats:
        return p.at if p.body == GROUND else np.asarray(self.r[p.body] + self.R[p.body] @ p.at)

    def velocity(self, p: Point) -> Floats:
        if p.body == GROUND:
            return np.zeros(3)
        return np.asarray(self.v[p.body] + cross(self.w[p.body], self.R[p.body] @ p.at))

    def axis(self, p: Point) -> Floats:
        """The vector `at` of a body, in world axes."""
        return p.at if p.body == GROUND else np.asarray(self.R[p.body] @ p.at)

    def turning(self, body: int) -> Floats:
        return np.zeros(3) if body == GROUND else np.asarray(self.w[body])


Rows = tuple[Floats, Floats]
Joint = Callable[[State], Rows]
Load = tuple[Point, Floats, Floats]
"""Force and moment on the body of the point."""
Loads = Callable[[float, State, Floats], Sequence[Load]]


def skew(a: Floats) -> Floats:
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def cross(a: Floats, b: Floats) -> Floats:
    """Many times as fast as NumPy's for single vectors."""
    (p, q, r), (x, y, z) = a.tolist(), b.tolist()
    return np.array([q * z - r * y, r * x - p * z, p * y - q * x])


def _rows(state: State, count: int) -> Floats:
    return np.zeros((count, 6 * len(state.r)))


def spherical(p: Point, q: Point) -> Joint:
    """The two points coincide."""

    def rows(state: State) -> Rows:
        jacobian, gamma = _rows(state, 3), np.zeros(3)
        for point, sign in ((p, 1.0), (q, -1.0)):
            if point.body != GROUND:
                arm, w = state.R[point.body] @ point.at, state.w[point.body]
                jacobian[:, 6 * point.body : 6 * point.body + 3] = sign * np.eye(3)
                jacobian[:, 6 * point.body + 3 : 6 * point.body + 6] = -sign * skew(arm)
                gamma -= sign * cross(w, cross(w, arm))
        return jacobian, gamma

    return rows


def perpendicular(a: Point, b: Point) -> Joint:
    """Two vectors, each fixed in its body, stay perpendicular."""

    def rows(state: State) -> Rows:
        jacobian = _rows(state, 1)
        x, y, wx, wy = state.axis(a), state.axis(b), state.turning(a.body), state.turning(b.body)
        normal = cross(x, y)
        for body, sign in ((a.body, 1.0), (b.body, -1.0)):
            if body != GROUND:
                jacobian[0, 6 * body + 3 : 6 * body + 6] = sign * normal
        bend = cross(cross(wx, x), y) + cross(x, cross(wy, y))
        return jacobian, np.array([-bend @ (wx - wy)])

    return rows


def distance(p: Point, q: Point) -> Joint:
    """The distance between two points stays what it is."""

    def rows(state: State) -> Rows:
        ends, gamma = spherical(p, q)(state)
        s = state.place(p) - state.place(q)
        rate = state.velocity(p) - state.velocity(q)
        return s[None, :] @ ends, np.array([s @ gamma - rate @ rate])

    return rows


def revolute(p: Point, q: Point, axis: Point, across: tuple[Point, Point]) -> list[Joint]:
    """A pin: the points coincide; `axis` of one body is perpendicular to two vectors `across` of the other."""
    return [spherical(p, q), *(perpendicular(axis, other) for other in across)]


def motion(
    bodies: Sequence[Body],
    joints: Sequence[Joint],
    loads: Loads,
    t: Floats,
    extra: tuple[Sequence[float], Callable[[float, State, Floats], Floats]] = ((), lambda *_: np.zeros(0)),
    tolerance: float = 1e-11,
) -> tuple[list[State], Floats, list[Floats]]:
    """States at the times `t`, the extra first-order states, and the multipliers of all rows at these times.

    A multiplier of a `spherical` row is the force on the body of its first point.
    """
    n = len(bodies)
    start = np.concatenate([
        *(b.position for b in bodies), *(_quaternion(b.attitude) for b in bodies),
        *(b.velocity for b in bodies), *(b.spin for b in bodies), extra[0],
    ])  # fmt: skip

    def rates(time: float, x: Floats) -> Floats:
        state, z = _state(n, x)
        accelerations, _ = _solve(bodies, joints, loads(time, state, z), state)
        turns = [_quaternion_rate(e, w) for e, w in zip(x[3 * n : 7 * n].reshape(n, 4), state.w, strict=True)]
        pairs = accelerations.reshape(n, 6)
        return np.concatenate(
            [state.v.ravel(), *turns, pairs[:, :3].ravel(), pairs[:, 3:].ravel(), extra[1](time, state, z)]
        )

    x = solve(rates, list(start), t, tolerance=tolerance)
    states = [_state(n, column) for column in x.T]
    forces = [
        _solve(bodies, joints, loads(time, state, z), state)[1] for time, (state, z) in zip(t, states, strict=True)
    ]
    return [state for state, _ in states], x[13 * n :], forces


def _solve(
    bodies: Sequence[Body], joints: Sequence[Joint], loads: Sequence[Load], state: State
) -> tuple[Floats, Floats]:
    n = len(bodies)
    mass, force = np.zeros((6 * n, 6 * n)), np.zeros(6 * n)
    for i, body in enumerate(bodies):
        inertia = state.R[i] @ body.inertia @ state.R[i].T
        at = 6 * i
        mass[at : at + 3, at : at + 3] = body.mass * np.eye(3)
        mass[at + 3 : at + 6, at + 3 : at + 6] = inertia
        force[at + 3 : at + 6] = -cross(state.w[i], inertia @ state.w[i])
    for point, push, moment in loads:
        if point.body != GROUND:
            at = 6 * point.body
            force[at : at + 3] += push
            force[at + 3 : at + 6] += moment + cross(state.R[point.body] @ point.at, push)
    rows = [joint(state) for joint in joints]
    jacobian = np.concatenate([_rows(state, 0), *(j for j, _ in rows)])
    gamma = np.concatenate([np.zeros(0), *(g for _, g in rows)])
    k = len(gamma)
    matrix = np.block([[mass, -jacobian.T], [jacobian, np.zeros((k, k))]])
    solution = np.linalg.solve(matrix, np.concatenate([force, gamma]))
    return solution[: 6 * n], solution[6 * n :]


def _state(n: int, x: Floats) -> tuple[State, Floats]:
    r, e, v, w = np.split(x[: 13 * n], [3 * n, 7 * n, 10 * n])
    attitudes = np.array([_matrix(each) for each in e.reshape(n, 4)])
    return State(r.reshape(n, 3), attitudes, v.reshape(n, 3), w.reshape(n, 3)), x[13 * n :]


def _matrix(e: Floats) -> Floats:
    s, u = e[0], e[1:]
    return np.asarray((s * s - u @ u) * np.eye(3) + 2 * np.outer(u, u) + 2 * s * skew(u)) / (e @ e)


def _quaternion(R: Floats) -> Floats:
    """Of a rotation matrix; by its largest component (Shepperd)."""
    squares = np.array([1 + np.trace(R), *(1 + 2 * R[i, i] - np.trace(R) for i in range(3))])
    k = int(np.argmax(squares))
    if k == 0:
        e = np.array([squares[0], R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    else:
        i, j, m = k - 1, k % 3, (k + 1) % 3
        e = np.zeros(4)
        e[0], e[1 + i], e[1 + j], e[1 + m] = R[m, j] - R[j, m], squares[k], R[j, i] + R[i, j], R[m, i] + R[i, m]
    return np.asarray(e / np.linalg.norm(e))


def _quaternion_rate(e: Floats, w: Floats) -> Floats:
    """Of the world's angular velocity."""
    return np.asarray(0.5 * np.concatenate([[-w @ e[1:]], e[0] * w + cross(w, e[1:])]))


def turned(axis: str, angle: float) -> Floats:
    """Rotation matrix about a coordinate axis."""
    c, s = np.cos(angle), np.sin(angle)
    match axis:
        case "x":
            return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
        case "y":
            return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
        case _:
            return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
