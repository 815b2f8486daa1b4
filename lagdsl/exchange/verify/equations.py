"""Lines on the equations: two derivations, four ways to compute, derivatives, the balance of power."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.lagrange.lagrangian import energies
from lagdsl.derivation.program.functions import ALONG_MANY, SIGNATURES
from lagdsl.derivation.program.passes.written_out import written_out
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.textbook.extent import extent
from lagdsl.engines.runtime.engines.engine import Engine, EngineName
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.exchange.verify.certificate import Line
from lagdsl.exchange.verify.states import Arrays, independent_rows, saddle_point, values, values_with_size
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation

# Parts of the size of the terms: two ways to compute a sum differ by some roundings of its terms.
_ROUNDING = 1e-12
_SOLVED = 1e-10
_DERIVED = 1e-9
_STEP = 1e-30  # of complex steps (Squire and Trapp, SIAM Review 40 (1998) 110): no subtraction, so no least step
_RANK = 1e-9  # of the largest singular value
_LEAST_PART = 1e-4  # of the largest row, to which rows that vanish are compared
_JACOBIANS = 4
_ENGINES: dict[EngineName, str] = {"tape": "on the tape", "numpy": "in NumPy", "c": "in C"}


def derivations(flat: FlatModel, program: Program, states: Arrays) -> Line:
    """SymPy's equations against those of the graph."""
    name, says = "two derivations", "Lagrange's equations by SymPy and on the graph have the same values"
    beyond = extent(flat).reasons
    if beyond:
        return Line(name=name, says=says, note=f"too large for the derivation on paper: {', '.join(beyond)}")
    from lagdsl.derivation.textbook.derive import derive
    from lagdsl.derivation.textbook.lower import lower

    other = lower(derive(flat), flat)
    worst = _Worst()
    for function in SIGNATURES:
        both = zip(values_with_size(program, function, states), values_with_size(other, function, states), strict=True)
        for index, ((ours, size), (theirs, their_size)) in enumerate(both):
            if (function, index) != ("monitor", 1):  # the largest term of an invariant depends on how it is written
                worst.compare(ours, theirs, np.maximum(size, their_size), function)
    return Line(name=name, says=says, figure=worst.part, limit=_ROUNDING, note=worst.where)


def engines(program: Program, states: Arrays, tape: Engine) -> Iterator[Line]:
    """Every engine against the interpreter of the graph."""
    for name, where in _ENGINES.items():
        says = f"the functions {where} have the values of the graph"
        try:
            engine = tape if name == tape.name else engine_of(program, name)
        except CompilationFailed as failure:
            yield Line(name=f"engine {name}", says=says, note=failure.diagnostics[0].message)
            continue
        worst = _Worst()
        for function in program.functions:
            if function.name in ALONG_MANY:
                continue
            expected = values_with_size(program, function.name, states)
            rows = [
                engine.evaluate(function.name, *arguments) for arguments in _arguments(program, function.name, states)
            ]
            for index, (value, size) in enumerate(expected):
                worst.compare(np.array([row[index] for row in rows]), value, size, function.name)
        yield Line(name=f"engine {name}", says=says, figure=worst.part, limit=_ROUNDING, note=worst.where)


def solutions(program: Program, engine: Engine, states: Arrays) -> Line:
    """M qdd - f - J' lam and J qdd - gamma with the computed accelerations and multipliers, against zero."""
    found = [engine.solve(*arguments) for arguments in _arguments(program, "dynamics", states)]
    qdd, lam = (np.array([solution[k] for solution in found]) for k in (0, 1))
    mass, force = values(program, "dynamics", states)[:2]
    free = np.array([np.linalg.lstsq(m, f, rcond=1e-10)[0] for m, f in zip(mass, force, strict=True)])
    most = {Group.QDD: _largest(np.concatenate([qdd, free], axis=1), qdd), Group.LAMBDA: _largest(lam, lam)}
    solved = _with_loads(program, states | {Group.QDD: qdd, Group.LAMBDA: lam})
    worst = _Worst()
    both = zip(
        values_with_size(program, "residual", solved),
        values_with_size(program, "residual", solved | most),
        strict=True,
    )
    for (value, size), (_, bound) in both:
        worst.compare(value, np.zeros_like(value), np.maximum(size, _LEAST_PART * bound), "residual")
    says = "accelerations and multipliers satisfy M qdd - f = J' lam and J qdd = gamma"
    return Line(name="solution", says=says, figure=worst.part, limit=_SOLVED, note=worst.where)


