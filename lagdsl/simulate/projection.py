"""Back to the constraints: the smallest change in the metric of the mass matrix.

With M the inertia, dq minimises dq' M dq subject to phi(q + dq) = 0, and dv minimises dv' M dv subject to J (v + dv)
+ b = 0: the change a stiff, inelastic mechanism would make. Rows are weighted by minimum norm with rank decisions,
so dependent constraints and singular positions pass. Source: Eich, SIAM J. Numer. Anal. 30 (1993) 1467.
"""

from __future__ import annotations

import numpy as np

from lagdsl.mechanics.rank import Floats, augmented_mass, minimum_norm
from lagdsl.mechanics.structure_points import Geometry
from lagdsl.simulate.right_hand_side import RightHandSide

_ITERATIONS = 12
# Rows that turn dependent on the constraint set only are independent by round-off beside it.
_RANK = 1e-8
_ROUNDING = 1e-14


class Projection:
    """Projects states of one simulation. `tolerance` is the residual that needs no correction: in SI units of the row,
    and as a part of its natural size where that is smaller than one; round-off of large rows passes."""

    def __init__(self, system: RightHandSide, space: Geometry, tolerance: float) -> None:
        self.system = system
        self.sizes = space.sizes
        self.tolerance = tolerance
        self.row_sizes = space.row_sizes
        self._limits = np.maximum(tolerance * np.minimum(self.row_sizes, 1.0), _ROUNDING * self.row_sizes)
        self.rows = space.position_rows
        self.count = 0
        self.active = len(space.row_sizes) > 0

    def __call__(self, t: float, y: Floats) -> Floats | None:
        """The projected state; the same object if nothing had to change, None if the positions cannot be repaired."""
        if not self.active:
            return y
        q, qd, z = (part.copy() for part in self.system.split(y))
        u = self.system.inputs(t)
        moved = self._positions(t, q, qd, z, u)
        if moved is None:
            return None
        rates = self._rates(t, moved, qd, z, u)
        if moved is q and rates is qd:
            return y
        self.count += 1
        return np.concatenate([moved, rates, z])

    def onto_rates(self, t: float, y: Floats, held: tuple[int, ...]) -> Floats:
        """The state with its rates moved onto the constraints, without the `held` ones where the others can do it."""
        if not self.active:
            return y
        q, qd, z = (part.copy() for part in self.system.split(y))
        evaluate, rest = self.system.engine.evaluate, (z, self.system.inputs(t), self.system.w, self.system.p)
        residual, jacobian = evaluate("velocity_constraint", t, q, qd, *rest)
        mass = evaluate("mass_matrix", t, q, qd, *rest)[0]
        rows, right = jacobian / self.row_sizes[:, None], residual / self.row_sizes
        hold = np.eye(len(q))[list(held)]
        for extra in (hold, hold[:0]):
            both, wanted = np.vstack([rows, extra]), np.concatenate([right, np.zeros(len(extra))])
            change = self._smallest(mass, both, wanted)
            if np.all(np.abs(both @ change - wanted) <= _RANK * (1.0 + np.abs(right).max(initial=0.0))):
                break
        return np.concatenate([q, qd - change, z])

    def residuals(self, t: float, y: Floats) -> tuple[float, float]:
        """Largest position residual and largest velocity residual, each in the units of its row."""
        if not self.active:
            return 0.0, 0.0
        phi, velocity = self._off("position_constraint", t, y), self._off("velocity_constraint", t, y)
        return float(np.max(phi, initial=0.0)), float(np.max(velocity, initial=0.0))

    def distance(self, t: float, y: Floats) -> float:
        """Largest position residual as a part of the natural size of its row."""
        return float(np.max(self.distances(t, y), initial=0.0))

    def distances(self, t: float, y: Floats) -> Floats:
        """Position residuals (nc) as parts of the natural sizes of their rows."""
        return self._off("position_constraint", t, y) / self.row_sizes

    def worst(self, t: float, y: Floats) -> tuple[int, float]:
        """Index and residual of the position row that is farthest off."""
        row = int(np.argmax(self.distances(t, y)))
        return row, float(self._off("position_constraint", t, y)[row])

    def _off(self, function: str, t: float, y: Floats) -> Floats:
        q, qd, z = (part.copy() for part in self.system.split(y))
        rest = (z, self.system.inputs(t), self.system.w, self.system.p)
        return np.abs(self.system.engine.evaluate(function, t, q, qd, *rest)[0])

    def _positions(self, t: float, q: Floats, qd: Floats, z: Floats, u: Floats) -> Floats | None:
        if not self.rows:
            return q
        evaluate, rest = self.system.engine.evaluate, (z, u, self.system.w, self.system.p)
        point, mass = q, None
        previous = np.inf
        for _ in range(_ITERATIONS):
            phi, jacobian = evaluate("position_constraint", t, point, qd, *rest)
            size = float(np.max(np.abs(phi[self.rows]) / self._limits[self.rows], initial=0.0))
            if size <= 1.0:
                return point
            if not size < np.inf or size > 1e3 * previous:
                return None
            previous = size
            if mass is None:
                mass = evaluate("mass_matrix", t, point, qd, *rest)[0]
            rows = jacobian[self.rows] / self.row_sizes[self.rows, None]
            point = point - self._smallest(mass, rows, phi[self.rows] / self.row_sizes[self.rows])
        # Round-off, or a singular position where convergence is slow: good enough if close.
        return point if previous <= 1e3 else None

    def _rates(self, t: float, q: Floats, qd: Floats, z: Floats, u: Floats) -> Floats:
        evaluate, rest = self.system.engine.evaluate, (z, u, self.system.w, self.system.p)
        residual, jacobian = evaluate("velocity_constraint", t, q, qd, *rest)
        pace = max(1.0, float(np.max(np.abs(qd) / self.sizes, initial=0.0)))
        if not float(np.max(np.abs(residual) / self._limits, initial=0.0)) > pace:
            return qd
        mass = evaluate("mass_matrix", t, q, qd, *rest)[0]
        return np.asarray(qd - self._smallest(mass, jacobian / self.row_sizes[:, None], residual / self.row_sizes))

    def _smallest(self, mass: Floats, rows: Floats, right: Floats) -> Floats:
        """Minimise dx' M dx subject to rows dx = right, in least squares where the rows contradict each other."""
        metric = augmented_mass(mass * self.sizes * self.sizes[:, None], rows * self.sizes)
        try:
            factor = np.linalg.cholesky(metric)
        except np.linalg.LinAlgError:
            return np.asarray(self.sizes * minimum_norm(rows * self.sizes, right, _RANK))
        weighted = np.linalg.solve(factor, (rows * self.sizes).T).T
        return np.asarray(self.sizes * np.linalg.solve(factor.T, minimum_norm(weighted, right, _RANK)))
