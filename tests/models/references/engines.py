"""Piston engines as one equation for the crank angle: reduced inertia and generalized force."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import Floats, solve
from models.references.linkages import slider_crank

Parameters = Mapping[str, float]

BANKS = np.radians([30, -30, 30, -30, 30, -30])
THROWS = np.radians([30, 210, 150, 330, 270, 90])
FIRES = np.radians([0, 120, 240, 360, 480, 600])


def slider_crank_components(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The same engine as in slider_crank.lag, so that its reference is this one's."""
    single = slider_crank(p, t)
    return {"main.q": single["th"], "speed": single["speed"]}


def v6_engine(p: Parameters, t: Floats) -> dict[str, Floats]:
    """I(th) th'' + I'(th) th'^2/2 = Q(th, th'); I' by a complex step."""
    r, l, area = p["r"], p["l"], np.pi * p["bore"] ** 2 / 4
    swept = 2 * area * r
    clearance = swept / (p["ratio"] - 1)

    def slider(th: complex | float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Of all cylinders, along their own axes: rod angle, its first and the piston's first derivative."""
        a = th + THROWS - BANKS
        rod = -np.arcsin(r / l * np.sin(a))
        drod = -r * np.cos(a) / (l * np.cos(rod))
        return rod, drod, -r * np.sin(a) - l * np.sin(rod) * drod

    def inertia(th: complex) -> complex:
        a = th + THROWS - BANKS
        rod, drod, dpiston = slider(th)
        dx = -r * np.cos(a) - p["c_rod"] * np.cos(rod) * drod
        dy = -r * np.sin(a) - p["c_rod"] * np.sin(rod) * drod
        each = p["m_rod"] * (dx**2 + dy**2) + p["J_rod"] * drod**2 + p["m_pis"] * dpiston**2
        return complex(p["J"] + np.sum(each))

    def rates(_: float, x: Floats) -> list[float]:
        th, w = x
        rod, _, dpiston = slider(th)
        piston = r * np.cos(th + THROWS - BANKS) + l * np.cos(rod)
        volume = clearance + area * (r + l - piston)
        burning = 1 + p["rise"] * np.cos((th - FIRES - p["delay"]) / 4) ** 32
        pressure = p["p0"] * ((clearance + swept) / volume) ** 1.3 * burning
        torque = -area * (pressure - p["p0"]) @ dpiston - p["load"] - p["friction"] * w
        slope = inertia(th + 1e-30j).imag / 1e-30
        return [w, (torque - slope * w**2 / 2) / inertia(th).real]

    th, w = solve(rates, [0, p["speed"]], t, tolerance=1e-12)
    columns = {"main.q": th, "der(main.q)": w}
    for i in range(6):
        a = th + THROWS[i] - BANKS[i]
        columns[f"cylinder[{i + 1}].guide.s"] = r * np.cos(a) + np.sqrt(l**2 - r**2 * np.sin(a) ** 2)
    return columns
