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
_SMALL_PIVOT = 1e-6
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
    """N (nq, m), column by column with a one at its coordinate `leading` (m,), and the sizes of these (m,). `ties` are
    coordinates with the rows that they follow, where parameters or positions change N: `columns` is N at one state."""

    columns: Floats
    leading: list[int]
    sizes: Floats
    ties: list[tuple[int, int]]

    def at(self, jacobian: Floats) -> Floats:
        """N where J is this."""
        if not self.ties:
            return self.columns
        columns = np.zeros_like(self.columns)
        columns[self.leading, np.arange(len(self.leading))] = 1.0
        tied, rows = ([pair[k] for pair in self.ties] for k in (0, 1))
        columns[tied] = -np.linalg.solve(jacobian[np.ix_(rows, tied)], jacobian[rows] @ columns)
        return columns


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
    general = _states(flat, space, points, general=True)
    directions = _directions(flat, space, general, found)
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


def _directions(flat: FlatModel, space: Geometry, states: list[_State], found: Massless) -> _Directions | None:
    """N that has no inertia at any state, whatever the parameters are; None where there is no such N."""
    columns, leading = _reduced(found.basis * found.sizes[:, None], found.sizes)
    simple = _simple(columns)
    switched = contact_rows(flat)
    looks = [(replace(space, p=state.p), state) for state in states]
    jacobians = [here.velocity(state.q, state.qd)[1] for here, state in looks]
    lasting = [row for row in range(len(jacobians[0])) if row not in switched]
    masses = [here.mass(state.q, state.qd) for here, state in looks]
    sizes = found.sizes[leading]
    choices = [] if simple is None else [_Directions(simple, leading, sizes, [])]
    ties = _ties(jacobians[0], lasting, [j for j in np.flatnonzero(columns.any(axis=1)).tolist() if j not in leading])
    choices += [] if ties is None else [_Directions(columns, leading, sizes, ties)]
    for choice in choices:
        parts = [
            (matrix, choice.at(rows))
            for rows, mass in zip(jacobians, masses, strict=True)
            for matrix in (mass, rows[lasting])
        ]
        if all(np.all(np.abs(matrix @ n) <= _ZERO * (np.abs(matrix) @ np.abs(n))) for matrix, n in parts):
            return choice
    return None


def _ties(jacobian: Floats, lasting: list[int], tied: list[int]) -> list[tuple[int, int]] | None:
    """The tied coordinates, each with a row that it follows, in an order in which no pivot is small; None where there
    are none, or rows are missing."""
    if not 0 < len(tied) <= len(lasting):
        return None
    lengths = np.linalg.norm(jacobian[lasting], axis=1, keepdims=True)
    rest = (jacobian[lasting] / np.where(lengths > 0.0, lengths, 1.0))[:, tied]
    found = []
    for _ in tied:
        row, column = divmod(int(np.argmax(np.round(np.abs(rest), 9))), rest.shape[1])
        if not abs(rest[row, column]) > _SMALL_PIVOT:
            return None
        found.append((tied[column], lasting[row]))
        rest = rest - np.outer(rest[:, column], rest[row] / rest[row, column])
    return found


def _reduced(columns: Floats, sizes: Floats) -> tuple[Floats, list[int]]:
    """Columns that span the same, each with a one in a row in which the others have a zero, and these rows, ascending:
    Gauss-Jordan elimination of entries divided by `sizes`."""
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
    return np.where(np.abs(work) < _ZERO, 0.0, work) * sizes[:, None] / sizes[leading], leading


def _simple(entries: Floats) -> Floats | None:
    """The entries as fractions of small numbers, which are known exactly; None where one is none."""
    simple = [float(Fraction(x).limit_denominator(_LARGEST_DENOMINATOR)) for x in entries.ravel().tolist()]
    exact = np.array(simple).reshape(entries.shape)
    return exact if np.all(np.abs(exact - entries) <= _ZERO * np.abs(entries)) else None


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
    columns = directions.at(replace(space, p=state.p).velocity(state.q, state.qd)[1])
    nothing = (np.zeros(n), np.zeros(len(functions.layout.constraints)))
    held = (np.zeros_like(space.z), np.zeros_like(space.u), np.zeros_like(state.p))
    q, qd = np.vstack([np.zeros((n, n)), columns.T]), np.vstack([np.eye(n), np.zeros((m, n))])
    given = (space.t, state.q, state.qd, space.z, space.u, space.w, state.p, *nothing, q, qd, *held)
    slopes = -functions.along("residual_tangent", 0, *given)
    total, size = slopes @ columns, np.abs(slopes) @ np.abs(columns)
    total = np.where(np.abs(total) > _ROUNDING * size, total, 0.0)
    by_rates = total[:n].T
    return _Forces(by_rates, by_rates @ columns, total[n:].T)


def _combinations(directions: _Directions, forces: list[_Forces]) -> list[_Combination] | None:
    """First the combinations of N' f that hold no rates, then balances beside them that do; None where combinations
    depend on parameters."""
    m = len(directions.leading)
    table = np.hstack([each.by_rates for each in forces])
    lengths = np.linalg.norm(table, axis=1)
    unit = np.where(lengths > 0.0, lengths, 1.0)
    columns, leading = _reduced(null_space((table / unit[:, None]).T, _ZERO) / unit[:, None], 1.0 / directions.sizes)
    still = _simple(columns)
    if still is None:
        return None
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
        rows = [combination.weights @ (each.stiffness if combination.still else each.damping) for combination in chosen]
        matrix = np.array(rows) * directions.sizes
        lengths = np.linalg.norm(matrix, axis=1, keepdims=True)
        free = null_space(matrix / np.where(lengths > 0.0, lengths, 1.0), _ZERO)
        if not free.shape[1]:
            return False
    way = _reduced(free * directions.sizes[:, None], directions.sizes)[0][:, 0]
    along = np.abs(directions.columns @ way)
    together = np.flatnonzero(along > _ZERO * np.max(along)).tolist()
    names = [f"`{flat.coordinates[i].name}`" for i in together]
    motion = names[0] if len(names) == 1 else f"the motion in which {some_of(names)} change together"
    pushed = any(
        np.any(np.abs(each.stiffness @ way) > _ZERO * (np.abs(each.stiffness) @ np.abs(way))) for each in forces
    )
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
