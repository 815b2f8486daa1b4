"""Dry friction in machines: contacts that share loads, shoes, wedges, chains, corners that are struck.

Forces of contacts from the balance of forces at bodies cut free, as in lectures of statics.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from models.references.hybrid import Mode, Motion
from models.references.integrate import G_N, Floats, solve

Parameters = Mapping[str, float]


def wedge(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Constant forces: unknowns are the accelerations of wedge and block along the face, and two normal forces."""
    m, M, mu, floor = p["m"], p["M"], p["mu"], p["mu_floor"]
    s, c = np.sin(p["alpha"]), np.cos(p["alpha"])
    across = s - mu * c  # on the wedge to the left, for a normal force of one
    down = c + mu * s
    balance = np.array(
        [
            [M, 0.0, across, -floor],  # wedge: M X'' = -N (s - mu c) + mu_floor N_floor
            [0.0, 0.0, -down, 1.0],  # wedge, upright
            [m, m * c, -across, 0.0],  # block, to the right
            [0.0, -m * s, -down, 0.0],  # block, upwards
        ]
    )
    back, along, force, below = np.linalg.solve(balance, [0.0, M * G_N, 0.0, -m * G_N])
    assert back < 0 < along
    zero = 0 * t
    columns = {"X": back * t**2 / 2, "s": along * t**2 / 2, "Y": zero, "h": zero}
    return columns | {"N": force + zero, "N_floor": below + zero}


