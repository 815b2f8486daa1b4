"""Machines that strike, slip and have play."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from models.references.hybrid import Mode, Motion
from models.references.integrate import Floats

Parameters = Mapping[str, float]


def two_mass_drive(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The shaft carries where the twist is more than half of the play."""
    half, k, d = p["play"] / 2, p["k"], p["d"]

    def torque(side: float, x: Floats) -> Floats:
        return abs(side) * (k * (x[0] - x[1] - side * half) + d * (x[2] - x[3]))

    def rates(side: float, time: float, x: Floats) -> ArrayLike:
        shaft = torque(side, x)
        return [x[2], x[3], (p["drive"] * np.sin(6 * time) - shaft) / p["J1"], shaft / p["J2"]]

    modes = {
        "free": Mode(
            lambda time, x: rates(0.0, time, x),
            [
                (lambda _, x: half - (x[0] - x[1]), lambda _, x: ("ahead", x)),
                (lambda _, x: half + (x[0] - x[1]), lambda _, x: ("behind", x)),
            ],
        ),
        "ahead": Mode(
            lambda time, x: rates(1.0, time, x), [(lambda _, x: (x[0] - x[1]) - half, lambda _, x: ("free", x))]
        ),
        "behind": Mode(
            lambda time, x: rates(-1.0, time, x), [(lambda _, x: -(x[0] - x[1]) - half, lambda _, x: ("free", x))]
        ),
    }
    motion = Motion(lambda name, _: modes[name], "free", [0.0, 0.0, 0.0, 0.0], t)
    side = (motion.modes == "ahead") * 1.0 - (motion.modes == "behind") * 1.0
    return {"motor": motion.x[0], "load": motion.x[1], "der(load)": motion.x[3], "through": torque(side, motion.x)}


