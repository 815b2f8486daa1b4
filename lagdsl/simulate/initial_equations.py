"""Initial equations: positions, rates, states and accelerations solved together (ruling 27)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from lagdsl.diagnostics import Sink
from lagdsl.mechanics.rank import Floats, rank
from lagdsl.mechanics.structure_newton import Descent, descend
from lagdsl.mechanics.structure_points import HOLDS, random_points
from lagdsl.runtime.engine import SingularSystem
from lagdsl.simulate.initial_positions import report_overdetermined
from lagdsl.simulate.initial_problem import EXPLICIT_WEIGHT, Problem

_TRIES = 12
_DIFFERENCE = 1e-6


@dataclass(frozen=True, slots=True)
class _Joint:
    """All unknowns as one vector y of weighted distances from the starts."""

    task: Problem
    starts: Floats
    widths: Floats
    free: np.ndarray

    def split(self, y: Floats) -> tuple[Floats, Floats, Floats]:
        """q, qd, z at the unknowns y."""
        x = self.starts.copy()
        x[self.free] += self.widths[self.free] * y
        n = len(self.task.space.q)
        return x[:n], x[n : 2 * n], x[2 * n :]

    def residual(self, y: Floats) -> Floats:
        """Constraints of both levels, relative to their rows' sizes, then the initial equations in their own
        units."""
        q, qd, z = self.split(y)
        space = self.task.space
        phi = space.position(q)[0] / space.row_sizes
        velocity = space.velocity(q, qd)[0] / space.row_sizes
        try:
            qdd, lam = self.task.engine.solve(space.t, q, qd, z, space.u, space.w, space.p)
        except SingularSystem:
            qdd, lam = np.full_like(q, np.nan), np.full_like(phi, np.nan)
        arguments = (space.t, q, qd, z, space.u, space.w, space.p, qdd, lam)
        (extra,) = self.task.engine.evaluate("initial_equation", *arguments)
        return np.concatenate([phi[space.position_rows], velocity, extra])

    def jacobian(self, y: Floats) -> Floats:
        """By central differences: rows of the initial equations hold accelerations, whose derivatives nobody else
        needs."""
        columns = []
        for index in range(len(y)):
            step = np.zeros_like(y)
            step[index] = _DIFFERENCE
            columns.append((self.residual(y + step) - self.residual(y - step)) / (2.0 * _DIFFERENCE))
        return np.array(columns).reshape(len(y), -1).T


def joint_state(task: Problem, sink: Sink) -> tuple[Floats, Floats, Floats]:
    """q, qd, z that satisfy constraints and initial equations, near the starts; E0801 or E0815 where there are
    none."""
    joint = _assemble(task)
    fixed_too = _Joint(task, joint.starts, joint.widths, np.arange(len(joint.starts)))
    lengths = np.linalg.norm(fixed_too.jacobian(np.zeros(len(joint.starts))), axis=1)
    scale = np.where(np.isfinite(lengths) & (lengths > 0.0), lengths, 1.0)

    def equations(y: Floats) -> tuple[Floats, Floats]:
        return joint.residual(y) / scale, joint.jacobian(y) / scale[:, None]

    best = descend(equations, np.zeros(len(joint.free)), target=1e-11)
    for other in random_points(task.flat.coordinates, task.space.q, task.space.sizes, _TRIES, task.seed):
        if best.size <= HOLDS:
            break
        beginning = np.zeros(len(joint.starts))
        beginning[: len(other)] = (other - task.space.q) / joint.widths[: len(other)]
        found = descend(equations, beginning[joint.free], target=1e-11)
        if found.size < best.size:
            best = found
    if best.size > HOLDS:
        _report(task, joint, fixed_too, best, scale, sink)
    return joint.split(best.point)


def _assemble(task: Problem) -> _Joint:
    space, flat = task.space, task.flat
    sharp = np.sqrt(EXPLICIT_WEIGHT)
    rate_widths = np.where(task.rate_explicit, space.sizes / sharp, space.sizes)
    state_sizes = np.array([abs(s.nominal) if s.nominal else 1.0 for s in flat.states])
    state_widths = np.where(
        np.array([s.start_explicit for s in flat.states], dtype=bool), state_sizes / sharp, state_sizes
    )
    fixed = np.concatenate([task.fixed, task.rate_fixed, np.array([s.fixed for s in flat.states], dtype=bool)])
    starts = np.concatenate([space.q, space.qd, space.z])
    return _Joint(task, starts, np.concatenate([task.widths, rate_widths, state_widths]), np.flatnonzero(~fixed))


def _report(task: Problem, joint: _Joint, fixed_too: _Joint, found: Descent, scale: Floats, sink: Sink) -> None:
    whole = fixed_too.jacobian(_widened(joint, found.point)) / scale[:, None]
    if np.all(np.isfinite(whole)):
        excess = rank(whole) - rank(whole[:, joint.free])
        if excess > 0 and any(c.fixed for c in task.flat.coordinates):
            report_overdetermined(task, excess, max(len(joint.starts) - rank(whole), 0), sink)
            return
    first = task.flat.initial_equations[0]
    sizes = found.residual * scale
    worst = float(np.max(np.abs(sizes))) if np.all(np.isfinite(sizes)) else np.inf
    sink.report("E0815", first.spans[0] if first.spans else None, residual=f"{worst:.3g}")


def _widened(joint: _Joint, y: Floats) -> Floats:
    whole = np.zeros(len(joint.starts))
    whole[joint.free] = y
    return whole
