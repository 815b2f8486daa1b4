"""Directions without inertia, along which the forces determine the motion.

Let N span the directions with M N = 0 and J N = 0. Lagrange's equations along them hold neither accelerations nor
multipliers: N' f(q, qd, t) = 0. Such a balance of forces is a constraint whose multiplier mu is zero: its own equation
along N is -N' W' mu = N' f = 0, with W the derivatives of the balances, and W N is regular where the forces determine
the motion along N. Without rates a balance is of position level, else of velocity level. Where damping acts along some
combinations only, the others are rows of their own: the left null space of d(N' f)/d(qd).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.structure.functions import ProgramFunctions
from lagdsl.derivation.structure.inertia import Massless, report_direction, report_massless, some_of
from lagdsl.derivation.structure.names import comes_and_goes, contact_rows, grammatical_subject, located
from lagdsl.derivation.structure.points import SEED, Geometry, Probe, random_rates
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats, null_space
from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import ENERGY
from lagdsl.language.flat.event_flow import reset_states
from lagdsl.language.flat.expression import ForceBalance
from lagdsl.language.flat.model import Constraint, FlatModel
from lagdsl.language.flat.spans import around, place

_ZERO = 1e-9
_ROUNDING = 1e-12
_LARGEST_DENOMINATOR = 1000
_FREE = "no force determines {}"
_JUMPS = "give it a mass or an inertia, or write forces on it that change continuously"


@record()
class _State:
    """Coordinates, rates and parameters at which derivatives are taken."""

    q: Floats
    qd: Floats
    p: Floats


@record()
class _Directions:
    """N (nq, m), column by column with a one at its coordinate `leading` (m,), and the sizes of these (m,)."""

    columns: Floats
    leading: list[int]
    sizes: Floats


@record()
class _Forces:
    """N' f at one state: its derivatives by the rates (m, nq), and by the coordinates along N (m, m)."""

    by_rates: Floats
    by_directions: Floats


@record()
class _Combination:
    """A balance as a combination (m,) of N' f, named by the direction `leading`; `still` ones hold no rates."""

    weights: Floats
    leading: int
    still: bool


def balances(
    flat: FlatModel, space: Geometry, points: list[Probe], found: Massless, sink: Sink
) -> tuple[Constraint, ...]:
    """The balances of forces along the directions that were `found`; none where E0503 tells which one is free."""
    functions = space.functions
    assert isinstance(functions, ProgramFunctions), "an engine has no graph to read dependences from"
    general = _states(flat, space, points, general=True)
    directions = _constant_directions(flat, space, general, found)
    if directions is not None and _report_switched(flat, functions.program, directions, sink):
        return ()
    chosen = None
    if directions is not None:
        chosen = _combinations(directions, [_forces(functions, space, each, directions) for each in general])
    if directions is None or chosen is None:
        report_massless(flat, found, sink)
        return ()
    given = _states(flat, space, points, general=False)
    forces = [_forces(functions, space, each, directions) for each in given]
    if _report_free(flat, directions, forces, chosen, sink):
        return ()
    faster = [_forces(functions, space, replace(each, qd=2.0 * each.qd), directions) for each in given]
    if _report_nonlinear(flat, directions, chosen, [forces, faster], sink):
        return ()
    made = tuple(_balance(flat, functions.program, directions, each, sink) for each in chosen)
    if sink.has_errors:
        return ()
    leading = [flat.coordinates[j] for j in directions.leading]
    names = some_of([f"`{coordinate.name}`" for coordinate in leading])
    sink.report("N0528", place(leading[0]), *around(leading[0]), names=names, name=leading[0].name)
    return made


def _states(flat: FlatModel, space: Geometry, points: list[Probe], *, general: bool) -> list[_State]:
    """The probed points with rates of natural size; `general`: with other values of the real parameters, so that what
    vanishes there vanishes whatever they are."""
    rates = random_rates(flat.coordinates, space.sizes, len(points))
    real = np.array([p.kind == "Real" for p in flat.parameters if not p.structural], dtype=np.bool_)
    generator = np.random.default_rng(SEED)
    found = []
    for point, qd in zip(points, rates, strict=True):
        factor = generator.uniform(0.9, 1.1, len(space.p))
        moved = np.where(space.p == 0.0, 0.1, space.p) * factor
        found.append(_State(point.q, qd, np.where(real, moved, space.p) if general else space.p))
    return found