def clutch(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Slipping, the clutch gives what it bears; sticking, what holds both together, until that is too much."""
    J1, J2, drive = p["J1"], p["J2"], p["drive"]

    def load(time: float) -> float:
        return p["brake"] + (p["blow"] if 4.0 <= time < 4.2 else 0.0)

    def holding(time: float) -> float:
        return load(time) + J2 * (drive - load(time)) / (J1 + J2)

    def both(x: Floats) -> ArrayLike:
        common = (J1 * x[2] + J2 * x[3]) / (J1 + J2)
        return [x[0], x[1], common, common]

    def mode(name: str, time: float) -> Mode:
        until = next((end for end in (4.0, 4.2) if time < end), np.inf)
        middle = time + 1e-9
        through = p["sliding"] if name == "slips" else holding(middle)
        rates = [(drive - through) / J1, (through - load(middle)) / J2]

        def then(_: float, x: Floats) -> tuple[str, ArrayLike]:
            return ("slips" if name == "slips" or holding(until + 1e-9) > p["sticking"] else "sticks"), x

        ends = [(lambda _, x: x[2] - x[3], lambda _, x: ("sticks", both(x)))] if name == "slips" else []
        return Mode(lambda _, x: [x[2], x[3], *rates], ends, until=until, then=then)

    motion = Motion(mode, "slips", [0.0, 0.0, 100.0, 0.0], t)
    a, b, da, db = motion.x
    return {"a": a, "b": b, "der(a)": da, "der(b)": db}


def escapement(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Both turn freely after a tooth has slipped off, as one after the next has struck its pallet without rebound."""
    J, Jw, weight, r, R, release = p["J"], p["Jw"], p["weight"], p["r"], p["R"], p["release"]
    pitch = 2 * r * release + p["drop"]

    def push(side: float) -> Mode:
        """R wheel = side r foliot + constant."""
        ratio = side * r / R
        angular = weight * ratio / (J + Jw * ratio**2)

        def slip(_: float, x: Floats) -> tuple[str, ArrayLike]:
            return ("to lower" if side > 0 else "to upper"), [*x[:4], x[4] + 1.0]

        return Mode(
            lambda _, x: [x[2], x[3], angular, ratio * angular, 0.0], [(lambda _, x: release - side * x[0], slip)]
        )

    def turn(side: float) -> Mode:
        ratio = side * r / R

        def strike(_: float, x: Floats) -> tuple[str, ArrayLike]:
            after = (J * x[2] + Jw * ratio * x[3]) / (J + Jw * ratio**2)
            return ("upper" if side > 0 else "lower"), [x[0], x[1], after, ratio * after, x[4]]

        return Mode(
            lambda _, x: [x[2], x[3], 0.0, weight / Jw, 0.0],
            [(lambda _, x: side * r * x[0] + pitch * x[4] - R * x[1], strike)],
        )

    modes = {"upper": push(1.0), "lower": push(-1.0), "to upper": turn(1.0), "to lower": turn(-1.0)}
    ratio = r / R
    first = -2.0 * J / (J + Jw * ratio**2)
    motion = Motion(lambda name, _: modes[name], "upper", [0.0, 0.0, first, ratio * first, 0.0], t)
    columns = {"foliot": motion.x[0], "wheel": motion.x[1], "der(foliot)": motion.x[2], "der(wheel)": motion.x[3]}
    force = weight / (R + Jw / J * r**2 / R)
    return columns | {
        "push[1]": force * (motion.modes == "upper"),
        "push[2]": force * (motion.modes == "lower"),
    }


def valve_train(p: Parameters, t: Floats) -> dict[str, Floats]:
    """On its seat, on the cam, in flight between. A contact that was struck holds where what is left of
    the series of its bounces is shorter than a millionth of the experiment."""
    m, J, k, preload = p["m"], p["J"], p["k"], p["preload"]
    lift = _Lift(p["lift"], p["lash"], p["duration"])
    tappet, seat = (_Contact(e, 1e-6 * (t[-1] - t[0])) for e in (0.2, 0.3))

    def apart(_: float, x: Floats) -> ArrayLike:
        return [x[2], x[3], 0.0, -(k * x[1] + preload) / m]

    def together(x: Floats) -> tuple[float, float]:
        """Acceleration of cam and valve that touch."""
        slope, bend = lift.slope(x[0]), lift.curvature(x[0]) * x[2] ** 2
        turning = -slope * (k * x[1] + preload + m * bend) / (J + m * slope**2)
        return turning, slope * turning + bend

    def pressing(_: float, x: Floats) -> float:
        return m * together(x)[1] + k * x[1] + preload

    def cam_strikes(_: float, x: Floats) -> tuple[str, ArrayLike]:
        slope = lift.slope(x[0])
        approach = slope * x[2] - x[3]
        after, holds = tappet.struck(approach, (k * x[1] + preload) / m + lift.curvature(x[0]) * x[2] ** 2)
        blow = (approach + after) / (1 / m + slope**2 / J)
        return ("follows" if holds else "flies"), [x[0], x[1], x[2] - slope * blow / J, x[3] + blow / m]

    def sits(_: float, x: Floats) -> tuple[str, ArrayLike]:
        after, holds = seat.struck(-x[3], (k * x[1] + preload) / m)
        return ("sits", [x[0], 0.0, x[2], 0.0]) if holds else ("flies", [x[0], 0.0, x[2], after])

    def gap(_: float, x: Floats) -> float:
        return float(x[1] - lift(x[0]))

    step = 1e-4
    modes = {
        "sits": Mode(lambda _, x: [x[2], 0.0, 0.0, 0.0], [(gap, cam_strikes)], step=step),
        "flies": Mode(apart, [(gap, cam_strikes), (lambda _, x: x[1], sits)], step=step),
        "follows": Mode(
            lambda _, x: [x[2], x[3], *together(x)],
            [(pressing, lambda _, x: ("flies", x)), (lambda _, x: x[1], sits)],
            step=step,
        ),
    }
    motion = Motion(lambda name, _: modes[name], "sits", [0.0, 0.0, 120 * np.pi, 0.0], t)
    force = [pressing(0.0, x) if mode == "follows" else 0.0 for x, mode in zip(motion.x.T, motion.modes, strict=True)]
    return {
        "cam": motion.x[0],
        "valve": motion.x[1],
        "der(cam)": motion.x[2],
        "der(valve)": motion.x[3],
        "on_cam": np.array(force),
        "on_seat": preload * (motion.modes == "sits"),
    }


class _Lift:
    """lift sin^2 over the duration, less the lash; by the angle of the cam."""

    def __init__(self, height: float, lash: float, duration: float) -> None:
        self._half, self._lash, self._duration, self._w = height / 2, lash, duration, 2 * np.pi / duration

    def __call__(self, cam: float) -> float:
        return float(self._half * (1 - np.cos(self._turned(cam))) - self._lash)

    def slope(self, cam: float) -> float:
        return float(self._half * self._w * np.sin(self._turned(cam)))

    def curvature(self, cam: float) -> float:
        up = cam % (2 * np.pi) < self._duration
        return float(up * self._half * self._w**2 * np.cos(self._turned(cam)))

    def _turned(self, cam: float) -> float:
        turned = cam % (2 * np.pi)
        return float(self._w * turned) if turned < self._duration else 0.0


class _Contact:
    """Newton's law of impact, and when it ends in holding."""

    def __init__(self, e: float, rest: float) -> None:
        self._e, self._rest = e, rest

    def struck(self, approach: float, back: float) -> tuple[float, bool]:
        """Speed of rebound, and whether the contact holds, which ends it; `back`: acceleration towards it in flight."""
        after = self._e * approach
        holds = after <= 0 or (back > 0 and 2 * after / back / (1 - self._e) < self._rest)
        return (0.0 if holds else after), holds
