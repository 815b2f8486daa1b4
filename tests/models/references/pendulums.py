"""Pendulums and tops."""

from collections.abc import Mapping

import numpy as np
from scipy.special import ellipj, ellipk

from models.references.integrate import G_N, Floats, solve

Parameters = Mapping[str, float]


def _released(amplitude: float, frequency: float, t: Floats) -> Floats:
    """Angle of a pendulum released at rest: sin(theta/2) = k cd(frequency t | k^2) (Whittaker)."""
    m = np.sin(amplitude / 2) ** 2
    _, cn, dn, _ = ellipj(frequency * t, m)
    return np.asarray(2 * np.arcsin(np.sqrt(m) * cn / dn))


def pendulum(p: Parameters, t: Floats) -> dict[str, Floats]:
    return {"theta": _released(np.radians(60), np.sqrt(9.81 / p["l"]), t)}


def pendulum_period(p: Parameters) -> float:
    """4 sqrt(l/g) K(sin(theta0/2))."""
    return float(4 * np.sqrt(p["l"] / 9.81) * ellipk(np.sin(np.radians(30)) ** 2))


def pendulum_two_dependent_constraints(p: Parameters, t: Floats) -> dict[str, Floats]:
    theta = _released(np.radians(60), np.sqrt(G_N / p["l"]), t)
    return {"x": p["l"] * np.sin(theta), "y": -p["l"] * np.cos(theta)}


def pendulum_by_energies(p: Parameters, t: Floats) -> dict[str, Floats]:
    m, l = p["m"], p["l"]
    x = solve(lambda _, x: [x[1], -G_N / l * np.sin(x[0]) - 0.02 / (m * l**2) * x[1]], [np.radians(60), 0], t)
    return {"theta": x[0], "der(theta)": x[1]}


def kapitza_pendulum(p: Parameters, t: Floats) -> dict[str, Floats]:
    l, a, w = p["l"], p["a"], p["w"]
    x = solve(lambda s, x: [x[1], -(G_N - a * w**2 * np.cos(w * s)) / l * np.sin(x[0])], [np.radians(170), 0], t)
    return {"theta": x[0]}


