"""Rules for every model in models/: drop a file in, and it is tested.

`make check` shows the rules of derivations, solutions and derivatives by models of each kind.
"""

from __future__ import annotations

import numpy as np
import pytest
from choice import ALL

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.functions import ALONG_MANY, SIGNATURES
from lagdsl.derivation.program.program import Program
from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.exchange.verify.states import Arrays, independent_rows, saddle_point, values, values_with_size
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.text import flat_text
from lagdsl.language.syntax.parser import parse
from lagdsl.language.syntax.printer import format_text
from models.corpus import (
    MODELS,
    STATES,
    arguments,
    c_engine,
    compiled,
    expectations,
    numpy_engine,
    path_of,
    random_states,
    textbook,
)
from models.kinds import FEW, HALF, OF_EACH_KIND, RARE, SOME, kinds

STEP = 1e-30
ROUNDING = 1e-12  # of the size of the terms
# Multipliers that take back the effect of forces leave its rounding: in rows in which nothing else
# stands, of coordinates that are prescribed at rest, and of a slide without mass (roundings of the largest multiplier).
TAKEN_BACK = {"library/forces_speed_drives": 1e-10, "library/planar_trammel": 1e-11}


def test_there_are_at_least_twenty_six_models_each_with_expectations() -> None:
    assert len(MODELS) >= 26
    for name in MODELS:
        assert expectations(name)["source"]


@pytest.mark.skipif(not ALL, reason="compiles all models: make check-all")
def test_the_chosen_models_show_every_kind() -> None:
    shown = set().union(*(kinds(name) for name in OF_EACH_KIND))
    assert {name: lacking for name in MODELS if (lacking := kinds(name) - shown)} == {}


@HALF
def test_the_format_is_canonical_stable_and_means_the_same(name: str) -> None:
    source = compiled(name).source
    sink = Sink()
    formatted = format_text(source, sink)
    assert formatted == source.text, "run `lag fmt models/*.lag`"
    again = type(source)(source.name, formatted)
    assert format_text(again, sink) == formatted
    assert parse(again, sink) == parse(source, sink) is not None
    assert not sink.diagnostics


@SOME
def test_compiling_finds_nothing_wrong(name: str) -> None:
    found = [d for d in compiled(name).diagnostics if d.severity != "note"]
    assert {d.code for d in found} <= set(expectations(name).get("warnings", [])), [d.message for d in found]


@RARE
def test_check_finds_nothing_wrong(name: str) -> None:
    from lagdsl import check

    found = [d for d in check(path_of(name)) if d.severity != "note"]
    assert [d.code for d in found] == expectations(name).get("warnings", []), [d.message for d in found]


@SOME
def test_the_flat_text_lists_every_coordinate_and_parameter(name: str) -> None:
    flat = compiled(name).flat
    text = flat_text(flat)
    assert text == flat_text(flat)
    for item in (*flat.coordinates, *flat.states, *flat.parameters, *flat.outputs, *flat.inputs):
        assert item.name in text
    for constraint in flat.constraints:
        assert constraint.name in text


# ---- two derivations, three ways to compute -------------------------------------------------------------------------


@FEW
def test_both_derivations_agree(name: str) -> None:
    graph, symbolic = compiled(name).graph, textbook(name)
    states = random_states(name)
    for function in SIGNATURES:
        pairs = zip(
            values_with_size(graph, function, states), values_with_size(symbolic, function, states), strict=True
        )
        for index, ((ours, size), (theirs, other)) in enumerate(pairs):
            if (function, index) != ("monitor", 1):  # the largest term of an invariant depends on how it is written
                _assert_close(ours, theirs, np.maximum(size, other), function)


@HALF
def test_the_derivations_solve_to_the_same_motion(name: str) -> None:
    """Accelerations and multipliers of one route leave nothing in the equations of the other.

    Terms that cancel in one of them only have left their rounding errors: the size is that of either.
    """
    from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine

    states, graph, symbolic = random_states(name), compiled(name).graph, textbook(name)
    _assert_solved(name, numpy_engine(name), states, symbolic, graph)
    _assert_solved(name, NumpyEngine(symbolic), states, graph, symbolic)


@HALF
def test_numpy_computes_what_the_graph_means(name: str) -> None:
    _assert_computed(name, numpy_engine(name))


@RARE
def test_c_computes_what_the_graph_means(name: str) -> None:
    _assert_computed(name, c_engine(name))


def _assert_computed(name: str, engine: Engine) -> None:
    program, states = compiled(name).graph, random_states(name)
    for function in program.functions:
        if function.name in ALONG_MANY:
            continue
        expected = values_with_size(program, function.name, states)
        rows = [engine.evaluate(function.name, *arguments(program, function.name, states, i)) for i in range(STATES)]
        for index, (value, size) in enumerate(expected):
            _assert_close(np.array([row[index] for row in rows]), value, size, function.name)


