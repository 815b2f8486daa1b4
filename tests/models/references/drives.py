"""Shafts and slides: gears, elastic shafts."""

from collections.abc import Mapping

import numpy as np
from scipy.linalg import eigh

from models.references.integrate import Floats, linear

Parameters = Mapping[str, float]


def gear_train(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Everything reduced to the motor's shaft: inertias by the square of the ratio, torques by the ratio."""
    first, total = p["first.ratio"], p["first.ratio"] * p["second.ratio"]
    inertia = p["motor.J"] + p["shaft.J"] / first**2 + p["drum.J"] / total**2
    rate = (2 + 10 / total) / inertia
    turned = rate * t**2 / 2
    return {"motor.phi": turned, "drum.phi": turned / total, "teeth": p["motor.J"] * rate - 2 + 0 * t}


def planetary_gear(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Ring held: sun = (1 + ratio) carrier; one inertia, one brake."""
    n = 1 + p["gear.ratio"]
    inertia, damping = p["sun.J"] + p["carrier.J"] / n**2, p["brake.c"] / n**2
    fading = np.exp(-damping / inertia * t)
    w = (1 - fading) / damping
    mesh = p["sun.J"] * fading / inertia - 1
    return {"der(gear.sun)": w, "der(gear.carrier)": w / n, "held": -p["gear.ratio"] * mesh}


def torsional_train(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Damping in proportion to stiffness: every mode fades alone."""
    k1, k2 = p["front.k"], p["rear.k"]
    stiffness = np.array([[k1, -k1, 0], [-k1, k1 + k2, -k2], [0, -k2, k2]])
    inertia = np.diag([p["engine.J"], p["clutch.J"], p["propeller.J"]])
    squares, shapes = eigh(stiffness, inertia)
    amounts = shapes.T @ inertia @ [np.radians(2), 0, 0]
    x = amounts[0] * np.outer(shapes[:, 0], np.ones_like(t))  # the train as a whole does not turn back
    for i in (1, 2):
        d = squares[i] * p["front.c"] / k1 / 2
        w = np.sqrt(squares[i] - d**2)
        x = x + amounts[i] * np.outer(shapes[:, i], np.exp(-d * t) * (np.cos(w * t) + d / w * np.sin(w * t)))
    return {"engine.phi": x[0], "clutch.phi": x[1], "propeller.phi": x[2]}


def turned_shaft(p: Parameters, t: Floats) -> dict[str, Floats]:
    """J phi'' = -k (phi - psi - rest) - c (phi' - psi'), psi = amplitude sin(omega t)."""
    k, c, J, omega = p["shaft.k"], p["oil.c"], p["flywheel.J"], p["omega"]
    a = np.array(
        [
            [0, 1, 0, 0, 0],
            [-k / J, -c / J, k / J, c / J, k / J],
            [0, 0, 0, 1, 0],
            [0, 0, -(omega**2), 0, 0],
            [0, 0, 0, 0, 0],
        ]
    )
    x = linear(a, [0, 0, 0, p["amplitude"] * omega, p["shaft.rest"]], t)
    return {"shaft.phi_b": x[0], "effort": -k * (x[0] - x[2] - x[4]) - c * (x[1] - x[3])}


def rack_drive(p: Parameters, t: Floats) -> dict[str, Floats]:
    """(m + J/r^2) s'' = tau/r - c s' - k s, from rest."""
    r, c, k = p["rack.r"], p["guide.c"], p["spring.k"]
    m = p["carriage.m"] + p["pinion.J"] / r**2
    d, end = c / (2 * m), 1.5 / r / k
    w = np.sqrt(k / m - d**2)
    fading = np.exp(-d * t)
    s = end * (1 - fading * (np.cos(w * t) + d / w * np.sin(w * t)))
    speed = end * fading * (w + d**2 / w) * np.sin(w * t)
    acceleration = (1.5 / r - c * speed - k * s) / m
    return {"rack.s": s, "pinion.phi": s / r, "teeth": 1.5 / r - p["pinion.J"] / r**2 * acceleration}


def lever_and_masses(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The lever carries the left mass along with the square of its ratio."""
    ratio, k, c, free = p["lever.ratio"], p["spring.k"], p["damper.c"], p["free.m"]
    m = p["right.m"] + ratio**2 * p["left.m"]
    row = np.array([-k, k, -c, c, -6])
    a = np.vstack([[0, 0, 1, 0, 0], [0, 0, 0, 1, 0], row / m, -row / free, np.zeros(5)])
    x = linear(a, [0, 0, 0, 0, 1], t)
    return {"right.s": x[0], "free.s": x[1], "left.s": ratio * x[0], "pivot": p["left.m"] * ratio * (row @ x) / m}


def driven_shafts(p: Parameters, t: Floats) -> dict[str, Floats]:
    """First-order lags behind a sine and a cosine."""
    c, J, w = p["coupling.c"], p["wheel.J"], p["omega"]
    a = c / J
    wheel = 3 * a * (a * np.sin(w * t) - w * np.cos(w * t) + w * np.exp(-a * t)) / (a**2 + w**2)
    wheel = wheel - 0.5 / c * -np.expm1(-a * t)
    b = p["drag.c"] / p["carriage.m"]
    cart = 0.2 * b * (b * np.cos(w * t) + w * np.sin(w * t) - b * np.exp(-b * t)) / (b**2 + w**2)
    cart = cart + 1.5 / p["drag.c"] * -np.expm1(-b * t)
    return {
        "der(coupling.phi_b)": wheel,
        "der(counter.phi)": 0.5 / p["counter.J"] * t,
        "der(drag.s_b)": cart,
        "effort": c * (3 * np.sin(w * t) - wheel),
    }


def servo_drive(p: Parameters, t: Floats) -> dict[str, Floats]:
    """A constant torque against a bearing; the winding warms up to what the torque loses. Samples are those of the last
    tick, of two rows at one time that before it comes first."""
    torque = p["step"] * 1.0
    fading = p["d"] / p["J"]

    def rate(time: Floats) -> Floats:
        return torque / p["d"] * (1 - np.exp(-fading * time))

    before = np.append(np.diff(t) == 0.0, False)
    ticks = np.maximum(np.floor(t / 0.1 + 1e-9) - before * (np.abs(t / 0.1 - np.rint(t / 0.1)) < 1e-9), 0)
    steady = p["heating"] * p["losses"] * torque**2
    return {
        "phi": torque / p["d"] * (t - (1 - np.exp(-fading * t)) / fading),
        "der(phi)": rate(t),
        "warmth": steady * (1 - np.exp(-t / p["cooling"])),
        "measured": rate(0.1 * ticks),
        "lost": p["d"] * rate(t) ** 2 * p["cooling"],
        "does": 2 + 0 * t,
    }
