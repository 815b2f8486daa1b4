"""Parts that stop, press and rub: rigid stops, play with elastic flanks, a plane with friction."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from models.references.hybrid import Guard, Jump, Mode, Motion
from models.references.integrate import G_N, Floats

Parameters = Mapping[str, float]


def end_stops(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Straight lines from stop to stop, each e times as fast as the one before."""
    slide = _between(1.0, p["ends.s_min"], p["ends.s_max"], p["ends.e"], t)
    return {"slide.s": slide, "shaft.phi": _between(3.0, p["stops.phi_min"], p["stops.phi_max"], p["stops.e"], t)}


def _between(speed: float, low: float, high: float, e: float, t: Floats) -> Floats:
    begin, place, x = 0.0, 0.0, np.zeros_like(t)
    while begin <= t[-1]:
        x = np.where(t >= begin, place + speed * (t - begin), x)
        target = high if speed > 0 else low
        begin, place, speed = begin + (target - place) / speed, target, -e * speed
    return x


def parts_with_play(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Both pairs of masses move apart from their centers of mass like one reduced mass each."""
    a, b = p["wagon.m"], p["other.m"]
    gap = _pressed(a * b / (a + b), p["buffer.k"], p["buffer.d"], [(1.0, p["buffer.rest"])], [0.2, -1.0], t)
    center = (b * 0.2 + a * t) / (a + b)
    i, j = p["motor.J"], p["load.J"]
    flanks = [(1.0, -p["teeth.play"] / 2), (-1.0, -p["teeth.play"] / 2)]
    twist = _pressed(i * j / (i + j), p["teeth.k"], p["teeth.d"], flanks, [0.0, 2.0], t)
    middle = i * 2.0 * t / (i + j)
    return {
        "wagon.s": center - b / (a + b) * gap,
        "other.s": center + a / (a + b) * gap,
        "motor.phi": middle + j / (i + j) * twist,
        "load.phi": middle - i / (i + j) * twist,
    }


def _pressed(
    mass: float, k: float, d: float, flanks: list[tuple[float, float]], start: list[float], t: Floats
) -> Floats:
    """x with k c (1 + d c') at each flank (side, place), c = place - side x being the compression."""

    def pushing(side: float, place: float) -> Mode:
        def rates(_: float, x: Floats) -> ArrayLike:
            return [x[1], side * k * (place - side * x[0]) * (1 - d * side * x[1]) / mass]

        return Mode(rates, [(lambda _, x: place - side * x[0], lambda _, x: ("free", x))])

    def meeting(index: int, side: float, place: float) -> tuple[Guard, Jump]:
        return (lambda _, x: side * x[0] - place), (lambda _, x: (f"flank {index}", x))

    free = Mode(lambda _, x: [x[1], 0.0], [meeting(n, *flank) for n, flank in enumerate(flanks)])
    modes = {"free": free, **{f"flank {n}": pushing(*flank) for n, flank in enumerate(flanks)}}
    return np.asarray(Motion(lambda name, _: modes[name], "free", start, t).x[0])


def sliding_on_a_plane(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The particle stays on the ground once it has landed, as this integration verifies."""
    m, k, d, mu, v_0 = p["m"], p["ground.k"], p["ground.d"], p["ground.mu"], 5e-3
    along, down = G_N * np.sin(p["slope"]), G_N * np.cos(p["slope"])

    def flight(_: float, x: Floats) -> ArrayLike:
        return [x[2], x[3], along, -down]

    def pressed(_: float, x: Floats) -> ArrayLike:
        force = max(-k * x[1] * (1 - d * x[3]), 0.0)
        return [x[2], x[3], along - mu * force / m * x[2] / np.hypot(x[2], v_0), force / m - down]

    modes = {
        "flight": Mode(flight, [(lambda _, x: x[1], lambda _, x: ("pressed", x))]),
        "pressed": Mode(pressed, [(lambda _, x: -x[1], lambda _, x: ("flight", x))]),
    }
    x = Motion(lambda name, _: modes[name], "flight", [0.0, 1e-3, 0.4, 0.0], t).x
    low, high, v_s = (p[f"pad.{name}"] for name in ("mu", "mu_b", "v_s"))

    def pad(_: float, z: Floats) -> ArrayLike:
        return [z[1], -6.0 * (low + (high - low) * np.exp(-((z[1] / v_s) ** 2))) / 2]

    rubbing = {
        "slides": Mode(pad, [(lambda _, z: z[1], lambda _, z: ("rests", [z[0], 0.0]))]),
        "rests": Mode(lambda *_: [0.0, 0.0]),
    }
    s = Motion(lambda name, _: rubbing[name], "slides", [0.0, 0.5], t).x[0]
    return {"x": x[0], "y": x[1], "s": s}
