"""The excavator as four free bodies held by pins."""

from collections.abc import Mapping, Sequence

import numpy as np

from models.references.integrate import G_N, Floats
from models.references.newton_euler import GROUND, Body, Load, Point, State, cross, motion, revolute, turned

Parameters = Mapping[str, float]

CENTERS = np.array([[0, 0, 0], [2.7, 0.4, 0], [1.1, 0.1, 0], [0.6, -0.3, 0]])
MASSES = (12e3, 1800.0, 900.0, 700.0)
INERTIAS = ((22e3, 22e3, 22e3), (300, 5.2e3, 5.2e3), (60, 900, 900), (150, 200, 250))
"""The cab turns about y only, so that its other two moments do not matter."""
PINS = ((0.4, 1.9, 0), (5.7, 0, 0), (2.9, 0, 0))
CYLINDERS = (
    ((0, (1.0, 1.3, 0)), (1, (2.6, 0.5, 0))),
    ((1, (3.2, 1.0, 0)), (2, (-0.7, 0.5, 0))),
    ((2, (0.3, 0.7, 0)), (3, (0.2, 0.4, 0))),
)
REFERENCES = (2.2, 2.6, 2.1)
START = np.radians([40, -95, -40])
AREA, P_MAX, LAG, GAIN, DAMPING = 0.02, 25e6, 0.08, 4e8, 5e4


def _point(body: int, at: Sequence[float]) -> Point:
    """Given in the axes of the frame, which begin at its pin."""
    return Point(body, np.array(at) - CENTERS[body])


def excavator(_: Parameters, t: Floats) -> dict[str, Floats]:
    """Newton's and Euler's equations with the forces of the pins; pressures as in the model."""
    return swinging(t, 0.0, 0.0)


def swinging(t: Floats, turning: float, drive: float) -> dict[str, Floats]:
    """Started with a rate of swing, driven by a constant moment."""
    bodies, origin, attitude = [], np.zeros(3), np.eye(3)
    for i, (mass, inertia) in enumerate(zip(MASSES, INERTIAS, strict=True)):
        if i > 0:
            origin = origin + attitude @ np.array(PINS[i - 1])
            attitude = attitude @ turned("z", START[i - 1])
        at = origin + attitude @ CENTERS[i]
        spin = np.array([0, turning, 0])
        bodies.append(Body(mass, np.diag(inertia), at, attitude, cross(spin, at), spin))
    x, y, z = np.eye(3)
    joints = revolute(
        _point(0, (0, 0, 0)), Point(GROUND, np.zeros(3)), Point(0, y), (Point(GROUND, z), Point(GROUND, x))
    )
    for i, pin in enumerate(PINS):
        across = (Point(i, x), Point(i, y))
        joints += revolute(_point(i + 1, (0, 0, 0)), _point(i, pin), Point(i + 1, z), across)
    ends = [(_point(*a), _point(*b)) for a, b in CYLINDERS]

    def length(state: State, a: Point, b: Point) -> tuple[float, float, Floats]:
        way = state.place(b) - state.place(a)
        s = float(np.linalg.norm(way))
        along = way / s
        return s, float(along @ (state.velocity(b) - state.velocity(a))), along

    def loads(_: float, state: State, pressures: Floats) -> list[Load]:
        found = [(Point(i, np.zeros(3)), np.array([0, -m * G_N, 0]), np.zeros(3)) for i, m in enumerate(MASSES)]
        for (a, b), pressure in zip(ends, pressures, strict=True):
            _, rate, along = length(state, a, b)
            force = (pressure * AREA - DAMPING * rate) * along
            found += [(a, -force, np.zeros(3)), (b, force, np.zeros(3))]
        return [*found, (Point(0, np.zeros(3)), np.zeros(3), np.array([0, drive, 0]))]

    def flow(_: float, state: State, pressures: Floats) -> Floats:
        errors = np.array([ref - length(state, a, b)[0] for ref, (a, b) in zip(REFERENCES, ends, strict=True)])
        return np.asarray((np.clip(GAIN * errors, -P_MAX, P_MAX) - pressures) / LAG)

    states, pressures, forces = motion(bodies, joints, loads, t, (np.zeros(3), flow), tolerance=1e-10)

    def angle(a: Floats, b: Floats) -> float:
        relative = a.T @ b
        return float(np.arctan2(relative[1, 0], relative[0, 0]))

    columns = {"swing": np.unwrap([np.arctan2(s.R[0, 0, 2], s.R[0, 0, 0]) for s in states])}
    for i, name in enumerate(("boom", "stick", "bucket")):
        columns[name] = np.unwrap([angle(s.R[i], s.R[i + 1]) for s in states])
    tip = np.array([s.place(_point(3, (1.4, 0, 0))) for s in states])
    for k in range(3):
        columns[f"cyl{k + 1}.p"] = pressures[k]
        columns[f"tip[{k + 1}]"] = tip[:, k]
        columns[f"root[{k + 1}]"] = np.array([f[5 + k] for f in forces])
    return columns
