"""Both engines over whole models: the same numbers, exact Jacobians, and what they say where there is no solution."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import product

import numpy as np
import pytest
from choice import chosen
from sample_programs import chain, closed_chain, pendulum, quaternion_body

from lagdsl.algebra.graph import Group
from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.derivation.program.functions import STATE
from lagdsl.derivation.program.program import Program
from lagdsl.engines.runtime.engines.broadcast import interface, spread
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.engine import SingularSystem
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine

Make = Callable[[], Program]
MODELS: dict[str, Make] = {
    "pendulum": pendulum,
    "chain": lambda: chain(4),
    "loop": closed_chain,
    "dependent": lambda: closed_chain(3, "Dependent", flagged=True),
    "quaternion": quaternion_body,
}
ENGINES = [NumpyEngine, CEngine]
FEW = [(name, engine) for name in ("dependent", "quaternion") for engine in ENGINES]


def _state(program: Program, seed: int) -> list:
    draw = np.random.default_rng(seed)
    layout = program.layout
    arrays = [draw.normal(size=layout.size(group)) for group in STATE[1:-1]]
    if program.name == "Free body":
        arrays[0] /= np.linalg.norm(arrays[0])
    return [draw.normal(), *arrays, np.array(layout.defaults) * draw.uniform(0.5, 2.0, len(layout.defaults))]


def _argument(program: Program, group: Group, draw: np.random.Generator) -> np.ndarray | float:
    if group is Group.TIME:
        return 0.7
    if group is Group.P:
        return np.array(program.layout.defaults)
    return draw.normal(size=program.layout.size(group))


@pytest.mark.parametrize("name", chosen(MODELS, ("dependent", "quaternion")))
def test_every_function_means_what_the_graph_means(name: str) -> None:
    program = MODELS[name]()
    engines = [engine(program) for engine in ENGINES]
    for function in program.functions:
        draw = np.random.default_rng(3)
        arguments = [_argument(program, group, draw) for group in function.arguments]
        symbols = dict(zip(function.arguments, arguments, strict=True))
        for index, block in enumerate(function.results):
            meaning = np.array(evaluate(program.graph, block.elements, symbols), dtype=float).reshape(block.shape)
            for engine in engines:
                found = engine.evaluate(function.name, *arguments)[index]
                assert found.shape == block.shape
                np.testing.assert_allclose(found, meaning, rtol=1e-13, atol=1e-13, err_msg=function.name)


@pytest.mark.parametrize("name", chosen(MODELS, ("dependent", "quaternion")))
def test_both_solve_to_the_size_of_the_terms(name: str) -> None:
    program = MODELS[name]()
    engines = [engine(program) for engine in ENGINES]
    for seed in range(50):
        state = _state(program, seed)
        for engine in engines:
            qdd, lam = engine.solve(*state)
            mass, force, rows, gamma = engine.evaluate("dynamics", *state)
            motion = np.abs(mass @ qdd - force - rows.T @ lam)
            terms = np.abs(mass) @ np.abs(qdd) + np.abs(force) + np.abs(rows.T) @ np.abs(lam)
            assert np.all(motion <= 1e-13 * terms), (name, seed)
            left, size = np.abs(rows @ qdd - gamma), np.abs(rows) @ np.abs(qdd) + np.abs(gamma)
            assert np.all(left <= 1e-13 * size), (name, seed)


@pytest.mark.parametrize(("name", "engine_type"), chosen(product(MODELS, ENGINES), FEW))
def test_jacobians_agree_with_differences(name: str, engine_type: type) -> None:
    program = MODELS[name]()
    engine = engine_type(program)
    t, q, qd, z, u, w, p = _state(program, 8)
    sizes = np.cumsum([len(q), len(q)])

    def rates(x: np.ndarray) -> np.ndarray:
        parts = [np.ascontiguousarray(part) for part in np.split(x, sizes)]
        qdd, lam = engine.solve(t, *parts, u, w, p)
        return np.concatenate([parts[1], qdd, *engine.evaluate("state_derivative", t, *parts, u, w, p, qdd, lam)])

    x = np.concatenate([q, qd, z])
    h = 1e-3
    stencil = [(-1, 1 / 60), (1, -1 / 60)]  # sixth order, for offsets 3, 2, 1
    differences = np.zeros((len(x), len(x)))
    for offset, weight in ((3, 1 / 60), (2, -3 / 20), (1, 3 / 4)):
        for sign, _ in stencil:
            for k, unit in enumerate(np.eye(len(x))):
                differences[:, k] -= sign * -weight * rates(x + sign * offset * h * unit) / h
    found = engine.jacobian(t, q, qd, z, u, w, p)
    np.testing.assert_allclose(found, differences, rtol=1e-8, atol=1e-8 * np.abs(found).max())


@pytest.mark.parametrize("engine_type", ENGINES)
def test_a_pendulum_by_hand(engine_type: type) -> None:
    engine = engine_type(pendulum())
    p = np.array([2.0, 0.5, 0.3, 0.2])
    one = np.array([1.0])
    qdd, lam = engine.solve(0.0, 0.4 * one, 2 * one, 3 * one, 4 * one, np.zeros(0), p)
    np.testing.assert_allclose(qdd, [(4 - 0.9 - 2 * 9.80665 * 0.5 * np.sin(0.4)) / 0.5], rtol=1e-15)
    assert lam.shape == (0,)
    a = engine.jacobian(0.0, 0.4 * one, 2 * one, 3 * one, 4 * one, np.zeros(0), p)
    expected = [[0, 1, 0], [-9.80665 * np.cos(0.4) / 0.5, 0, -0.3 / 0.5], [0, 5, -5]]
    np.testing.assert_allclose(a, expected, rtol=1e-14)


@pytest.mark.parametrize("engine_type", ENGINES)
def test_new_parameters_count_at_once(engine_type: type) -> None:
    engine = engine_type(chain(2))
    state = [0.0, np.array([0.1, 0.2]), np.zeros(2), *(np.zeros(0),) * 3]
    light, heavy = np.array([1.0, 1.0, 9.81]), np.array([1.0, 2.0, 9.81])
    first = engine.solve(*state, light)[0]
    np.testing.assert_allclose(engine.solve(*state, heavy)[0], first / 2, rtol=1e-14)
    engine.solve_many(*state, heavy)
    np.testing.assert_array_equal(engine.solve(*state, light)[0], first)
    np.testing.assert_allclose(
        engine.evaluate("mass_matrix", *state, heavy)[0], 4 * engine.evaluate("mass_matrix", *state, light)[0]
    )


@pytest.mark.parametrize("engine_type", ENGINES)
def test_results_are_the_callers_own(engine_type: type) -> None:
    program = closed_chain()
    engine = engine_type(program)
    first = engine.solve(*_state(program, 1))
    kept = [x.copy() for x in first]
    engine.solve(*_state(program, 2))
    engine.jacobian(*_state(program, 3))
    for now, before in zip(first, kept, strict=True):
        np.testing.assert_array_equal(now, before)


@pytest.mark.parametrize("engine_type", ENGINES)
def test_dependent_rows_move_like_independent_ones(engine_type: type) -> None:
    once, thrice = closed_chain(), closed_chain(3, "Dependent", flagged=True)
    for seed in range(10):
        state = _state(once, seed)
        qdd, lam = engine_type(once).solve(*state)
        qdd3, lam3 = engine_type(thrice).solve(*state)
        np.testing.assert_allclose(qdd3, qdd, rtol=1e-11, atol=1e-12 * np.abs(qdd).max())
        scale = np.array([1.0, 10.0, 100.0])
        least = np.outer(scale, lam) / (scale @ scale)
        np.testing.assert_allclose(lam3, least.ravel(), rtol=1e-10, atol=1e-11 * np.abs(least).max())


@pytest.mark.parametrize("engine_type", ENGINES)
def test_a_stretched_four_bar_is_solved(engine_type: type) -> None:
    """All links in line: the closure's rows become dependent, the motion must not become infinite."""
    engine = engine_type(closed_chain())
    nothing = (np.zeros(0),) * 3
    qdd, lam = engine.solve(0.0, np.zeros(3), np.zeros(3), *nothing, np.array([1.0]))
    assert np.all(np.isfinite(qdd))
    assert np.abs(qdd).max() < 1e3
    assert lam[0] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("engine_type", ENGINES)
