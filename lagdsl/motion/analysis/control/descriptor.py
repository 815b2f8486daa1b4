"""The linearized motion in descriptor form: nothing is solved for, so that nothing is lost in solving.

With x = (q, qd, z, qdd, lam, loads): E dx/dt = A x + B u, y = C x + D u. Rows are those of position level that hold,
all rows J qd + b, dq/dt = qd and dqd/dt = qdd in the independent coordinates and rates, the equations of motion with
their rows, the rates of the states, and the loads that depend on accelerations and multipliers. M is not inverted, and
dependent coordinates are not eliminated: the frequency response is one solution of s E - A at each frequency.
Source of the form: Kunkel and Mehrmann, Differential-Algebraic Equations (2006), chapter 2.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from lagdsl.engines.backends.python.sizes import motion_sizes
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.eigen import Complexes
from lagdsl.motion.analysis.linearize import Reduced
from lagdsl.motion.analysis.point import System

_Lines = tuple[Floats, Floats, Floats]


@dataclass(frozen=True, slots=True, kw_only=True)
class Descriptor:
    """E and A (ne, nx), B (ne, nu), C (ny, nx), D (ny, nu); more equations than unknowns where rows are redundant.
    `states` are the places in x of the entries of the minimal state."""

    e: Floats
    a: Floats
    b: Floats
    c: Floats
    d: Floats
    states: tuple[int, ...]

    def response(self, omega: Floats, source: int, row: Floats, direct: float) -> Complexes:
        """row x + direct u, for u = 1 in input `source`, at angular frequencies `omega` [rad/s] (k,)."""
        right = self.b[:, source].astype(np.complex128)
        found = [complex(row @ self._solved(1j * each, right)) for each in omega.tolist()]
        return np.array(found, dtype=np.complex128) + direct

    def row_of_state(self, place: int) -> Floats:
        """The row that tells one entry of the minimal state."""
        row = np.zeros(self.a.shape[1])
        row[self.states[place]] = 1.0
        return row

    def _solved(self, s: complex, right: Complexes) -> Complexes:
        pencil = s * self.e - self.a
        # Equations of similar size: the units of their rows are those of forces, lengths, voltages.
        sizes = np.max(np.abs(pencil), axis=1)
        sizes = np.where(sizes > 0.0, sizes, 1.0)
        pencil, right = pencil / sizes[:, None], right / sizes
        told = np.any(pencil != 0.0, axis=0)
        found = np.zeros(len(told), dtype=np.complex128)
        if pencil.shape[0] == np.count_nonzero(told):
            try:
                found[told] = np.linalg.solve(pencil[:, told], right)
            except np.linalg.LinAlgError:
                found[:] = np.nan
        else:
            found[told] = np.linalg.lstsq(pencil[:, told], right, rcond=1e-13)[0]
        return found


def descriptor(system: System, at: Reduced) -> Descriptor:
    """At the point of `at`, all derivatives exact."""
    engine, flow, chosen = system.engine, at.flow, at.partition
    point = flow.point
    n, nz, nu, nc = len(point.q), len(point.z), len(point.u), len(flow.lam)
    loads = motion_sizes(system.program).loads
    columns = _Columns(n=n, nz=nz, nu=nu, nc=nc, loads=loads)
    count = columns.count
    unit = np.eye(count)
    parts = np.split(unit, np.cumsum([n, n, nz]), axis=1)
    directions = (*parts, np.zeros((count, len(point.p))))
    solved = (*point.arguments, flow.qdd, flow.lam)
    motion, rows = engine.evaluate_many("residual_tangent", *solved, *directions)
    phi, rates = engine.evaluate_many("constraint_tangent", *point.arguments, *directions)
    mass, _, jacobian, _ = engine.evaluate("dynamics", *point.arguments)
    held = list(chosen.held)
    # d(zd, y, loads) by everything, one direction a row.
    every = np.eye(count + n + nc)
    wide = (*np.split(every[:, :count], np.cumsum([n, n, nz]), axis=1), np.zeros((len(every), len(point.p))))
    along = (*wide, every[:, count : count + n], every[:, count + n :])
    names = ["state_derivative_tangent", "output_tangent", *(["load_tangent"] if loads else [])]
    told = [engine.evaluate_many(name, *solved, *along)[0].T for name in names]
    gains = engine.evaluate("load_gain", *solved) if loads else tuple(np.zeros((k, 0)) for k in (n, nz, len(flow.y), 0))

    none = np.zeros

    def parts_of(every: Floats) -> tuple[Floats, Floats, Floats]:
        return every[:, :count], every[:, count : count + n], every[:, count + n :]

    lines = [
        columns.algebraic(phi.T[held], none((len(held), n)), none((len(held), nc)), none((len(held), loads))),
        columns.algebraic(rates.T, none((nc, n)), none((nc, nc)), none((nc, loads))),
        columns.rates_of(chosen.position, 0, n),
        columns.rates_of(chosen.rate, n, 2 * n + nz),
        columns.algebraic(motion.T, mass, -jacobian.T, gains[0]),
        columns.algebraic(rows.T, jacobian, none((nc, nc)), none((nc, loads))),
        columns.states(parts_of(told[0]), gains[1]),
    ]
    if loads:
        lines.append(columns.algebraic(*parts_of(told[2]), gains[3] - np.eye(loads)))
    e, a, b = (np.vstack([line[k] for line in lines]) for k in range(3))
    c, d = columns.of(*parts_of(told[1]), gains[2])
    states = (*chosen.position, *(n + k for k in chosen.rate), *(2 * n + k for k in range(nz)))
    # Rows of open contacts are empty, and their multipliers act on nothing.
    told_rows = np.any(np.hstack([e, a, b]) != 0.0, axis=1)
    return Descriptor(e=e[told_rows], a=a[told_rows], b=b[told_rows], c=c, d=d, states=states)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Columns:
    """Lengths of the parts of x and u, and lines of the descriptor form from their derivatives."""

    n: int
    nz: int
    nu: int
    nc: int
    loads: int

    @property
    def count(self) -> int:
        """Of directions: q, qd, z, u."""
        return 2 * self.n + self.nz + self.nu

    @property
    def width(self) -> int:
        return 3 * self.n + self.nz + self.nc + self.loads

    def of(self, first: Floats, qdd: Floats, lam: Floats, load: Floats) -> tuple[Floats, Floats]:
        """Columns of x and of u from derivatives by (q, qd, z, u), qdd, lam and loads."""
        state = 2 * self.n + self.nz
        return np.hstack([first[:, :state], qdd, lam, load]), first[:, state:]

    def algebraic(self, first: Floats, qdd: Floats, lam: Floats, load: Floats) -> _Lines:
        a, b = self.of(first, qdd, lam, load)
        return np.zeros((len(a), self.width)), a, b

    def rates_of(self, entries: tuple[int, ...], first: int, second: int) -> _Lines:
        """Entries of one part are the derivatives of those of another."""
        e, a = np.zeros((2, len(entries), self.width))
        for row, entry in enumerate(entries):
            e[row, first + entry] = a[row, second + entry] = 1.0
        return e, a, np.zeros((len(entries), self.nu))

    def states(self, parts: tuple[Floats, Floats, Floats], load: Floats) -> _Lines:
        """Rates of first-order states."""
        a, b = self.of(*parts, load)
        e = np.zeros((self.nz, self.width))
        e[:, 2 * self.n : 2 * self.n + self.nz] = np.eye(self.nz)
        return e, a, b
