"""Forward dynamics of what is timed, by other formulations than anybody's who is timed, in extended precision."""

import numpy as np
from serial import Arm

# 80-bit numbers where the machine has them: eleven bits more than everybody else uses.
Extended = np.longdouble


def serial_arm(arm: Arm, states: np.ndarray) -> np.ndarray:
    """qdd (states, n) by the articulated-body algorithm in six-dimensional vectors (angular above linear) about the
    origins of the links: Featherstone, Rigid Body Dynamics Algorithms, 2008, table 7.1."""
    n, count = len(arm.links), len(states)
    q, qd = np.asarray(states[:, :n], Extended), np.asarray(states[:, n:], Extended)
    x, velocity, bias, inertia, force = [], [], [], [], []
    before = np.zeros((count, 6), Extended)
    for i, link in enumerate(arm.links):
        x.append(_motion_transform(link.rotation, link.place, q[:, i]))
        now = apply(x[i], before)
        now[:, 2] += qd[:, i]
        turn = np.zeros((count, 6), Extended)
        turn[:, 2] = qd[:, i]
        velocity.append(now)
        bias.append(_cross(now, turn))
        inertia.append(np.broadcast_to(_spatial_inertia(link.mass, link.center, link.inertia), (count, 6, 6)).copy())
        force.append(_cross_force(now, apply(inertia[i], now)))
        before = now
    ready: list[tuple[np.ndarray, np.ndarray, np.ndarray]] = []
    for i in reversed(range(n)):
        column, d, u = inertia[i][:, :, 2], inertia[i][:, 2, 2], -force[i][:, 2]
        ready.append((column, d, u))
        if i:
            rest = inertia[i] - column[:, :, None] * column[:, None, :] / d[:, None, None]
            load = force[i] + apply(rest, bias[i]) + column * (u / d)[:, None]
            back = np.swapaxes(x[i], 1, 2)
            inertia[i - 1] += back @ rest @ x[i]
            force[i - 1] += apply(back, load)
    qdd = np.empty((count, n), Extended)
    acceleration = np.zeros((count, 6), Extended)
    acceleration[:, 3:] = -np.asarray(arm.gravity, Extended)
    for i, (column, d, u) in enumerate(reversed(ready)):
        acceleration = apply(x[i], acceleration) + bias[i]
        qdd[:, i] = (u - np.sum(column * acceleration, axis=1)) / d
        acceleration[:, 2] += qdd[:, i]
    return qdd


def serial_arm_jacobian(arm: Arm, states: np.ndarray) -> np.ndarray:
    """d qdd/d(q, qd), (states, n * 2 n) row by row, by central differences of fourth order: good to about 1e-13."""
    count, width = states.shape
    h = Extended("1e-4")
    result = np.empty((count, width // 2, width), Extended)
    for i in range(width):
        step = np.zeros(width, Extended)
        step[i] = h
        f = [serial_arm(arm, np.asarray(states, Extended) + k * step) for k in (-2, -1, 1, 2)]
        result[:, :, i] = (f[0] - 8 * f[1] + 8 * f[2] - f[3]) / (12 * h)
    return result.reshape(count, -1)


def apply(matrix: np.ndarray, vector: np.ndarray) -> np.ndarray:
    return np.sum(matrix * vector[:, None, :], axis=2)


def _hat(v: np.ndarray) -> np.ndarray:
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]], Extended)


def _motion_transform(rotation: list[float], place: tuple[float, ...], angle: np.ndarray) -> np.ndarray:
    """From the axes of the link before to those of the link, (states, 6, 6)."""
    turn = np.zeros((len(angle), 3, 3), Extended)
    turn[:, 0, 0] = turn[:, 1, 1] = np.cos(angle)
    turn[:, 1, 0] = np.sin(angle)
    turn[:, 0, 1] = -turn[:, 1, 0]
    turn[:, 2, 2] = 1
    back = np.swapaxes(np.asarray(rotation, Extended).reshape(3, 3) @ turn, 1, 2)
    result = np.zeros((len(angle), 6, 6), Extended)
    result[:, :3, :3] = result[:, 3:, 3:] = back
    result[:, 3:, :3] = -back @ _hat(np.asarray(place, Extended))
    return result


def _spatial_inertia(mass: float, center: tuple[float, ...], inertia: tuple[float, ...]) -> np.ndarray:
    xx, yy, zz, xy, xz, yz = inertia
    c = _hat(np.asarray(center, Extended))
    result = np.zeros((6, 6), Extended)
    result[:3, :3] = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], Extended) + mass * c @ c.T
    result[:3, 3:] = mass * c
    result[3:, :3] = mass * c.T
    result[3:, 3:] = mass * np.eye(3, dtype=Extended)
    return result


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Of motions."""
    w, v = a[:, :3], a[:, 3:]
    return np.hstack([np.cross(w, b[:, :3]), np.cross(v, b[:, :3]) + np.cross(w, b[:, 3:])])


def _cross_force(a: np.ndarray, f: np.ndarray) -> np.ndarray:
    w, v = a[:, :3], a[:, 3:]
    return np.hstack([np.cross(w, f[:, :3]) + np.cross(v, f[:, 3:]), np.cross(w, f[:, 3:])])


def error(found: np.ndarray, reference: np.ndarray) -> np.ndarray:
    """Largest error of each state, of its largest acceleration."""
    size = np.max(np.abs(reference), axis=1)
    return np.asarray(np.max(np.abs(found - reference), axis=1) / size, dtype=float)
