"""Dry friction of one body: it slides with Coulomb's force and sticks below it. Closed forms."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.optimize import brentq

from models.references.integrate import G_N, Floats

Parameters = Mapping[str, float]


def block_on_slope(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Braked by weight and friction, then at rest for mu >= tan(slope)."""
    across = p["m"] * G_N * np.cos(p["slope"])
    brake = G_N * (np.sin(p["slope"]) + p["mu"] * np.cos(p["slope"]))
    s, rate = _braked(p["v0"], brake, t)
    return {"s": s, "der(s)": rate, "h": 0 * t, "N": across + 0 * t}


def _braked(speed: float, brake: float, t: Floats) -> tuple[Floats, Floats]:
    """Way and speed under a constant deceleration, at rest from its end on."""
    moving = np.minimum(t, speed / brake)
    return speed * moving - brake * moving**2 / 2, np.maximum(speed - brake * t, 0.0)


def sliding_cube(p: Parameters, t: Floats) -> dict[str, Floats]:
    """v^2/(2 mu g); the friction below the mass center loads the front corner: mu m g a/2 = (N_front - N_rear) a/2."""
    x, rate = _braked(p["v0"], p["mu"] * G_N, t)
    return {"x": x, "der(x)": rate, "y": p["a"] / 2 + 0 * t, "phi": 0 * t}


def table_on_four_legs(p: Parameters, t: Floats) -> dict[str, Floats]:
    """All feet slide in one direction: their loads do not matter."""
    way, rate = _braked(1.3, p["mu"] * G_N, t)
    rest = dict.fromkeys(("yaw", "pitch", "roll"), 0 * t)
    return {
        "x": 12 / 13 * way,
        "y": -5 / 13 * way,
        "z": p["h"] + 0 * t,
        "der(x)": 12 / 13 * rate,
        "der(y)": -5 / 13 * rate,
        "N": p["m"] * G_N + 0 * t,
        **rest,
    }


