"""Dense linear algebra of mechanics: accelerations, least impulses, impacts. Written from the textbooks (F. Pfeiffer,
Ch. Glocker, *Multibody Dynamics with Unilateral Contacts*, 1996; B. Brogliato, *Nonsmooth Mechanics*, 2016)."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import combinations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse.csgraph import connected_components

Floats = NDArray[np.float64]
_RANK = 1e-10


def tied(mass: Floats, rows: Floats) -> NDArray[np.int_]:
    """The part of the mechanism to which each coordinate belongs: those that inertia or rows tie together."""
    return _tied((mass != 0).tobytes(), (rows != 0).tobytes(), len(mass))


@lru_cache(maxsize=256)
def _tied(mass: bytes, rows: bytes, count: int) -> NDArray[np.int_]:
    if not count:
        return np.zeros(0, dtype=int)
    ties = np.frombuffer(mass, dtype=bool).reshape(count, count)
    entries = np.frombuffer(rows, dtype=bool).reshape(-1, count).astype(int)
    return np.asarray(connected_components(ties | (entries.T @ entries > 0), directed=False)[1])


@lru_cache(maxsize=256)
def _places(mass: bytes, rows: bytes, count: int) -> list[tuple[NDArray[np.int_], NDArray[np.int_]]]:
    """Coordinates and rows of each part; all without rows are one, as a block diagonal mixes nothing."""
    part, entries = _tied(mass, rows, count), np.frombuffer(rows, dtype=bool).reshape(-1, max(count, 1))
    bound = np.unique(part[np.any(entries, axis=0)]) if count else part
    members = [part == each for each in bound] + [~np.isin(part, bound)]
    return [(np.flatnonzero(of), np.flatnonzero(np.any(entries[:, of], axis=1))) for of in members if np.any(of)]


class Balance:
    """M x - J' y = a, J x = b, for any ranks of J: x and the shortest y. Parts that nothing ties to each other are
    solved each by itself: the round-off of one does not reach the other."""

    def __init__(self, mass: Floats, rows: Floats) -> None:
        places = _places((mass != 0).tobytes(), (rows != 0).tobytes(), len(mass))
        self._parts = [(of, own, _Part(mass[of[:, None], of], rows[own[:, None], of])) for of, own in places]

    def solve(self, a: Floats, b: Floats) -> tuple[Floats, Floats]:
        x, y = np.zeros(len(a)), np.zeros(len(b))
        for of, own, part in self._parts:
            x[of], y[own] = part.solve(a[of], b[own])
        return x, y


class _Part:
    """In units in which M has a unit diagonal and the rows of J are of length one."""

    def __init__(self, mass: Floats, rows: Floats) -> None:
        self._unit = 1 / np.sqrt(np.where(np.diag(mass) > 0, np.diag(mass), 1.0))
        scaled = rows * self._unit
        lengths = np.linalg.norm(scaled, axis=1)
        self._row = np.where(lengths > 0, 1 / np.where(lengths > 0, lengths, 1.0), 0.0)
        self._rows = scaled * self._row[:, None]
        self._mass = mass * np.outer(self._unit, self._unit)
        # directions that the rows leave free, and those that they take
        held = bool(np.any(self._rows))
        u, s, vt = np.linalg.svd(self._rows) if held else (np.eye(len(rows)), np.zeros(0), np.eye(len(mass)))
        rank = int(np.sum(s > _RANK * max(1.0, s.max(initial=0.0))))
        self._free = vt[rank:].T
        self._inverse = vt[:rank].T @ ((u[:, :rank].T) / s[:rank, None]) if rank else np.zeros((len(mass), len(rows)))

    def solve(self, a: Floats, b: Floats) -> tuple[Floats, Floats]:
        """By the null space: x = N c + J^+ b with N' M x = N' a, then J' y = M x - a."""
        a, b = a * self._unit, b * self._row
        held = self._inverse @ b
        n = self._free
        c = np.linalg.solve(n.T @ self._mass @ n, n.T @ (a - self._mass @ held)) if n.shape[1] else np.zeros(0)
        x = n @ c + held
        y = self._inverse.T @ (self._mass @ x - a)
        return x * self._unit, y * self._row


def impact(
    mass: Floats, rows: Floats, gaps: Floats, speeds: Floats, restitutions: Sequence[float]
) -> tuple[Floats, Floats]:
    """The jump of the rates and the impulses of contacts with gap rates `speeds` before: p >= 0, s+ + e s- >= 0,
    p (s+ + e s-) = 0. By trying all sets of contacts that transmit something, smaller ones first."""
    balance = Balance(mass, rows)
    moved = np.array([balance.solve(gap, np.zeros(len(rows)))[0] for gap in gaps]).reshape(len(gaps), len(mass))
    size = np.sqrt(np.maximum(np.einsum("ij,ij->i", gaps, moved), 1e-300))
    matrix = (gaps @ moved.T) / np.outer(size, size)
    wanted = -(1 + np.asarray(restitutions)) * speeds / size
    near = 1e-9 * max(1e-300, float(np.max(np.abs(wanted), initial=0.0)))
    for count in range(len(gaps) + 1):
        for chosen in combinations(range(len(gaps)), count):
            p = np.zeros(len(gaps))
            index = list(chosen)
            p[index] = np.linalg.lstsq(matrix[np.ix_(index, index)], wanted[index], rcond=1e-12)[0]
            slack = matrix @ p - wanted
            if np.all(p >= -near) and np.all(slack >= -near) and np.all(np.abs(slack[index]) <= near):
                p = p / size
                return p @ moved, p
    raise AssertionError("a linear complementarity problem with a semidefinite matrix has a solution")


def pushed(found: dict[str, Floats], contacts: NDArray[np.int_], none: Floats) -> tuple[Floats, Floats]:
    """Accelerations of the gaps of closed contacts, and the sizes of their terms, where forces only push: p >= 0,
    a >= 0, p a = 0. `contacts` are their rows in J a = gamma, `none` are forces that count as none. The accelerations
    are unique (J. J. Moreau, 1966); they are found by trying all sets of contacts that push."""
    mass, rows, right = found["M"], found["J"], found["gamma"]
    for count in range(len(contacts), -1, -1):
        for chosen in combinations(range(len(contacts)), count):
            index = list(chosen)
            kept = rows.copy()
            kept[np.delete(contacts, index)] = 0.0
            wanted = np.where(np.any(kept != 0, axis=1), right, 0.0)
            x, y = Balance(mass, kept).solve(found["f"], wanted)
            acceleration = rows[contacts] @ x - right[contacts]
            terms = np.abs(rows[contacts]) @ np.abs(x) + np.abs(right[contacts]) + 1e-300
            if np.all(y[contacts[index]] >= -none[index]) and np.all(acceleration >= -1e-9 * terms):
                return acceleration, terms
    raise AssertionError("a linear complementarity problem with a semidefinite matrix has a solution")


def least_impulse(mass: Floats, rows: Floats, residual: Floats, held: Sequence[int]) -> Floats:
    """The smallest change of rates in the metric of M that makes J v + b zero, those in `held` not changed."""
    free = [i for i in range(len(mass)) if i not in held]
    change = np.zeros(len(mass))
    if free and len(rows):
        change[free] = Balance(mass[np.ix_(free, free)], rows[:, free]).solve(np.zeros(len(free)), -residual)[0]
    return change
