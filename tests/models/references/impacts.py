"""Impacts and contacts: balls, a ladder, a sphere, a wheel of spokes."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import ellipj, ellipk

from models.references.hybrid import Mode, Motion
from models.references.integrate import G_N, Floats, solve

Parameters = Mapping[str, float]


def bouncing_ball(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Parabolas, until their times accumulate."""
    return {"h": _flights(0.8, t, until=1e-9)}


def bouncing_ball_modelica(p: Parameters, t: Floats) -> dict[str, Floats]:
    return {"h": _flights(p["e"], t, until=0.0)}


def _flights(e: float, t: Floats, until: float) -> Floats:
    """Height of a ball dropped from 1 m at rest."""
    begin, speed = np.sqrt(2 / G_N), np.sqrt(2 * G_N)
    first, h = speed, 1 - G_N * t**2 / 2
    while begin < t[-1] and speed * e >= until * first:
        speed *= e
        flown = t - begin
        h = np.where(flown > 0, speed * flown - G_N * flown**2 / 2, h)
        begin += 2 * speed / G_N
    return np.where(t < begin, h, 0.0)


def bouncing_ball_compliant(p: Parameters, t: Floats) -> dict[str, Floats]:
    """k d (1 + damping d') at the penetration d."""
    m, k, d = p["m"], p["k"], p["d"]

    def free(_: float, x: Floats) -> ArrayLike:
        return [x[1], -G_N]

    def pressed(_: float, x: Floats) -> ArrayLike:
        return [x[1], -G_N - k / m * x[0] * (1 - d * x[1])]

    modes = {
        "free": Mode(free, [(lambda _, x: x[0], lambda _, x: ("pressed", x))]),
        "pressed": Mode(pressed, [(lambda _, x: -x[0], lambda _, x: ("free", x))]),
    }
    x = Motion(lambda name, _: modes[name], "free", [1.0, 0.0], t).x
    return {"h": x[0], "der(h)": x[1]}


def newtons_cradle(p: Parameters, t: Floats) -> dict[str, Floats]:
    """First and last ball swing in turn, half a period of the pendulum each; the others hang."""
    l, amplitude = p["l"], np.radians(30)
    k, omega = np.sin(amplitude / 2) ** 2, np.sqrt(G_N / l)
    quarter = ellipk(k) / omega
    sn = ellipj(omega * (t + quarter), k)[0]
    angle = -2 * np.arcsin(np.sqrt(k) * sn)
    left, right = np.minimum(angle, 0), np.maximum(angle, 0)
    hang = np.zeros_like(t)
    return {"theta[1]": left, "theta[2]": hang, "theta[3]": hang, "theta[4]": hang, "theta[5]": right}


def ball_on_moving_table(p: Parameters, t: Floats) -> dict[str, Floats]:
    """It rests where the table presses; it stays after an impact where what is left of the series is shorter than
    a millionth of the experiment."""
    amplitude, w, e = p["A"], p["w"], p["e"]
    length = t[-1] - t[0]

    def table(time: float) -> tuple[float, float, float]:
        return (
            amplitude * np.sin(w * time),
            amplitude * w * np.cos(w * time),
            -amplitude * w**2 * np.sin(w * time),
        )

    def struck(time: float, x: Floats) -> tuple[str, ArrayLike]:
        position, rate, acceleration = table(time)
        approach = rate - x[1]
        back = G_N + acceleration
        stays = back > 0 and 2 * e * approach / back / (1 - e) < 1e-6 * length
        return ("rests", [position, rate]) if stays else ("flies", [position, rate + e * approach])

    modes = {
        "rests": Mode(
            lambda time, _: table(time)[1:], [(lambda time, _: G_N + table(time)[2], lambda _, x: ("flies", x))]
        ),
        "flies": Mode(lambda _, x: [x[1], -G_N], [(lambda time, x: x[0] - table(time)[0], struck)]),
    }
    motion = Motion(lambda name, _: modes[name], "rests", [0.0, amplitude * w], t)
    rests = (motion.modes == "rests").astype(float)
    force = rests * 0.1 * (G_N - amplitude * w**2 * np.sin(w * t))
    return {"h": motion.x[0], "der(h)": motion.x[1], "rests": rests, "N": force}


def block_on_incline(p: Parameters, t: Floats) -> dict[str, Floats]:
    down, across = G_N * np.sin(p["slope"]), p["mu"] * G_N * np.cos(p["slope"])
    x = solve(lambda _, x: [x[1], -down - across * np.tanh(x[1] / p["v0"])], [0.0, 2.0], t)
    return {"s": x[0], "der(s)": x[1], "friction": p["m"] * across * np.tanh(x[1] / p["v0"])}


