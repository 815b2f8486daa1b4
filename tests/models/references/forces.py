"""Force elements of the component library, by Newton's equations."""

from collections.abc import Mapping

import numpy as np
from scipy.optimize import brentq

from models.references.integrate import G_N, Floats, linear, solve

Parameters = Mapping[str, float]


def forces_zero_length_spring(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Both coordinates swing alike: the ball passes through the center."""
    swing = np.cos(np.sqrt(p["spring.k"] / p["ball.m"]) * t)
    return {"across.s": 0.3 * swing, "up.s": 0.4 * swing}


def forces_spring_damper(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Newton's equation of the ball."""
    post = np.array([2.0, 0.0])

    def rates(_: float, x: Floats) -> Floats:
        place, v = x[:2], x[2:]
        r = np.linalg.norm(place)
        along, other = place / r, (place - post) / np.linalg.norm(place - post)
        pull = p["elastic.k"] * (r - p["elastic.rest"]) + p["elastic.c"] * (along @ v)
        force = -pull * along - p["side.c"] * (other @ v) * other
        return np.array([*v, *(force / p["ball.m"] - [0, G_N])])

    x = solve(rates, [0.5, -1, 0, 0], t)
    return {"across.s": x[0], "up.s": x[1]}


def forces_gas_spring(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Pressure of the gas against weight and air."""

    def column(name: str, n: float) -> Floats:
        area, start = p[f"{name}.A"], p[f"{name}.V0"]

        def rates(_: float, x: Floats) -> list[float]:
            volume = start + area * (x[0] - p[f"{name}.l0"])
            pressure = p[f"{name}.p0"] * (start / volume) ** n
            return [x[1], (pressure - p[f"{name}.p_ambient"]) * area / p["upper.m"] - G_N]

        return solve(rates, [0.3, 0], t)[0]

    return {"fast.s": column("adiabatic", 1.4), "slow.s": column("isothermal", 1.0)}


def forces_follower(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Newton and Euler; the thrust turns with the puck."""
    m, turn = p["puck.m"], 0.02 / p["puck.Izz"]

    def rates(time: float, x: Floats) -> list[float]:
        q = turn / 2 * time**2
        thrust = np.array([1.5 * np.cos(q) - 0.2 * np.sin(q), 1.5 * np.sin(q) + 0.2 * np.cos(q) - 0.8])
        return [x[2], x[3], *(thrust / m)]

    x = solve(rates, [0, 0, 0.5, 0], t)
    return {"motion.x": x[0], "motion.y": x[1], "motion.q": turn / 2 * t**2}


def forces_jack(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Moments about the hinge."""
    m, l = p["flap.m"], p["flap.l"]

    def rates(time: float, x: Floats) -> list[float]:
        end = 0.6 * np.array([np.cos(x[0]), np.sin(x[0])])
        line = end - [0.5, -0.4]
        push = (90 + 20 * np.sin(3 * time)) * line / np.linalg.norm(line)
        moment = end[0] * push[1] - end[1] * push[0] - m * G_N * l / 2 * np.cos(x[0])
        return [x[1], moment / (m * l**2 / 3)]

    return {"hinge.q": solve(rates, [np.radians(20), 0], t)[0]}


def forces_kepler(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Kepler's equation from the perigee."""
    mu, r, v = p["earth.mu"], 7e6, 9e3
    a = 1 / (2 / r - v**2 / mu)
    e = 1 - r / a
    mean = np.sqrt(mu / a**3) * t
    eccentric = np.array([brentq(lambda x, m=m: x - e * np.sin(x) - m, m - 1, m + 1, xtol=1e-14) for m in mean])
    return {"east.s": a * (np.cos(eccentric) - e), "north.s": a * np.sqrt(1 - e**2) * np.sin(eccentric)}


def forces_gravity_gradient(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Libration in pitch: q'' = -3/2*n^2*(Iyy - Ixx)/Izz*sin(2*q) (P. Hughes, Spacecraft Attitude Dynamics)."""
    rate = 1.5 * p["mu"] / p["radius"] ** 3 * (p["field.I[2]"] - p["field.I[1]"]) / p["satellite.Izz"]
    return {"pitch.q": solve(lambda _, x: [x[1], -rate * np.sin(2 * x[0])], [np.radians(30), 0], t)[0]}


def forces_bushing(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Three linear oscillators; the twist has the energy k*(1 - cos(q)) of a pendulum."""
    m = p["block.m"]
    found = {}
    for axis, start in enumerate((1e-3, 2e-3, -1e-3), 1):
        k, c = p[f"rubber.k[{axis}]"], p[f"rubber.c[{axis}]"]
        found[f"motion.r[{axis}]"] = linear([[0, 1], [-k / m, -c / m]], [start, 0], t)[0]
    stiffness = p["rubber.k_turn[3]"] / p["block.I[3]"]
    twist = solve(lambda _, x: [x[1], -stiffness * np.sin(x[0])], [np.radians(80), 0], t)[0]
    return found | {"motion.angles[3]": twist, "motion.angles[1]": 0 * t}


def forces_speed_drives(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Moment of the weight at constant rate; weight and inertia at constant acceleration."""
    q = np.radians(30) + 0.4 * t
    return {
        "shoulder.q": q,
        "hoist.s": 0.15 * t**2,
        "swing_torque": p["arm.m"] * G_N * p["arm.l"] / 2 * np.cos(q),
        "rope": p["load.m"] * (G_N + 0.3) + 0 * t,
    }


def forces_torsion(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Overdamped oscillator about a vertical hinge."""
    length, width = p["door.r[1]"], p["door.width"]
    mass = p["door.density"] * length * width * p["door.height"]
    inertia = mass * (length**2 / 3 + width**2 / 12)
    matrix = [[0, 1], [-p["closer.k"] / inertia, -p["damper.c"] / inertia]]
    return {"hinge.q": linear(matrix, [np.radians(60), 0], t)[0]}
