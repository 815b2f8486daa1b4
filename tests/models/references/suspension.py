"""A corner of a car on a double wishbone: four free bodies held by ball joints, hinges and a tie rod."""

from collections.abc import Callable, Mapping

import numpy as np

from models.references.integrate import G_N, Floats
from models.references.newton_euler import (
    Body,
    Joint,
    Load,
    Point,
    Rows,
    State,
    distance,
    motion,
    perpendicular,
    spherical,
)

Parameters = Mapping[str, float]
CAR, LOWER, UPPER, UPRIGHT = range(4)


def double_wishbone(p: Parameters, t: Floats) -> dict[str, Floats]:
    """Newton's and Euler's equations; the car moves vertically only."""

    def vector(name: str) -> Floats:
        return np.array([p[f"{name}[{k}]"] for k in (1, 2, 3)])

    lower_ball, upper_ball, wheel = vector("lower_ball"), vector("upper_ball"), vector("wheel")
    centers = [
        np.zeros(3),
        _middle(vector("lower_front"), vector("lower_rear"), lower_ball),
        _middle(vector("upper_front"), vector("upper_rear"), upper_ball),
        wheel,
    ]
    masses = [p["m_car"], p["m_lower"], p["m_upper"], p["m_wheel"]]
    inertias = [np.ones(3), vector("I_lower"), vector("I_upper"), vector("I_wheel")]
    bodies = [
        Body(m, np.diag(i), c, np.eye(3), *np.zeros((2, 3)))
        for m, i, c in zip(masses, inertias, centers, strict=True)
    ]  # fmt: skip

    def at(body: int, place: Floats) -> Point:
        return Point(body, place - centers[body])

    joints = [
        _upright_car,
        *_hinge(at, LOWER, vector("lower_front"), vector("lower_rear")),
        *_hinge(at, UPPER, vector("upper_front"), vector("upper_rear")),
        spherical(at(UPRIGHT, lower_ball), at(LOWER, lower_ball)),
        spherical(at(UPRIGHT, upper_ball), at(UPPER, upper_ball)),
        distance(at(UPRIGHT, vector("rod_outer")), at(CAR, vector("rod_inner"))),
    ]
    top, foot = at(CAR, vector("strut_top")), at(LOWER, vector("strut_foot"))
    rest_strut = p["strut_rest"]

    def loads(_: float, state: State, __: Floats) -> list[Load]:
        found = [(Point(i, np.zeros(3)), np.array([0, -m * G_N, 0]), np.zeros(3)) for i, m in enumerate(masses)]
        way = state.place(foot) - state.place(top)
        length = float(np.linalg.norm(way))
        along = way / length
        rate = float(along @ (state.velocity(foot) - state.velocity(top)))
        push = (-p["k_strut"] * (length - rest_strut) - p["c_strut"] * rate) * along
        height, sinking = state.r[UPRIGHT, 1] - wheel[1], state.v[UPRIGHT, 1]
        tyre = np.array([0, p["tyre_load"] - p["k_tyre"] * height - p["c_tyre"] * sinking, 0])
        none = np.zeros(3)
        return [*found, (foot, push, none), (top, -push, none), (Point(UPRIGHT, none), tyre, none)]

    states, _, _ = motion(bodies, joints, loads, t)
    columns = {"body_.s": np.array([s.r[CAR, 1] for s in states])}
    for k in range(3):
        columns[f"center[{k + 1}]"] = np.array([s.r[UPRIGHT, k] for s in states])
        columns[f"axle[{k + 1}]"] = np.array([s.R[UPRIGHT, k, 2] for s in states])
    return columns


def _middle(front: Floats, rear: Floats, ball: Floats) -> Floats:
    return np.asarray((front + rear + ball) / 3)


def _hinge(at: Callable[[int, Floats], Point], arm: int, front: Floats, rear: Floats) -> list[Joint]:
    """Two ball joints would hold the arm twice along their line; the second is free along it."""
    line = rear - front
    side = np.cross(line, [0.3, 0.5, 0.8])
    across = (side, np.cross(line, side))
    return [
        spherical(at(arm, front), at(CAR, front)),
        *(perpendicular(Point(arm, line), Point(CAR, n)) for n in across),
    ]


def _upright_car(state: State) -> Rows:
    """The car keeps its attitude and its place in the horizontal plane."""
    rows = np.zeros((5, 6 * len(state.r)))
    rows[range(5), [0, 2, 3, 4, 5]] = 1.0
    return rows, np.zeros(5)
