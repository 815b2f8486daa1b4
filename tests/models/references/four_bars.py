"""The four-bar linkage as three free bars held by pins: angles and the force in the pin between coupler and rocker."""

from collections.abc import Mapping
from functools import cache

import numpy as np

from models.references.integrate import G_N, Floats
from models.references.newton_euler import GROUND, Body, Point, motion, revolute, spherical, turned

Parameters = Mapping[str, float]

LENGTHS, MASSES, GROUND_LINK, CRANK = (0.4, 1.0, 0.8), (1.0, 2.0, 1.5), 1.0, np.radians(60)


def four_bar(_: Parameters, t: Floats) -> dict[str, Floats]:
    """Joint angles as the components count them; the rocker's own x axis points from C to D."""
    a, b, c, pin = _bars(tuple(t))
    start = np.radians([60, -30, -110])
    relative = {"A.q": a, "B.q": b - a, "C.q": c + np.pi - b, "D.q": -c - np.pi}
    columns = {name: q - 2 * np.pi * np.round((q[0] - s) / (2 * np.pi)) for (name, q), s in zip(
        relative.items(), [*start, np.radians(96.75)], strict=True
    )}  # fmt: skip
    return columns | {f"pinC[{k + 1}]": pin[:, k] for k in range(3)}


def four_bar_spatial(p: Parameters, t: Floats) -> dict[str, Floats]:
    """The same joints, turning in space."""
    return four_bar(p, t)


def four_bar_points(_: Parameters, t: Floats) -> dict[str, Floats]:
    """Angles from the horizontal."""
    a, b, c, pin = _bars(tuple(t))
    return {"a": a, "b": b, "c": c} | {f"pinC[{k + 1}]": pin[:, k] for k in range(3)}


def four_bar_crank(_: Parameters, t: Floats) -> dict[str, Floats]:
    """The crank angle, and the pin's force as the model works it out."""
    a, _b, _c, pin = _bars(tuple(t))
    return {"a": a} | {f"pinC[{k + 1}]": pin[:, k] for k in range(3)}


@cache
def _bars(times: tuple[float, ...]) -> tuple[Floats, Floats, Floats, Floats]:
    """Angles of crank, coupler and rocker (from D to C) from the horizontal; force of the coupler on the rocker.

    The crank turns about z; the other pins are ball joints, which the plane motion does not notice.
    """
    b, c = _closed(CRANK)
    ends = np.array([[0, 0, 0], [*(LENGTHS[0] * _along(CRANK)), 0], [GROUND_LINK, 0, 0]])
    angles = (CRANK, b, c)
    bars = [
        Body(m, m * l**2 / 12 * np.eye(3), end + np.array([*(l / 2 * _along(q)), 0]), turned("z", q), *np.zeros((2, 3)))
        for m, l, end, q in zip(MASSES, LENGTHS, ends, angles, strict=True)
    ]
    near = [Point(i, np.array([-l / 2, 0, 0])) for i, l in enumerate(LENGTHS)]
    far = [Point(i, np.array([l / 2, 0, 0])) for i, l in enumerate(LENGTHS)]
    x, y, z = np.eye(3)
    axis, across = Point(0, z), (Point(GROUND, x), Point(GROUND, y))
    joints = [
        *revolute(near[0], Point(GROUND, np.zeros(3)), axis, across),
        spherical(near[1], far[0]),
        spherical(near[2], Point(GROUND, np.array([GROUND_LINK, 0, 0]))),
        spherical(far[2], far[1]),
    ]
    weights = [(Point(i, np.zeros(3)), np.array([0, -m * G_N, 0]), np.zeros(3)) for i, m in enumerate(MASSES)]
    states, _, forces = motion(bars, joints, lambda *_: weights, np.array(times))
    turned_by = [np.unwrap([np.arctan2(s.R[i, 1, 0], s.R[i, 0, 0]) for s in states]) for i in range(3)]
    return turned_by[0], turned_by[1], turned_by[2], np.array([f[-3:] for f in forces])


def _along(angle: float) -> Floats:
    return np.array([np.cos(angle), np.sin(angle)])


def _closed(a: float) -> tuple[float, float]:
    """Directions of coupler and rocker: two circles meet above the line of their centers."""
    _, l2, l3 = LENGTHS
    reach = np.array([GROUND_LINK, 0]) - LENGTHS[0] * _along(a)
    s = float(np.hypot(*reach))
    b = float(np.arctan2(reach[1], reach[0]) + np.arccos((l2**2 + s**2 - l3**2) / (2 * l2 * s)))
    tip = l2 * _along(b) - reach
    return b, float(np.arctan2(tip[1], tip[0]))
