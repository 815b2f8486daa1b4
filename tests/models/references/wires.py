"""Beads on wires and hoops, a ladder."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import G_N, Floats, solve

Parameters = Mapping[str, float]


def bead_on_hoop(p: Parameters, t: Floats) -> dict[str, Floats]:
    """R theta'' + g sin - R Omega^2 sin cos = 0; the hoop gives the Coriolis force 2 m R Omega theta' cos(theta)."""
    m, R, W = p["m"], p["R"], p["Omega"]
    x = solve(lambda _, x: [x[1], (W**2 * np.cos(x[0]) - G_N / R) * np.sin(x[0])], [np.radians(10), 0], t)
    theta, rate = x
    return {
        "theta": theta,
        "N_out": -2 * m * R * W * rate * np.cos(theta),
        "N_rad": m * R * (rate**2 + (W * np.sin(theta)) ** 2) + m * G_N * np.cos(theta),
    }


def bead_on_cosine_wire(p: Parameters, t: Floats) -> dict[str, Floats]:
    """One coordinate: (1 + y'^2) x'' + y' y'' x'^2 + g y' = 0 for the wire y(x); the multiplier is m (y'' + g)."""
    m, A, k = p["m"], p["A"], 2 * np.pi / p["wavelength"]

    def shape(x: Floats) -> tuple[Floats, Floats]:
        return -A * k * np.sin(k * x), -A * k**2 * np.cos(k * x)

    def acceleration(x: Floats, v: Floats) -> Floats:
        slope, bend = shape(x)
        return -slope * (bend * v**2 + G_N) / (1 + slope**2)

    x, v = solve(lambda _, s: [s[1], acceleration(s[0], s[1])], [0.02, 0], t)
    slope, bend = shape(x)
    return {"x": x, "y": A * np.cos(k * x), "lambda": m * (slope * acceleration(x, v) + bend * v**2 + G_N)}


def _circular_wire(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Newton's law along and across the wire."""
    m, R, c, F = p["m"], p["R"], p["c"], p["F"]

    def push(phi: Floats, rate: Floats) -> Floats:
        return F - c * R * np.cos(phi) * rate

    phi, rate = solve(
        lambda _, x: [x[1], (push(x[0], x[1]) * np.cos(x[0]) - m * G_N * np.sin(x[0])) / (m * R)],
        [np.radians(40), 0],
        t,
    )
    normal = m * R * rate**2 + m * G_N * np.cos(phi) + push(phi, rate) * np.sin(phi)
    return {"x": R * np.sin(phi), "y": -R * np.cos(phi), "normal": normal}


def bead_on_circular_wire(p: Parameters, t: Floats) -> dict[str, Floats]:
    return _circular_wire(p, t)


def bead_on_circular_wire_redundant(p: Parameters, t: Floats) -> dict[str, Floats]:
    return _circular_wire(p, t)


def sliding_ladder(p: Parameters, t: Floats) -> dict[str, Floats]:
    """theta'' = -(3 g/2 l) cos(theta); the wall pushes with 3/4 m g cos(theta) (3 sin(theta) - 2 sin(theta0))."""
    m, l, start = p["m"], p["l"], np.radians(70)
    theta, rate = solve(lambda _, x: [x[1], -1.5 * G_N / l * np.cos(x[0])], [start, 0], t)
    turning = -1.5 * G_N / l * np.cos(theta)
    return {
        "theta": theta,
        "wall_force": 0.75 * m * G_N * np.cos(theta) * (3 * np.sin(theta) - 2 * np.sin(start)),
        "ground_force": m * G_N + m * l / 2 * (turning * np.cos(theta) - rate**2 * np.sin(theta)),
    }