def wedge_under_load(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Weight W on the face needs W tan(alpha + rho), the floor mu (W + w); inertia adds to W. Without the push the
    wedge stops, and holds as alpha < 2 rho."""
    slope = np.tan(p["alpha"])
    need = np.tan(p["alpha"] + np.arctan(p["mu"])) + p["mu"]
    weight = p["M"] * G_N * need + p["mu"] * p["m"] * G_N
    inertia = p["m"] + p["M"] * slope * need
    begin, end = weight / p["rise"], p["t_off"]

    def driven(since: Floats) -> tuple[Floats, Floats]:
        return p["rise"] * since**3 / 6 / inertia, p["rise"] * since**2 / 2 / inertia

    x, rate = driven(np.clip(t - begin, 0.0, end - begin))
    speed, brake = driven(np.array(end - begin))[1], weight / inertia
    moving = np.clip(t - end, 0.0, speed / brake)
    x = x + speed * moving - brake * moving**2 / 2
    return {
        "x": x,
        "z": slope * x,
        "y": 0 * t,
        "der(x)": np.where(t > end, np.maximum(rate - brake * moving, 0.0), rate),
    }


def stacked_blocks(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Both at rest, both together, the upper one behind."""
    m1, m2, rise = p["m1"], p["m2"], p["rise"]
    below, between = p["mu1"] * (m1 + m2) * G_N, p["mu2"] * m2 * G_N
    starts = below / rise
    parts = (below + between * (m1 + m2) / m2) / rise

    def together(since: Floats) -> tuple[Floats, Floats]:
        return rise * since**3 / 6 / (m1 + m2), rise * since**2 / 2 / (m1 + m2)

    x, v = together(np.clip(t - starts, 0.0, parts - starts))
    late = np.maximum(t - parts, 0.0)
    first = (rise * parts - below - between) / m1
    lower = v * late + first * late**2 / 2 + rise * late**3 / 6 / m1
    upper = v * late + p["mu2"] * G_N * late**2 / 2
    zero = 0 * t
    return {
        "x1": x + lower,
        "x2": x + upper,
        "der(x1)": v + first * late + rise * late**2 / 2 / m1,
        "der(x2)": v + p["mu2"] * G_N * late,
        "N_floor": (m1 + m2) * G_N + zero,
        "N_between": m2 * G_N + zero,
    }


def pinched_capsule(p: Parameters, t: Floats) -> dict[str, Floats]:
    """2 mu F holds it; it falls from where that is less than its weight."""
    begin = (p["press"] - p["m"] * G_N / (2 * p["mu"])) / p["relax"] if p["relax"] else np.inf
    falls = np.maximum(t - begin, 0.0)
    force, zero = p["press"] - p["relax"] * t, 0 * t
    return {
        "y": -2 * p["mu"] * p["relax"] / p["m"] * falls**3 / 6,
        "x": zero,
        "l": -p["w"] + zero,
        "r": p["w"] + zero,
        "N_left": force,
        "N_right": force,
    }


def gripper(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The workpiece moves with the hand: m (g + A f^2) < 2 mu grip."""
    assert p["m"] * (G_N + p["A"] * p["f"] ** 2) < 2 * p["mu"] * p["grip"]
    zero = 0 * t
    return {
        "y": p["A"] * (1 - np.cos(p["f"] * t)),
        "der(y)": p["A"] * p["f"] * np.sin(p["f"] * t),
        "x": zero,
        "phi": zero,
        "l": p["w"] + zero,
        "N_left": p["grip"] + zero,
        "N_right": p["grip"] + zero,
    }


def drum_brake(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Moments about the pivots: N (b -+ mu a) = F (b + c). At rest the load is less than what the shoes hold."""
    leading = p["F"] * (p["b"] + p["c"]) / (p["b"] - p["mu"] * p["a"])
    trailing = p["F"] * (p["b"] + p["c"]) / (p["b"] + p["mu"] * p["a"])
    brake = (p["mu"] * p["R"] * (leading + trailing) - p["load"]) / p["J"]
    moving = np.minimum(t, p["w0"] / brake)
    zero = 0 * t
    return {
        "drum": p["w0"] * moving - brake * moving**2 / 2,
        "der(drum)": p["w0"] - brake * moving,
        "left": zero,
        "right": zero,
    }


def worm_gear(p: Parameters, t: Floats) -> dict[str, Floats]:
    """One normal force on the flank: r1 (sin + mu cos) N brakes the worm, r2 (cos - mu sin) N turns the wheel."""
    s, c, mu = np.sin(p["lead"]), np.cos(p["lead"]), p["mu"]
    worm, wheel = p["r1"] * (s + mu * c), p["r2"] * (c - mu * s)
    ratio = p["r1"] * s / (p["r2"] * c)

    def accelerated(drive: float) -> tuple[float, float]:
        """Acceleration of the worm, normal force."""
        force = (p["load"] + p["J2"] * ratio * drive / p["J1"]) / (wheel + p["J2"] * ratio * worm / p["J1"])
        assert force > 0
        return (drive - worm * force) / p["J1"], force

    up, down = accelerated(p["drive"])[0], -accelerated(0.0)[0]
    driven = np.minimum(t, p["t_off"])
    late = np.clip(t - p["t_off"], 0.0, up * p["t_off"] / down)
    turned = up * driven**2 / 2 + up * p["t_off"] * late - down * late**2 / 2
    rate = up * driven - down * late
    return {"worm": turned, "wheel": ratio * turned, "der(worm)": rate, "der(wheel)": ratio * rate}


def capstan(p: Parameters, t: Floats) -> dict[str, Floats]:
    """At a node where the chain turns by delta, (T' - T) cos(delta/2) = mu N and N = (T' + T) sin(delta/2)."""
    n = 40
    step = p["mu"] * np.tan(p["wrap"] / n / 2)
    zero = 0 * t
    columns = {f"a[{i}]": p["wrap"] / n * (i - 0.5) + zero for i in (1, n // 2, n)}
    columns |= {f"r[{i}]": p["R"] + zero for i in (1, n // 2, n)}
    return columns | {"load": p["hand"] * ((1 + step) / (1 - step)) ** n + zero}


def freewheel(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Together while the ratchet pushes: J_b (push cos + drag) > J_a..., else each for itself."""
    J_a, J_b, push, drag, w = p["J_a"], p["J_b"], p["push"], p["drag"], p["w"]

    def through(time: float, _: Floats) -> float:
        return (J_b * push * np.cos(w * time) + J_a * drag) / (J_a + J_b)

    def meet(time: float, x: Floats) -> tuple[str, ArrayLike]:
        common = (J_a * x[2] + J_b * x[3]) / (J_a + J_b)
        return ("together" if through(time, x) > 0 else "apart"), [x[0], x[1], common, common]

    def together(time: float, x: Floats) -> ArrayLike:
        common = (push * np.cos(w * time) - drag) / (J_a + J_b)
        return [x[2], x[3], common, common]

    modes = {
        "together": Mode(together, [(through, lambda _, x: ("apart", x))]),
        "apart": Mode(
            lambda time, x: [x[2], x[3], push * np.cos(w * time) / J_a, -drag / J_b],
            [(lambda _, x: x[3] - x[2], meet)],
            step=0.1,
        ),
    }
    motion = Motion(lambda name, _: modes[name], "together", [0.0, 0.0, 0.0, 0.0], t)
    a, b, da, db = motion.x
    return {"a": a, "b": b, "der(a)": da, "der(b)": db}


def ladder_with_friction(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Newton and Euler for the cut ladder: both ends slide, then the foot alone. State: angle to the floor and its
    rate, place and speed of the middle."""
    half, m, mu_f, mu_w = p["l"] / 2, p["m"], p["mu_floor"], p["mu_wall"]

    def forces(x: Floats, leaning: bool) -> Floats:
        """x'', angle'', force of the floor, force of the wall."""
        s, c = np.sin(x[0]), np.cos(x[0])
        balance = [
            [m, 0.0, mu_f, -1.0],
            [0.0, m * half * c, -1.0, -mu_w],
            [0.0, -m * half**2 / 3, -half * (c - mu_f * s), half * (s + mu_w * c)],
            [1.0, half * s, 0.0, 0.0] if leaning else [0.0, 0.0, 0.0, 1.0],
        ]
        known = [0.0, -m * G_N + m * half * s * x[1] ** 2, 0.0, -half * c * x[1] ** 2 if leaning else 0.0]
        return np.asarray(np.linalg.solve(balance, known))

    def rates(x: Floats, leaning: bool) -> ArrayLike:
        found = forces(x, leaning)
        return [x[1], found[1], x[3], found[0]]

    def wall(x: Floats) -> float:
        return float(forces(x, True)[3])

    modes = {
        "leaning": Mode(lambda _, x: rates(x, True), [(lambda _, x: wall(x), lambda _, x: ("free", x))]),
        "free": Mode(lambda _, x: rates(x, False)),
    }
    motion = Motion(lambda name, _: modes[name], "leaning", [p["lean"], 0.0, half * np.cos(p["lean"]), 0.0], t)
    leaning = motion.modes == "leaning"
    ground = np.array([forces(x, bool(on))[2] for x, on in zip(motion.x.T, leaning, strict=True)])
    at_wall = np.array([wall(x) if on else 0.0 for x, on in zip(motion.x.T, leaning, strict=True)])
    return {
        "phi": np.pi - motion.x[0],
        "x": motion.x[2],
        "y": half * np.sin(motion.x[0]),
        "N_ground": ground,
        "N_wall": at_wall,
    }


def painleve_rod(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The tip slides to the left: Newton and Euler with N at the tip and mu N to the right."""
    half, m, mu = p["l"] / 2, p["m"], p["mu"]

    def normal(x: Floats) -> float:
        s, c = np.sin(x[0]), np.cos(x[0])
        return float(m * (G_N - half * s * x[1] ** 2) / (1 + 3 * c * (c - mu * s)))

    def rates(_: float, x: Floats) -> ArrayLike:
        s, c = np.sin(x[0]), np.cos(x[0])
        return [x[1], normal(x) * half * (mu * s - c) / (m * half**2 / 3), x[3], mu * normal(x) / m]

    start = [p["lean"], p["w0"], 0.0, p["v0"] - half * np.sin(p["lean"]) * p["w0"]]
    phi, rate, x, speed = solve(rates, start, t)
    force = np.array([normal(each) for each in np.array([phi, rate, x, speed]).T])
    return {"phi": phi, "der(phi)": rate, "x": x, "der(x)": speed, "y": half * np.sin(phi), "N": force}


def tipping_box(p: Parameters, t: Floats) -> dict[str, Floats]:
    """At rest until the moment of the pull about the right corner is that of the weight, then a pendulum upside
    down."""
    m, b, h, rise = p["m"], p["b"], p["h"], p["rise"]
    begin = m * G_N * b / 2 / (rise * h)
    assert rise * t[-1] < p["mu"] * m * G_N

    def rates(time: float, x: Floats) -> ArrayLike:
        s, c = np.sin(x[0]), np.cos(x[0])
        weight = m * G_N * (b / 2 * c + h / 2 * s)
        return [x[1], (weight - rise * time * (h * c - b / 2 * s)) / (m * (b**2 + h**2) / 3)]

    modes = {
        "rests": Mode(lambda _, x: [0.0, 0.0], until=begin, then=lambda _, x: ("tips", x)),
        "tips": Mode(rates),
    }
    phi, rate = Motion(lambda name, _: modes[name], "rests", [0.0, 0.0], t).x
    s, c = np.sin(phi), np.cos(phi)
    return {
        "phi": phi,
        "der(phi)": rate,
        "x": b / 2 - b / 2 * c - h / 2 * s,
        "y": h / 2 * c - b / 2 * s,
    }


def rocking_block(p: Parameters, t: Floats) -> dict[str, Floats]:
    """About one corner, then about the other, with 1 - 3/2 sin^2 of the rate (G. W. Housner, Bull. Seism. Soc. Am. 53
    (1963) 403)."""
    R, angle = np.hypot(p["b"], p["h"]), np.arctan2(p["b"], p["h"])
    ratio, w = 1 - 1.5 * np.sin(angle) ** 2, np.sqrt(3 * G_N / (4 * R))

    def about(side: float, other: str) -> Mode:
        """side: 1 about the left corner, where the angle is positive."""

        def strike(_: float, x: Floats) -> tuple[str, ArrayLike]:
            return other, [0.0, ratio * x[1]]

        return Mode(
            lambda _, x: [x[1], -side * w**2 * np.sin(angle - side * x[0])], [(lambda _, x: side * x[0], strike)]
        )

    modes = {"left": about(1.0, "right"), "right": about(-1.0, "left")}
    motion = Motion(lambda name, _: modes[name], "left", [p["tilt"], 0.0], t)
    phi, rate = motion.x
    side = np.where(motion.modes == "left", 1.0, -1.0)
    way = angle - side * phi
    return {
        "phi": phi,
        "der(phi)": rate,
        "x": np.where(side > 0, 0.0, 2 * p["b"]) + side * R * np.sin(way),
        "y": R * np.cos(way),
    }


def standing_quadruped(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Legs bend alike, so the trunk moves up and down only: one freedom, the angle of the thighs."""
    l, bend, m = p["l"], p["bend"], p["m"]
    m1, m2, k, d = (p[f"leg[1].{name}"] for name in ("m1", "m2", "k", "d"))
    lifted = 2 * m + 4 * (1.5 * m1 + 0.5 * m2)

    def inertia(angle: float) -> tuple[float, float]:
        """With its derivative."""
        up = 4 * m + 4 * (2.25 * m1 + 0.25 * m2)
        along = m1 + m2
        s, c = np.sin(angle), np.cos(angle)
        return l**2 * (up * s**2 + along * c**2), 2 * l**2 * (up - along) * s * c

    def rates(_: float, x: Floats) -> ArrayLike:
        mass, change = inertia(x[0])
        force = lifted * G_N * l * np.sin(x[0]) - 4 * 5 * (k * (x[0] - bend) + d * x[1]) - change / 2 * x[1] ** 2
        return [x[1], force / mass]

    angle, rate = solve(rates, [bend, 0.0], t)
    zero = 0 * t
    return {
        "motion.r[3]": 2 * l * np.cos(angle),
        "leg[1].hip": angle,
        "leg[3].hip": -angle,
        "leg[2].knee": -2 * angle,
        "der(leg[1].hip)": rate,
        "motion.r[1]": zero,
        "motion.angles[2]": zero,
        "leg[4].side": zero,
    }
