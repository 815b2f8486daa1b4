"""Inverse kinematics: coordinates that place a frame or a point where it is asked to be.

Unknown are the coordinates, within their `min` and `max`. The errors of place [parts of the reach] and of rotation
[rad], a vector of SO(3), and the rows of constraints that restrict positions have to vanish: damped Gauss-Newton with
exact Jacobians, from the start, then from ever wider points about it, the same ones in every run. A step is the one of
least size, so that a redundant arm stays near its start. Coordinates that move nothing of it keep theirs.
Source: Sugihara, Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method, IEEE Trans. Robotics
27(5) (2011) 984-991.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from lagdsl.derivation.structure.names import listed
from lagdsl.derivation.structure.points import HOLDS, Geometry, random_points
from lagdsl.foundation.numerics.connected_blocks import Flags
from lagdsl.foundation.numerics.levenberg_marquardt import Bounds, Minimizer, descend
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.numerics.rotations import inverse_right_jacobian, rotation_vector
from lagdsl.foundation.record import record
from lagdsl.language.flat.display import quantity_text
from lagdsl.language.flat.model import FlatModel

# Position (3,), rotation (3, 3) or None, and the Jacobian of both, (3, nq) or (6, nq), at coordinates (nq,).
Pose = Callable[[Floats], tuple[Floats, Floats | None, Floats]]

_TRIES = 24
_SIZED_AT = 8
_REACHED = 1e-9
_SAME = 1e-9  # round-off of a place that is as far from the target as another


@record(kw_only=True)
class Target:
    """Goal of a frame: `position` (3,) [m] and `rotation` (3, 3), None for what is free."""

    position: Floats | None
    rotation: Floats | None


@record(kw_only=True)
class Placement:
    """The result of inverse kinematics: `q` (nq,), the same by name in `coordinates`, SI units.

    `position_error` [m] and `rotation_error` [rad] are left over, `residual` is the norm of all errors: of places as
    parts of the reach, of angles, of constraints as parts of their sizes. `converged` says that it vanishes, to 1e-9;
    if not, `q` is the nearest configuration found that meets the constraints, and `reason` says what keeps it away.
    `at_limits` are the coordinates at their `min` or `max`; `starts` is the number of starts that were tried.
    """

    q: Floats
    coordinates: dict[str, float]
    converged: bool
    residual: float
    position_error: float
    rotation_error: float
    at_limits: tuple[str, ...]
    starts: int
    reason: str


@record(kw_only=True)
class _Task:
    """The unknowns are x = q / sizes of the coordinates `free`; others stay at `start`. `reach` [m] is the size of
    places."""

    flat: FlatModel
    space: Geometry
    pose: Pose
    target: Target
    start: Floats
    free: Floats
    reach: float
    lower: Floats
    upper: Floats

    @property
    def bounds(self) -> Bounds:
        """Of x."""
        return self.lower / self.space.sizes, self.upper / self.space.sizes

    def q(self, x: Floats) -> Floats:
        return np.where(self.free > 0.0, x * self.space.sizes, self.start)

    def equations(self, x: Floats) -> tuple[Floats, Floats]:
        placed, closed = self.errors(x), self.rows(x)
        return np.concatenate([placed[0], closed[0]]), np.vstack([placed[1], closed[1]])

    def errors(self, x: Floats) -> tuple[Floats, Floats]:
        """The errors, in parts of the reach and rad, and their derivative."""
        position, rotation, jacobian = self.pose(self.q(x))
        residual, derivative = [], []
        if self.target.position is not None:
            residual.append((position - self.target.position) / self.reach)
            derivative.append(jacobian[:3] / self.reach)
        if self.target.rotation is not None and rotation is not None:
            missing = rotation_vector(self.target.rotation @ rotation.T)
            residual.append(-missing)
            derivative.append(inverse_right_jacobian(missing) @ jacobian[3:])
        return np.concatenate(residual), np.vstack(derivative) * (self.space.sizes * self.free)

    def rows(self, x: Floats) -> tuple[Floats, Floats]:
        """Constraints that restrict positions, in parts of their sizes, and their derivative."""
        rows = self.space.position_rows
        if not rows:
            return np.zeros(0), np.zeros((0, len(x)))
        phi, jacobian = self.space.position(self.q(x))
        sizes = self.space.row_sizes[rows]
        return phi[rows] / sizes, jacobian.taken(rows).dense() * (self.space.sizes * self.free) / sizes[:, None]


def inverse_kinematics(
    flat: FlatModel, space: Geometry, pose: Pose, target: Target, start: Floats, hold: tuple[int, ...] = ()
) -> Placement:
    """Coordinates that place `pose` at `target`; those of `hold`, by number, stay at `start` (nq,).

    `space` has the constraints, with everything but q as it is to be.
    """
    free = np.ones(len(start))
    free[list(hold)] = 0.0
    lower, upper = _limits(flat)
    places = [start, *(np.clip(q, lower, upper) for q in random_points(flat.coordinates, start, space.sizes, _TRIES))]
    levers = np.array([pose(q)[2] * space.sizes for q in places[: _SIZED_AT + 1]])
    moving = _contributing(np.any(levers != 0.0, axis=(0, 1)), space.pattern.taken(space.position_rows).dense() != 0.0)
    places = [np.where(moving, q, start) for q in places]
    reach = _reach(levers)
    task = _Task(
        flat=flat, space=space, pose=pose, target=target, start=start, free=free, reach=reach, lower=lower, upper=upper
    )
    with np.errstate(all="ignore"):
        found, starts = _search(task, places)
        found = _unwound(task, found)
        reached = found.size <= _REACHED
        return _placement(
            task, found if reached else _closed(task, found), starts, "" if reached else _reason(task, found)
        )


def _limits(flat: FlatModel) -> tuple[Floats, Floats]:
    lower = [-np.inf if c.minimum is None else c.minimum for c in flat.coordinates]
    upper = [np.inf if c.maximum is None else c.maximum for c in flat.coordinates]
    return np.array(lower), np.array(upper)


def _contributing(flags: Flags, pattern: Flags) -> Flags:
    """The coordinates of `flags`, and those that rows of constraints, by their `pattern`, tie to them."""
    while True:
        tied = flags | np.any(pattern[np.any(pattern & flags, axis=1)], axis=0)
        if np.array_equal(tied, flags):
            return flags
        flags = tied


def _reach(levers: Floats) -> float:
    """The largest displacement [m] that a coordinate of natural size causes, of Jacobians (k, 3 or 6, nq)."""
    lengths = np.linalg.norm(levers[:, :3], axis=1)
    largest = float(np.max(lengths[np.isfinite(lengths)], initial=0.0))
    return largest if largest > 0.0 else 1.0


def _search(task: _Task, places: list[Floats]) -> tuple[Minimizer, int]:
    """The first start that leads to the target, else the best of all; and how many were tried."""
    best: Minimizer | None = None
    for count, place in enumerate(places, 1):
        found = _from(task, place / task.space.sizes)
        if best is None or found.size < best.size:
            best = found
        if best.size <= _REACHED:
            return best, count
    assert best is not None
    return best, len(places)


def _from(task: _Task, x: Floats) -> Minimizer:
    return descend(task.equations, x, bounds=task.bounds)


def _unwound(task: _Task, found: Minimizer) -> Minimizer:
    """The same place with angles less than a turn from the start, where the model cannot tell turns apart."""
    angles = np.array([c.type_name == "Angle" for c in task.flat.coordinates], dtype=np.bool_)
    q = task.q(found.point)
    turns = np.where(angles, np.round((q - task.start) / (2.0 * np.pi)), 0.0)
    nearer = q - 2.0 * np.pi * turns
    if not np.any(turns) or np.any(nearer < task.lower) or np.any(nearer > task.upper):
        return found
    x = nearer / task.space.sizes
    residual = task.equations(x)[0]
    size = float(np.linalg.norm(residual))
    same = size <= max(_REACHED, (1.0 + _SAME) * found.size)
    return Minimizer(point=x, residual=residual, size=size) if same else found


def _closed(task: _Task, found: Minimizer) -> Minimizer:
    """The configuration nearby that meets the constraints."""
    if not task.space.position_rows:
        return found
    met = descend(task.rows, found.point, bounds=task.bounds)
    residual = task.equations(met.point)[0]
    return Minimizer(point=met.point, residual=residual, size=float(np.linalg.norm(residual)))


def _placement(task: _Task, found: Minimizer, starts: int, reason: str) -> Placement:
    q = task.q(found.point)
    place, turn = _left(task, q)
    names = [c.name for c in task.flat.coordinates]
    ends = (q <= task.lower) | (q >= task.upper)
    return Placement(
        q=q,
        coordinates=dict(zip(names, q.tolist(), strict=True)),
        converged=not reason,
        residual=found.size,
        position_error=place,
        rotation_error=turn,
        at_limits=tuple(name for name, end in zip(names, ends.tolist(), strict=True) if end),
        starts=starts,
        reason=reason,
    )


def _left(task: _Task, q: Floats) -> tuple[float, float]:
    """Distance [m] and angle [rad] to the target; zero for what is free."""
    position, rotation, _ = task.pose(q)
    target = task.target
    place = 0.0 if target.position is None else float(np.linalg.norm(position - target.position))
    if target.rotation is None or rotation is None:
        return place, 0.0
    return place, float(np.linalg.norm(rotation_vector(target.rotation @ rotation.T)))


def _reason(task: _Task, found: Minimizer) -> str:
    """The words for a frame that does not reach its target."""
    nearest = _closed(task, found)
    if not np.isfinite(nearest.size):
        return "the place is not finite at any start that was tried: choose another start"
    if float(np.linalg.norm(task.rows(nearest.point)[0])) > HOLDS:
        return "no configuration found meets the constraints: choose another start, or hold less"
    place, turn = _left(task, task.q(nearest.point))
    parts = [f"{place:.4g} m away"] if task.target.position is not None else []
    parts += [f"turned by {np.degrees(turn):.4g} deg"] if task.target.rotation is not None else []
    text = f"the nearest configuration found, from {_TRIES + 1} starts, is {' and '.join(parts)}"
    beyond = _beyond(task, found)
    held = [f"`{c.name}`" for c, free in zip(task.flat.coordinates, task.free.tolist(), strict=True) if not free]
    if beyond:
        return f"{text}; the target lies beyond limits, it would take {listed(beyond)}"
    return f"{text}; {listed(held)} held" if held else text


def _beyond(task: _Task, found: Minimizer) -> list[str]:
    """`q[2] = 95 deg (max 90 deg)` where the target can be reached without limits."""
    wide = np.full(len(task.start), np.inf)
    free = replace(task, lower=-wide, upper=wide)
    ways = (_from(free, x) for x in (found.point, task.start / task.space.sizes))
    other = next((way for way in ways if way.size <= _REACHED), None)
    if other is None:
        return []
    texts = []
    for c, value in zip(task.flat.coordinates, task.q(_unwound(free, other).point).tolist(), strict=True):
        if c.minimum is not None and value < c.minimum:
            texts.append(f"`{c.name}` = {quantity_text(value, c)} (min {quantity_text(c.minimum, c)})")
        if c.maximum is not None and value > c.maximum:
            texts.append(f"`{c.name}` = {quantity_text(value, c)} (max {quantity_text(c.maximum, c)})")
    return texts