def _constant_directions(flat: FlatModel, space: Geometry, states: list[_State], found: Massless) -> _Directions | None:
    """N with entries that no state and no parameter changes; None where there is no such N."""
    reduced = _reduced(found.basis * found.sizes[:, None], found.sizes)
    if reduced is None:
        return None
    columns, leading = reduced
    switched = contact_rows(flat)
    for state in states:
        here = replace(space, p=state.p)
        rows = here.velocity(state.q, state.qd)[1]
        lasting = [row for row in range(len(rows)) if row not in switched]
        for matrix in (here.mass(state.q, state.qd), rows[lasting]):
            if np.any(np.abs(matrix @ columns) > _ZERO * (np.abs(matrix) @ np.abs(columns))):
                return None
    return _Directions(columns, leading, found.sizes[leading])


def _reduced(columns: Floats, sizes: Floats) -> tuple[Floats, list[int]] | None:
    """Columns that span the same, each with a one in a row in which the others have a zero, and these rows, ascending.

    Gauss-Jordan elimination of entries divided by `sizes`. None where an entry is no fraction of small numbers: it
    would not be known exactly.
    """
    work = columns / sizes[:, None]
    leading: list[int] = []
    for k in range(work.shape[1]):
        rest = np.round(np.abs(work[:, k:]), 9)
        rest[leading] = -1.0
        row, column = divmod(int(np.argmax(rest)), rest.shape[1])
        work[:, [k, k + column]] = work[:, [k + column, k]]
        work[:, k] /= work[row, k]
        others = [j for j in range(work.shape[1]) if j != k]
        work[:, others] -= np.outer(work[:, k], work[row, others])
        leading.append(row)
    work, leading = work[:, np.argsort(leading)], sorted(leading)
    entries = np.where(np.abs(work) < _ZERO, 0.0, work) * sizes[:, None] / sizes[leading]
    simple = [float(Fraction(x).limit_denominator(_LARGEST_DENOMINATOR)) for x in entries.ravel().tolist()]
    exact = np.array(simple).reshape(entries.shape)
    return (exact, leading) if np.all(np.abs(exact - entries) <= _ZERO * np.abs(entries)) else None


def _report_switched(flat: FlatModel, program: Program, directions: _Directions, sink: Sink) -> bool:
    """E0503 where a row that comes and goes acts along a direction: the forces alone do not determine the motion."""
    moved = np.flatnonzero(np.any(directions.columns != 0.0, axis=1)).tolist()
    (_, jacobian) = program.function("velocity_constraint").results
    n = len(flat.coordinates)
    for item in located(flat):
        if comes_and_goes(item.constraint):
            held = [j for row in item.rows for j in moved if jacobian.elements[row * n + j] != program.graph.zero]
            if held:
                why = f"{grammatical_subject(flat, item.constraint)} acts on it, which comes and goes"
                report_direction(flat, held[0], why, sink)
                return True
    return False


def _forces(functions: ProgramFunctions, space: Geometry, state: _State, directions: _Directions) -> _Forces:
    """From the tangents of M qdd - f - J' lam at qdd = 0 and lam = 0."""
    n, m = len(state.q), len(directions.leading)
    nothing = (np.zeros(n), np.zeros(len(functions.layout.constraints)))
    held = (np.zeros_like(space.z), np.zeros_like(space.u), np.zeros_like(state.p))
    q, qd = np.vstack([np.zeros((n, n)), directions.columns.T]), np.vstack([np.eye(n), np.zeros((m, n))])
    given = (space.t, state.q, state.qd, space.z, space.u, space.w, state.p, *nothing, q, qd, *held)
    slopes = -functions.along("residual_tangent", 0, *given)
    total, size = slopes @ directions.columns, np.abs(slopes) @ np.abs(directions.columns)
    total = np.where(np.abs(total) > _ROUNDING * size, total, 0.0)
    return _Forces(total[:n].T, total[n:].T)