def ladder_leaving_wall(p: Parameters, t: Floats) -> dict[str, Floats]:
    """At the wall: theta'' = -3 g cos(theta)/(2 l), until the wall does not push. Then the middle keeps its speed, and
    (1/12 + cos^2/4) theta'' = sin cos theta'^2/4 - g cos/(2 l)."""
    l, m = p["l"], p["m"]

    def at_wall(_: float, x: Floats) -> ArrayLike:
        theta, rate, _, _ = x
        return [rate, -1.5 * G_N / l * np.cos(theta), -l / 2 * np.sin(theta) * rate, 0.0]

    def free(_: float, x: Floats) -> ArrayLike:
        theta, rate, _, speed = x
        s, c = np.sin(theta), np.cos(theta)
        return [rate, (s * c * rate**2 / 4 - G_N / (2 * l) * c) / (1 / 12 + c**2 / 4), speed, 0.0]

    def wall(x: Floats) -> Floats:
        theta, rate = x[:2]
        return m * l / 2 * (1.5 * G_N / l * np.sin(theta) * np.cos(theta) - np.cos(theta) * rate**2)

    def leave(_: float, x: Floats) -> tuple[str, ArrayLike]:
        return "free", [x[0], x[1], x[2], -l / 2 * np.sin(x[0]) * x[1]]

    modes = {"wall": Mode(at_wall, [(lambda _, x: float(wall(x)), leave)]), "free": Mode(free)}
    motion = Motion(lambda name, _: modes[name], "wall", [p["lean"], 0.0, l / 2 * np.cos(p["lean"]), 0.0], t)
    leaning = motion.modes == "wall"
    theta = motion.x[0]
    return {
        "phi": np.pi - theta,
        "x": motion.x[2],
        "y": l / 2 * np.sin(theta),
        "N_wall": np.where(leaning, wall(motion.x), 0.0),
        "at_wall": leaning.astype(float),
    }


def particle_on_sphere(p: Parameters, t: Floats) -> dict[str, Floats]:
    """theta'' = g sin(theta)/R while g cos(theta) > R theta'^2, then a parabola."""
    radius = p["R"]

    def slide(_: float, x: Floats) -> ArrayLike:
        return [x[1], G_N / radius * np.sin(x[0]), 0.0, 0.0]

    def leave(_: float, x: Floats) -> tuple[str, ArrayLike]:
        s, c = radius * np.sin(x[0]), radius * np.cos(x[0])
        return "fly", [s, c, c * x[1], -s * x[1]]

    modes = {
        "slide": Mode(slide, [(lambda _, x: G_N * np.cos(x[0]) - radius * x[1] ** 2, leave)]),
        "fly": Mode(lambda _, x: [x[2], x[3], 0.0, -G_N]),
    }
    motion = Motion(lambda name, _: modes[name], "slide", [p["theta0"], 0.0, 0.0, 0.0], t)
    slides, (first, second) = motion.modes == "slide", motion.x[:2]
    force = p["m"] * (G_N * np.cos(first) - radius * second**2)
    return {
        "x": np.where(slides, radius * np.sin(first), first),
        "y": np.where(slides, radius * np.cos(first), second),
        "N": np.where(slides, force, 0.0),
        "slides": slides.astype(float),
    }


def rimless_wheel(p: Parameters, t: Floats) -> dict[str, Floats]:
    """A pendulum upside down on the standing spoke; the angular momentum about the spoke that lands is kept (McGeer,
    Passive dynamic walking, Int. J. Robotics Res. 9 (1990)). Angles are positive downhill."""
    alpha, inertia, m, l = np.pi / 8, p["J"] + p["m"] * p["l"] ** 2, p["m"], p["l"]
    kept = (p["J"] + m * l**2 * np.cos(2 * alpha)) / inertia

    def stand(_: float, x: Floats) -> ArrayLike:
        return [x[1], m * G_N * l / inertia * np.sin(x[0] + p["slope"]), 0.0]

    def land(_: float, x: Floats) -> tuple[str, ArrayLike]:
        return "stand", [x[0] - 2 * alpha, kept * x[1], x[2] + 1.0]

    mode = Mode(stand, [(lambda _, x: alpha - x[0], land)])
    lean, rate, steps = Motion(lambda *_: mode, "stand", [0.0, 1.0, 0.0], t).x
    return {
        "theta": -(lean + 2 * alpha * steps),
        "speed": rate,
        "x": 2 * l * np.sin(alpha) * steps + l * np.sin(lean),
        "y": l * np.cos(lean),
        "steps": steps,
    }