def coulomb_oscillator(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Half swings about +-R/k, each shorter by 2 R/k; at rest where the spring is weaker than friction (J. P. Den
    Hartog, Mechanical Vibrations, section 8.6)."""
    shift, w = p["R"] / p["k"], np.sqrt(p["k"] / p["m"])
    begin, place, x, v = 0.0, p["x0"], 0 * t, 0 * t
    while abs(place) > shift:
        middle, angle = np.sign(place) * shift, w * (t - begin)
        now = (angle >= 0) & (angle <= np.pi)
        x = np.where(now, middle + (place - middle) * np.cos(angle), x)
        v = np.where(now, -(place - middle) * w * np.sin(angle), v)
        begin, place = begin + np.pi / w, 2 * middle - place
    rests = t > begin
    return {"x": np.where(rests, place, x), "der(x)": np.where(rests, 0.0, v)}


def stick_slip_belt(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Carried with the belt until the spring reaches the limit at rest; then a harmonic swing about the limit of
    sliding until it is as fast as the belt."""
    w = np.sqrt(p["k"] / p["m"])
    edge, middle, u = p["sticking"] / p["k"], p["sliding"] / p["k"], p["belt"]
    phase = np.arctan2(u, w * (edge - middle))
    swing = (np.pi + 2 * phase) / w
    size = np.hypot(edge - middle, u / w)
    period = swing + 2 * (edge - middle) / u
    since = np.where(t < edge / u, t - edge / u, np.mod(t - edge / u, period))
    free = (since >= 0) & (since < swing)
    swung, v = middle + size * np.cos(w * since - phase), -size * w * np.sin(w * since - phase)
    carried = np.where(since < 0, edge + u * since, edge + u * (since - period))
    return {"x": np.where(free, swung, carried), "der(x)": np.where(free, v, u)}


def flywheel_brake(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Driven by the load, braked to rest, held, and driven again."""
    free, brake = p["load"] / p["J"], (p["brake"] - p["load"]) / p["J"]
    on, off = p["t_on"], p["t_off"]
    first = np.minimum(t, on)
    turned, fastest = p["w0"] * first + free * first**2 / 2, p["w0"] + free * on
    more, rate = _braked(fastest, brake, np.maximum(t - on, 0.0))
    late = np.maximum(t - off, 0.0)
    before = t < on
    return {
        "phi": turned + more + free * late**2 / 2,
        "der(phi)": np.where(before, p["w0"] + free * t, rate + free * late),
    }


def disc_starts_to_roll(p: Parameters, t: Floats) -> dict[str, Floats]:
    """mu g t slower, 2 mu g t faster at the rim: it rolls at two thirds of its speed."""
    return _rolling_out(p["v0"], 0.0, p["R"], p["mu"], 1 / 2, t)


def billiard_ball_with_draw(p: Parameters, t: Floats) -> dict[str, Floats]:
    """It rolls at (5 v0 - 2 R w0)/7 (G. Coriolis, Théorie mathématique des effets du jeu de billard, 1835)."""
    return _rolling_out(p["v0"], p["w0"], p["R"], p["mu"], 2 / 5, t)


def _rolling_out(v: float, w: float, R: float, mu: float, inertia: float, t: Floats) -> dict[str, Floats]:
    """A round body of the inertia `inertia` m R^2 with positive slip v + R w."""
    slides = (v + R * w) / (mu * G_N * (1 + 1 / inertia))
    moving, later = np.minimum(t, slides), np.maximum(t - slides, 0.0)
    rates = v - mu * G_N * moving, w - mu * G_N / (inertia * R) * moving
    return {
        "x": v * moving - mu * G_N * moving**2 / 2 + rates[0] * later,
        "phi": w * moving - mu * G_N / (inertia * R) * moving**2 / 2 + rates[1] * later,
        "der(x)": rates[0],
        "der(phi)": rates[1],
        "y": R + 0 * t,
    }


def billiard_ball_swerves(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The slip keeps its direction and loses 7/2 mu g: a parabola, then a straight line (Coriolis 1835)."""
    R, spin = p["R"], np.array([-60.0, 30.0])
    v = np.array([2.0, 0.0])
    slip = v + R * np.array([-spin[1], spin[0]])  # spin x (0, 0, -R)
    size = float(np.hypot(*slip))
    pull = p["mu"] * G_N * slip / size
    slides = size / (3.5 * p["mu"] * G_N)
    moving, later = np.minimum(t, slides), np.maximum(t - slides, 0.0)
    place = v[:, None] * moving - pull[:, None] * moving**2 / 2 + (v - pull * slides)[:, None] * later
    rates = v[:, None] - pull[:, None] * moving
    return {"x": place[0], "y": place[1], "der(x)": rates[0], "der(y)": rates[1], "z": R + 0 * t}


def puck_with_side_force(p: Parameters, t: Floats) -> dict[str, Floats]:
    """With u = tan(theta/2) of the angle theta from the force to the velocity, and n = friction/force: the speed is
    v0 u^(n - 1)(1 + u^2)/2, so time and place are powers of u, which goes from 1 to 0."""
    n, v0, a = 1 / p["part"], p["v0"], p["part"] * p["mu"] * G_N

    def power(k: float, u: Floats) -> Floats:
        """Integral of u^(k - 1) from u to 1."""
        return (1 - u**k) / k

    def time(u: Floats) -> Floats:
        return v0 / (2 * a) * (power(n - 1, u) + power(n + 1, u))

    end = float(time(np.array(0.0)))
    u = np.array([brentq(lambda u, s=s: float(time(u)) - s, 0.0, 1.0, xtol=1e-16) if s < end else 0.0 for s in t])
    speed, square = v0 * u ** (n - 1) * (1 + u**2) / 2, v0**2 / a
    return {
        "x": square / 2 * (power(2 * n - 1, u) + power(2 * n + 1, u)),
        "y": square / 4 * (power(2 * n - 2, u) - power(2 * n + 2, u)),
        "der(x)": speed * 2 * u / (1 + u**2),
        "der(y)": speed * (1 - u**2) / (1 + u**2),
    }