def _combinations(directions: _Directions, forces: list[_Forces]) -> list[_Combination] | None:
    """First the combinations of N' f that hold no rates, then balances beside them that do; None where combinations
    depend on parameters."""
    m = len(directions.leading)
    table = np.hstack([each.by_rates for each in forces])
    lengths = np.linalg.norm(table, axis=1)
    unit = np.where(lengths > 0.0, lengths, 1.0)
    reduced = _reduced(null_space((table / unit[:, None]).T, _ZERO) / unit[:, None], 1.0 / directions.sizes)
    if reduced is None:
        return None
    still, leading = reduced
    moving = [k for k in range(m) if k not in leading]
    return [
        *(_Combination(weights, k, True) for weights, k in zip(still.T, leading, strict=True)),
        *(_Combination(np.eye(m)[k], k, False) for k in moving),
    ]


def _report_free(
    flat: FlatModel, directions: _Directions, forces: list[_Forces], chosen: Sequence[_Combination], sink: Sink
) -> bool:
    """E0503 for a direction that no force determines at any of the states."""
    free = np.zeros((len(chosen), 0))
    for each in forces:
        rows = [
            combination.weights @ (each.by_directions if combination.still else each.by_rates @ directions.columns)
            for combination in chosen
        ]
        matrix = np.array(rows) * directions.sizes
        lengths = np.linalg.norm(matrix, axis=1, keepdims=True)
        free = null_space(matrix / np.where(lengths > 0.0, lengths, 1.0), _ZERO)
        if not free.shape[1]:
            return False
    reduced = _reduced(free * directions.sizes[:, None], directions.sizes)
    way = free[:, 0] * directions.sizes if reduced is None else reduced[0][:, 0]
    along = np.abs(directions.columns @ way)
    together = np.flatnonzero(along > _ZERO * np.max(along)).tolist()
    names = [f"`{flat.coordinates[i].name}`" for i in together]
    motion = names[0] if len(names) == 1 else f"the motion in which {some_of(names)} change together"
    pushed = any(np.any(each.by_directions @ way) for each in forces)
    why = "forces that change with {} are balanced by rates of other coordinates alone" if pushed else _FREE
    report_direction(flat, together[0], why.format(motion), sink)
    return True


def _report_nonlinear(
    flat: FlatModel, directions: _Directions, chosen: Sequence[_Combination], forces: list[list[_Forces]], sink: Sink
) -> bool:
    """E0503 for a balance that is not linear in the rates: its derivatives by them differ between two speeds."""
    for combination in chosen:
        for one, other in zip(*forces, strict=True):
            slopes = np.array([combination.weights @ each.by_rates for each in (one, other)])
            if np.any(np.abs(slopes[0] - slopes[1]) > _ZERO * np.max(np.abs(slopes))):
                leading = directions.leading[combination.leading]
                report_direction(flat, leading, "the forces that damp it are not linear in the rates", sink)
                return True
    return False


def _balance(
    flat: FlatModel, program: Program, directions: _Directions, chosen: _Combination, sink: Sink
) -> Constraint:
    """The balance as a constraint; E0503 for one of position level that changes at instants: positions do not jump."""
    leading = directions.leading[chosen.leading]
    coordinate = flat.coordinates[leading]
    weights = directions.columns @ chosen.weights
    parts = [(i, float(weights[i])) for i in np.flatnonzero(weights).tolist()]
    (force,) = program.function("inverse_dynamics").results
    jumping = _jumps(flat, program, [force.elements[i] for i, _ in parts])
    if jumping and chosen.still:
        why = "the forces on it change at instants, and it would jump then"
        report_direction(flat, leading, why, sink, help=_JUMPS)
    name = f"balance({coordinate.name})"
    return Constraint(
        spans=coordinate.spans,
        name=name,
        rows=(name,),
        residuals=(ForceBalance(tuple((flat.coordinates[i].name, weight) for i, weight in parts), chosen.still),),
        dimension=ENERGY / coordinate.dimension,
        level="position" if chosen.still else "velocity",
        switched=jumping,
    )


def _jumps(flat: FlatModel, program: Program, forces: Sequence[int]) -> bool:
    """True if discretes that are not continuous in time, or states that clauses set, enter the forces."""
    graph, states = program.graph, reset_states(flat)
    corners = {each.name for each in flat.events.timed if each.kind == "corner"}
    for node in graph.live(forces):
        if graph.op[node] is Op.SYMBOL:
            group, index = graph.group(node), graph.b[node]
            if group is Group.W and program.layout.discretes[index].name not in corners:
                return True
            if group is Group.Z and flat.states[index].name in states:
                return True
    return False
