"""Sampled control: what a controller says is held until its next tick."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from models.references.hybrid import Mode, Motion
from models.references.integrate import G_N, Floats

Parameters = Mapping[str, float]


def furuta_swing_up(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Lagrange's equations by hand: arm phi, pendulum theta from upright, tip at L ex + l (ey cos + ez sin)."""
    m, l, arm, bearing, period = p["m"], p["l"], p["L"], 1e-4, 5e-3

    def control(x: Floats) -> float:
        phi, theta, dphi, dtheta = x[:4]
        up = (theta + np.pi) % (2 * np.pi) - np.pi
        if abs(up) < np.radians(20):
            u = -(p["k1"] * phi + p["k2"] * up + p["k3"] * dphi + p["k4"] * dtheta)
        else:
            energy = m * (l * dtheta) ** 2 / 2 + m * G_N * l * (np.cos(theta) - 1)
            u = -p["kE"] * energy * dtheta * np.cos(theta)
        return float(np.clip(u, -p["u_max"], p["u_max"]))

    def rates(_: float, x: Floats) -> ArrayLike:
        _, theta, dphi, dtheta, u = x
        s, c = np.sin(theta), np.cos(theta)
        across, pendulum = -m * arm * l * c, m * l**2
        hub = p["J"] + m * (arm**2 + l**2 * s**2)
        f1 = u - bearing * dphi - m * (2 * l**2 * s * c * dphi * dtheta + arm * l * s * dtheta**2)
        f2 = m * G_N * l * s - bearing * dtheta + m * l**2 * s * c * dphi**2
        determinant = hub * pendulum - across**2
        return [dphi, dtheta, (pendulum * f1 - across * f2) / determinant, (hub * f2 - across * f1) / determinant, 0.0]

    def tick(_: float, x: Floats) -> tuple[str, ArrayLike]:
        return "held", [*x[:4], control(x)]

    def held(_: str, time: float) -> Mode:
        return Mode(rates, until=(round(time / period) + 1) * period, then=tick)

    start = np.array([0.0, np.radians(175), 0.0, 0.0, 0.0])
    start[4] = control(start)
    x = Motion(held, "held", start, t).x
    return {"phi": x[0], "theta": x[1], "der(phi)": x[2], "der(theta)": x[3], "u": x[4]}