def _with_loads(program: Program, solved: Arrays) -> Arrays:
    """With those loads in w that accelerations and multipliers ask for; a load may read the others."""
    count = program.layout.kinds.count("load")
    for _ in range(count):
        discretes = solved[Group.W].copy()
        discretes[:, -count:] = values(program, "load", solved)[0]
        solved = solved | {Group.W: discretes}
    return solved


def tangents(program: Program, engine: Engine, states: Arrays) -> Line:
    """The state Jacobian against complex steps through the equations and their solution."""
    says = "exact derivatives equal complex steps through the equations"
    part = 0.0
    for i, arguments in enumerate(_arguments(program, "dynamics", states)[:_JACOBIANS]):
        state = {group: rows[i] for group, rows in states.items()}
        directions = _consistent(program, state)
        jacobian = engine.jacobian(*arguments)
        ours, exact = jacobian @ directions, _by_complex_steps(program, state, directions)
        scale = np.max(np.abs(jacobian), axis=1, keepdims=True, initial=0.0)
        alone = _unconstrained(program, state)
        scale = np.maximum(scale, _LEAST_PART * max(np.max(scale, initial=0.0), np.max(np.abs(alone), initial=0.0)))
        part = max(part, float(np.max(np.abs(ours - exact) / np.where(scale > 0.0, scale, 1.0), initial=0.0)))
    return Line(name="tangents", says=says, figure=part, limit=_DERIVED)


def power(compilation: Compilation, states: Arrays) -> Line:
    """dh/dt = (Q - dD/dqd) . qd + lam . J qd - dL/dt with the Jacobi integral h = qd . dL/dqd - L (Goldstein 2.7).

    In L(q, qd, t) states z are functions of time, whatever their equations read: dL/dt at fixed q and qd holds
    dL/dz zd + dL/dzd zdd, with zd and zdd as they are along the motion. So are inputs whose derivatives are inputs;
    others are held.
    """
    program, graph = compilation.program, compilation.equations.graph
    given = energies(compilation.equations.lowering.with_held_states(compilation.flat), compilation.flat).lagrangian
    part, names = 0.0, [slot.name for slot in program.layout.inputs]
    follows = [(k, names.index(f"der({name})")) for k, name in enumerate(names) if f"der({name})" in names]
    for i in range(0, len(states[Group.TIME]), 5):
        state = {group: rows[i] for group, rows in states.items()}
        qdd, lam = (x.real for x in _solved(program, state))
        qd = state[Group.QD]
        u = state[Group.U].astype(complex)
        for k, rate_of in follows:
            u[k] += 1j * _STEP * state[Group.U][rate_of]
        solved = {Group.QDD: qdd, Group.LAMBDA: lam}
        (zd,) = values(program, "state_derivative", state | solved)
        later = state | {
            Group.TIME: state[Group.TIME] + 1j * _STEP,
            Group.Z: state[Group.Z] + 1j * _STEP * zd,
            Group.U: u,
        }
        moving = later | {
            Group.Q: state[Group.Q] + 1j * _STEP * qd,
            Group.QD: qd + 1j * _STEP * qdd,
        }
        rate = values(program, "energies", moving)[3].imag / _STEP
        (moving_zd,) = values(program, "state_derivative", moving | solved)
        explicit = np.imag(evaluate(graph, [given], later | {Group.DIRECTION_Z: moving_zd})[0]) / _STEP
        load, dissipated = values(program, "power", state)
        _, jacobian = values(program, "velocity_constraint", state)
        terms = np.concatenate([load, -dissipated, lam * (jacobian @ qd), [-explicit]])
        momentum = values(program, "momenta", state)[0]
        swing = np.sum(np.abs(momentum * qd)) * np.max(np.abs(qd), initial=0.0)
        size = max(np.sum(np.abs(terms)), np.sum(np.abs(momentum * qdd)), swing, abs(rate))
        part = max(part, float(abs(rate - np.sum(terms)) / size) if size > 0.0 else 0.0)
    says = "the energy changes by the power of loads, dissipation, moving constraints, states, inputs and the time"
    return Line(name="power balance", says=says, figure=part, limit=_SOLVED)