def spherical_pendulum(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Point mass in space with the tension of the rod, Cartesian."""
    l, theta, rate = p["l"], np.radians(40), 3.0
    start = [l * np.sin(theta), 0, -l * np.cos(theta), 0, rate * l * np.sin(theta), 0]

    def rates(_: float, x: Floats) -> Floats:
        r, v, g = x[:3], x[3:], np.array([0, 0, -G_N])
        return np.concatenate([v, g - (v @ v + g @ r) / l**2 * r])

    x = solve(rates, start, t)
    return {"theta": np.arctan2(np.hypot(x[0], x[1]), -x[2]), "phi": np.unwrap(np.arctan2(x[1], x[0]))}


def foucault_pendulum(p: Parameters, t: Floats) -> dict[str, Floats]:
    """In the rotating frame, with Coriolis and centrifugal accelerations and the tension of the wire."""
    l, omega = p["l"], p["Omega"] * np.array([0, np.cos(p["latitude"]), np.sin(p["latitude"])])

    def rates(_: float, x: Floats) -> Floats:
        r, v = x[:3], x[3:]
        free = np.array([0, 0, -G_N]) - 2 * np.cross(omega, v) - np.cross(omega, np.cross(omega, r))
        return np.concatenate([v, free - (v @ v + free @ r) / l**2 * r])

    x = solve(rates, [0.5, 0, -np.sqrt(l**2 - 0.25), 0, 0, 0], t)
    return {"x": x[0], "y": x[1]}


def elastic_pendulum(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Cartesian."""
    m, k, l0 = p["m"], p["k"], p["l0"]

    def rates(_: float, x: Floats) -> list[float]:
        r = np.hypot(x[0], x[1])
        pull = -k * (r - l0) / (m * r)
        return [x[2], x[3], pull * x[0], pull * x[1] - G_N]

    angle = np.radians(10)
    x = solve(rates, [0.6 * np.sin(angle), -0.6 * np.cos(angle), 0, 0], t)
    return {"r": np.hypot(x[0], x[1]), "theta": np.arctan2(x[0], -x[1])}


def double_pendulum(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The explicit equations solved by Cramer's rule (Goldstein's form)."""
    m1, m2, l1, l2, g = p["m1"], p["m2"], p["l1"], p["l2"], G_N

    def rates(_: float, x: Floats) -> list[float]:
        a, b, va, vb = x
        d = a - b
        den = 2 * m1 + m2 - m2 * np.cos(2 * d)
        wa = (
            -g * (2 * m1 + m2) * np.sin(a)
            - m2 * g * np.sin(a - 2 * b)
            - 2 * np.sin(d) * m2 * (vb**2 * l2 + va**2 * l1 * np.cos(d))
        ) / (l1 * den)
        wb = (
            2
            * np.sin(d)
            * (va**2 * l1 * (m1 + m2) + g * (m1 + m2) * np.cos(a) + vb**2 * l2 * m2 * np.cos(d))
            / (l2 * den)
        )
        return [va, vb, wa, wb]

    x = solve(rates, [np.radians(30), np.radians(-20), 0, 0], t)
    return {"a": x[0], "b": x[1]}


def cart_double_pendulum(p: Parameters, t: Floats) -> dict[str, Floats]:
    M, m1, m2, l1, l2, c, g = p["M"], p["m1"], p["m2"], p["l1"], p["l2"], p["c"], G_N

    def rates(_: float, x: Floats) -> Floats:
        a, b, v, va, vb = x[1], x[2], x[3], x[4], x[5]
        matrix = np.array(
            [
                [M + m1 + m2, (m1 + m2) * l1 * np.cos(a), m2 * l2 * np.cos(b)],
                [(m1 + m2) * l1 * np.cos(a), (m1 + m2) * l1**2, m2 * l1 * l2 * np.cos(a - b)],
                [m2 * l2 * np.cos(b), m2 * l1 * l2 * np.cos(a - b), m2 * l2**2],
            ]
        )
        right = [
            (m1 + m2) * l1 * np.sin(a) * va**2 + m2 * l2 * np.sin(b) * vb**2 - c * v,
            -m2 * l1 * l2 * np.sin(a - b) * vb**2 - (m1 + m2) * g * l1 * np.sin(a),
            m2 * l1 * l2 * np.sin(a - b) * va**2 - m2 * g * l2 * np.sin(b),
        ]
        return np.concatenate([x[3:], np.linalg.solve(matrix, right)])

    x = solve(rates, [0, np.radians(10), np.radians(-5), 0, 0, 0], t)
    return {"x": x[0], "a": x[1], "b": x[2]}


def chain(p: Parameters, t: Floats) -> dict[str, Floats]:
    """M_ij = m l^2 (links from max(i, j) on) cos(q_i - q_j)."""
    n, m, l, c = 8, p["m"], p["l"], 1e-4
    carried = np.arange(n, 0, -1)
    weight = m * l**2 * np.minimum.outer(carried, carried)

    def rates(_: float, x: Floats) -> Floats:
        q, v = x[:n], x[n:]
        d = q[:, None] - q[None, :]
        right = -(weight * np.sin(d)) @ v**2 - m * G_N * l * carried * np.sin(q) - c * v
        return np.concatenate([v, np.linalg.solve(weight * np.cos(d), right)])

    x = solve(rates, [np.radians(30)] * n + [0.0] * n, t)
    return {f"q[{i + 1}]": x[i] for i in range(n)}


def motor_pendulum(p: Parameters, t: Floats) -> dict[str, Floats]:
    """L i' = u - R i - k theta', m l^2 theta'' = k i - m g l sin(theta), u = 6 V."""
    R, L, k, m, l = p["R"], p["L"], p["k"], p["m"], p["l"]
    x = solve(
        lambda _, x: [
            (6 - R * x[0] - k * x[2]) / L,
            x[2],
            (k * x[0] - m * G_N * l * np.sin(x[1])) / (m * l**2),
        ],
        [0, 0, 0],
        t,
        max_step=0.2 * L / R,
    )
    return {"i_a": x[0], "theta": x[1]}


def reaction_wheel_pendulum(p: Parameters, t: Floats) -> dict[str, Floats]:
    m, mw, l, J, c, u = p["m_arm"], p["m_wheel"], p["l"], p["J"], p["c"], 0.02
    inertia = m * l**2 / 3 + mw * l**2

    def rates(_: float, x: Floats) -> list[float]:
        """The arm's own equation: what the motor gives the wheel it takes from the arm."""
        motor = u - c * x[3]
        arm = (-G_N * (m * l / 2 + mw * l) * np.sin(x[0]) - motor) / inertia
        return [x[2], x[3], arm, motor / J - arm]

    x = solve(rates, [np.radians(20), 0, 0, 0], t)
    accelerations = np.array([rates(0, column) for column in x.T]).T
    theta, rate, turning = x[0], x[2], accelerations[2]
    moment = m * l / 2 + mw * l
    return {
        "theta": theta,
        "phi": x[1],
        "pin[1]": moment * (turning * np.cos(theta) - rate**2 * np.sin(theta)),
        "pin[2]": moment * (turning * np.sin(theta) + rate**2 * np.cos(theta)) + (m + mw) * G_N,
        "pin[3]": 0 * t,
    }


def heavy_top(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Nutation in the effective potential of the two conserved momenta (Landau, Lifshitz, Mechanics, 35, problem 1)."""
    a, c, torque = p["A"] + p["m"] * p["l"] ** 2, p["C"], p["m"] * G_N * p["l"]
    theta = np.radians(30)
    spin = c * 150.0
    vertical = spin * np.cos(theta)

    def rates(_: float, x: Floats) -> list[float]:
        s, k = np.sin(x[0]), np.cos(x[0])
        turn = (vertical - spin * k) / (a * s**2)
        return [x[1], turn**2 * s * k - spin * turn * s / a + torque * s / a, turn, spin / c - turn * k]

    x = solve(rates, [theta, 0, 0, 0], t)
    return {"theta": x[0], "psi": x[2], "phi": x[3]}


def free_rigid_body(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Euler's equations."""
    a, b, c = p["A"], p["B"], p["C"]
    x = solve(
        lambda _, w: [(b - c) / a * w[1] * w[2], (c - a) / b * w[2] * w[0], (a - b) / c * w[0] * w[1]], [0.1, 5, 0], t
    )
    return {"spin": x[1]}


def sleeping_top(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Angular momentum about the tip, A e x e' + C w e for the unit vector e of the axis; w is constant."""
    a, spin, moment = p["A"], p["C"] * p["n"], p["m"] * G_N * p["l"]
    up = np.array([0.0, 0.0, 1.0])

    def rates(_: float, x: Floats) -> Floats:
        e, de = x[:3], x[3:]
        turned = spin * np.cross(e, de) + moment * np.cross(e, np.cross(e, up))
        return np.concatenate([de, turned / a - (de @ de) * e])

    tilt = np.radians(1)
    e = solve(rates, [0, -np.sin(tilt), np.cos(tilt), 0, 0, 0], t)
    return {"alpha": np.arctan2(-e[1], e[2]), "beta": np.arcsin(e[0])}
