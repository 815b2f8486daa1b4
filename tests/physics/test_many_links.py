"""Large mechanisms against Newton's and Euler's equations of their bodies, link by link, in extended precision.

Source: the recursive Newton-Euler equations (R. Featherstone, Rigid Body Dynamics Algorithms, 2008, ch. 5), here in
axes of the world. The error of a joint is compared with the torques that meet there, which are large in a long chain.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from choice import ALL, chosen, engines
from compiled_programs import program_of
from models.many_states import onto_constraints

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.functions import STATE
from lagdsl.engines.runtime.engines.selection import engine_of

Extended = np.longdouble
STATES = 20
LEFT = 1e-10
G = Extended("9.80665")
MASS, CENTER, INERTIA = (
    Extended("1.5"),
    np.array(["0.2", "-0.1", "0.05"], Extended),
    np.array(["0.03", "0.04", "0.05"], Extended),
)


@dataclass(frozen=True)
class Links:
    """Link i turns about z of a frame that is moved and turned about x from its parent's; all have the same inertia
    about their mass center, in axes of their own. Pins hold the ends of two links together."""

    parents: tuple[int, ...]
    way: tuple[float, float, float] = (0.7, 0.0, 0.0)
    twist: float = 0.0
    pins: tuple[tuple[int, int], ...] = ()

    def text(self) -> str:
        lines = ["model Links", "  gravity = -g_n*world.y;"]
        way = ", ".join(f"{x!r} m" for x in self.way)
        for i, parent in enumerate(self.parents):
            base = "world" if parent < 0 else f"F{parent}.move({{{way}}}).rotx({self.twist!r})"
            lines += [
                f"  coordinate Angle q{i};",
                f"  frame F{i} = {base}.rotz(q{i});",
                f"  body b{i}(m = 1.5, com = {{0.2 m, -0.1 m, 0.05 m}}, I = {{0.03, 0.04, 0.05}}) on F{i};",
            ]
        for a, b in self.pins:
            lines += [f"  constraint F{a}.point({{{way}}})*world.{e} = F{b}.point({{{way}}})*world.{e};" for e in "xy"]
        return "\n".join([*lines, "end Links;\n"])


LOOPS = 14 if ALL else 6
CASES = {
    "planar chain": Links(tuple(range(-1, 99))),
    "planar tree": Links(tuple((i - 1) // 2 if i else -1 for i in range(45 if ALL else 30))),
    "spatial chain": Links(tuple(range(-1, 23 if ALL else 15)), (0.1, 0.3, 0.2), 1.2),
    "spatial tree": Links(tuple((i - 1) // 2 if i else -1 for i in range(20 if ALL else 10)), (0.1, 0.3, 0.2), -0.8),
    # each three links after those that carry them: two side by side, pinned at their ends, and one that goes on
    "loops": Links(
        tuple(k for i in range(LOOPS) for k in (3 * i - 1, 3 * i, 3 * i - 1)),
        pins=tuple((3 * i + 1, 3 * i + 2) for i in range(LOOPS)),
    ),
}


def turned(axes: np.ndarray, axis: int, angle: np.ndarray) -> np.ndarray:
    """Axes (..., 3, 3), as columns, turned about one of their own."""
    c, s = np.cos(angle), np.sin(angle)
    u, v = (axis + 1) % 3, (axis + 2) % 3
    result = np.array(np.broadcast_to(axes, (*np.shape(angle), 3, 3)))
    first, second = axes[..., u] + 0 * result[..., u], axes[..., v] + 0 * result[..., v]
    result[..., u] = c[..., None] * first + s[..., None] * second
    result[..., v] = c[..., None] * second - s[..., None] * first
    return result


def applied(axes: np.ndarray, x: np.ndarray) -> np.ndarray:
    return np.asarray((axes @ x[..., None])[..., 0])


class Bodies:
    """Motion of all links in axes of the world, at states (k, n) of coordinates, rates and accelerations."""

    def __init__(self, links: Links, q: np.ndarray, qd: np.ndarray, qdd: np.ndarray) -> None:
        self.links, self.count = links, len(q)
        q, qd, qdd = (np.asarray(x, Extended) for x in (q, qd, qdd))
        nothing, way = np.zeros((self.count, 3), Extended), np.array(links.way, Extended)
        self.axes: list[np.ndarray] = []
        self.spin: list[np.ndarray] = []
        self.turning: list[np.ndarray] = []
        self.place: list[np.ndarray] = []
        self.pull: list[np.ndarray] = []  # acceleration of the origin
        twist = np.full(self.count, links.twist, Extended)
        for i, parent in enumerate(links.parents):
            if parent < 0:
                before, spin, turning, place, pull = np.eye(3, dtype=Extended), nothing, nothing, nothing, nothing
            else:
                before, spin, turning = turned(self.axes[parent], 0, twist), self.spin[parent], self.turning[parent]
                place, pull = (
                    x + y for x, y in zip((self.place[parent], self.pull[parent]), self.arm(parent, way), strict=True)
                )
            axes = turned(before, 2, q[:, i])
            own = axes[..., 2] * qd[:, i, None]
            self.axes.append(axes)
            self.spin.append(spin + own)
            self.turning.append(turning + axes[..., 2] * qdd[:, i, None] + np.cross(spin, own))
            self.place.append(place)
            self.pull.append(pull)

    def arm(self, i: int, point: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """From the origin of link i to a point of it, and by how much its acceleration is more."""
        arm = applied(self.axes[i], np.broadcast_to(point, (self.count, 3)))
        return arm, np.cross(self.turning[i], arm) + np.cross(self.spin[i], np.cross(self.spin[i], arm))

    def wrenches(self) -> list[tuple[np.ndarray, np.ndarray]]:
        """Force and torque about its origin that each link needs beside its weight."""
        found = []
        for i in range(len(self.links.parents)):
            arm, more = self.arm(i, CENTER)
            force = MASS * (self.pull[i] + more + G * np.array([0, 1, 0], Extended))
            axes = self.axes[i]
            inertia = axes @ np.diag(INERTIA) @ np.swapaxes(axes, -1, -2)
            spin = applied(inertia, self.spin[i])
            found.append(
                (force, applied(inertia, self.turning[i]) + np.cross(self.spin[i], spin) + np.cross(arm, force))
            )
        return found

    def left_at_joints(self, multipliers: np.ndarray) -> float:
        """Torques about the axes that nothing gives, relative to the torques there."""
        wrenches, way = self.wrenches(), np.array(self.links.way, Extended)
        sizes = [np.abs(torque).max(axis=-1) for _, torque in wrenches]
        for k, (a, b) in enumerate(self.links.pins):
            pin = np.concatenate([multipliers[:, 2 * k : 2 * k + 2], np.zeros((self.count, 1))], axis=1)
            for i, force in ((a, np.asarray(pin, Extended)), (b, -np.asarray(pin, Extended))):
                arm, _ = self.arm(i, way)
                wrenches[i] = wrenches[i][0] - force, wrenches[i][1] - np.cross(arm, force)
                sizes[i] = sizes[i] + np.abs(np.cross(arm, force)).max(axis=-1)
        worst = 0.0
        for i in reversed(range(len(wrenches))):
            force, torque = wrenches[i]
            left = np.abs(np.sum(torque * self.axes[i][..., 2], axis=-1))
            worst = max(worst, float(np.max(left / sizes[i])))
            parent = self.links.parents[i]
            if parent >= 0:
                arm = self.place[i] - self.place[parent]
                moment = np.cross(arm, force)
                wrenches[parent] = wrenches[parent][0] + force, wrenches[parent][1] + torque + moment
                sizes[parent] = sizes[parent] + sizes[i] + np.abs(moment).max(axis=-1)
        return worst

    def left_at_pins(self) -> float:
        """Accelerations of pinned points away from each other, relative to those of both."""
        worst, way = 0.0, np.array(self.links.way, Extended)
        for a, b in self.links.pins:
            first, second = (self.pull[i] + self.arm(i, way)[1] for i in (a, b))
            size = np.maximum(np.abs(first), np.abs(second)).max(axis=-1)
            worst = max(worst, float(np.max(np.abs(first - second)[:, :2].max(axis=-1) / size)))
        return worst


@pytest.mark.parametrize("name", chosen(CASES, ("spatial tree", "loops")))
def test_every_link_obeys_newton_and_euler(name: str) -> None:
    links = CASES[name]
    program, random = program_of(links.text()), np.random.default_rng(3)
    assert program.has("elimination")
    n = len(links.parents)
    state = {
        Group.TIME: np.zeros(STATES),
        Group.Q: random.uniform(-1.5, 1.5, (STATES, n)),
        Group.QD: random.normal(size=(STATES, n)),
        **{group: np.zeros((STATES, 0)) for group in (Group.Z, Group.U, Group.W, Group.P)},
    }
    state = onto_constraints(program, state)
    for engine in engines(("numpy", "c")):
        qdd, lam = engine_of(program, engine).solve_many(*(state[group] for group in STATE))
        found = Bodies(links, state[Group.Q], state[Group.QD], qdd)
        assert found.left_at_joints(lam) < LEFT
        assert found.left_at_pins() < LEFT
