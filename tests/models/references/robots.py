"""The robot arm under computed torque: every error obeys the equation of a damped oscillator."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import Floats

Parameters = Mapping[str, float]


def robot_arm(p: Parameters, t: Floats) -> dict[str, Floats]:
    """e'' + 2 zeta wn e' + wn^2 e = 0 for e = wanted - q; the arm starts at rest at q = 0."""
    wn, zeta = p["wn"], p["zeta"]
    damped = wn * np.sqrt(1 - zeta**2)
    columns = {}
    for i in range(1, 7):
        middle, amplitude, rate = (p[f"{name}[{i}]"] for name in ("middle", "amplitude", "rate"))
        error, slope = middle, amplitude * rate
        swing = error * np.cos(damped * t) + (slope + zeta * wn * error) / damped * np.sin(damped * t)
        columns[f"axis[{i}].pin.q"] = middle + amplitude * np.sin(rate * t) - np.exp(-zeta * wn * t) * swing
    return columns
