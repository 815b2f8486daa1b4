"""Accelerations with a pull towards the constraints, and their derivatives in C, against the same with fifty digits."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from choice import ALL, EXPLORE, chosen
from derivatives_in_c import GROUPS, MOVED, TIME, Probe, program_of

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program

STEP = mpmath.mpf("1e-16")
GENERAL = (
    "double_pendulum",
    "four_bar",
    "rolling_coin",
    "furuta_swing_up",
    "kapitza_pendulum",
    "maglev",
    "crane_with_motor",
    "bead_on_cosine_wire",
)
# The rows depend on each other on the constraints only.
DEPENDENT = (
    "pendulum_two_dependent_constraints",
    "bead_on_circular_wire_redundant",
    "four_bar_spatial",
    "newtons_cradle",
)


def at_random(program: Program, start: dict[Group, np.ndarray]) -> dict[Group, np.ndarray]:
    """A state in general position, off the constraints."""
    rng = np.random.default_rng(3)
    found = {group: rng.uniform(0.2, 0.7, program.layout.size(group)) for group in GROUPS[:4]}
    return {**found, Group.W: start[Group.W], Group.P: start[Group.P]}


class Exact:
    """The same function with any number of digits; `rows` of J are solved for, the others depend on them."""

    def __init__(self, program: Program, rate: float, rows: list[int]) -> None:
        self._program, self._rate, self._rows = program, mpmath.mpf(rate), rows

    def solve(self, given: dict[Group, Any]) -> tuple[list[Any], list[Any]]:
        """qdd, and lam of least length."""
        layout, rate = self._program.layout, self._rate
        n, m = len(layout.coordinates), len(layout.constraints)
        mass, force, jacobian, gamma = self._blocks("dynamics", given)
        phi, velocity = self._blocks("position_constraint", given)[0], self._blocks("velocity_constraint", given)[0]
        for i, of_positions in enumerate(layout.position_level):
            gamma[i] -= 2 * rate * velocity[i] + rate**2 * phi[i] if of_positions else rate * velocity[i]
        system, right = mpmath.zeros(n + len(self._rows)), mpmath.zeros(n + len(self._rows), 1)
        for i in range(n):
            right[i] = force[i]
            for k in range(n):
                system[i, k] = mass[i * n + k]
        for r, row in enumerate(self._rows):
            right[n + r] = gamma[row]
            for k in range(n):
                system[n + r, k] = jacobian[row * n + k]
                system[k, n + r] = -jacobian[row * n + k]
        solution = mpmath.lu_solve(system, right) if n + len(self._rows) else []
        lam = [mpmath.mpf(0)] * m
        for r, row in enumerate(self._rows):
            lam[row] = solution[n + r]
        return list(solution[:n]), self._shortest(lam, jacobian, mass)

    def _shortest(self, lam: list[Any], jacobian: list[Any], mass: list[Any]) -> list[Any]:
        """Without the parts that change nothing: rows that depend on others, less these combinations of them. How
        well a combination fits is measured with coordinates of unit inertia."""
        n, m = len(self._program.layout.coordinates), len(lam)
        others = [row for row in range(m) if row not in self._rows]
        if not others:
            return lam
        if not self._rows:  # those that come and go are all absent
            return [mpmath.mpf(0)] * m
        diagonal = [mass[k * n + k] for k in range(n)]
        scale = [1 / mpmath.sqrt(x if x > 1e-28 * max(diagonal) else max(diagonal)) for x in diagonal]
        rows = [[jacobian[row * n + k] * scale[k] for k in range(n)] for row in range(m)]
        gram = mpmath.matrix([[mpmath.fdot(rows[a], rows[b]) for b in self._rows] for a in self._rows])
        excess = mpmath.zeros(len(others), m)
        for k, row in enumerate(others):
            parts = mpmath.lu_solve(gram, mpmath.matrix([mpmath.fdot(rows[row], rows[a]) for a in self._rows]))
            excess[k, row] = 1
            for part, a in zip(parts, self._rows, strict=True):
                excess[k, a] = -part
        along = mpmath.lu_solve(excess * excess.T, excess * mpmath.matrix(lam))
        return [a - b for a, b in zip(lam, excess.T * along, strict=True)]

    def everything(self, given: dict[Group, Any]) -> list[Any]:
        """Output of the probe, as values: rates, y, d, energies, phi, J qd + b, lam."""
        qdd, lam = self.solve(given)
        solved = {**given, Group.QDD: qdd, Group.LAMBDA: lam}
        told = [*given[Group.QD], *qdd]
        for function in ("state_derivative", "output", "definition"):
            told += self._blocks(function, solved)[0]
        told += [value for (value,) in self._blocks("energies", given)[:3]]
        for function in ("position_constraint", "velocity_constraint"):
            told += self._blocks(function, given)[0]
        return told + lam

    def _blocks(self, function: str, given: dict[Group, Any]) -> list[list[Any]]:
        graph = self._program.graph
        return [evaluate(graph, block.elements, given) for block in self._program.function(function).results]


def moved(at: dict[Group, np.ndarray], along: dict[Group, np.ndarray], time: float, step: Any) -> dict[Group, Any]:
    given: dict[Group, Any] = {group: [mpmath.mpf(float(x)) for x in values] for group, values in at.items()}
    for group, direction in along.items():
        given[group] = [x + step * mpmath.mpf(float(d)) for x, d in zip(given[group], direction, strict=True)]
    given[Group.TIME] = mpmath.mpf(TIME) + step * time
    return given


def compare(path: Path, at: dict[Group, np.ndarray], along: dict[Group, np.ndarray], time: float, rate: float) -> None:
    program, _ = program_of(path)
    found = Probe(path, at, along, time, rate)
    with mpmath.workdps(50):
        exact = Exact(program, rate, found.rows)
        qdd, lam = exact.solve(moved(at, along, time, mpmath.mpf(0)))
        close(found.qdd, [float(x) for x in qdd])
        close(found.lam, [float(x) for x in lam])
        plus, minus = (exact.everything(moved(at, along, time, sign * STEP)) for sign in (1, -1))
        close(found.changes, [float((a - b) / (2 * STEP)) for a, b in zip(plus, minus, strict=True)])


def close(ours: np.ndarray, theirs: list[float]) -> None:
    np.testing.assert_allclose(ours, theirs, rtol=1e-9, atol=1e-9 * max([1.0, *map(abs, theirs)]) * 1e-2)


@pytest.mark.parametrize("rate", [0.0, 7.0])
@pytest.mark.parametrize("name", chosen(GENERAL, ("double_pendulum", "four_bar")))
def test_off_the_constraints(root: Path, name: str, rate: float) -> None:
    path = root / "models" / f"{name}.lag"
    program, start = program_of(path)
    rng = np.random.default_rng(5)
    along = {group: rng.uniform(-1.0, 1.0, program.layout.size(group)) for group in MOVED}
    compare(path, at_random(program, start), along, 0.7, rate)


@pytest.mark.parametrize("rate", [0.0, 7.0])
@pytest.mark.parametrize("name", chosen(DEPENDENT, DEPENDENT[:2]))
def test_rows_that_depend_on_each_other(root: Path, name: str, rate: float) -> None:
    path = root / "models" / f"{name}.lag"
    program, start = program_of(path)
    rng = np.random.default_rng(5)
    along = {group: rng.uniform(-1.0, 1.0, program.layout.size(group)) for group in MOVED}
    compare(path, start, along, 0.0, rate)


# A start where rows coincide, and parameters whose default is where a branch of the model changes.
BRANCHING = ("parallelogram", "library/forces_gas_spring", "library/forces_zero_length_spring")
FOLDER = Path(__file__).parents[3] / "models"
EVERY = [str(path.relative_to(FOLDER).with_suffix("")) for path in sorted(FOLDER.rglob("*.lag"))]
SOME = ("slider_crank", "gyroscope_in_gimbals", "clutch", "library/tank_circuit", "library/spatial_differential")
CHOSEN = [name for name in EVERY if name not in BRANCHING] if EXPLORE else SOME if ALL else SOME[::2]


@pytest.mark.parametrize("name", CHOSEN)
def test_near_the_start(root: Path, name: str) -> None:
    path = root / "models" / f"{name}.lag"
    program, start = program_of(path)
    dependent = any(program.layout.redundant)
    rng = np.random.default_rng(5)
    along, at = {}, dict(start)
    for group in MOVED:
        sizes = np.where(start[group] != 0.0, np.maximum(np.abs(start[group]), 1e-3), 1.0)
        along[group] = sizes * rng.uniform(-1.0, 1.0, len(sizes))
    if not dependent:
        at[Group.Q] = start[Group.Q] * (1.0 + 0.01 * rng.uniform(-1.0, 1.0, len(start[Group.Q]))) + 0.001
        at[Group.QD] = start[Group.QD] + rng.uniform(-0.3, 0.3, len(start[Group.QD]))
    compare(path, at, along, 0.0 if dependent else 0.7, 7.0)
