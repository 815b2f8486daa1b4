"""Motion about a center of gravitation."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import Floats

GM_EARTH, R_EARTH = 3.986004e14, 6.3781e6


def constants_orbit(p: Mapping[str, float], t: Floats) -> dict[str, Floats]:
    """Ellipse from its perigee on, by Kepler's equation."""
    near, far = R_EARTH + p["low"], R_EARTH + p["high"]
    a, e = (near + far) / 2, (far - near) / (far + near)
    mean = np.sqrt(GM_EARTH / a**3) * t
    anomaly = mean.copy()
    for _ in range(50):
        anomaly -= (anomaly - e * np.sin(anomaly) - mean) / (1 - e * np.cos(anomaly))
    return {
        "x": a * (np.cos(anomaly) - e),
        "y": a * np.sqrt(1 - e**2) * np.sin(anomaly),
        "r": a * (1 - e * np.cos(anomaly)),
        "E": np.full_like(t, -p["m"] * GM_EARTH / (2 * a)),
    }