@HALF
def test_solutions_satisfy_the_equations(name: str) -> None:
    _assert_solved(name, numpy_engine(name), random_states(name), compiled(name).graph)


@FEW
def test_solutions_in_c_satisfy_the_equations(name: str) -> None:
    engine, program = c_engine(name), compiled(name).graph
    _assert_solved(name, engine, _with_loads_found(engine, random_states(name), program), program)


def _with_loads_found(engine: Engine, states: Arrays, program: Program) -> Arrays:
    """States with the loads that the engine finds with its solution, where a model has such loads."""
    if not program.has("load"):
        return states
    solutions = [engine.solve(*arguments(program, "dynamics", states, i)) for i in range(STATES)]
    qdd, lam = (np.array([solution[k] for solution in solutions]) for k in (0, 1))
    loads = values(program, "load", states | {Group.QDD: qdd, Group.LAMBDA: lam})[0]
    discretes = states[Group.W].copy()
    discretes[:, discretes.shape[1] - loads.shape[1] :] = loads
    return states | {Group.W: discretes}


def _assert_solved(name: str, engine: Engine, states: Arrays, program: Program, *as_large_as: Program) -> None:
    """Residual that qdd and lam leave in M qdd - f - J' lam = 0 and J qdd = gamma, against the size of the terms.

    Where all terms of a row vanish, against a ten-thousandth of what the largest unknowns, or the accelerations that
    the forces alone would make, would make of it: where everything is held, those are all there is.
    """
    solutions = [engine.solve(*arguments(program, "dynamics", states, i)) for i in range(STATES)]
    qdd, lam = (np.array([solution[k] for solution in solutions]) for k in (0, 1))
    mass, force = values(program, "dynamics", states)[:2]
    free = np.array([np.linalg.lstsq(m, f, rcond=1e-10)[0] for m, f in zip(mass, force, strict=True)])
    alone = np.concatenate([qdd, free], axis=1)
    solved = states | {Group.QDD: qdd, Group.LAMBDA: lam}
    largest = states | {Group.QDD: _level(alone)[:, : qdd.shape[1]], Group.LAMBDA: _level(lam)}
    sizes = [_residual_sizes(each, solved, largest) for each in (program, *as_large_as)]
    for (value, _), *size in zip(values_with_size(program, "residual", solved), *sizes, strict=True):
        _assert_close(value, np.zeros_like(value), np.maximum.reduce(size), "residual", TAKEN_BACK.get(name, ROUNDING))


def _residual_sizes(program: Program, solved: Arrays, largest: Arrays) -> list[np.ndarray]:
    own, most = (values_with_size(program, "residual", at) for at in (solved, largest))
    return [np.maximum(size, 1e-4 * bound) for (_, size), (_, bound) in zip(own, most, strict=True)]


def _level(rows: np.ndarray) -> np.ndarray:
    """The largest of each row in all its entries."""
    return np.broadcast_to(np.max(np.abs(rows), axis=1, initial=0.0, keepdims=True), rows.shape)


def _assert_close(ours: np.ndarray, theirs: np.ndarray, size: np.ndarray, what: str, part: float = ROUNDING) -> None:
    assert np.array_equal(np.isinf(ours), np.isinf(theirs))
    ours, theirs = (np.where(np.isinf(each), 0.0, each) for each in (ours, theirs))
    assert ours.shape == theirs.shape, what
    wrong = np.abs(ours - theirs) > part * size
    assert not np.any(wrong), (what, np.argwhere(wrong)[:3], ours[wrong][:3], theirs[wrong][:3], size[wrong][:3])


# ---- derivatives -----------------------------------------------------------------------------------------------------


@HALF
def test_the_jacobian_is_exact(name: str) -> None:
    _assert_exact(name, numpy_engine(name))


@RARE
def test_the_jacobian_of_c_is_exact(name: str) -> None:
    _assert_exact(name, c_engine(name))


def _assert_exact(name: str, engine: Engine) -> None:
    """Against a complex step through the equations and their solution."""
    program, states = compiled(name).graph, random_states(name)
    nq = len(program.layout.coordinates)
    for i in range(0, STATES, 5):
        state = {g: a[i] for g, a in states.items()}
        ours = engine.jacobian(*arguments(program, "dynamics", states, i))
        directions = _consistent_directions(program, state)
        exact = _derivatives_along(program, state, directions.T).T
        error = np.abs(ours @ directions - exact)
        scale = np.max(np.abs(ours), axis=1, keepdims=True, initial=0.0)
        scale = np.maximum(scale, 1e-4 * np.max(scale))  # rows that vanish
        jacobian = values(program, "velocity_constraint", state)[1]
        if np.max(scale[nq : 2 * nq], initial=0.0) <= 1e-4 and np.linalg.matrix_rank(jacobian) == nq:
            continue  # contacts lock the machine: accelerations are round-off
        assert np.all(error <= 1e-10 * scale), np.max(error / np.maximum(scale, 1e-30))


