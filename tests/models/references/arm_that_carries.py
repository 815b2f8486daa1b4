"""An arm of two links that takes a load from a table: the textbook's equations of the arm, and the load beside it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from models.references.hybrid import Mode, Motion
from models.references.integrate import G_N, Floats

Parameters = Mapping[str, float]


def pick_and_place(p: Parameters, t: Floats) -> dict[str, Floats]:
    arm = _Arm(p)
    start = np.zeros(14)
    start[:4] = np.radians(10), np.radians(-80), p["from_x"], 0.0
    motion = Motion(arm.mode, "table", arm.controlled(0.0, start), t)
    a, b, x, y = motion.x[:4]
    return {
        "a": a,
        "b": b,
        "x": x,
        "y": y,
        "der(a)": motion.x[4],
        "der(b)": motion.x[5],
        "held": np.array(["held" in name for name in motion.modes], dtype=float),
    }


class _Arm:
    """State: angles and place of the load, their rates, torques, errors, sums of errors. Modes name what holds."""

    def __init__(self, p: Parameters) -> None:
        self._p = p

    # ---- control -----------------------------------------------------------------------------------------------------

    def _wanted(self, time: float) -> Floats:
        """The angles that bring the hand to its path, by the law of cosines."""
        p = self._p
        l1, l2 = p["l1"], p["l2"]
        s = np.clip((time - p["t_take"]) / (p["t_put"] - p["t_take"] - 20 * p["h"]), 0, 1)
        w = 10 * s**3 - 15 * s**4 + 6 * s**5
        x = p["from_x"] * (1 - w) + p["to_x"] * w
        y = 0.01 + p["above"] * w + 4 * p["lift"] * w * (1 - w) - p["shoulder"]
        reach = np.hypot(x, y)
        elbow = -(np.pi - np.arccos((l1**2 + l2**2 - reach**2) / (2 * l1 * l2)))
        inner = np.arccos((l1**2 + reach**2 - l2**2) / (2 * l1 * reach))
        return np.array([np.arctan2(y, x) + inner, elbow])

    def controlled(self, time: float, state: Floats) -> Floats:
        p, h, after = self._p, self._p["h"], state.copy()
        error = self._wanted(time) - state[:2]
        total = state[12:] + h * error
        change = (error - state[10:12]) / h
        gains = [np.array([p[f"{kind}1"], p[f"{kind}2"]]) for kind in "pid"]
        torque = gains[0] * error + gains[1] * total + gains[2] * change
        after[8:] = *np.clip(torque, -p["most"], p["most"]), *error, *total
        return after

    # ---- mechanics ---------------------------------------------------------------------------------------------------

    def _equations(self, state: Floats) -> tuple[Floats, Floats, Floats, Floats]:
        """Masses, forces, rows of hand - load = constant, and what their rates of change do without accelerations."""
        p = self._p
        a, b, _, _, da, db = state[:6]
        l1, l2, m1, m2, m = p["l1"], p["l2"], p["m1"], p["m2"], p["m"]
        inner = l1 * l2 * np.cos(b)
        m22 = m2 * l2**2 / 3
        m12 = m22 + m2 * inner / 2
        m11 = m1 * l1**2 / 3 + m2 * l1**2 + m22 + m2 * inner
        mass = np.diag([m11, m22, m, m])
        mass[0, 1] = mass[1, 0] = m12
        coriolis = m2 * l1 * l2 * np.sin(b) / 2
        lower = m2 * G_N * l2 / 2 * np.cos(a + b)
        upper = (m1 / 2 + m2) * G_N * l1 * np.cos(a) + lower
        force = np.array([coriolis * (2 * da * db + db**2) - upper, -coriolis * da**2 - lower, 0.0, -m * G_N])
        force[:2] += state[8:10]
        first, second = l1 * np.array([np.cos(a), np.sin(a)]), l2 * np.array([np.cos(a + b), np.sin(a + b)])
        turned = np.array([[0.0, -1.0], [1.0, 0.0]])
        rows = np.column_stack([turned @ (first + second), turned @ second, -np.eye(2)])
        return mass, force, rows, first * da**2 + second * (da + db) ** 2

    def _solved(self, name: str, state: Floats) -> tuple[Floats, float]:
        """Accelerations, and the force of the table."""
        mass, force, rows, bias = self._equations(state)
        if name == "table":
            force[2] -= self._p["sliding"] * state[6]
        chosen, right = (
            self._rows(name, rows),
            np.array([*(bias if "held" in name else []), *[0.0] * ("table" in name)]),
        )
        zero = np.zeros((len(chosen), len(chosen)))
        found = np.linalg.solve(np.block([[mass, -chosen.T], [chosen, zero]]), np.concatenate([force, right]))
        return found[:4], float(found[-1]) if "table" in name else 0.0

    def _rows(self, name: str, rows: Floats) -> Floats:
        return np.vstack([rows[: 2 * ("held" in name)], np.eye(4)[3:][: "table" in name]])

    def _onto(self, name: str, state: Floats) -> Floats:
        """The state with the rates that a blow leaves which makes the rows of `name` hold."""
        mass, _, rows, _ = self._equations(state)
        chosen = self._rows(name, rows)
        across = np.linalg.solve(mass, chosen.T)
        after = state.copy()
        after[4:8] -= across @ np.linalg.solve(chosen @ across, chosen @ state[4:8])
        return after

    # ---- modes -------------------------------------------------------------------------------------------------------

    def mode(self, name: str, time: float) -> Mode:
        h = self._p["h"]
        following = h * (round(time / h) + 1)

        def rates(_: float, state: Floats) -> ArrayLike:
            return [*state[4:8], *self._solved(name, state)[0], *[0.0] * 6]

        def tick(now: float, state: Floats) -> tuple[str, ArrayLike]:
            return self._ticked(name, now, state)

        def land(_: float, state: Floats) -> tuple[str, ArrayLike]:
            both = "held table" if name == "held" else "table"
            return both, self._onto(both, state)

        def part(_: float, state: Floats) -> tuple[str, ArrayLike]:
            return name.replace("table", "").strip() or "falls", state

        if "table" in name:
            return Mode(rates, [(lambda _, x: self._solved(name, x)[1], part)], until=following, then=tick)
        return Mode(rates, [(lambda _, x: x[3], land)], until=following, then=tick)

    def _ticked(self, name: str, time: float, state: Floats) -> tuple[str, Floats]:
        after, close = self.controlled(time, state), self._p["h"] / 2
        if abs(time - self._p["t_take"]) < close:
            after = self._onto("held", after)
            if after[7] > 0:
                return "held", after
            name, after = "held table", self._onto("held table", after)
        elif abs(time - self._p["t_put"]) < close:
            name = "table" if "table" in name else "falls"
        if "table" in name and self._solved(name, after)[1] <= 0:
            name = name.replace("table", "").strip() or "falls"
        return name, after
