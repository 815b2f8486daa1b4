"""The Stewart platform by Newton's and Euler's equations of the platform alone."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import G_N, Floats, solve
from models.references.newton_euler import cross, skew

Parameters = Mapping[str, float]


def stewart_platform(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Legs are solved for the forces at their upper ends (Dasgupta and Mruthyunjaya 1998): six equations remain.

    A leg is two thin rods that slide in each other; it turns with w = u x v/s about its foot and not about itself. Its
    transverse force at the top follows from the moment about the foot, the axial one from the upper rod.
    """
    base, top = _joints(p, "R_base", "at_base"), _joints(p, "R_top", "at_top")
    inertia = np.diag([p["I_t"], p["I_t"], p["I_a"]])
    weight = np.array([0, 0, -G_N])
    m1, m2, c1, c2 = p["m_low"], p["m_up"], p["c_low"], p["c_up"]
    one = np.eye(3)

    def leg(time: float, i: int, r: Floats, R: Floats, v: Floats, w: Floats) -> tuple[Floats, Floats, Floats]:
        """K and h of the leg's force K a + h on the platform, a the acceleration of its upper joint; and that joint."""
        arm = R @ top[i]
        way, rate = r + arm - base[i], v + cross(w, arm)
        s = float(np.linalg.norm(way))
        u = way / s
        turning, sliding = cross(u, rate) / s, float(u @ rate)
        # w' = (u x a - 2 s' w)/s, as u x (a - ...) with u' = w x u
        across = one - np.outer(u, u)
        spin_k, spin_h = skew(u) / s, -2 * sliding / s * turning
        # the lower center at c1 u, the upper at way - c2 u; moments of inertia I_low, I_up about them
        about = p["I_low"] + p["I_up"] + m1 * c1**2 + m2 * (s - c2) ** 2
        drift = 2 * m2 * (s - c2) * sliding * turning
        moment = (m1 * c1 + m2 * (s - c2)) * cross(u, weight)
        # u x N s = moment - about w' - drift, for N the transverse part of the force on the platform
        n_k, n_h = skew(u) @ (about * spin_k) / s, -skew(u) @ (moment - about * spin_h - drift) / s
        # along u: m2 (a.u - s'' part ...): the upper center's acceleration is a - c2 u''
        push = _push(p, time, i, s, sliding)
        bend = c2 * float(turning @ turning)
        a_k, a_h = -m2 * np.outer(u, u), (push + m2 * (weight @ u) - m2 * bend) * u
        return n_k @ across + a_k, n_h + a_h, arm

    def accelerations(time: float, x: Floats) -> tuple[Floats, Floats]:
        r, e, v, w = x[:3], x[3:7], x[7:10], x[10:13]
        R = _rotation(e)
        matrix, right = np.zeros((6, 6)), np.zeros(6)
        spun = R @ inertia @ R.T
        matrix[:3, :3], matrix[3:, 3:] = p["m_top"] * one, spun
        right[:3], right[3:] = p["m_top"] * weight, -cross(w, spun @ w)
        for i in range(6):
            k, h, arm = leg(time, i, r, R, v, w)
            h = h + k @ cross(w, cross(w, arm))
            turn = skew(arm)
            matrix[:3, :3] -= k
            matrix[:3, 3:] += k @ turn
            matrix[3:, :3] -= turn @ k
            matrix[3:, 3:] += turn @ k @ turn
            right[:3] += h
            right[3:] += turn @ h
        both = np.linalg.solve(matrix, right)
        return both[:3], both[3:]

    def rates(time: float, x: Floats) -> Floats:
        e, w = x[3:7], x[10:13]
        a, alpha = accelerations(time, x)
        de = 0.5 * np.concatenate([[-w @ e[1:]], e[0] * w + cross(w, e[1:])])
        return np.concatenate([x[7:10], de, a, alpha])

    x = solve(rates, [0, 0, p["height"], 1, *(9 * [0.0])], t, tolerance=1e-11)
    columns = {f"pose.r[{k + 1}]": x[k] for k in range(3)} | {f"pose.e[{k + 1}]": x[3 + k] for k in range(4)}
    for i in range(6):
        ends = np.array([q[:3] + _rotation(q[3:7]) @ top[i] - base[i] for q in x.T])
        columns[f"leg[{i + 1}].slide.s"] = np.linalg.norm(ends, axis=1)
    return columns


def _joints(p: Parameters, radius: str, angle: str) -> Floats:
    angles = [p[f"{angle}[{i + 1}]"] for i in range(6)]
    return p[radius] * np.array([[np.cos(a), np.sin(a), 0] for a in angles])


def _push(p: Parameters, time: float, i: int, s: float, rate: float) -> float:
    """Of the actuator: a spring-damper about a length that swings."""
    wanted = p["s0"] + p["stroke"] * np.sin(p["rate"] * time + i)
    return float(p["k"] * (wanted - s) - p["c"] * rate)


def _rotation(e: Floats) -> Floats:
    s, u = e[0], e[1:]
    return np.asarray((s * s - u @ u) * np.eye(3) + 2 * np.outer(u, u) + 2 * s * skew(u)) / (e @ e)
