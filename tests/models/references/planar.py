"""Mechanisms of the plane from the component library."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import G_N, Floats, linear, solve

Parameters = Mapping[str, float]


def planar_pendulum(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Physical pendulum, angle from the horizontal."""
    length, width = p["bar.r[1]"], p["bar.width"]
    mass = p["bar.density"] * length * width**2
    inertia = mass * (length**2 / 3 + width**2 / 12)
    pull = mass * G_N * length / 2
    q, w = solve(lambda _, x: [x[1], -pull * np.cos(x[0]) / inertia], [np.radians(-150), 0], t)
    turn = -pull * np.cos(q) / inertia
    along = [-(w**2) * np.cos(q) - turn * np.sin(q), -(w**2) * np.sin(q) + turn * np.cos(q)]
    return {
        "pin.q": q,
        "load[1]": mass * length / 2 * along[0],
        "load[2]": mass * (length / 2 * along[1] + G_N),
    }


def planar_trammel(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The sliding ladder: the moment of inertia about the instantaneous center is m*l^2/3 throughout."""
    m, l = p["ladder.m"], p["ladder.l"]
    q, w = solve(lambda _, x: [x[1], -1.5 * G_N / l * np.cos(x[0])], [np.radians(120), 0], t)
    turn = -1.5 * G_N / l * np.cos(q)
    push = m * l / 2 * (np.cos(q) * w**2 + np.sin(q) * turn)
    return {"foot.q": q, "head.q": -q, "floor_.s": -l * np.cos(q), "wall.s": -l * np.sin(q), "wall_push": -push}


def planar_throw(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Parabola of the mass center, constant spin."""
    arm, q = p["hammer.com[1]"], 9 * t
    across, up = arm + 4 * t, 1.5 + (3 + 9 * arm) * t - G_N / 2 * t**2
    return {
        "flight.q": q,
        "center[1]": across,
        "center[2]": up,
        "flight.x": across - arm * np.cos(q),
        "flight.y": up - arm * np.sin(q),
    }


def planar_bead_on_arm(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The distance along the arm grows by a hyperbolic cosine; torque from the angular momentum."""
    omega, aside = p["Omega"], p["elbow.r[2]"]
    start = p["elbow.r[1]"] + 0.2
    way, rate = start * np.cosh(omega * t), start * omega * np.sinh(omega * t)
    drive = p["bead.m"] * (2 * omega * way * rate - aside * omega**2 * way)
    return {"slide.s": way - p["elbow.r[1]"], "drive": drive}


def planar_shaken_mass(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Oscillator in the shaken frame under the force of inertia."""
    m, k, c, w = p["block.m"], p["spring.k"], p["spring.c"], p["omega"]

    def acceleration(time: Floats | float, x: Floats | float, v: Floats | float) -> Floats | float:
        return -k / m * x - c / m * v + p["amplitude"] * w**2 * np.sin(w * time)

    x, v = solve(lambda time, y: [y[1], acceleration(time, y[0], y[1])], [0, 0], t)
    base = -p["amplitude"] * w**2 * np.sin(w * t)
    return {"slide.s": p["spring.rest"] + x, "drive": m * (base + acceleration(t, x, v))}


def planar_rolling_disc(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Two thirds of the acceleration of sliding, a third of the weight's component as traction."""
    m, radius, slope = p["disc.m"], p["disc.R"], p["slope"]
    way = G_N * np.sin(slope) / 3 * t**2
    return {
        "motion.x": way,
        "motion.y": radius + 0 * t,
        "motion.q": -way / radius,
        "traction": -m * G_N * np.sin(slope) / 3 + 0 * t,
        "normal": m * G_N * np.cos(slope) + 0 * t,
    }


def planar_skate(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Chaplygin's sleigh: v' = a*w^2, (J + m*a^2)*w' = -m*a*v*w (Neimark, Fufaev)."""
    m, a = p["sleigh.m"], p["sleigh.com[1]"]
    inertia = p["sleigh.Izz"] + m * a**2

    def rates(_: float, x: Floats) -> list[float]:
        _, _, q, v, w = x
        return [v * np.cos(q), v * np.sin(q), w, a * w**2, -m * a * v * w / inertia]

    x, y, q, v, w = solve(rates, [0, 0, 0, -1.5, 0.5], t)
    side = m * (v * w - a * m * a * v * w / inertia)
    return {"motion.x": x, "motion.y": y, "motion.q": q, "side": side}


def planar_rod_pendulum(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Pendulum; the rod pulls with m*(g*cos + l*w^2)."""
    m, l = p["ball.m"], p["rod.l"]
    angle, w = solve(lambda _, x: [x[1], -G_N / l * np.sin(x[0])], [np.arcsin(0.6), 0], t)
    return {
        "across.s": l * np.sin(angle),
        "up.s": -l * np.cos(angle),
        "compression": -m * (G_N * np.cos(angle) + l * w**2),
    }


def planar_planet_wheel(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Inertia reduced to the arm: the planet turns (1 + sun/planet) times as fast as the arm."""
    m, sun, planet, torque = p["wheel.m"], p["sun"], p["planet"], 0.05
    turns = 1 + sun / planet
    own = m * planet**2 / 2
    arm = torque / (m * (sun + planet) ** 2 + own * turns**2)
    return {
        "center.q": arm / 2 * t**2,
        "pin.q": arm / 2 * t**2 * sun / planet,
        "teeth": own * turns * arm * sun / planet + 0 * t,
    }


def planar_oscillators(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Two linear oscillators."""
    inertia, rest = p["wheel.m"] * p["wheel.R"] ** 2 / 2, p["wire.rest"]
    q = linear([[0, 1], [-p["wire.k"] / inertia, -p["oil.c"] / inertia]], [np.radians(40) - rest, 0], t)[0]
    m = p["block.m"]
    s = linear([[0, 1], [-p["spring.k"] / m, -p["dashpot.c"] / m]], [0.6 - p["spring.rest"], 0], t)[0]
    return {"pivot.q": rest + q, "slide.s": p["spring.rest"] + s}
