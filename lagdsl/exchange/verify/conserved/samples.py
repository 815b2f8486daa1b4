"""Values and changes of candidates at random states: their rates along the motion, and their jumps at impacts."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.differentiate import jacobian
from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.program.passes.written_out import written_out
from lagdsl.derivation.program.program import Program
from lagdsl.exchange.verify.conserved.candidates import Candidate
from lagdsl.exchange.verify.conserved.noise import with_size
from lagdsl.exchange.verify.states import (
    Arrays,
    drawn_parameters,
    drawn_sizes,
    drawn_states,
    independent_rows,
    is_regular,
    saddle_point,
    values,
)
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.event_flow import branches
from lagdsl.language.flat.events import Impact, entries
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation

_SEED = 21
_ROUNDS = 12
_MOST_STEPS = 40
_ROUNDING = 1e-11


@record()
class Samples:
    """`values` (states, candidates) at `states`, of natural sizes `natural`. `changes` are rates [1/s] and jumps, one
    row each, of natural sizes `sizes`; `of` is the state that a row belongs to."""

    states: Arrays
    values: Floats
    natural: Floats
    changes: Floats
    sizes: Floats
    of: NDArray[np.intp]

    @property
    def p(self) -> Floats:
        """Parameters of each state (states, np)."""
        return np.asarray(self.states[Group.P])


def samples(
    compilation: Compilation, found: Sequence[Candidate], count: int, *, p: Floats | None = None
) -> Samples | None:
    """Of `count` states, with parameters at random or all with `p` (np,); None where so many are not found."""
    equations, program = compilation.equations, compilation.program
    states = _states(compilation, count, p)
    if states is None:
        return None
    motion, inertia = _solution(program, states)
    solved = states | motion
    graph, nodes = equations.graph, [each.value for each in found]
    own = _natural(program, states)
    at, natural = with_size(graph, nodes, states, own)
    changes, sizes = with_size(graph, [each.rate for each in found], solved, own, inertia)
    of = [np.arange(count)]
    for after, which in _after_impacts(equations, program, states):
        now = at[which]
        then = _evaluated(equations, nodes, after)
        changes = np.concatenate([changes, then - now])
        sizes = np.concatenate([sizes, np.abs(then) + np.abs(now)])
        of.append(which)
    return Samples(states, at, natural, changes, sizes, np.concatenate(of))


def _natural(program: Program, states: Arrays) -> dict[Group, Floats]:
    """Sizes of coordinates and rates, as states are drawn: those of their starts."""
    q, qd, _, _ = values(program, "start", {group: states[group] for group in (Group.TIME, Group.P)})
    return {group: drawn_sizes(np.asarray(start[0], dtype=float)) for group, start in ((Group.Q, q), (Group.QD, qd))}


def _states(compilation: Compilation, count: int, p: Floats | None) -> Arrays | None:
    flat, program = compilation.flat, compilation.program
    random = np.random.default_rng(_SEED)
    parts: list[Arrays] = []
    missing = count
    for _ in range(_ROUNDS):
        if p is None:
            parameters = drawn_parameters(flat, program, random, missing)
        else:
            parameters = np.broadcast_to(p, (missing, len(p)))
        drawn = drawn_states(flat, program, random, parameters, widely=True)
        sound = is_regular(program, drawn)
        parts.append({group: rows[sound] for group, rows in drawn.items()})
        missing -= int(np.count_nonzero(sound))
        if missing == 0:
            return {group: np.concatenate([part[group] for part in parts]) for group in parts[0]}
    return None


def _solution(program: Program, states: Arrays) -> tuple[Arrays, Floats]:
    """Accelerations and multipliers of each state, and the inertia (states, nq) of each coordinate."""
    mass, force, rows, gamma = values(written_out(program), "dynamics", states)
    qdd, lam = np.zeros(force.shape), np.zeros(gamma.shape)
    for i in range(len(force)):
        kept = independent_rows(program, rows[i])
        solution = np.linalg.solve(saddle_point(mass[i], rows[i][kept]), np.concatenate([force[i], gamma[i][kept]]))
        qdd[i] = solution[: len(force[i])]
        lam[i, kept] = solution[len(force[i]) :]
    return {Group.QDD: qdd, Group.LAMBDA: lam}, np.abs(np.diagonal(mass, axis1=1, axis2=2))


def _after_impacts(equations: Equations, program: Program, states: Arrays) -> list[tuple[Arrays, NDArray[np.intp]]]:
    """States after an impulse along each gap that can collide, each border at which energies may step and each
    constraint that can appear: J' of the row, balanced over the mechanism so that what stays closed moves on its
    constraints. A row that is closed and opens is given a rate instead of being left out: M may be regular with it
    only. Impulses are of random sizes: equal ones change an energy and a momentum alike. Rates that have no momenta are
    left out."""
    gaps, appearing = _gaps(equations), _rows_of_some_times(equations.flat)
    if not gaps and not appearing:
        return []
    _, _, rows, _ = values(written_out(program), "dynamics", states)
    count, n = len(rows), len(equations.symbols.q)
    slopes = rows[:, appearing]
    if gaps:
        found = jacobian(equations.graph, gaps, equations.symbols.q)
        elements = [row.get(column, equations.graph.zero) for row in found for column in range(n)]
        slopes = np.concatenate([slopes, _evaluated(equations, elements, states).reshape(count, len(gaps), n)], axis=1)
    after = []
    random = np.random.default_rng(_SEED)
    for slope in np.moveaxis(slopes * random.uniform(0.5, 2.0, slopes.shape[:2])[..., None], 1, 0):
        qd = _struck(program, states, slope)
        whole = np.flatnonzero(np.isfinite(qd).all(axis=1))
        after.append(({group: rows[whole] for group, rows in (states | {Group.QD: qd}).items()}, whole))
    return after


def _struck(program: Program, states: Arrays, slope: Floats) -> Floats:
    """Rates (states, nq) behind impulses `slope`, by Newton's method in the balance of momenta; nan where there are
    none. A step to rates that have no momenta is halved."""
    (before,) = values(program, "momenta", states)
    qd = before_qd = np.array(states[Group.QD])
    left = np.full(len(qd), np.inf)
    for _ in range(_MOST_STEPS):
        mass, _, jacobian, _ = values(written_out(program), "dynamics", states | {Group.QD: qd})
        (momenta,) = values(program, "momenta", states | {Group.QD: qd})
        step = np.zeros_like(qd)
        for i in range(len(qd)):
            rows = jacobian[i][independent_rows(program, jacobian[i])]
            own = np.array([_opening(row, slope[i]) for row in rows])
            missing = np.where(np.any(own), 0.0, slope[i]) + before[i] - momenta[i]
            matrix = saddle_point(mass[i], rows)
            step[i] = np.linalg.solve(matrix, np.append(missing, own - rows @ (qd[i] - before_qd[i])))[: qd.shape[1]]
        step = _halved(program, states, qd, step)
        qd, left = qd + step, np.max(np.abs(step), axis=1, initial=0.0)
        if np.all(left <= _ROUNDING * np.max(np.abs(qd), axis=1, initial=0.0)):
            break
    return np.where((left <= _ROUNDING * np.max(np.abs(qd), axis=1, initial=0.0))[:, None], qd, np.nan)


def _halved(program: Program, states: Arrays, qd: Floats, step: Floats) -> Floats:
    for _ in range(_MOST_STEPS):
        (momenta,) = values(program, "momenta", states | {Group.QD: qd + step})
        lost = ~np.isfinite(momenta).all(axis=1)
        if not lost.any():
            break
        step = np.where(lost[:, None], 0.5 * step, step)
    return step


def _opening(row: Floats, slope: Floats) -> float:
    """Change of the rate of a row: 0 where it stays closed, of the size of the impulse where it is the gap itself."""
    impulse = float(np.linalg.norm(slope))
    is_gap = abs(float(row @ slope)) > (1.0 - 1e-12) * float(np.linalg.norm(row)) * impulse
    return impulse if is_gap else 0.0


def _rows_of_some_times(flat: FlatModel) -> list[int]:
    """Rows that are there at some times only."""
    flags = [constraint.switched for constraint in flat.constraints for _ in constraint.rows]
    return [index for index, flag in enumerate(flags) if flag]


def _gaps(equations: Equations) -> list[int]:
    flat, lowering = equations.flat, equations.lowering
    acts = (action for branch in branches(flat) for action in branch.actions)
    gaps = [contact.gap for contact in flat.events.contacts]
    gaps += [action.gap for action in acts if isinstance(action, Impact)]
    return [*(lowering.scalar(gap) for gap in gaps), *_borders(equations)]


def _borders(equations: Equations) -> list[int]:
    """Distances from borders of the energies, `if x < 1 m then ... else ...`: a step of energy is an impulse across."""
    graph, lowering = equations.graph, equations.lowering
    symbols = [node for node in graph.live([equations.energies.total]) if graph.op[node] is Op.SYMBOL]
    read = {graph.b[node] for node in symbols if graph.group(node) is Group.W}
    names = [entry.name for place, entry in enumerate(entries(equations.flat.events)) if place in read]
    distances = [lowering.scalar(each.difference) for each in equations.flat.events.relations if each.name in names]
    return [distance for distance in distances if graph.depends(distance, Group.Q)]


def _evaluated(equations: Equations, nodes: list[int], states: Arrays) -> Floats:
    found = evaluate(equations.graph, nodes, states)
    count = len(states[Group.TIME])
    return np.stack([np.broadcast_to(np.real(each), (count,)) for each in found], axis=1)
