"""Are the constraints about to lose rank, and do branches of the motion really meet there?

Rows of J have size one, so its singular values are those of the mechanism; independent parts of it are looked at each
for itself. Along a branch that crosses a singular position some of them pass through zero and change their sign. A step
that jumps across shows it: seen in the singular vectors of the state before, J has then turned around.

Branches that meet do so in a saddle of a combination u of the rows: u'J = 0 there. Its height, u'phi, is zero; where it
is not, the branches miss each other by as much and the motion turns away, however sharply.
Source: W. Rheinboldt, Numerical Analysis of Parametrized Nonlinear Equations (1986), chapter 5 (simple bifurcations).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from lagdsl.mechanics.partition import Parts, entries
from lagdsl.mechanics.rank import Floats, minimum_norm
from lagdsl.mechanics.structure_points import Geometry
from lagdsl.simulate.right_hand_side import RightHandSide

# Singular values of J, rows of size one: where rank counts as lost, where that seems near.
LOST = 1e-7
NEAR = 0.05
# By how much, as a part of the sizes of their rows, branches that meet may miss each other.
MEETING = 1e-12
_ITERATIONS = 12
_SETTLED = 1e-8
_LEVEL = 1e-6
_DIFFERENCE = 1e-5


@dataclass(frozen=True, slots=True)
class Directions:
    """Singular vectors and values of the parts of one shape: (k, r, r), (k, s), (k, s, c); `kept` (k, s) flags those
    that belong to the rank of general positions and are not lost."""

    parts: Parts
    left: Floats
    values: Floats
    right: Floats
    kept: np.ndarray


@dataclass(frozen=True, slots=True)
class Look:
    """J at one state; `margin` is the smallest singular value of those that are not zero in general."""

    directions: tuple[Directions, ...]
    margin: float
    rank: int


class Ranks:
    """Looks at J of one simulation, whose rows `redundant` depend on others in general."""

    def __init__(self, space: Geometry, redundant: tuple[bool, ...]) -> None:
        self._space = space
        self._split = space.parts(list(range(len(redundant))))
        independent = ~np.array(redundant, dtype=np.bool_)
        self.general = int(np.count_nonzero(independent))
        self._counts = np.bincount(self._split.row_labels[independent], minlength=self._split.count)
        self._kept = np.flatnonzero(independent)

    def look(self, jacobian: Floats) -> Look:
        scaled = self._scaled(jacobian)
        found, margin, rank = [], np.inf, 0
        for parts in self._split.parts:
            left, values, right = np.linalg.svd(entries(scaled, parts), full_matrices=False)
            general = np.arange(values.shape[1]) < self._counts[parts.labels][:, None]
            margin = min(margin, float(np.min(values, where=general, initial=np.inf)))
            kept = general & (values > LOST)
            rank += int(np.count_nonzero(kept))
            found.append(Directions(parts, left, values, right, kept))
        return Look(tuple(found), margin, rank)

    def turn(self, look: Look, jacobian: Floats) -> float:
        """How far J has turned since that look: 1 not at all, 0 where a direction is lost, negative where one has
        changed its sign."""
        scaled = self._scaled(jacobian)
        least = np.inf
        for seen in look.directions:
            now = np.swapaxes(seen.left, -1, -2) @ entries(scaled, seen.parts) @ np.swapaxes(seen.right, -1, -2)
            now = now / np.where(seen.kept, seen.values, 1.0)[:, :, None]
            both = seen.kept[:, :, None] & seen.kept[:, None, :]
            now = np.where(both, now, np.eye(now.shape[-1]))
            if not np.all(np.isfinite(now)):
                return -np.inf
            least = min(least, float(np.min(np.linalg.eigvals(now).real, initial=np.inf)))
        return least

    def weakest(self, jacobian: Floats) -> int:
        """The row that has the largest share in the combination of rows that vanishes."""
        left = np.linalg.svd(self._scaled(jacobian)[self._kept])[0]
        return int(self._kept[int(np.argmax(np.abs(left[:, -1])))])

    def _scaled(self, jacobian: Floats) -> Floats:
        return np.asarray(jacobian * self._space.sizes / self._space.row_sizes[:, None])


def saddle_height(system: RightHandSide, space: Geometry, general: int, t: float, y: Floats) -> float:
    """By how much branches miss each other at the saddle near the state `y`, as a part of the sizes of the rows;
    infinite where there is none.

    Newton's method for u'[J b] = 0 where the rows that do not vanish hold; time is a coordinate like others, scaled so
    that the constraints move by their size.
    """
    n = system.n
    speed = np.abs(space.velocity(np.ascontiguousarray(y[:n]), np.zeros(n))[0]) / space.row_sizes
    pace = 1.0 / (float(np.max(speed, initial=0.0)) or 1.0)
    sizes = np.append(space.sizes, pace)
    point = np.append(y[:n] / space.sizes, 0.0)
    z = y[2 * n :].copy()
    position = np.array(space.functions.layout.position_level, dtype=np.float64)

    def rows(x: Floats) -> tuple[Floats, Floats]:
        time, q = t + pace * float(x[-1]), np.ascontiguousarray(x[:-1] * space.sizes)
        rest = (z, system.inputs(time), system.w, system.p)
        drift, jacobian = system.engine.evaluate("velocity_constraint", time, q, np.zeros(n), *rest)
        phi = system.engine.evaluate("position_constraint", time, q, np.zeros(n), *rest)[0]
        wide = np.hstack([jacobian, drift[:, None]]) * sizes / space.row_sizes[:, None]
        return position * phi / space.row_sizes, wide

    for _ in range(_ITERATIONS):
        phi, wide = rows(point)
        if not np.all(np.isfinite(wide)) or not np.all(np.isfinite(phi)):
            return np.inf
        left, values, right = np.linalg.svd(wide)
        holding = min(general - 1, int(np.count_nonzero(values[:general] > NEAR)))
        vanishing, free = left[:, holding:general], right[holding:]
        slopes = [(rows(point + d)[1] - rows(point - d)[1]).T @ vanishing for d in _DIFFERENCE * np.eye(n + 1)]
        bends = np.array(slopes) / (2.0 * _DIFFERENCE)  # (direction, column of J, combination)
        conditions = np.einsum("ij,djk->kid", free, bends).reshape(-1, n + 1)
        lines = np.vstack([left[:, :holding].T @ wide, conditions])
        wanted = np.concatenate([left[:, :holding].T @ phi, (free @ (wide.T @ vanishing)).T.ravel()])
        step = minimum_norm(lines, wanted, 1e-6)
        if np.linalg.norm(step) > 1.0:
            return np.inf
        point = point - step
        if np.linalg.norm(step) <= _SETTLED:
            phi, wide = rows(point)
            slope = float(np.max(np.abs(wide.T @ vanishing), initial=0.0))
            return float(np.max(np.abs(vanishing.T @ phi), initial=0.0)) if slope <= _LEVEL else np.inf
    return np.inf