def _consistent_directions(program: Program, state: Arrays) -> np.ndarray:
    """All directions of (q, qd, z); with redundant rows those that stay on the constraints, where all rows agree."""
    nq, nz = len(program.layout.coordinates), len(program.layout.states)
    if not any(program.layout.redundant):
        return np.eye(2 * nq + nz)
    stepped = _stepped(state, nq, np.eye(2 * nq + nz))
    rows = ("position_constraint", "velocity_constraint")
    columns = [_complex(program, row, stepped)[0].imag / STEP for row in rows]
    matrix = np.concatenate(columns, axis=1).T
    _, sizes, axes = np.linalg.svd(matrix)
    rank = int(np.sum(sizes > 1e-9 * sizes[0]))
    return axes[rank:].T


def _stepped(state: Arrays, nq: int, directions: np.ndarray) -> Arrays:
    """A complex step along each of (n, 2 nq + nz)."""
    return state | {
        Group.TIME: np.full(len(directions), state[Group.TIME]),
        Group.Q: state[Group.Q] + 1j * STEP * directions[:, :nq],
        Group.QD: state[Group.QD] + 1j * STEP * directions[:, nq : 2 * nq],
        Group.Z: state[Group.Z] + 1j * STEP * directions[:, 2 * nq :],
    }


def _derivatives_along(program: Program, state: Arrays, directions: np.ndarray) -> np.ndarray:
    """d(qd, qdd, zd) along each (dq, dqd, dz)."""
    stepped = _stepped(state, len(program.layout.coordinates), directions)
    qdd, lam = _complex_solution(program, stepped)
    (zd,) = _complex(program, "state_derivative", stepped | {Group.QDD: qdd, Group.LAMBDA: lam})
    return np.concatenate([stepped[Group.QD].imag, qdd.imag, zd.imag], axis=1) / STEP


def _complex_solution(program: Program, state: Arrays) -> tuple[np.ndarray, np.ndarray]:
    """Of one state, or of several that differ by complex steps."""
    mass, force, jacobian, gamma = _complex(program, "dynamics", state)
    rows = independent_rows(program, jacobian)
    matrix = saddle_point(mass, jacobian[..., rows, :])
    right = np.concatenate([force, gamma[..., rows]], axis=-1)
    solution = np.linalg.solve(matrix, right[..., None])[..., 0]
    lam = np.zeros(gamma.shape, dtype=complex)
    lam[..., rows] = solution[..., force.shape[-1] :]
    return solution[..., : force.shape[-1]], lam


def _complex(program: Program, function: str, state: Arrays) -> list[np.ndarray]:
    return [block.astype(complex) for block in values(program, function, state)]


# ---- power -----------------------------------------------------------------------------------------------------------


@HALF
def test_power_balance(name: str) -> None:
    """dh/dt = (Q - dD/dqd) . qd + lam . J qd - dL/dt with h = qd . dL/dqd - L, states held, and inputs but for those
    that have derivatives."""
    program, states = compiled(name).graph, random_states(name)
    for i in range(0, STATES, 5):
        state = {g: a[i] for g, a in states.items()}
        qdd, lam = (x.real for x in _complex_solution(program, state))
        inputs = state[Group.U] + 1j * STEP * _input_rates(program, state[Group.U])
        moving = state | {
            Group.TIME: state[Group.TIME] + 1j * STEP,
            Group.U: inputs,
            Group.Q: state[Group.Q] + 1j * STEP * state[Group.QD],
            Group.QD: state[Group.QD] + 1j * STEP * qdd,
        }
        rate = _complex(program, "energies", moving)[3].imag / STEP
        later = state | {Group.TIME: state[Group.TIME] + 1j * STEP, Group.U: inputs}
        jacobi, momenta = _complex(program, "energies", later)[3], _complex(program, "momenta", later)[0]
        explicit = (momenta @ state[Group.QD] - jacobi).imag / STEP
        load, dissipated = values(program, "power", state)
        _, jacobian = values(program, "velocity_constraint", state)
        terms = np.concatenate([load, -dissipated, lam * (jacobian @ state[Group.QD]), [-explicit]])
        momentum = values(program, "momenta", state)[0]
        swing = np.sum(np.abs(momentum * state[Group.QD])) * np.max(np.abs(state[Group.QD]), initial=0.0)
        size = max(np.sum(np.abs(terms)), np.sum(np.abs(momentum * qdd)), swing, abs(rate))
        assert abs(rate - np.sum(terms)) <= 1e-10 * size


def _input_rates(program: Program, u: np.ndarray) -> np.ndarray:
    """Of inputs whose time derivative is an input, too; zeros else."""
    names = [slot.name for slot in program.layout.inputs]
    return np.array([u[names.index(rate)] if (rate := f"der({name})") in names else 0.0 for name in names])
