"""Random problems of contacts with Coulomb's friction, and what any solver of them has to satisfy.

g = G f + c of rows: first those of the contacts, then the components of each slip, one or two. A contact: 0 <= f, 0
<= g, f g = 0. A slip: -f in R Sign(g) with R = r + mu f_n: at rest any force of at most R, else R against the slip.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from stepping.friction_modes import Friction, Problem, solutions

Floats = NDArray[np.float64]
Kind = Literal["impulses", "redundant impulses", "accelerations", "with own limits"]
KINDS: tuple[Kind, ...] = ("impulses", "redundant impulses", "accelerations", "with own limits")


@dataclass(frozen=True)
class RandomProblem:
    """`components` of each slip; `limits` r (slips), `mu` (slips, contacts)."""

    kind: Kind
    G: Floats
    c: Floats
    contacts: int
    components: tuple[int, ...]
    limits: Floats
    mu: Floats

    @property
    def slips(self) -> list[list[int]]:
        """Rows of each."""
        ends = self.contacts + np.cumsum((0, *self.components))
        return [list(range(a, b)) for a, b in pairwise(ends.tolist())]


# Forces or impulses of all rows; None where the solver finds none.
Solver = Callable[[RandomProblem], Floats | None]


def random_problem(seed: int, planar: bool, most: int = 12) -> RandomProblem:
    """One to `most` contacts on a random mechanism, some without friction. The same for a seed on every machine."""
    random = np.random.default_rng([seed, planar])
    kind = KINDS[seed % len(KINDS)]
    contacts = int(random.integers(1, most + 1))
    rubbing = [k for k in range(contacts) if random.random() < 0.85]
    own = int(random.integers(1, 3)) if kind == "with own limits" else 0
    components = tuple(int(n) for n in random.choice([1, 2] if planar else [1], len(rubbing) + own))
    rows = contacts + sum(components)
    freedoms = rows + int(random.integers(0, 4))
    if kind == "redundant impulses":
        freedoms = max(2, int(random.integers(rows // 2, rows + 1)))
    root = random.normal(size=(freedoms, freedoms))
    mobility = root @ root.T / freedoms + 0.1 * np.eye(freedoms)
    J = random.normal(size=(rows, freedoms))
    G = J @ mobility @ J.T
    c = J @ random.normal(size=freedoms) if "impulses" in kind else 3.0 * random.normal(size=rows)
    mu = np.zeros((len(components), contacts))
    for slip, contact in enumerate(rubbing):
        mu[slip, contact] = random.uniform(0.0, 1.0 if "impulses" in kind else 0.6)
    limits = np.zeros(len(components))
    limits[len(rubbing) :] = random.uniform(0.1, 2.0, own)
    return RandomProblem(kind, G, c, contacts, components, limits, mu)


def residual(problem: RandomProblem, f: Floats) -> float:
    """The worst violation of the law, against the terms of the row in which it is."""
    g = problem.G @ f + problem.c
    forces = np.abs(f) + np.abs(problem.c) / np.diag(problem.G)
    rates = np.abs(problem.G) @ np.abs(f) + np.abs(problem.c) + 1e-300
    worst = 0.0
    for row in range(problem.contacts):
        apart, push = g[row] / rates[row], f[row] / (np.max(forces) + 1e-300)
        worst = max(worst, -apart, -push, min(apart, push))
    for rows, r, mu in zip(problem.slips, problem.limits, problem.mu, strict=True):
        limit = max(0.0, float(r + mu @ f[: problem.contacts]))
        force, slip = float(np.linalg.norm(f[rows])), float(np.linalg.norm(g[rows]))
        most = np.max(forces) + r
        worst = max(worst, (force - limit) / most)
        if slip > 1e-12 * np.max(rates[rows]):  # the power of friction is the least of all
            worst = max(
                worst, float(limit * slip + f[rows] @ g[rows]) / (most * slip) * min(1.0, slip / np.max(rates[rows]))
            )
    return worst


def enumerated(problem: RandomProblem) -> list[Floats]:
    """Rates of all solutions of a problem with scalar slips."""
    assert all(count == 1 for count in problem.components)
    frictions = []
    for (row,), r, mu in zip(problem.slips, problem.limits, problem.mu, strict=True):
        on = np.flatnonzero(mu)
        frictions.append(Friction(row, int(on[0]), float(mu[on[0]])) if len(on) else Friction(row, r0=float(r)))
    contacts = tuple(range(problem.contacts))
    return [each.g for each in solutions(Problem(problem.G, problem.c, contacts, tuple(frictions)))]


def bounced(problem: RandomProblem, e: float, solve: Solver) -> tuple[Floats, Floats] | None:
    """Impulses and rates after a blow by Poisson's law: compression, then e times its normal impulses."""
    first = solve(problem)
    if first is None:
        return None
    back = np.zeros_like(first)
    back[: problem.contacts] = e * first[: problem.contacts]
    rates = problem.c + problem.G @ (first + back)
    second = solve(replace(problem, c=rates, limits=problem.limits + problem.mu @ back[: problem.contacts]))
    if second is None:
        return None
    impulse = first + back + second
    return impulse, problem.c + problem.G @ impulse


def energy_gained(problem: RandomProblem, impulse: Floats, after: Floats) -> float:
    """Of the blow, against its size."""
    gained = float((problem.c + after) @ impulse) / 2
    return gained / max(1e-300, float(np.abs(problem.c) @ np.abs(impulse)))
