"""Particles in fields."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import Floats

Parameters = Mapping[str, float]


def kepler_orbit(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Kepler's equation by Newton's method; the start is the perigee."""
    mu, r, v = p["mu"], 7e6, 8.5e3
    a = 1 / (2 / r - v**2 / mu)
    e = 1 - r / a
    mean = np.sqrt(mu / a**3) * t
    anomaly = mean + e * np.sin(mean)
    for _ in range(50):
        anomaly -= (anomaly - e * np.sin(anomaly) - mean) / (1 - e * np.cos(anomaly))
    return {"x": a * (np.cos(anomaly) - e), "y": a * np.sqrt(1 - e**2) * np.sin(anomaly)}


def charged_particle(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Cycloid: cyclotron frequency e B/m, drift E/B."""
    w, drift = p["e"] * p["B"] / p["m"], p["E"] / p["B"]
    return {"x": drift * (t - np.sin(w * t) / w), "y": drift / w * (1 - np.cos(w * t))}


def relativistic_particle(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Constant force: p_x = F t, p_y constant, energy sqrt(m^2 c^4 + p^2 c^2) (Landau, Lifshitz, Fields, 20)."""
    m, c, F, v = p["m"], p["c"], p["F"], 1e8
    across = m * v / np.sqrt(1 - (v / c) ** 2)
    rest = np.hypot(m * c**2, across * c)
    x = F * (c * t) ** 2 / (np.hypot(rest, F * c * t) + rest)
    return {"x": x, "y": across * c / F * np.arcsinh(F * c * t / rest)}
