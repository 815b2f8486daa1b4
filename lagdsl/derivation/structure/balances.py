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

import numpy as np

from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.structure.directions import ZERO, Directions, State, find_directions, reduced, simple, states
from lagdsl.derivation.structure.functions import ProgramFunctions
from lagdsl.derivation.structure.inertia import Massless, report_direction, report_massless, some_of
from lagdsl.derivation.structure.names import comes_and_goes, grammatical_subject, located
from lagdsl.derivation.structure.points import Geometry, Probe
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats, null_space
from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import ENERGY
from lagdsl.language.flat.event_flow import reset_states
from lagdsl.language.flat.expression import ForceBalance
from lagdsl.language.flat.model import Constraint, FlatModel
from lagdsl.language.flat.spans import around, place

_ROUNDING = 1e-12
_FREE = "no force determines {}"
_JUMPS = "give it a mass or an inertia, or write forces that change continuously, with `max` or `abs` where laws meet"


@record()
class _Forces:
    """N' f at one state: its derivatives by the rates (m, nq), by those along N (m, m), and by the coordinates along N
    (m, m)."""

    by_rates: Floats
    damping: Floats
    stiffness: Floats


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
    general = states(flat, space, points, general=True)
    directions = find_directions(flat, space, general, found)
    if directions is not None and _report_switched(flat, functions.program, directions, sink):
        return ()
    chosen = None
    if directions is not None:
        chosen = _combinations(directions, _forces(functions, space, general, directions))
    if directions is None or chosen is None:
        report_massless(flat, found, sink)
        return ()
    given = states(flat, space, points, general=False)
    if _report_free(flat, directions, _forces(functions, space, given, directions), chosen, sink):
        return ()
    speeds = [[each, replace(each, qd=2.0 * each.qd)] for each in given]
    pairs = [_forces(functions, space, pair, directions) for pair in speeds]
    if _report_nonlinear(flat, directions, chosen, pairs, sink):
        return ()
    made = tuple(_balance(flat, functions.program, directions, each, sink) for each in chosen)
    if sink.has_errors:
        return ()
    leading = [flat.coordinates[j] for j in directions.leading]
    names = some_of([f"`{coordinate.name}`" for coordinate in leading])
    sink.report("N0529", place(leading[0]), *around(leading[0]), names=names, name=leading[0].name)
    return made


def _report_switched(flat: FlatModel, program: Program, directions: Directions, sink: Sink) -> bool:
    """E0503 where a row that comes and goes acts along a direction: the forces alone do not determine the motion."""
    moved = np.flatnonzero(np.any(directions.columns != 0.0, axis=1)).tolist()
    (_, jacobian) = program.function("velocity_constraint").results
    n, there = len(flat.coordinates), {place for place, _ in jacobian.entries}
    for item in located(flat):
        if comes_and_goes(item.constraint):
            held = [j for row in item.rows for j in moved if row * n + j in there]
            if held:
                why = f"{grammatical_subject(flat, item.constraint)} acts on it, which comes and goes"
                report_direction(flat, held[0], why, sink)
                return True
    return False


def _forces(
    functions: ProgramFunctions, space: Geometry, chosen: Sequence[State], directions: Directions
) -> list[_Forces]:
    """At those states at which they are numbers."""
    found = (_forces_at(functions, space, state, directions) for state in chosen)
    return [each for each in found if np.isfinite(each.by_rates).all() and np.isfinite(each.stiffness).all()]


def _forces_at(functions: ProgramFunctions, space: Geometry, state: State, directions: Directions) -> _Forces:
    """From the tangents of M qdd - f - J' lam at qdd = 0 and lam = 0."""
    n, m = len(state.q), len(directions.leading)
    columns = directions.at(replace(space, p=state.p).velocity(state.q, state.qd)[1].dense())
    nothing = (np.zeros(n), np.zeros(len(functions.layout.constraints)))
    held = (np.zeros_like(space.z), np.zeros_like(space.u), np.zeros_like(state.p))
    q, qd = np.vstack([np.zeros((n, n)), columns.T]), np.vstack([np.eye(n), np.zeros((m, n))])
    given = (space.t, state.q, state.qd, space.z, space.u, space.w, state.p, *nothing, q, qd, *held)
    slopes = -functions.along("residual_tangent", 0, *given)
    total, size = slopes @ columns, np.abs(slopes) @ np.abs(columns)
    total = np.where(np.abs(total) <= _ROUNDING * size, 0.0, total)
    by_rates = total[:n].T
    return _Forces(by_rates, by_rates @ columns, total[n:].T)


