"""The evaluator is the meaning of a program; NumPy on arrays, Python on numbers and C compute the same."""

from __future__ import annotations

import numpy as np
import pytest
from choice import examples
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from random_programs import EXACT, SMOOTH, SYMBOLS, Step, as_outputs, grow, steps, values

from lagdsl.algebra.graph import Graph, Group
from lagdsl.algebra.graph.evaluate import evaluate_with_size
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.program.verify import verify
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine

Engine = CEngine | NumpyEngine
EMPTY = np.zeros(0)


def _outputs(engine: Engine, q: np.ndarray) -> np.ndarray:
    nothing = (EMPTY,) * 4
    return engine.evaluate("output", 0.75, q, np.zeros(SYMBOLS), *nothing, np.zeros(SYMBOLS), EMPTY)[0]


def _many_outputs(engine: Engine, q: np.ndarray) -> np.ndarray:
    nothing = (EMPTY,) * 4
    return engine.evaluate_many("output", 0.75, q, np.zeros(SYMBOLS), *nothing, np.zeros(SYMBOLS), EMPTY)[0]


def _check(program: Program, exact: int, found: np.ndarray, q: np.ndarray) -> None:
    """The first `exact` outputs to the bit (up to the sign of zero), the others to roundings of their size."""
    roots = program.function("output").results[0].elements
    expected = evaluate_with_size(program.graph, roots, {Group.Q: q, Group.TIME: 0.75})
    for index, (value, (meaning, size)) in enumerate(zip(found, expected, strict=True)):
        if index < exact or not np.isfinite(size):
            same = value == meaning or (np.isnan(value) and np.isnan(meaning))
            assert same or (index >= exact and not np.isfinite(size)), (index, value, meaning)
        else:
            assert abs(value - meaning) <= 1e-12 * size + 1e-300, (index, value, meaning, size)


@settings(max_examples=examples(150), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(steps, steps, st.lists(values, min_size=1, max_size=3))
def test_numpy_means_what_the_evaluator_means(a: list[Step], b: list[Step], states: list[list[float]]) -> None:
    graph = Graph()
    exact, smooth = grow(graph, a, b)
    program = as_outputs(graph, exact + smooth)
    engine = NumpyEngine(program)
    q = np.array(states)
    together = _many_outputs(engine, q)
    for row, state in zip(together, q, strict=True):
        _check(program, len(exact), row, state)
        _check(program, len(exact), _outputs(engine, state), state)


def _dense_program(seed: int) -> tuple[Program, int]:
    """Every operation many times, drawn without Hypothesis: compiled once."""
    draw = np.random.default_rng(seed)
    graph = Graph()

    def walk(count: int) -> list[Step]:
        return [(i, *(int(x) for x in draw.integers(0, 25, 3))) for i in range(count)]

    exact, smooth = grow(graph, walk(8 * len(EXACT)), walk(6 * len(SMOOTH)))
    program = as_outputs(graph, exact + smooth, f"Random{seed}")
    verify(program)
    return program, len(exact)


@pytest.fixture(scope="module", params=range(3))
def compiled(request: pytest.FixtureRequest) -> tuple[Program, int, CEngine]:
    program, exact = _dense_program(request.param)
    return program, exact, CEngine(program)


@settings(max_examples=examples(60), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(state=values)
def test_c_means_what_the_evaluator_means(compiled: tuple[Program, int, CEngine], state: list[float]) -> None:
    program, exact, engine = compiled
    q = np.array(state)
    found = _outputs(engine, q)
    _check(program, exact, found, q)
    np.testing.assert_array_equal(_many_outputs(engine, np.array([q, q]))[1], found)


def test_long_functions_in_pieces_mean_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("lagdsl.engines.backends.c.function.LONGEST_FUNCTION", 20)
    monkeypatch.setattr("lagdsl.engines.backends.c.function._PIECE", 7)
    program, exact = _dense_program(7)
    engine = CEngine(program)
    for seed in range(20):
        q = np.random.default_rng(seed).normal(size=SYMBOLS)
        _check(program, exact, _outputs(engine, q), q)