def test_euler_equations_through_quaternions(engine_type: type) -> None:
    """edd gives I wd = -w x I w for the body with principal moments 1, 2, 4."""
    engine = engine_type(quaternion_body())
    inertia = np.array([1.0, 2.0, 4.0])
    draw = np.random.default_rng(4)
    for _ in range(20):
        e, spin = draw.normal(size=4), draw.normal(size=3)
        e /= np.linalg.norm(e)
        w, x, y, z = e
        transfer = np.array([[-x, w, z, -y], [-y, -z, w, x], [-z, y, -x, w]])
        ed = 0.5 * transfer.T @ spin
        edd, _ = engine.solve(0.0, e, ed, *(np.zeros(0),) * 4)
        np.testing.assert_allclose(2 * transfer @ edd, -np.cross(spin, inertia * spin) / inertia, atol=1e-13)
        assert e @ edd == pytest.approx(-ed @ ed, abs=1e-13)


@pytest.mark.parametrize("engine_type", ENGINES)
def test_massless_coordinate_is_named(engine_type: type) -> None:
    engine = engine_type(pendulum())
    one = np.ones(1)
    state = (0.0, one, one, one, one, np.zeros(0), np.array([0.0, 1.0, 1.0, 1.0]))
    for call in (engine.solve, engine.jacobian, engine.solve_many, partial(engine.jacobian_many, "state")):
        with pytest.raises(SingularSystem, match="coordinate 0"):
            call(*state)