def _combinations(directions: Directions, forces: list[_Forces]) -> list[_Combination] | None:
    """First the combinations of N' f that hold no rates, then balances beside them that do; None where combinations
    depend on parameters."""
    m = len(directions.leading)
    if not forces:
        return None
    table = np.hstack([each.by_rates for each in forces])
    lengths = np.linalg.norm(table, axis=1)
    unit = np.where(lengths > 0.0, lengths, 1.0)
    columns, leading = reduced(null_space((table / unit[:, None]).T, ZERO) / unit[:, None], 1.0 / directions.sizes)
    still = simple(columns)
    if still is None:
        return None
    moving = [k for k in range(m) if k not in leading]
    return [
        *(_Combination(weights, k, True) for weights, k in zip(still.T, leading, strict=True)),
        *(_Combination(np.eye(m)[k], k, False) for k in moving),
    ]


def _report_free(
    flat: FlatModel, directions: Directions, forces: list[_Forces], chosen: Sequence[_Combination], sink: Sink
) -> bool:
    """E0503 for a direction that no force determines at any of the states."""
    free = np.zeros((len(chosen), 0))
    for each in forces:
        rows = [combination.weights @ (each.stiffness if combination.still else each.damping) for combination in chosen]
        matrix = np.array(rows) * directions.sizes
        lengths = np.linalg.norm(matrix, axis=1, keepdims=True)
        free = null_space(matrix / np.where(lengths > 0.0, lengths, 1.0), ZERO)
        if not free.shape[1]:
            return False
    way = reduced(free * directions.sizes[:, None], directions.sizes)[0][:, 0]
    along = np.abs(directions.columns @ way)
    together = np.flatnonzero(along > ZERO * np.max(along)).tolist()
    names = [f"`{flat.coordinates[i].name}`" for i in together]
    motion = names[0] if len(names) == 1 else f"the motion in which {some_of(names)} change together"
    pushed = any(
        np.any(np.abs(each.stiffness @ way) > ZERO * (np.abs(each.stiffness) @ np.abs(way))) for each in forces
    )
    why = "forces that change with {} are balanced by rates of other coordinates alone" if pushed else _FREE
    report_direction(flat, together[0], why.format(motion), sink)
    return True


def _report_nonlinear(
    flat: FlatModel, directions: Directions, chosen: Sequence[_Combination], pairs: list[list[_Forces]], sink: Sink
) -> bool:
    """E0503 for a balance that is not linear in the rates: its derivatives by them differ between two speeds."""
    for combination in chosen:
        for pair in pairs:
            slopes = np.array([combination.weights @ each.by_rates for each in pair])
            if np.any(np.abs(slopes - slopes[:1]) > ZERO * np.max(np.abs(slopes), initial=0.0)):
                leading = directions.leading[combination.leading]
                report_direction(flat, leading, "the forces that damp it are not linear in the rates", sink)
                return True
    return False


def _balance(flat: FlatModel, program: Program, directions: Directions, chosen: _Combination, sink: Sink) -> Constraint:
    """The balance as a constraint; E0503 for one of position level that changes at instants: positions do not jump."""
    leading = directions.leading[chosen.leading]
    coordinate = flat.coordinates[leading]
    weights = directions.columns @ chosen.weights
    tied = [j for j, _ in directions.ties]
    parts = [(i, float(weights[i])) for i in np.flatnonzero(weights).tolist() if i not in tied]
    (force,) = program.function("inverse_dynamics").results
    jumping = _jumps(flat, program, [force.elements[i] for i in (*tied, *(i for i, _ in parts))])
    if jumping and chosen.still:
        why = "the forces on it change at instants, and it would jump then"
        report_direction(flat, leading, why, sink, help=_JUMPS)
    name = f"balance({coordinate.name})"
    return Constraint(
        spans=coordinate.spans,
        name=name,
        rows=(name,),
        residuals=(
            ForceBalance(
                weights=tuple((flat.coordinates[i].name, weight) for i, weight in parts),
                ties=tuple(
                    (flat.coordinates[j].name, program.layout.constraints[row].name) for j, row in directions.ties
                ),
                still=chosen.still,
            ),
        ),
        dimension=ENERGY / coordinate.dimension,
        level="position" if chosen.still else "velocity",
        switched=jumping,
    )


def _jumps(flat: FlatModel, program: Program, forces: Sequence[int]) -> bool:
    """True if discretes that are not continuous in time, or states that clauses set, enter the forces."""
    graph, jumping = program.graph, reset_states(flat)
    corners = {each.name for each in flat.events.timed if each.kind == "corner"}
    for node in graph.live(forces):
        if graph.op[node] is Op.SYMBOL:
            group, index = graph.group(node), graph.b[node]
            if group is Group.W and program.layout.discretes[index].name not in corners:
                return True
            if group is Group.Z and flat.states[index].name in jumping:
                return True
    return False
