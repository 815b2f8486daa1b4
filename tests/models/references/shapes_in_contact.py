"""Balls, boxes and wheels in rigid contact with dry friction: closed forms."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from models.references.components_with_friction import _way
from models.references.integrate import G_N, Floats

Parameters = Mapping[str, float]


def balls_in_contact(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Equal bodies that meet with the speeds v_n along and v_t across their centers have the impulses (1 + e) m v_n/2
    and the least of mu times this and what ends the slip: m v_t/7 of balls, m v_t/6 of discs."""
    m, R, e, v = p["m"], p["R"], p["e"], p["v"]
    aside = 0.12
    along = np.sqrt(4 * R**2 - aside**2)
    meet = (0.5 - along) / v
    n, across = np.array([along, aside]) / (2 * R), np.array([aside, -along]) / (2 * R)
    columns: dict[str, Floats] = {}
    since = np.maximum(t - meet, 0.0)
    fall = -G_N * t**2 / 2
    for (first, second), mu, share, names, height in (
        (("first.r", "second.r"), p["mu"], 7, ("[1]", "[3]"), True),
        (("left", "right"), 0.9, 6, (".x", ".y"), False),
    ):
        push = (1 + e) * m * v * n[0] / 2
        rub = min(mu * push, m * v * across[0] / share)
        rate = (push * n + rub * across) / m
        for k, name in enumerate(names):
            own = fall if name == ".y" else 0 * t
            columns[first + name] = (v * t if k == 0 else 0 * t) - rate[k] * since + own
            columns[second + name] = (0.5 if k == 0 else aside) + rate[k] * since + own
        if height:
            columns[first + "[2]"] = columns[second + "[2]"] = fall
        else:
            columns["left.q"] = columns["right.q"] = rub * R / (m * R**2 / 2) * since
    return columns


def boxes_in_contact(p: Parameters, t: Floats) -> dict[str, Floats]:
    """v^2/(2 mu g) for all that slide. Moments about the rear foot of the sled give the load of the front one."""
    v, brake = p["v"], p["mu"] * G_N
    way = _way(v, [(0.0, -brake), (v / brake, 0.0)], t)[0]
    c, s = np.cos(np.radians(15)), np.sin(np.radians(15))
    front = p["m"] * G_N * (2 * c - s) / 4
    return {
        "motion.r[1]": 0.8 * way,
        "motion.r[3]": 0.6 * way,
        "motion.r[2]": p["a"] / 2 + 0 * t,
        "slide.x": way,
        "slide.y": p["a"] / 2 + 0 * t,
        "stands.x": 0 * t,
        "stands.y": p["a"] + 0 * t,
        "N_front": front + 0 * t,
        "N_rear": p["m"] * G_N * c - front + 0 * t,
        "skids.r[3]": way,
    }


def wheels_in_contact(p: Parameters, t: Floats) -> dict[str, Floats]:
    """A spinning wheel has the acceleration mu g until w R = 3 mu g t; a coin that slides is braked by it as long as
    v > 3 mu g t."""
    a = p["mu"] * G_N
    grips, rolls = p["w"] * p["R"] / (3 * a), p["v"] / (3 * a)
    return {
        "drive.x": _way(0.0, [(0.0, a), (grips, 0.0)], t)[0],
        "drive.y": p["R"] + 0 * t,
        "der(drive.q)": _way(-p["w"], [(0.0, 2 * a / p["R"]), (grips, 0.0)], t)[1],
        "slides.r[1]": _way(p["v"], [(0.0, -a), (rolls, 0.0)], t)[0],
        "slides.r[2]": p["R"] + 0 * t,
    }


def cylinder_on_an_incline(p: Parameters, t: Floats) -> dict[str, Floats]:
    return {"rolls.r[1]": G_N * np.sin(p["slope"]) * t**2 / 3, "rolls.r[2]": p["R"] + 0 * t}


def ball_on_an_incline(p: Parameters, t: Floats) -> dict[str, Floats]:
    """It rolls with 5/7 g sin(slope); with less friction it slides with g (sin - mu cos)."""
    slides = p["mu"] < 2 / 7 * np.tan(p["slope"])
    share = np.sin(p["slope"]) - p["mu"] * np.cos(p["slope"]) if slides else 5 / 7 * np.sin(p["slope"])
    return {"rolls.r[1]": G_N * share * t**2 / 2, "rolls.r[2]": p["R"] + 0 * t}
