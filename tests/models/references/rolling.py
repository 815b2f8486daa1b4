"""Rolling bodies and skates."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import G_N, Floats, linear, solve

Parameters = Mapping[str, float]


def knife_edge(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The skate turns at a constant rate and describes a cycloid across the slope (Neimark, Fufaev)."""
    w, pull = 2.0, G_N * np.sin(p["slope"])
    return {
        "x": pull / (2 * w**2) * np.sin(w * t) ** 2,
        "y": pull / (2 * w**2) * (w * t - np.sin(2 * w * t) / 2),
        "phi": w * t,
        "grip": 2 * p["m"] * pull * np.sin(w * t),
    }


def rolling_sphere(p: Parameters, t: Floats) -> dict[str, Floats]:
    """5/7 of the acceleration of sliding."""
    return {"x": 5 / 14 * G_N * np.sin(p["slope"]) * t**2, "y": 0.5 * t}


def ball_on_turntable(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The velocity turns at 2/7 of the table's rate (K. Weltner, Am. J. Phys. 47 (1979) 984)."""
    w = 2 / 7 * p["Omega"]
    return {"x": 0.3 - 0.1 / w * (1 - np.cos(w * t)), "y": 0.1 / w * np.sin(w * t)}


def rolling_coin(p: Parameters, t: Floats) -> dict[str, Floats]:
    """A thin disc."""
    return _rolling_wheel(p["m"], p["R"], 1 / 2, np.radians(10), 40.0, t)


def rolling_hoop(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The same about upright."""
    return _rolling_wheel(p["m"], p["R"], p["k"], np.radians(1), p["w"], t)


def _rolling_wheel(m: float, R: float, inertia: float, lean: float, spin: float, t: Floats) -> dict[str, Floats]:
    """Angular momentum about the mass center in axes that do not spin, contact force eliminated."""
    a, c = inertia * m * R**2 / 2, inertia * m * R**2

    def rates(_: float, x: Floats) -> list[float]:
        tilt, w1, w2, w3 = x[0], x[1], x[2], x[3]
        turn = w3 / np.cos(tilt)
        n2 = w3 * np.tan(tilt)
        return [
            w1,
            (-a * n2 * w3 + (c + m * R**2) * w2 * w3 + m * G_N * R * np.sin(tilt)) / (a + m * R**2),
            -m * R**2 * w1 * w3 / (c + m * R**2),
            (-c * w1 * w2 + a * n2 * w1) / a,
            turn,
            w2 - turn * np.sin(tilt),
        ]

    # The heading's rate is not given: the start is the one nearest to rest in the metric of the kinetic energy.
    s, k = np.sin(lean), np.cos(lean)
    heading = -spin * m * R**2 * s / (m * R**2 * s**2 + a * k**2 + c * s**2)
    x = solve(rates, [lean, 0, spin + heading * s, heading * k, 0, 0], t)
    return {"lean": x[0], "psi": x[4], "spin": x[5]}


def bicycle(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The benchmark's equations of roll and steering; a hundred thousandth of a radian has no higher order."""
    v = p["v"]
    mass = np.array([[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]])
    damping = v * np.array([[0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]])
    weight = p["g"] * np.array([[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]])
    stiffness = weight + v**2 * np.array([[0, 76.59734589573222], [0, 2.65431523794604]])
    inverse = np.linalg.inv(mass)
    a = np.block([[np.zeros((2, 2)), np.eye(2)], [-inverse @ stiffness, -inverse @ damping]])
    x = linear(a, [np.radians(0.001), 0, 0, 0], t)
    return {"phi": x[0], "delta": -x[1]}
