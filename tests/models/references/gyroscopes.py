"""Things on a spindle: gyroscope in gimbals, governor on its engine."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import G_N, Floats, solve

Parameters = Mapping[str, float]


def gyroscope_in_gimbals(p: Parameters, t: Floats) -> dict[str, Floats]:
    """One equation for the nutation; momenta of outer ring and rotor are constant (Magnus, Kreisel, 5)."""
    weight, arm = p["weight.m"], p["weight.com[3]"]
    A, C = p["rotor.I[1]"], p["rotor.I[3]"]
    nod = p["inner_ring.I[1]"] + A + weight * arm**2
    across = p["inner_ring.I[2]"] + A + weight * arm**2
    along, outer = p["inner_ring.I[3]"], p["outer_ring.I[3]"]
    start, precession = np.radians(60), 1.0
    spin = p["spin"] + precession * np.cos(start)  # about the rotor's axis, constant

    def inertia(angle: float) -> float:
        return float(outer + across * np.sin(angle) ** 2 + along * np.cos(angle) ** 2)

    momentum = inertia(start) * precession + C * spin * np.cos(start)

    def rates(_: float, x: Floats) -> list[float]:
        angle, w = x[:2]
        turn = (momentum - C * spin * np.cos(angle)) / inertia(angle)
        centrifugal = (across - along) * np.sin(angle) * np.cos(angle) * turn**2
        moment = centrifugal - C * spin * turn * np.sin(angle) + weight * G_N * arm * np.sin(angle)
        return [w, moment / nod, turn, spin - turn * np.cos(angle)]

    x = solve(rates, [start, 0, 0, 0], t)
    return {"inner.q": x[0], "outer.q": x[2], "axle.q": x[3]}


def watt_governor(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Two coordinates, angle of the arms and of the spindle (Pontryagin, Ordinary Differential Equations, 27, with the
    inertia of the balls and the mass of the sleeve)."""
    l, m, collar, J = p["l"], p["ball1.m"], p["collar.m"], p["flywheel.J"]
    c = p["dashpot.c"]

    def rates(_: float, x: Floats) -> list[float]:
        angle, w, _, turn = x
        s, co = np.sin(angle), np.cos(angle)
        moment = 2 * m * l**2 * s * co * turn**2 - 2 * (m + collar) * G_N * l * s
        moment -= 4 * collar * l**2 * s * co * w**2 + 4 * c * l**2 * s**2 * w
        torque = p["steam"] * co - p["load"] - 4 * m * l**2 * s * co * w * turn
        return [w, moment / (2 * m * l**2 + 4 * collar * l**2 * s**2), turn, torque / (J + 2 * m * l**2 * s**2)]

    x = solve(rates, [np.radians(45), 0, 0, 12], t)
    height = -2 * l * np.cos(x[0])
    return {"arm1.q": x[0], "arm2.q": -x[0], "sleeve.s": height, "spindle.q": x[2], "der(spindle.q)": x[3]}