@pytest.mark.parametrize("engine_type", ENGINES)
def test_what_is_not_finite_comes_back_as_it_is(engine_type: type) -> None:
    engine = engine_type(pendulum())
    one = np.ones(1)
    p = np.array([1.0, 1.0, 1.0, 0.0])
    assert np.isnan(engine.solve(0.0, one * np.nan, one, one, one, np.zeros(0), p)[0]).all()
    assert np.isnan(engine.solve(0.0, one, one, one, one, np.zeros(0), np.full(4, np.inf))[0]).all()
    (zd,) = engine.evaluate("state_derivative", 0.0, one, 2 * one, one, one, np.zeros(0), p, one, np.zeros(0))
    assert np.isposinf(zd).all()
    assert not np.isfinite(engine.jacobian(0.0, one, one, one, one, np.zeros(0), p)).all()
    q = np.array([[0.5], [np.nan], [0.5]])
    qdd, _ = engine.solve_many(0.0, q, one, one, one, np.zeros(0), np.ones(4))
    np.testing.assert_array_equal(np.isnan(qdd[:, 0]), [False, True, False])
    assert qdd[0] == qdd[2]


# ---- leading axes ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "engine_type"), chosen(product(MODELS, ENGINES), FEW))
def test_many_states_are_each_like_one(name: str, engine_type: type) -> None:
    program = MODELS[name]()
    engine = engine_type(program)
    states = [_state(program, seed) for seed in range(6)]
    t, q, qd, z, u, w, p = (np.array(column) for column in zip(*states, strict=True))
    shaped = [x.reshape((2, 3, *x.shape[1:])) for x in (t, q, qd, z, u, w)]
    for parameters in (p.reshape((2, 3, -1)), p[0]):
        qdd, lam = engine.solve_many(*shaped, parameters)
        jacobian = engine.jacobian_many("state", *shaped, parameters)[0]
        mass = engine.evaluate_many("dynamics", *shaped, parameters)[0]
        for k, state in enumerate(states):
            one = [*state[:-1], parameters if parameters.ndim == 1 else p[k]]
            at = divmod(k, 3)
            expected, multipliers = engine.solve(*one)
            np.testing.assert_allclose(qdd[at], expected, rtol=1e-12, atol=1e-12 * np.abs(expected).max())
            np.testing.assert_allclose(
                lam[at], multipliers, rtol=1e-11, atol=1e-12 * np.abs(multipliers).max(initial=0)
            )
            whole = engine.jacobian(*one)
            np.testing.assert_allclose(jacobian[at], whole, rtol=1e-10, atol=1e-11 * np.abs(whole).max())
            np.testing.assert_allclose(mass[at], engine.evaluate("dynamics", *one)[0], rtol=1e-14, atol=1e-14)


def test_the_interface_is_the_same_over_both_engines() -> None:
    program = pendulum()
    numpy, c = (interface(program, engine(program)) for engine in ENGINES)
    q = np.linspace(-2, 2, 5)[:, None]
    for name, arguments in {
        "forward_dynamics": (q, [1.0]),
        "multipliers": (q, [1.0]),
        "inverse_dynamics": (q, [1.0], [2.0]),
        "mass_matrix": (q,),
        "constraint_jacobian": (q,),
        "output": (q, [1.0]),
        "energy": (q, [1.0]),
        "state_jacobian": (q, [1.0]),
        "input_jacobian": (q, [1.0]),
        "parameter_jacobian": (q, [1.0]),
        "output_jacobian": (q, [1.0]),
    }.items():
        found, expected = getattr(c, name)(0.5, *arguments), getattr(numpy, name)(0.5, *arguments)
        assert found.shape == expected.shape
        np.testing.assert_allclose(found, expected, rtol=1e-14, atol=1e-14, err_msg=name)


def test_spread_shares_what_all_states_have_in_common() -> None:
    many = spread([("t", None), ("q", 2)], [[0.0, 1.0, 2.0], [5.0, 6.0]])
    assert many.leading == (3,)
    assert [(name, stride) for name, _, stride in many.arrays] == [("t", 1), ("q", 0)]
    with pytest.raises(ValueError, match="q must have 2 entries"):
        spread([("q", 2)], [[1.0]])


def test_one_engine_after_another_keeps_its_own_parameters() -> None:
    program = chain(2)
    light = replace(program, layout=replace(program.layout, defaults=(1.0, 1.0, 1.0)))
    a, b = CEngine(program), CEngine(light)
    state = _state(program, 1)
    before = a.solve(*state)[0]
    b.solve(*state[:-1], np.array([9.0, 9.0, 9.0]))
    np.testing.assert_array_equal(a.solve(*state)[0], before)
