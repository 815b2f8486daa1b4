"""Mechanisms with a closed loop, as one equation for the crank angle."""

from collections.abc import Mapping

import numpy as np

from models.references.hybrid import Mode, Motion
from models.references.integrate import G_N, Floats, solve

Parameters = Mapping[str, float]


def _turn(angle: complex | float) -> np.ndarray:
    return np.array([np.cos(angle), np.sin(angle)])


def four_bar_angles(p: Parameters, t: Floats) -> dict[str, Floats]:
    """G a'' + H a'^2 = -V'(a) with the kinematic coefficients of the two other links (Paul)."""
    l1, l2, l3, d = p["l1"], p["l2"], p["l3"], p["d"]
    masses = (p["m1"], p["m2"], p["m3"])
    lengths = (l1, l2, l3)

    def angles(a: float) -> tuple[float, float]:
        """Directions of coupler and rocker: two circles meet above the line of their centers."""
        reach = np.array([d, 0]) - l1 * _turn(a)
        s = np.hypot(*reach)
        base = np.arctan2(reach[1], reach[0])
        b = base + np.arccos((l2**2 + s**2 - l3**2) / (2 * l2 * s))
        tip = l1 * _turn(a) + l2 * _turn(b) - np.array([d, 0])
        return b, np.arctan2(tip[1], tip[0])

    def coefficients(a: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Angles, their first and second derivatives with respect to the crank angle."""
        b, c = angles(a)
        matrix = np.array([[-l2 * np.sin(b), l3 * np.sin(c)], [l2 * np.cos(b), -l3 * np.cos(c)]])
        first = np.linalg.solve(matrix, [l1 * np.sin(a), -l1 * np.cos(a)])
        db, dc = first
        right = l1 * _turn(a) + l2 * db**2 * _turn(b) - l3 * dc**2 * _turn(c)
        second = np.linalg.solve(matrix, right)
        return np.array([a, b, c]), np.array([1, db, dc]), np.array([0, *second])

    def rates(_: float, x: Floats) -> list[float]:
        q, dq, ddq = coefficients(x[0])
        inertia = bias = weight = 0.0
        joint, djoint, ddjoint = np.zeros(2), np.zeros(2), np.zeros(2)
        for i in range(3):
            along, across = _turn(q[i]), _turn(q[i] + np.pi / 2)
            if i == 2:
                joint, djoint, ddjoint = np.array([d, 0]), np.zeros(2), np.zeros(2)
            half = lengths[i] / 2
            first = djoint + half * dq[i] * across
            second = ddjoint + half * (ddq[i] * across - dq[i] ** 2 * along)
            moment = masses[i] * lengths[i] ** 2 / 12
            inertia += masses[i] * first @ first + moment * dq[i] ** 2
            bias += masses[i] * first @ second + moment * dq[i] * ddq[i]
            weight += masses[i] * G_N * first[1]
            joint = joint + lengths[i] * along
            djoint = djoint + lengths[i] * dq[i] * across
            ddjoint = ddjoint + lengths[i] * (ddq[i] * across - dq[i] ** 2 * along)
        return [x[1], -(bias * x[1] ** 2 + weight) / inertia]

    a = solve(rates, [np.radians(60), 0], t)[0]
    others = np.array([angles(angle) for angle in a]).T
    return {"a": a, "b": others[0], "c": np.unwrap(others[1])}


def parallelogram(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Without weight the cranks turn at a constant rate."""
    return {"a": 4 * t, "b": 0 * t, "c": 4 * t}


def slider_crank(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Reduced inertia I(th): I th'' + I' th'^2/2 = Q; I' by a complex step."""
    r, l, area = p["r"], p["l"], np.pi * p["bore"] ** 2 / 4
    swept = 2 * area * r
    clearance = swept / (p["ratio"] - 1)

    def inertia(th: complex) -> complex:
        """From first derivatives with respect to the crank angle."""
        ph = -np.arcsin(r / l * np.sin(th))
        dph = -r * np.cos(th) / (l * np.cos(ph))
        rod = np.array([-r * np.cos(th) - l / 2 * np.cos(ph) * dph, -r * np.sin(th) - l / 2 * np.sin(ph) * dph])
        piston = -r * np.sin(th) - l * np.sin(ph) * dph
        return p["J"] + p["m_rod"] * (rod @ rod) + p["J_rod"] * dph**2 + p["m_pis"] * piston**2

    def rates(kick: float, x: Floats) -> list[float]:
        th, w = x
        ph = -np.arcsin(r / l * np.sin(th))
        lift = -r * np.sin(th) + l * np.sin(ph) * r * np.cos(th) / (l * np.cos(ph))
        volume = clearance + area * (r + l - r * np.cos(th) - l * np.cos(ph))
        pressure = p["p0"] * ((clearance + swept) / volume) ** 1.3 * kick
        slope = inertia(th + 1e-30j).imag / 1e-30
        return [w, (-(pressure - p["p0"]) * area * lift - slope * w**2 / 2) / np.real(inertia(th))]

    def stroke(name: str, _: float) -> Mode:
        """The power strokes are the even ones, each of them half a turn in two."""
        count, end = int(name), 4 * np.pi * ((int(name) + 1) // 2) + (np.pi if int(name) % 2 == 0 else 0.0)
        kick = p["kick"] if count % 2 == 0 else 1.0
        return Mode(lambda _, x: rates(kick, x), [(lambda _, x: end - x[0], lambda _, x: (f"{count + 1}", x))])

    x = Motion(stroke, "0", [0, 30 * np.pi], t).x
    return {"th": x[0], "speed": x[1]}
