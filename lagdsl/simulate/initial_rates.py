"""Start rates: fixed ones, then explicit ones as far as the constraints leave them free, then least kinetic energy
of the change."""

from __future__ import annotations

import numpy as np

from lagdsl.diagnostics import Label, Sink
from lagdsl.mechanics.rank import Floats, minimum_norm, null_space, rank
from lagdsl.mechanics.structure_names import located, place, seat, unit_suffix
from lagdsl.mechanics.structure_newton import descend
from lagdsl.mechanics.structure_points import HOLDS
from lagdsl.simulate.initial_problem import Problem

# A rate that the remaining freedom moves by less than this part is decided by the others (dead centers).
_INDEPENDENT = 1e-6
_CONSISTENT = 1e-9


def rates(task: Problem, q: Floats, sink: Sink) -> Floats:
    """Rates at positions `q`: J v + b = 0 and fixed rates exactly (else E0803), see ruling 26 for the rest."""
    space = task.space
    sizes = space.sizes
    if not len(space.row_sizes):  # nothing restricts them
        return space.qd
    drift, jacobian = space.velocity(q, np.zeros_like(q))
    rows = jacobian * sizes / space.row_sizes[:, None]
    fixed = np.flatnonzero(task.rate_fixed)
    wanted = space.qd / sizes
    conditions = np.vstack([rows, np.eye(len(q))[fixed]])
    right = np.concatenate([-drift / space.row_sizes, wanted[fixed]])
    v = minimum_norm(conditions, right)
    left_over = np.abs(conditions @ v - right)
    if float(np.max(left_over, initial=0.0)) > _CONSISTENT * (1.0 + float(np.max(np.abs(right), initial=0.0))):
        _report(task, left_over, fixed, sink)
        return np.asarray(v * sizes)
    unbound = null_space(conditions)
    v, free = _explicit(v, unbound, wanted, np.flatnonzero(task.rate_explicit & ~task.rate_fixed))
    v = v + free @ (free.T @ (wanted - v))
    mass = space.mass(q, v * sizes) * sizes * sizes[:, None]
    v = v + free @ minimum_norm(free.T @ mass @ free, free.T @ mass @ (wanted - v))
    v = _on_a_branch(task, q, v, rows, [free, unbound])
    result = np.asarray(v * sizes)
    # What was met exactly is handed on exactly, not to within round-off.
    exact = np.abs(result - space.qd) <= 1e-13 * np.maximum(np.abs(space.qd), sizes)
    return np.where(exact, space.qd, result)


def _explicit(v: Floats, free: Floats, wanted: Floats, explicit: np.ndarray) -> tuple[Floats, Floats]:
    """Impose explicit rates in order of declaration, each if it is independent of the constraints and those before
    it."""
    for index in explicit:
        row = free[index]
        length = float(np.linalg.norm(row))
        if length > _INDEPENDENT:
            v = v + free @ (row * ((wanted[index] - v[index]) / length**2))
            free = free @ null_space(row[None, :])
    return v, free


def _on_a_branch(task: Problem, q: Floats, v: Floats, rows: Floats, spaces: list[Floats]) -> Floats:
    """In a singular position J leaves rates free that lead off the constraints at once: not along any branch of the
    motion.

    The rates of a branch also satisfy n' gamma(q, v) = 0 for every n with n' J = 0. The nearest such rates are
    taken; the explicit ones are kept if that is possible.
    """
    space = task.space
    general = space.functions.layout.redundant.count(False)
    if rank(rows, 1e-7) >= general:
        return v
    vanishing = null_space(rows.T, 1e-7).T

    def bias(rates: Floats) -> Floats:
        arguments = (space.t, q, rates * space.sizes, space.z, space.u, space.w, space.p)
        return np.asarray(vanishing @ (task.engine.evaluate("dynamics", *arguments)[3] / space.row_sizes))

    for free in spaces:

        def equations(y: Floats, free: Floats = free) -> tuple[Floats, Floats]:
            steps = 1e-6 * free.T
            columns = [(bias(v + free @ y + step) - bias(v + free @ y - step)) / 2e-6 for step in steps]
            return bias(v + free @ y), np.array(columns).reshape(len(y), len(vanishing)).T

        found = descend(equations, np.zeros(free.shape[1]))
        if found.size <= HOLDS * max(1.0, float(v @ v)):
            return np.asarray(v + free @ found.point)
    return v


def _report(task: Problem, left_over: Floats, fixed: np.ndarray, sink: Sink) -> None:
    rows = len(task.space.row_sizes)
    fixed_spans = [c.rate_start_span or c.spans[0] for c in task.flat.coordinates if c.rate_fixed and c.spans]
    labels = [Label(span, "fixed rate") for span in fixed_spans]
    worst = int(np.argmax(left_over))
    if worst < rows:
        item = next(item for item in located(task.flat) if worst in item.rows)
        row = task.space.functions.layout.constraints[worst].name
        name = row if item.constraint.closure is None else seat(item.constraint)
        size = f"{float(left_over[worst] * task.space.row_sizes[worst]):.3g}{unit_suffix(item.constraint)}"
        unit = "/s" if item.constraint.level == "position" else ""
        sink.report("E0803", place(item.constraint), *labels, residual=size + unit, name=name)
        return
    coordinate = task.flat.coordinates[fixed[worst - rows]]
    size = f"{float(left_over[worst] * task.space.sizes[fixed[worst - rows]]):.3g}"
    sink.report("E0803", labels[0] if labels else None, *labels[1:], residual=size, name=f"der({coordinate.name})")
