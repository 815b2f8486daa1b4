"""Dense linear algebra of mechanics: accelerations, least impulses, impacts. Written from the textbooks (F. Pfeiffer,
Ch. Glocker, *Multibody Dynamics with Unilateral Contacts*, 1996; B. Brogliato, *Nonsmooth Mechanics*, 2016)."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
_RANK = 1e-10


class Balance:
    """M x - J' y = a, J x = b, for any ranks of J: x and the shortest y, in units in which M has a unit diagonal and
    the rows of J are of length one."""

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


def least_impulse(mass: Floats, rows: Floats, residual: Floats, held: Sequence[int]) -> Floats:
    """The smallest change of rates in the metric of M that makes J v + b zero, those in `held` not changed."""
    free = [i for i in range(len(mass)) if i not in held]
    change = np.zeros(len(mass))
    if free and len(rows):
        change[free] = Balance(mass[np.ix_(free, free)], rows[:, free]).solve(np.zeros(len(free)), -residual)[0]
    return change