def _consistent(program: Program, state: Arrays) -> Any:
    """Directions of (q, qd, z) as columns: all, or with redundant rows those that stay on the constraints, where all
    rows agree."""
    size = 2 * len(program.layout.coordinates) + len(program.layout.states)
    if not any(program.layout.redundant):
        return np.eye(size)
    rows = [
        np.concatenate([values(program, name, moved)[0] for name in ("position_constraint", "velocity_constraint")])
        for moved in _stepped(program, state, np.eye(size))
    ]
    _, sizes, axes = np.linalg.svd(np.array(rows).imag.T / _STEP)
    return axes[int(np.sum(sizes > _RANK * sizes[0])) :].T


def _stepped(program: Program, state: Arrays, directions: Any) -> Iterator[Arrays]:
    """A complex step along each column."""
    n = len(program.layout.coordinates)
    for step in 1j * _STEP * directions.T:
        moved = {Group.Q: step[:n], Group.QD: step[n : 2 * n], Group.Z: step[2 * n :]}
        yield state | {group: state[group] + part for group, part in moved.items()}


def _unconstrained(program: Program, state: Arrays) -> Any:
    """Accelerations of the forces alone: where constraints hold everything, derivatives are round-off of them."""
    mass, force, _, _ = values(written_out(program), "dynamics", state)
    return np.linalg.lstsq(mass, force, rcond=None)[0]


def _by_complex_steps(program: Program, state: Arrays, directions: Any) -> Any:
    """d(qd, qdd, zd) along the columns."""
    columns = []
    for moved in _stepped(program, state, directions):
        qdd, lam = _solved(program, moved)
        (zd,) = values(program, "state_derivative", moved | {Group.QDD: qdd, Group.LAMBDA: lam})
        columns.append(np.concatenate([moved[Group.QD], qdd, zd]).imag / _STEP)
    return np.array(columns).T


def _solved(program: Program, state: Arrays) -> tuple[Any, Any]:
    """qdd and lam of one state, real or complex."""
    mass, force, jacobian, gamma = values(written_out(program), "dynamics", state)
    rows = independent_rows(program, jacobian)
    right = np.concatenate([force, gamma[rows]])
    solution = np.linalg.solve(saddle_point(mass, jacobian[rows]), right)
    lam = np.zeros(len(gamma), dtype=solution.dtype)
    lam[rows] = solution[len(force) :]
    return solution[: len(force)], lam


def _arguments(program: Program, function: str, states: Arrays) -> list[list[Any]]:
    """Arguments of a function at every state, as an engine takes them."""
    groups = program.function(function).arguments
    return [
        [float(states[g][i]) if g is Group.TIME else np.ascontiguousarray(states[g][i]) for g in groups]
        for i in range(len(states[Group.TIME]))
    ]


def _largest(rows: Any, like: Any) -> Any:
    """The largest of each row, in the shape of `like`."""
    return np.broadcast_to(np.max(np.abs(rows), axis=1, initial=0.0, keepdims=True), like.shape)


class _Worst:
    """The largest difference, as a part of the size of the terms, and the function that shows it."""

    def __init__(self) -> None:
        self.part = 0.0
        self.where = ""

    def compare(self, ours: Any, theirs: Any, size: Any, function: str) -> None:
        alike = (ours == theirs) | (np.isnan(ours) & np.isnan(theirs))
        with np.errstate(all="ignore"):
            # A size may be no number where a pivot is infinite; the value itself is a size, too.
            parts = np.where(alike, 0.0, np.abs(ours - theirs) / np.fmax(size, np.abs(theirs)))
        worst = float(np.max(np.where(np.isnan(parts), np.inf, parts), initial=0.0))
        if worst > self.part:
            self.part, self.where = worst, f"largest in {function}"
