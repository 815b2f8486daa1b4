"""Models written by hand as engines: what a simulator can be tested with before any compiler has run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from lagdsl.algebra.graph.graph import Graph
from lagdsl.derivation.program.program import Layout, Program, Slot
from lagdsl.engines.runtime.engines.engine import SingularSystem
from lagdsl.engines.runtime.engines.numpy_model import Callbacks
from lagdsl.foundation.numerics.rank import minimum_norm, null_space
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.foundation.units.dimension import DIMENSIONLESS, ENERGY, LENGTH
from lagdsl.language.flat.expression import Number
from lagdsl.language.flat.model import (
    Assertion,
    Constraint,
    Coordinate,
    Experiment,
    FlatModel,
    InitialEquation,
    Input,
    Invariant,
    Output,
    State,
)

# Functions that the runtime asks a model for.
NATIVE = (
    *("start", "position_constraint", "velocity_constraint", "mass_matrix", "dynamics"),
    *("residual", "residual_tangent", "state_derivative", "state_derivative_tangent"),
    *("output", "output_tangent", "energies", "power", "monitor"),
)
FILE = SourceFile("hand.lag", "model Hand\n" + "  some text to point at;\n" * 40)


def span(line: int) -> tuple[Span, ...]:
    """A place in a pretended source text."""
    start = FILE.line_starts[line]
    return (Span(FILE, start + 2, start + 10),)


def coordinate(name: str, start: float = 0.0, rate: float = 0.0, *, line: int = 1, **more: object) -> Coordinate:
    """An angle unless `dimension` says otherwise; starts count as explicit where they are not zero."""
    attributes: dict[str, object] = {
        "dimension": DIMENSIONLESS,
        "unit": "rad",
        "type_name": "Angle",
        "start": Number(start),
        "start_explicit": start != 0.0,
        "fixed": False,
        "rate_start": Number(rate),
        "rate_start_explicit": rate != 0.0,
        "rate_fixed": False,
        "spans": span(line),
    }
    return Coordinate(name=name, **(attributes | more))  # type: ignore[arg-type]


def length(name: str, start: float = 0.0, rate: float = 0.0, **more: object) -> Coordinate:
    return coordinate(name, start, rate, **({"dimension": LENGTH, "unit": "m", "type_name": "Length"} | more))


def constraint(name: str, rows: int = 1, level: str = "position", line: int = 5) -> Constraint:
    names = (name,) if rows == 1 else tuple(f"{name}[{i + 1}]" for i in range(rows))
    zero = Number(0.0)
    return Constraint(
        name=name,
        rows=names,
        residuals=(zero,) * rows,
        dimension=LENGTH,
        level=level,
        spans=span(line),  # type: ignore[arg-type]
    )


def flat_model(
    coordinates: Sequence[Coordinate] = (),
    constraints: Sequence[Constraint] = (),
    *,
    states: Sequence[str] = (),
    inputs: Sequence[str] = (),
    outputs: Sequence[str] = (),
    invariants: Sequence[str] = (),
    assertions: Sequence[str] = (),
    initial_equations: int = 0,
    invariant_tolerance: float | None = None,
    experiment: Experiment | None = None,
) -> FlatModel:
    """A flat model with names and starts only; the physics is in the engine."""
    zero = Number(0.0)
    plain = {"dimension": DIMENSIONLESS, "spans": span(9)}
    return FlatModel(
        name="Hand",
        doc=None,
        parameters=(),
        coordinates=tuple(coordinates),
        states=tuple(
            State(name=n, start=zero, start_explicit=False, fixed=False, derivative=zero, **plain) for n in states
        ),
        inputs=tuple(Input(name=n, default=zero, smooth=0 if "road" not in n else 2, **plain) for n in inputs),
        named=(),
        energies=(),
        masses=(),
        bodies=(),
        gravity=None,
        loads=(),
        constraints=tuple(constraints),
        outputs=tuple(Output(name=n, value=zero, **plain) for n in outputs),
        invariants=tuple(
            Invariant(name=n, value=zero, dimension=ENERGY, tolerance=invariant_tolerance, spans=span(12))
            for n in invariants
        ),
        assertions=tuple(Assertion(condition=zero, message=m, spans=span(13)) for m in assertions),
        initial_equations=tuple(
            InitialEquation(residual=zero, dimension=DIMENSIONLESS, spans=span(14)) for _ in range(initial_equations)
        ),
        drawings=(),
        experiment=experiment or Experiment(stop_time=1.0, tolerance=1e-8, interval=0.05),
    )


class Hand:
    """Engine of a model given by closed forms; subclasses override what they have. Arrays may be complex (J is
    differentiated by a complex step)."""

    start_z: Sequence[float] = ()
    start_u: Sequence[float] = ()

    def __init__(self, flat: FlatModel) -> None:
        self.flat = flat
        rows = [(Slot(name=r), c.level == "position") for c in flat.constraints for r in c.rows]
        self.layout = Layout(
            coordinates=tuple(Slot(name=c.name, unit=c.unit) for c in flat.coordinates),
            states=tuple(Slot(name=s.name) for s in flat.states),
            inputs=tuple(Slot(name=i.name) for i in flat.inputs),
            discretes=(),
            parameters=(),
            defaults=(),
            outputs=tuple(Slot(name=o.name) for o in flat.outputs),
            constraints=tuple(slot for slot, _ in rows),
            position_level=tuple(level for _, level in rows),
            redundant=(False,) * len(rows),
            invariants=tuple(Slot(name=i.name, unit="J") for i in flat.invariants),
            assertions=tuple(a.message for a in flat.assertions),
        )
        self.calls = 0

    @property
    def program(self) -> Program:
        """Without functions: these are written by hand."""
        return Program(name=self.flat.name, layout=self.layout, graph=Graph(), functions=())

    def with_redundant(self, *redundant: bool) -> Hand:
        self.layout = replace(self.layout, redundant=redundant)
        return self

    # ---- the model ---------------------------------------------------------------------------------------------------

    def mass(self, q):  # type: ignore[no-untyped-def]
        return np.eye(len(q))

    def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
        return np.zeros(len(q))

    def phi(self, t, q):  # type: ignore[no-untyped-def]
        """All rows; zero for those of velocity level."""
        return np.zeros(0)

    def rows(self, t, q):  # type: ignore[no-untyped-def]
        """J, all rows."""
        return np.zeros((0, len(q)))

    def rate(self, t, q):  # type: ignore[no-untyped-def]
        """b of J qd + b."""
        return np.zeros(len(self.layout.constraints))

    def potential(self, q):  # type: ignore[no-untyped-def]
        return 0.0

    def zdot(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
        return np.zeros(len(z))

    def output(self, t, q, qd, z, u, qdd, lam):  # type: ignore[no-untyped-def]
        return np.zeros(len(self.layout.outputs))

    def monitor(self, t, q, qd, z):  # type: ignore[no-untyped-def]
        energy = self.energy(q, qd)
        return (
            np.full(len(self.layout.invariants), energy),
            np.ones(len(self.layout.invariants)),
            np.ones(len(self.layout.assertions)),
        )

    def initial(self, t, q, qd, z, u, qdd, lam):  # type: ignore[no-untyped-def]
        return np.zeros(len(self.flat.initial_equations))

    # ---- the engine --------------------------------------------------------------------------------------------------

    def energy(self, q, qd):  # type: ignore[no-untyped-def]
        return float(0.5 * qd @ self.mass(q) @ qd + self.potential(q))

    def gamma(self, t, q, qd):  # type: ignore[no-untyped-def]
        if not self.layout.constraints:
            return np.zeros(0)
        h = 1e-30
        moved = self.rows(t + 1j * h, q + 1j * h * qd), self.rate(t + 1j * h, q + 1j * h * qd)
        return -(np.imag(moved[0]) / h @ qd + np.imag(moved[1]) / h)

    def solve(self, t, q, qd, z, u, w, p):  # type: ignore[no-untyped-def]
        self.calls += 1
        mass, force, rows = self.mass(q), self.force(t, q, qd, z, u), np.real(self.rows(t, q))
        if not np.all(np.isfinite(mass)) or not np.all(np.isfinite(force)) or not np.all(np.isfinite(rows)):
            return np.full(len(q), np.nan), np.full(len(rows), np.nan)
        if not len(q):
            return np.zeros(0), np.zeros(0)
        free = null_space(rows, 1e-8)
        inner = free.T @ mass @ free
        if inner.size and np.linalg.eigvalsh(inner)[0] <= 1e-13 * max(1.0, np.max(np.abs(mass))):
            raise SingularSystem(int(np.argmax(np.abs(free @ np.linalg.eigh(inner)[1][:, 0]))))
        special = minimum_norm(rows, self.gamma(t, q, qd), 1e-8)
        qdd = special + free @ np.linalg.solve(inner, free.T @ (force - mass @ special)) if inner.size else special
        return qdd, minimum_norm(rows.T, mass @ qdd - force, 1e-8)

    @property
    def native(self):  # type: ignore[no-untyped-def]
        """As the runtime in C takes it: every function is called back."""
        names = [*NATIVE, *(("initial_equation",) if self.flat.initial_equations else ())]
        return Callbacks(self, "Hand", names, {"ne": len(self.flat.initial_equations)}).native()

    def along(self) -> None:
        """There are none."""

    def tangent(self, function, *arguments):  # type: ignore[no-untyped-def]
        """Along the directions that come last, by differences."""
        t, q, qd, z, u, w, p, qdd, lam, dq, dqd, dz, du, _, *solved = arguments
        dqdd, dlam = solved or (0.0 * qdd, 0.0 * lam)
        step = 1e-6

        def moved(by):  # type: ignore[no-untyped-def]
            state = (t, q + by * dq, qd + by * dqd, z + by * dz, u + by * du, w, p, qdd + by * dqdd, lam + by * dlam)
            return self.evaluate(function, *state)

        return tuple((a - b) / (2.0 * step) for a, b in zip(moved(step), moved(-step), strict=True))

    def evaluate(self, function, *arguments):  # type: ignore[no-untyped-def]
        if function.endswith("_tangent"):
            return self.tangent(function.removesuffix("_tangent"), *arguments)
        if function == "start":
            q = np.array([c.start.value for c in self.flat.coordinates])
            qd = np.array([c.rate_start.value for c in self.flat.coordinates])
            return q, qd, np.array(self.start_z, dtype=float), np.array(self.start_u, dtype=float)
        t, q, qd, z, u, _, _, *solved = arguments
        if function in ("position_constraint", "velocity_constraint", "dynamics", "mass_matrix", "residual"):
            return self.mechanics(function, t, q, qd, z, u, *solved)
        match function:
            case "state_derivative":
                return (self.zdot(t, q, qd, z, u),)
            case "output":
                return (self.output(t, q, qd, z, u, *solved),)
            case "energies":
                return np.float64(self.energy(q, qd)), np.float64(0.0), np.float64(0.0), np.float64(0.0)
            case "monitor":
                return self.monitor(t, q, qd, z)
            case "power":
                return self.force(t, q, qd, z, u) * qd, np.zeros(len(q))
            case "initial_equation":
                return (np.asarray(self.initial(t, q, qd, z, u, *solved), dtype=float),)
        raise AssertionError(function)

    def mechanics(self, function, t, q, qd, z, u, *solved):  # type: ignore[no-untyped-def]
        rows = np.real(self.rows(t, q))
        match function:
            case "position_constraint":
                return np.asarray(self.phi(t, q), dtype=float), rows
            case "velocity_constraint":
                return rows @ qd + np.real(self.rate(t, q)), rows
            case "dynamics":
                return self.mass(q), self.force(t, q, qd, z, u), rows, self.gamma(t, q, qd)
            case "mass_matrix":
                return (self.mass(q),)
            case _:
                qdd, lam = solved
                motion = self.mass(q) @ qdd - self.force(t, q, qd, z, u) - rows.T @ lam
                return motion, rows @ qdd - self.gamma(t, q, qd)

    def jacobian(self, t, q, qd, z, u, w, p):  # type: ignore[no-untyped-def]
        n, y = len(q), np.concatenate([q, qd, z])

        def derivative(y):  # type: ignore[no-untyped-def]
            a, b, c = y[:n], y[n : 2 * n], y[2 * n :]
            return np.concatenate([b, self.solve(t, a, b, c, u, w, p)[0], self.zdot(t, a, b, c, u)])

        step = 1e-6
        columns = [(derivative(y + step * e) - derivative(y - step * e)) / (2 * step) for e in np.eye(len(y))]
        return np.array(columns).T.reshape(len(y), len(y))


# ---- some mechanisms -------------------------------------------------------------------------------------------------


class Pendulum(Hand):
    """Point mass on a rod of length 0.5 m, angle from the vertical."""

    def mass(self, q):  # type: ignore[no-untyped-def]
        return np.array([[0.25]])

    def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
        return np.array([-9.81 * 0.5 * np.sin(q[0])])

    def potential(self, q):  # type: ignore[no-untyped-def]
        return -9.81 * 0.5 * np.cos(q[0])


class TwiceTied(Hand):
    """A point mass in x, y on the circle of radius 0.5 m, which is demanded twice in different words."""

    def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
        return np.array([0.0, -9.81])

    def potential(self, q):  # type: ignore[no-untyped-def]
        return 9.81 * q[1]

    def phi(self, t, q):  # type: ignore[no-untyped-def]
        s = q[0] ** 2 + q[1] ** 2
        return np.array([s - 0.25, np.sqrt(s) - 0.5])

    def rows(self, t, q):  # type: ignore[no-untyped-def]
        r = np.sqrt(q[0] ** 2 + q[1] ** 2)
        return np.array([[2 * q[0], 2 * q[1]], [q[0] / r, q[1] / r]])


class FourBar(Hand):
    """Three uniform rods with absolute angles; ground link of length d along x."""

    a, b, c, d = 0.4, 1.0, 0.8, 1.0
    m1, m2, m3, g = 1.0, 2.0, 1.5, 9.81

    def mass(self, q):  # type: ignore[no-untyped-def]
        k = self.m2 * self.a * self.b / 2 * np.cos(q[0] - q[1])
        return np.array(
            [
                [self.m1 * self.a**2 / 3 + self.m2 * self.a**2, k, 0.0],
                [k, self.m2 * self.b**2 / 3, 0.0],
                [0.0, 0.0, self.m3 * self.c**2 / 3],
            ]
        )

    def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
        k = self.m2 * self.a * self.b / 2 * np.sin(q[0] - q[1])
        return np.array(
            [
                -k * qd[1] ** 2 - (self.m1 / 2 + self.m2) * self.g * self.a * np.cos(q[0]),
                k * qd[0] ** 2 - self.m2 * self.g * self.b / 2 * np.cos(q[1]),
                -self.m3 * self.g * self.c / 2 * np.cos(q[2]),
            ]
        )

    def potential(self, q):  # type: ignore[no-untyped-def]
        return self.g * (
            (self.m1 / 2 + self.m2) * self.a * np.sin(q[0])
            + self.m2 * self.b / 2 * np.sin(q[1])
            + self.m3 * self.c / 2 * np.sin(q[2])
        )

    def phi(self, t, q):  # type: ignore[no-untyped-def]
        return np.array(
            [
                self.a * np.cos(q[0]) + self.b * np.cos(q[1]) - self.c * np.cos(q[2]) - self.d,
                self.a * np.sin(q[0]) + self.b * np.sin(q[1]) - self.c * np.sin(q[2]),
            ]
        )

    def rows(self, t, q):  # type: ignore[no-untyped-def]
        return np.array(
            [
                [-self.a * np.sin(q[0]), -self.b * np.sin(q[1]), self.c * np.sin(q[2])],
                [self.a * np.cos(q[0]), self.b * np.cos(q[1]), -self.c * np.cos(q[2])],
            ]
        )


def four_bar(start: tuple[float, float, float] = (1.0, 0.3, 1.6), rate: float = 0.0, **more: object) -> FourBar:
    coordinates = [coordinate(n, s, line=i + 1) for i, (n, s) in enumerate(zip(("A", "B", "C"), start, strict=True))]
    coordinates[0] = replace(
        coordinates[0], fixed=True, rate_start=Number(rate), rate_start_explicit=rate != 0.0, rate_fixed=rate != 0.0
    )
    return FourBar(flat_model(coordinates, [constraint("loop", 2)], **more))  # type: ignore[arg-type]
