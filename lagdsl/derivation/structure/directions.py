"""Directions without inertia that no state and no parameter changes, or that rows tie by parameters."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np

from lagdsl.derivation.structure.inertia import Massless
from lagdsl.derivation.structure.names import contact_rows
from lagdsl.derivation.structure.points import SEED, Geometry, Probe, random_rates
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel

# Of the terms of a sum: less is round-off.
ZERO = 1e-9
_LARGEST_DENOMINATOR = 1000
_SMALL_PIVOT = 1e-6


@record()
class State:
    """Coordinates, rates and parameters at which derivatives are taken."""

    q: Floats
    qd: Floats
    p: Floats


@record()
class Directions:
    """N (nq, m), column by column with a one at its coordinate `leading` (m,), and the sizes of these (m,). `ties` are
    coordinates with the rows that they follow, where parameters or positions change N: `columns` is N at one state."""

    columns: Floats
    leading: list[int]
    sizes: Floats
    ties: list[tuple[int, int]]

    def at(self, jacobian: Floats) -> Floats:
        """N where J is this."""
        if not self.ties:
            return self.columns
        columns = np.zeros_like(self.columns)
        columns[self.leading, np.arange(len(self.leading))] = 1.0
        tied, rows = ([pair[k] for pair in self.ties] for k in (0, 1))
        columns[tied] = -np.linalg.pinv(jacobian[np.ix_(rows, tied)]) @ jacobian[rows] @ columns
        return columns


def states(flat: FlatModel, space: Geometry, points: list[Probe], *, general: bool) -> list[State]:
    """The probed points with rates of natural size; `general`: with other values of the real parameters, so that what
    vanishes there vanishes whatever they are."""
    rates = random_rates(flat.coordinates, space.sizes, len(points))
    real = np.array([p.kind == "Real" for p in flat.parameters if not p.structural], dtype=np.bool_)
    generator = np.random.default_rng(SEED)
    found = []
    for point, qd in zip(points, rates, strict=True):
        factor = generator.uniform(0.9, 1.1, len(space.p))
        moved = np.where(space.p == 0.0, 0.1, space.p) * factor
        found.append(State(point.q, qd, np.where(real, moved, space.p) if general else space.p))
    return found


def find_directions(flat: FlatModel, space: Geometry, states: list[State], found: Massless) -> Directions | None:
    """N that has no inertia at any state, whatever the parameters are; None where there is no such N. States at which M
    or J is no number say nothing."""
    columns, leading = reduced(found.basis * found.sizes[:, None], found.sizes)
    exact = simple(columns)
    switched = contact_rows(flat)
    looks = [(replace(space, p=state.p), state) for state in states]
    every = [
        (here.velocity(state.q, state.qd)[1].dense(), here.mass(state.q, state.qd).dense()) for here, state in looks
    ]
    pairs = [each for each in every if np.isfinite(each[0]).all() and np.isfinite(each[1]).all()]
    if not pairs:
        return None
    lasting = [row for row in range(len(pairs[0][0])) if row not in switched]
    sizes = found.sizes[leading]
    choices = []
    if exact is not None:
        choices.append(_sparse(Directions(exact, leading, sizes, []), found.sizes))
    ties = _ties(pairs[0][0], lasting, [j for j in np.flatnonzero(columns.any(axis=1)).tolist() if j not in leading])
    choices += [] if ties is None else [Directions(columns, leading, sizes, ties)]
    for choice in choices:
        parts = [(matrix, choice.at(rows)) for rows, mass in pairs for matrix in (mass, rows[lasting])]
        if all(np.all(np.abs(matrix @ n) <= ZERO * (np.abs(matrix) @ np.abs(n))) for matrix, n in parts):
            return choice
    return None


def _sparse(directions: Directions, sizes: Floats) -> Directions:
    """The same directions with fewer entries: meshes of a circuit rather than long loops. Each is replaced by its sum
    or difference with another where that has fewer, and named by its first coordinate that names no other."""
    columns, fewer = directions.columns.copy(), True
    while fewer:
        fewer = False
        for k in range(columns.shape[1]):
            for factor in (1.0, -1.0):
                other = columns + factor * columns[:, [k]]
                better = np.count_nonzero(other, axis=0) < np.count_nonzero(columns, axis=0)
                better[k] = False
                columns[:, better] = other[:, better]
                fewer = fewer or bool(better.any())
    leading: list[int] = []
    for column in columns.T:
        leading += [j for j in np.flatnonzero(column).tolist() if j not in leading][:1]
    if len(leading) < columns.shape[1]:
        return directions
    return replace(directions, columns=columns, leading=leading, sizes=sizes[leading])


def _ties(jacobian: Floats, lasting: list[int], tied: list[int]) -> list[tuple[int, int]] | None:
    """The tied coordinates, each with a row that it follows, in an order in which no pivot is small; None where there
    are none, or rows are missing."""
    if not 0 < len(tied) <= len(lasting):
        return None
    lengths = np.linalg.norm(jacobian[lasting], axis=1, keepdims=True)
    rest = (jacobian[lasting] / np.where(lengths > 0.0, lengths, 1.0))[:, tied]
    found = []
    for _ in tied:
        row, column = divmod(int(np.argmax(np.round(np.abs(rest), 9))), rest.shape[1])
        if not abs(rest[row, column]) > _SMALL_PIVOT:
            return None
        found.append((tied[column], lasting[row]))
        rest = rest - np.outer(rest[:, column], rest[row] / rest[row, column])
    return found


def reduced(columns: Floats, sizes: Floats) -> tuple[Floats, list[int]]:
    """Columns (n, m) that span the same, each with a one in a row in which the others have a zero, and these rows,
    ascending: Gauss-Jordan elimination of entries divided by `sizes`."""
    work = columns / sizes[:, None]
    leading: list[int] = []
    for k in range(work.shape[1]):
        rest = np.round(np.abs(work[:, k:]), 9)
        rest[leading] = -1.0
        row, column = divmod(int(np.argmax(rest)), rest.shape[1])
        work[:, [k, k + column]] = work[:, [k + column, k]]
        work[:, k] /= work[row, k]
        others = [j for j in range(work.shape[1]) if j != k]
        work[:, others] -= np.outer(work[:, k], work[row, others])
        leading.append(row)
    work, leading = work[:, np.argsort(leading)], sorted(leading)
    return np.where(np.abs(work) < ZERO, 0.0, work) * sizes[:, None] / sizes[leading], leading


def simple(entries: Floats) -> Floats | None:
    """The entries as fractions of small numbers, which are known exactly; None where one is none."""
    simple = [float(Fraction(x).limit_denominator(_LARGEST_DENOMINATOR)) for x in entries.ravel().tolist()]
    exact = np.array(simple).reshape(entries.shape)
    return exact if np.all(np.abs(exact - entries) <= ZERO * np.abs(entries)) else None
