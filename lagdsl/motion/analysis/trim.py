"""Equilibria and steady motions: a state at which nothing accelerates, with inputs free where asked for.

Unknown are the coordinates and first-order states, but for fixed ones, and whatever else is freed: inputs, rates. The
constraints of both levels and the accelerations have to vanish; rates that are not free keep their values. Newton's
method with exact derivatives, first along the path on which the forces of the start are let go. Where that ends far
away a model at rest falls, slowly. Else the method is damped, from the start and from where a spring to it lets
residuals become least; the nearer solution is taken. Truths of relations and closed contacts are those of the start,
and where they are others at the solution it is looked for again with these.

Friction that sticks at the start is a constraint first: what it holds stays where it is, as far as its slip is the rate
of a position. Where there is no such equilibrium things may slide to another one. There friction holds what stands
still, within its limits.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from lagdsl.derivation.structure.names import balanced_coordinates, configuration
from lagdsl.derivation.structure.points import random_points
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.suggest import listing
from lagdsl.foundation.numerics.gradient_flow import fall
from lagdsl.foundation.numerics.homotopy import release, settle
from lagdsl.foundation.numerics.levenberg_marquardt import Equations, Minimizer, descend, sprung
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.units.naming import rate_text
from lagdsl.motion.analysis.discretes import discretes_at, open_contacts
from lagdsl.motion.analysis.friction import FrictionForce, friction_forces
from lagdsl.motion.analysis.grip import Grip, grip_at, gripping, unheld
from lagdsl.motion.analysis.linearize import Named, holonomic_rows, reduce
from lagdsl.motion.analysis.modes import growth
from lagdsl.motion.analysis.partition import partition
from lagdsl.motion.analysis.point import (
    Changes,
    Directions,
    Point,
    System,
    changes,
    constraint_changes,
    coordinate_sizes,
    flow,
)
from lagdsl.motion.analysis.steady import Steadiness, first_order_sizes, steadiness

_TRIES = 24
_HOLDS = 1e-9
# The stiff rows may hold to that part with the soft ones far from their places: by more than this part of their sizes.
_SURE = 1e-3
# Rates that follow are none below this part of their natural sizes.
_RESTS = 1e-12
_DEPENDENT = 1e-10
# No nearer solution is looked for than one at this distance, in natural displacements.
_CLOSE = 1.0
_MOST_TOLD = 4
# So often the truths, and which contacts are closed, may turn out to be others at the equilibrium found.
_MOST_CHANGES = 12
# Rates of growth below this part of the fastest rate are rounding errors.
_ROUNDING = 1e-13


@dataclass(frozen=True, slots=True, kw_only=True)
class Equilibrium:
    """`point` with its inputs; `unknowns` are the names that were free, `residual` the largest acceleration left, as a
    part of what a natural displacement causes. `growth` are the real parts [1/s] of modes that grow about an
    equilibrium, largest first. `frictions` are the forces of dry friction, with what they bear."""

    model: str
    point: Point
    unknowns: tuple[str, ...]
    residual: float
    steadiness: Steadiness
    growth: tuple[float, ...] = ()
    frictions: tuple[FrictionForce, ...] = ()


@dataclass(frozen=True, slots=True)
class _Task:
    """Unknowns as weighted distances from `start`, in the order q, qd, z, u; `rates` accelerate by nothing. `grip` is
    what friction holds in its place."""

    system: System
    start: Point
    free: tuple[int, ...]
    widths: Floats
    rates: tuple[int, ...]
    grip: Grip

    def point(self, x: Floats) -> Point:
        whole = np.concatenate([self.start.q, self.start.qd, self.start.z, self.start.u])
        whole[list(self.free)] += self.widths[list(self.free)] * x
        n, nz = len(self.start.q), len(self.start.z)
        q, qd, z, u = np.split(whole, [n, 2 * n, 2 * n + nz])
        if not np.any(self.start.qd):  # a rate of rounding errors has a sense, which friction would follow
            qd = np.where(np.abs(qd) > _RESTS * self.widths[n : 2 * n], qd, 0.0)
        return replace(self.start, q=q, qd=qd, z=z, u=u)

    def equations(self, x: Floats) -> tuple[Floats, Floats]:
        """Constraints, accelerations and rates of states, in SI units, and their Jacobian."""
        system, point, rows = self.system, self.point(x), holonomic_rows(self.system)
        here = flow(system, point, Sink())
        count = len(rows) + len(system.engine.layout.constraints) + len(self.rates) + len(point.z) + len(self.grip.rows)
        if here is None:
            return np.full(count, np.nan), np.full((count, len(x)), np.nan)
        phi = system.engine.evaluate("position_constraint", *point.arguments)[0][rows]
        drift = system.engine.evaluate("velocity_constraint", *point.arguments)[0]
        along = self._directions()
        moved, drifted = constraint_changes(system, point, along)
        found = changes(system, here, along) if along.count else _nothing(point)
        way, held = self.grip.way(system, point)
        values = np.concatenate([phi, drift, here.qdd[list(self.rates)], here.zd, way])
        jacobian = np.hstack([moved[:, rows], drifted, found.qdd[:, list(self.rates)], found.zd, along.q @ held.T]).T
        return values, jacobian

    def _directions(self) -> Directions:
        n, nz, nu = len(self.start.q), len(self.start.z), len(self.start.u)
        unit = (np.eye(len(self.widths)) * self.widths)[list(self.free)]
        q, qd, z, u = np.split(unit, [n, 2 * n, 2 * n + nz], axis=1)
        assert u.shape[1] == nu
        return Directions(q=q, qd=qd, z=z, u=u)


def _nothing(point: Point) -> Changes:
    n = len(point.q)
    return Changes(qdd=np.zeros((0, n)), lam=np.zeros((0, 0)), zd=np.zeros((0, len(point.z))), y=np.zeros((0, 0)))


def all_names(system: System) -> list[str]:
    """Names that can be free or held: coordinates, rates, states, inputs."""
    layout = system.engine.layout
    coordinates = [slot.name for slot in layout.coordinates]
    rates = [f"der({name})" for name in coordinates]
    return [*coordinates, *rates, *(s.name for s in layout.states), *(s.name for s in layout.inputs)]


def trim_at(
    system: System, start: Point, *, free: Sequence[str] = (), hold: Sequence[str] = (), sink: Sink
) -> Equilibrium | None:
    """The equilibrium or steady motion nearest to `start`; None after E0850 to E0853."""
    names = all_names(system)
    for name in (*free, *hold):
        if name not in names:
            what = "freed" if name in free else "held"
            sink.report("E0853", None, name=name, what=what, known=listing(name, names))
    if sink.has_errors:
        return None
    whose = [names.index(n) for n in free], [names.index(n) for n in hold]
    reached = _reached(system, start, whose, sink)
    if reached is None:
        return None
    task, found = reached
    point = task.point(found.point)
    at = reduce(system, point, holonomic_rows(system), sink, outputs=False)
    if at is None:
        return None
    kind = steadiness(system, at)
    return Equilibrium(
        model=system.flat.name,
        point=point,
        unknowns=tuple(names[i] for i in task.free if i in _asked(task, names, free)),
        residual=found.size,
        steadiness=kind,
        growth=growth(at) if kind.kind == "equilibrium" else (),
        frictions=friction_forces(system, at.flow),
    )


def _reached(
    system: System, start: Point, whose: tuple[list[int], list[int]], sink: Sink
) -> tuple[_Task, Minimizer] | None:
    """The solution with the discretes that belong to it."""
    gripped = grip_at(system, start)
    found = None if not gripped.rows else _settled(system, start, whose, gripped, Sink())
    return found or _settled(system, start, whose, Grip((), start.q), sink)


def _settled(
    system: System, start: Point, whose: tuple[list[int], list[int]], grip: Grip, sink: Sink
) -> tuple[_Task, Minimizer] | None:
    for _ in range(_MOST_CHANGES):
        task = _task(system, start, *whose, grip.at(system, start), sink)
        if task is None:
            return None
        with np.errstate(all="ignore"):
            found, scale = _search(task)
        if not found.size <= _HOLDS:
            _report(task, found, scale, sink)
            return None
        point = task.point(found.point)
        w = discretes_at(system, point)
        held = gripping(system, point, w)
        if held is not None:
            return replace(task, start=replace(task.start, w=held.w)), found
        if np.array_equal(w, point.w):
            return task, found
        start = replace(point, w=w)
    notes = tuple(open_contacts(system, start))
    sink.report("E0852", None, notes=notes, left="every solution changes what is true or closed, and so another one")
    return None


def _asked(task: _Task, names: Sequence[str], free: Sequence[str]) -> set[int]:
    """Unknowns to tell of: not the rates that merely follow."""
    n = len(task.start.q)
    return {i for i in task.free if not n <= i < 2 * n or names[i] in free}


def _task(
    system: System, start: Point, free: Sequence[int], hold: Sequence[int], grip: Grip, sink: Sink
) -> _Task | None:
    flat, n = system.flat, len(start.q)
    chosen = partition(system, start, holonomic_rows(system), sink)
    if chosen is None:
        return None
    light = balanced_coordinates(flat)
    at_rest = not np.any(np.delete(start.qd, light)) and not any(n <= j < 2 * n for j in free)
    if at_rest:  # forces move what has no inertia at the start, and not at the equilibrium
        start = replace(start, qd=np.zeros(n))
    held = {*chosen.rate, *(light if at_rest else ())}
    following = [n + j for j in range(n) if j not in held] if len(chosen.jacobian) else []
    default = [j for j, c in enumerate(flat.coordinates) if not c.fixed]
    default += [2 * n + j for j, s in enumerate(flat.states) if not s.fixed]
    unknown = sorted((set(default) | set(following) | set(free)) - set(hold))
    sizes = coordinate_sizes(system, start.p)
    states = first_order_sizes(system, start)
    inputs = np.maximum(np.abs(start.u), 1.0)
    widths = np.concatenate([sizes, sizes, states, inputs])
    rates = tuple(range(n)) if at_rest else chosen.rate
    return _Task(system, start, tuple(unknown), widths, rates, grip if at_rest else Grip((), start.q))


def _search(task: _Task) -> tuple[Minimizer, Floats]:
    """The best of several beginnings, and what its residuals are parts of."""
    start, flat = task.start, task.system.flat
    origin = np.zeros(len(task.free))
    scale = _scale(task, origin)

    def equations(x: Floats) -> tuple[Floats, Floats]:
        residual, jacobian = task.equations(x)
        return residual / scale, jacobian / scale[:, None]

    own = partial(_independent, task, scale)

    def end(way: Minimizer) -> tuple[Minimizer, float]:
        settled, rest = settle(equations, own, way)
        return _judged(task, scale, settled)[0], rest

    ends = [end(release(equations, own, origin))]
    if not (ends[0][0].size <= _HOLDS and float(np.linalg.norm(ends[0][0].point)) <= _CLOSE):
        low = _fallen(task, equations, own, scale)
        fallen = [] if low is None else [found for found in [end(low)] if found[0].size <= _HOLDS]
        ways = (descend(equations, start, target=1e-12) for start in (origin, sprung(equations, origin)))
        ends = fallen or ends + [end(way) for way in ways]

    def order(found: tuple[Minimizer, float]) -> tuple[bool, bool, float, float]:
        way, rest = found
        return not way.size <= _HOLDS, not rest <= _SURE, float(np.linalg.norm(way.point)), way.size

    best = min(ends, key=order)[0]
    n = len(start.q)
    tries = 0 if task.grip.rows else _TRIES  # what friction holds is near
    for other in random_points(flat.coordinates, start.q, task.widths[:n], tries):
        if best.size <= _HOLDS:
            break
        beginning = [(other[i] - start.q[i]) / task.widths[i] if i < n else 0.0 for i in task.free]
        found = _judged(task, scale, descend(equations, np.array(beginning), target=1e-12))[0]
        best = found if found.size < best.size else best
    return best, _judged(task, scale, best)[1]


def _fallen(task: _Task, equations: Equations, own: Callable[[Floats], Floats], scale: Floats) -> Minimizer | None:
    """The end of a motion with rates as large as the accelerations: along the constraints, down a potential. None for
    steady motions, where inputs are free, and where unknowns are more than rows."""
    n, origin = len(task.start.q), np.zeros(len(task.free))
    last = 2 * n + len(task.start.z)
    if len(task.rates) < n or len(own(origin)) < len(task.free) or any(i >= last for i in task.free):
        return None
    from scipy.linalg import eigvals

    first = len(scale) - len(task.grip.rows) - n - len(task.start.z)
    columns = [k for k, i in enumerate(task.free) if not n <= i < 2 * n]  # rates follow
    moved = [task.free[k] for k in columns]
    rows = [first + (i if i < n else i - n) for i in moved]
    widths = task.widths[moved] / scale[rows]
    inertia = np.zeros((len(scale), len(task.free)))
    inertia[rows, columns] = widths
    pace = float(np.linalg.norm(equations(origin)[0][rows] / widths))

    def implicit(x: Floats, before: Floats, step: float) -> tuple[Floats, Floats]:
        residual, jacobian = equations(x)
        free = own(x)
        return free @ (residual - inertia @ (x - before) / step), free @ (jacobian - inertia / step)

    def leaving(x: Floats) -> float:
        free = own(x)
        pencil = np.hstack([free @ equations(x)[1], free @ inertia])
        if not np.all(np.isfinite(pencil)):
            return 0.0
        of_rows = np.linalg.svd(pencil)[0][:, : len(task.free)].T  # without the rows that follow from others
        left, right = np.hsplit(of_rows @ pencil, 2)
        rates = np.asarray(eigvals(left, right))
        finite = rates[np.isfinite(rates)]
        largest = float(np.max(finite.real, initial=0.0))
        return largest if largest > _ROUNDING * float(np.max(np.abs(finite), initial=0.0)) else 0.0

    point = fall(implicit, leaving, origin, 1.0 / pace) if pace > 0.0 and np.isfinite(pace) else None
    if point is None:
        return None
    residual = equations(point)[0]
    return Minimizer(point=point, residual=residual, size=float(np.linalg.norm(residual)))


def _judged(task: _Task, scale: Floats, way: Minimizer) -> tuple[Minimizer, Floats]:
    """The end of a search with residuals as parts of the larger of `scale` and what it is there: rows that are soft
    at the start may be stiff where the search ends, and are as inexact as that."""
    if not np.isfinite(way.size):
        return way, scale
    there = np.fmax(scale, _scale(task, way.point))
    residual, jacobian = task.equations(way.point)
    size = float(np.linalg.norm(residual / there))
    if len(task.rates) == len(task.start.q):
        size = max(size, _unbalanced(task, way.point, residual, jacobian))
    return replace(way, residual=residual / there, size=size), there


def _unbalanced(task: _Task, x: Floats, residual: Floats, jacobian: Floats) -> float:
    """The forces M qdd as parts of what natural displacements cause: the pin of a thin beam, whose acceleration is
    1e-12 of those by strains, holds no torque."""
    mass, _, rows, _ = task.system.engine.evaluate("dynamics", *task.point(x).arguments)
    first = len(holonomic_rows(task.system)) + len(rows)
    forces, slopes = (mass @ each[first : first + len(mass)] for each in (residual, jacobian))
    sizes = np.linalg.norm(slopes, axis=1)
    told = sizes > 1e-12 * np.max(sizes, initial=0.0)
    return float(np.linalg.norm(forces[told] / sizes[told]))


def _independent(task: _Task, scale: Floats, x: Floats) -> Floats:
    """The rows that do not follow from others, of rows that are parts of `scale`: at rest the accelerations hold the
    constraints, so only those along the constraints are free."""
    n, count = len(task.start.q), len(scale)
    if len(task.rates) < n or not task.system.engine.layout.constraints:
        return np.eye(count)
    jacobian = task.system.engine.evaluate("velocity_constraint", *task.point(x).arguments)[1]
    first = len(holonomic_rows(task.system)) + len(jacobian)
    if not np.all(np.isfinite(jacobian)):
        return np.eye(count)
    _, sizes, axes = np.linalg.svd(jacobian * scale[first : first + n])
    free = axes[int(np.sum(sizes > _DEPENDENT * np.max(sizes, initial=0.0))) :]
    rows = np.zeros((len(free), count))
    rows[:, first : first + n] = free
    others = np.delete(np.eye(count), np.arange(first, first + n), axis=0)
    return np.vstack([others, rows])


def _scale(task: _Task, x: Floats) -> Floats:
    """Changes of the rows by natural displacements at a point; the accelerations of coordinates of one unit that a
    constraint ties together, as those of a quaternion, have the largest size of them."""
    system, start = task.system, task.point(x)
    lengths = np.linalg.norm(task.equations(x)[1], axis=1)
    scale = np.where(np.isfinite(lengths) & (lengths > 1e-12 * np.max(lengths, initial=0.0)), lengths, 0.0)
    count = len(system.engine.layout.constraints)
    if len(task.rates) == len(start.q) and count:
        first = len(holonomic_rows(system)) + count
        nearby = replace(start, q=start.q + task.widths[: len(start.q)] * np.linspace(0.1, 0.2, len(start.q)))
        ties = system.engine.evaluate("velocity_constraint", *nearby.arguments)[1]
        units = [coordinate.dimension for coordinate in system.flat.coordinates]
        for tie in ties:
            tied = np.flatnonzero(np.abs(tie) > 0.0).tolist()
            for unit in {units[j] for j in tied}:
                rows = [first + j for j in tied if units[j] == unit]
                scale[rows] = np.max(scale[rows])
    return np.where(scale > 0.0, scale, 1.0)


def _report(task: _Task, found: Minimizer, scale: Floats, sink: Sink) -> None:
    """E0852 with what is left for each coordinate, largest first, and where."""
    layout, flat = task.system.engine.layout, task.system.flat
    rows = [layout.constraints[i] for i in holonomic_rows(task.system)]
    named = [Named(slot.name, slot.unit) for slot in rows]
    named += [Named(f"rate of {slot.name}", slot.unit) for slot in layout.constraints]
    for j in task.rates:
        c = flat.coordinates[j]
        named.append(Named(f"der(der({c.name}))", rate_text(c.dimension, c.unit).replace("/s", "/s2")))
    named += [Named(f"der({s.name})", rate_text(s.dimension, s.unit)) for s in flat.states]
    order = sorted(range(len(named)), key=lambda i: -abs(found.residual[i]))[:_MOST_TOLD]
    order = [i for i in order if abs(found.residual[i]) > _HOLDS] or order[:1]
    told = [f"{named[i].name} = {found.residual[i] * scale[i]:.4g} {named[i].unit}".rstrip() for i in order]
    left = f"{told[0]} remains" if told and np.isfinite(found.size) else "the accelerations are not finite"
    closest = configuration(flat, task.point(found.point).q)
    notes = [f"left over: {', '.join(told)}", f"closest configuration: {closest}"]
    notes += open_contacts(task.system, task.start)
    notes += unheld(task.system, task.start)
    held = [c.name for j, c in enumerate(flat.coordinates) if j not in task.free]
    if held:
        notes.append(f"not free: {', '.join(f'`{name}`' for name in held[:_MOST_TOLD])}")
    sink.report("E0852", None, notes=tuple(notes), left=left)
