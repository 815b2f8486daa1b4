"""Rolling bodies and skates."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import G_N, Floats, solve

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
    """Angular momentum about the mass center in axes that do not spin, contact force eliminated."""
    m, R = p["m"], p["R"]
    a, c = m * R**2 / 4, m * R**2 / 2
    lean, spin = np.radians(10), 40.0

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
