"""Responses of signal blocks."""

from collections.abc import Mapping

import numpy as np
from scipy.interpolate import RegularGridInterpolator

from models.references.integrate import G_N, Floats, linear, solve

Parameters = Mapping[str, float]


def blocks_linear(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Responses to a step of 2 at the start, by inverse Laplace transforms."""
    damped = np.sqrt(0.75) * 4
    second = 2 * (1 - np.exp(-2 * t) * (np.cos(damped * t) + 2 / damped * np.sin(damped * t)))
    return {
        "y1": 6 * (1 - np.exp(-2 * t)),
        "y2": second,
        "y3": t,
        "y4": 6 * (np.exp(-2 * t) - np.exp(-5 * t)) / 0.3,
        "y5": second,
        "y6": 2 + np.exp(-t / 2),
        "y7": second,
    }


def blocks_pid(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The closed loop is linear in x, v, the integral, the filtered error and 1."""
    m, k, ti, td, n = p["m"], p["pid.kp"], p["pid.Ti"], p["pid.Td"], p["pid.N"]
    target, load = p["target"], p["load"]
    system = np.zeros((5, 5))
    system[0, 1] = 1
    force = np.array([-k * (1 + n), 0, k, -k * n, k * (1 + n) * target])
    system[1] = force / m
    system[1, 4] -= load / m
    system[2, [0, 4]] = -1 / ti, target / ti
    system[3, [0, 3, 4]] = -n / td, -n / td, n * target / td
    states = linear(system, [0, 0, 0, 0, 1], t)
    return {"x": states[0], "F": force @ states, "pid.integral": states[2], "pid.slow": states[3]}


def blocks_sources(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Integrals of the sources in closed form."""
    rise = np.clip(t - 0.5, 0, 1.5)
    ramp = 1 + rise * 2 / 1.5
    sine = 0.5 + 3 * np.sin(2 * t + np.pi / 6)
    s = np.clip((t - 0.25) / 2, 0, 1)
    return {
        "cut_sine": np.clip(sine, -1, 2),
        "mapped": np.interp(ramp, [1, 2, 3], [0, 5, 0]),
        "bent": 2 * s**3 * (10 - 15 * s + 6 * s**2),
        "high": RegularGridInterpolator(([1, 1.5, 3], [-3, 0.5, 4]), [[0, 1, 5], [2, -1, 3], [4, 0, 1]])((ramp, sine)),
        "i1": t + rise**2 / 1.5 + 2 * np.maximum(t - 2, 0),
        "i2": 0.5 * t + 1.5 * (np.cos(np.pi / 6) - np.cos(2 * t + np.pi / 6)),
        "i3": t**3 / 3,
        "i4": 4 * s**4 * (2.5 - 3 * s + s**2) + 2 * np.maximum(t - 2.25, 0),
    }


def blocks_table(p: Parameters, t: Floats) -> dict[str, Floats]:
    """On the parabola y = x^2/2, which the cubic table meets exactly, with the controller written out."""
    m, k, n = p["m"], p["pid.kp"], p["pid.N"]
    ti, td, tt, high = p["pid.Ti"], p["pid.Td"], np.sqrt(p["pid.Ti"] * p["pid.Td"]), p["pid.high"]

    def control(state: Floats) -> tuple[Floats, Floats]:
        x, _, integral, slow = state
        demand = k * ((0.2 - x) * (1 + n) + integral - n * slow)
        return demand, np.clip(demand, -high, high)

    def rates(_: float, state: Floats) -> list[Floats]:
        x, v, _, slow = state
        demand, y = control(state)
        turn = (y - m * x * v**2 - m * G_N * x) / (m * (1 + x**2))
        return [v, turn, (0.2 - x) / ti + (y - demand) / (k * tt), n * (0.2 - x - slow) / td]

    states = solve(rates, [0.6, 0, 0, -0.4], t)
    return {"x": states[0], "F": control(states)[1], "pid.integral": states[2]}
