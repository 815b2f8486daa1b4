"""Contacts and dry friction at one instant, by trying all modes.

Rates (of an impulse problem) or accelerations g = G f + c of rows, with the impulses or forces f:

- a contact, or a row that is one way: 0 <= f, 0 <= g, f g = 0;
- a scalar friction: -f in R Sign(g), R = r0 + mu f_n with the force of a contact (F. Pfeiffer, Ch. Glocker, *Multibody
  Dynamics with Unilateral Contacts*, 1996).

In a mode each contact is open or closed, each friction sticks or slides in one direction, so that f follows from linear
equations. A mode is a solution if f and g satisfy the inequalities. The cost is 4 to the power of the contacts.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

Floats = NDArray[np.float64]
Codes = NDArray[np.int8]

# The state of a row in a mode. OFF: a friction under a contact that is open.
OPEN, CLOSED, STICK, PLUS, MINUS, OFF = range(6)

# Of the largest forces and rates: what misses an inequality by less satisfies it.
_NEAR = 1e-9
# Rates that differ by less are one solution.
_ALIKE = 1e-7
_CHUNK = 4096
# Ranks of the equations of a mode.
_RANK = 1e-11


@dataclass(frozen=True)
class Friction:
    """Of the row `row`: slides with r0 + mu f[contact], sticks with up to r0_rest + mu_rest f[contact]."""

    row: int
    contact: int | None = None
    mu: float = 0.0
    r0: float = 0.0
    mu_rest: float | None = None
    r0_rest: float | None = None

    def law(self, at_rest: bool) -> tuple[float, float]:
        """mu and r0."""
        mu = self.mu if not at_rest or self.mu_rest is None else self.mu_rest
        return mu, (self.r0 if not at_rest or self.r0_rest is None else self.r0_rest)


@dataclass(frozen=True)
class Problem:
    """Rows of `contacts` and of `frictions`; all others are bilateral, g = 0."""

    G: Floats
    c: Floats
    contacts: tuple[int, ...]
    frictions: tuple[Friction, ...]


class AmbiguousError(AssertionError):
    """More than one motion, or none, satisfies the law."""


@dataclass(frozen=True)
class Solution:
    """`mode`: what each row is."""

    mode: tuple[int, ...]
    f: Floats
    g: Floats


def solutions(
    problem: Problem, kinetic: Collection[int] = (), given: Mapping[int, int] | None = None
) -> list[Solution]:
    """All modes that satisfy the law and differ in their rates; of those with equal rates the one that holds most.
    Frictions of the rows in `kinetic` have the limit of sliding at rest, too. `given` fixes rows, whose rates may
    have either sign."""
    unit = 1 / np.sqrt(np.where(np.diag(problem.G) > 0, np.diag(problem.G), 1.0))
    scaled = _scaled(problem, unit)
    found: list[Solution] = []
    for modes in _chunks(problem, given or {}):
        for mode, f in _satisfied(scaled, modes, kinetic, given or {}):
            g = scaled.G @ f + scaled.c
            if not any(np.max(np.abs(g - other.g)) <= _ALIKE * _size(scaled) for other in found):
                found.append(Solution(tuple(int(code) for code in mode), f, g))
    return [Solution(each.mode, each.f * unit, each.g / unit) for each in found]


def _size(problem: Problem) -> float:
    return max(1e-300, float(np.max(np.abs(problem.c), initial=0.0)))


def _scaled(problem: Problem, unit: Floats) -> Problem:
    """In units in which G has a unit diagonal."""

    def scaled(each: Friction) -> Friction:
        own = unit[each.row]
        ratio = unit[each.contact] / own if each.contact is not None else 1.0
        (mu, r0), (mu_rest, r0_rest) = each.law(at_rest=False), each.law(at_rest=True)
        return Friction(each.row, each.contact, mu * ratio, r0 / own, mu_rest * ratio, r0_rest / own)

    frictions = tuple(scaled(each) for each in problem.frictions)
    return Problem(problem.G * np.outer(unit, unit), problem.c * unit, problem.contacts, frictions)


def _chunks(problem: Problem, given: Mapping[int, int]) -> Iterator[Codes]:
    """All modes (modes, rows), some thousands at a time."""
    groups = _groups(problem)
    sizes = [len(alternatives) for _, alternatives in groups]
    count = int(np.prod(sizes, dtype=np.int64)) if sizes else 1
    for first in range(0, count, _CHUNK):
        choice = np.unravel_index(np.arange(first, min(first + _CHUNK, count)), sizes) if sizes else ()
        modes = np.full((min(_CHUNK, count - first), len(problem.c)), CLOSED, dtype=np.int8)
        for (rows, alternatives), chosen in zip(groups, choice, strict=True):
            modes[:, rows] = np.array(alternatives, dtype=np.int8)[chosen]
        for row, code in given.items():
            modes = modes[(modes[:, row] == code) | (modes[:, row] == OFF)]
        yield modes


def _groups(problem: Problem) -> list[tuple[list[int], list[tuple[int, ...]]]]:
    """Rows of each contact with the frictions that need its force, and of each other friction: what they may be."""
    needy = [each for each in problem.frictions if each.contact is not None and not each.r0 and not each.r0_rest]
    groups: list[tuple[list[int], list[tuple[int, ...]]]] = []
    for contact in problem.contacts:
        mine = [each.row for each in needy if each.contact == contact]
        closed = [(CLOSED, *choice) for choice in product((STICK, PLUS, MINUS), repeat=len(mine))]
        groups.append(([contact, *mine], [*closed, (OPEN, *[OFF] * len(mine))]))
    groups += [([each.row], [(STICK,), (PLUS,), (MINUS,)]) for each in problem.frictions if each not in needy]
    return groups


def _satisfied(
    problem: Problem, modes: Codes, kinetic: Collection[int], given: Mapping[int, int]
) -> Iterator[tuple[Codes, Floats]]:
    """Of these modes those that satisfy the law, with forces: of redundant rows some of them."""
    matrix, right = _equations(problem, modes, kinetic)
    u, s, vt = np.linalg.svd(matrix)
    keep = s > _RANK * np.maximum(s[:, :1], 1e-300)
    inverse = np.where(keep, 1 / np.where(keep, s, 1.0), 0.0)
    f = np.einsum("kji,kj->ki", vt, inverse * np.einsum("kji,kj->ki", u, right))
    near = _NEAR * (_size(problem) + np.max(np.abs(f), axis=1, initial=0.0))
    consistent = np.max(np.abs(np.einsum("kij,kj->ki", matrix, f) - right), axis=1, initial=0.0) <= near
    reserves = _reserves(problem, modes, f, kinetic, given)
    holds = np.min(reserves, axis=1, initial=np.inf) >= -near
    redundant = keep.sum(axis=1) < len(problem.c)
    for k in np.flatnonzero(consistent & (holds | redundant)):
        if holds[k]:
            yield modes[k], f[k]
        elif (other := _some(problem, modes[k], (matrix[k], right[k]), kinetic, given, near[k])) is not None:
            yield modes[k], other


def _equations(problem: Problem, modes: Codes, kinetic: Collection[int]) -> tuple[Floats, Floats]:
    """E f = e of each mode, one for each row: no force, no rate, or the force of sliding."""
    held = (modes == CLOSED) | (modes == STICK)
    matrix = np.where(held[:, :, None], problem.G, np.eye(len(problem.c)))
    right = np.where(held, -problem.c, 0.0)
    for each in problem.frictions:
        mu, r0 = each.law(at_rest=each.row not in kinetic)
        sign = (modes[:, each.row] == PLUS) * 1.0 - (modes[:, each.row] == MINUS)
        right[:, each.row] -= sign * r0
        if each.contact is not None:
            matrix[:, each.row, each.contact] += sign * mu
    return matrix, right


def _reserves(problem: Problem, modes: Codes, f: Floats, kinetic: Collection[int], given: Mapping[int, int]) -> Floats:
    """Numbers that must not be negative (modes, rows and frictions)."""
    g = f @ problem.G.T + problem.c
    free = np.array([row not in given for row in range(len(problem.c))], dtype=bool)
    contacts = np.isin(np.arange(len(problem.c)), problem.contacts)
    rows = np.select(
        [(modes == CLOSED) & contacts, ((modes == OPEN) | (modes == PLUS)) & free, (modes == MINUS) & free],
        [f, g, -g],
        np.inf,
    )
    sticking = [np.full(len(modes), np.inf)]
    for each in problem.frictions:
        mu, r0 = each.law(at_rest=each.row not in kinetic)
        limit = r0 + (mu * f[:, each.contact] if each.contact is not None else 0.0)
        sticking.append(np.where(modes[:, each.row] == STICK, limit - np.abs(f[:, each.row]), np.inf))
    return np.hstack([rows, np.array(sticking).T])


def _some(
    problem: Problem,
    mode: Codes,
    equations: tuple[Floats, Floats],
    kinetic: Collection[int],
    given: Mapping[int, int],
    near: float,
) -> Floats | None:
    """Forces of redundant rows with the largest least reserve, None if that is negative."""
    count = len(problem.c)
    rows, bounds = _inequalities(problem, mode, kinetic, given)
    if not rows:
        return None
    found = linprog(
        np.append(np.zeros(count), -1.0),
        A_ub=np.hstack([rows, np.ones((len(rows), 1))]),
        b_ub=bounds,
        A_eq=np.hstack([equations[0], np.zeros((count, 1))]),
        b_eq=equations[1],
        bounds=[(None, None)] * count + [(None, max(1.0, _size(problem)))],
    )
    return np.asarray(found.x[:-1]) if found.success and found.x[-1] >= -near else None


def _inequalities(
    problem: Problem, mode: Codes, kinetic: Collection[int], given: Mapping[int, int]
) -> tuple[list[Floats], list[float]]:
    """The same reserves as rows f <= bounds."""
    unit, rows, bounds = np.eye(len(problem.c)), [], []
    for row in np.flatnonzero(np.isin(mode, (OPEN, PLUS, MINUS))):
        if row not in given:
            sign = -1.0 if mode[row] == MINUS else 1.0
            rows.append(-sign * problem.G[row])
            bounds.append(sign * float(problem.c[row]))
    for row in problem.contacts:
        if mode[row] == CLOSED:
            rows.append(-unit[row])
            bounds.append(0.0)
    for each in problem.frictions:
        if mode[each.row] == STICK:
            mu, r0 = each.law(at_rest=each.row not in kinetic)
            limit = mu * unit[each.contact] if each.contact is not None else 0 * unit[each.row]
            rows += [unit[each.row] - limit, -unit[each.row] - limit]
            bounds += [r0, r0]
    return rows, bounds


def reserve(problem: Problem, mode: tuple[int, ...]) -> tuple[float, Floats]:
    """Of a mode with redundant rows the largest least reserve of forces: negative where no forces within their limits
    carry it on. With those forces."""
    codes = np.array(mode, dtype=np.int8)
    matrix, right = _equations(problem, codes[None], [each.row for each in problem.frictions])
    free = {row: mode[row] for row in range(len(mode)) if mode[row] in (OPEN, PLUS, MINUS)}
    found = _some(problem, codes, (matrix[0], right[0]), (), free, np.inf)
    assert found is not None
    rows, bounds = _inequalities(problem, codes, (), free)
    return float(np.min(np.array(bounds) - np.array(rows) @ found)), found
