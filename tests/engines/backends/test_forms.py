"""Straight lines, pieces, loops and lanes are forms of the same operations: they give the same bits."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from choice import chosen
from random_programs import EXACT, SMOOTH, SYMBOLS, as_outputs, grow
from sample_programs import chain, closed_chain, pendulum, quaternion_body

from lagdsl.algebra.graph import Graph, Group, Op
from lagdsl.algebra.graph.evaluate import evaluate_with_size
from lagdsl.derivation.program.functions import STATE
from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.c.dialect import Place
from lagdsl.engines.backends.c.emit import sources
from lagdsl.engines.backends.c.reroll import reroll
from lagdsl.engines.backends.c.statement import Store, listing
from lagdsl.engines.runtime.engines import c_engine
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.engine import SingularSystem
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine

# Longest straight function, length of a piece, and the part of the text that loops must leave at most.
FORMS = {"straight": (10**9, 150, 0.0), "pieces": (5, 7, 0.0), "rolled": (0, 150, 1e9)}


def _set(monkeypatch: pytest.MonkeyPatch, form: str) -> None:
    longest, piece, part = FORMS[form]
    monkeypatch.setattr("lagdsl.engines.backends.c.function.LONGEST_FUNCTION", longest)
    monkeypatch.setattr("lagdsl.engines.backends.c.function._PIECE", piece)
    monkeypatch.setattr("lagdsl.engines.backends.c.function._ROLLED_PART", part)


def _random() -> Program:
    """Every operation many times, sines of sines among them."""
    draw = np.random.default_rng(3)
    graph = Graph()
    walks = [[(i, *map(int, draw.integers(0, 25, 3))) for i in range(6 * len(ops))] for ops in (EXACT, SMOOTH)]
    exact, smooth = grow(graph, walks[0], walks[1])
    deep = graph.symbol(Group.Q)
    for _ in range(5):
        deep = graph.unary(Op.COS, graph.add(graph.unary(Op.SIN, deep), graph.symbol(Group.QD, 1)))
    return as_outputs(graph, [*exact, *smooth, deep])


PROGRAMS: dict[str, Callable[[], Program]] = {
    "pendulum": pendulum,
    "chain": lambda: chain(6),
    "closed_chain": lambda: closed_chain(3),
    "quaternion_body": quaternion_body,
    "random": _random,
}


def _arguments(program: Program, seed: int) -> dict[Group, np.ndarray]:
    draw = np.random.default_rng(seed)
    groups = [group for group in Group if group not in (Group.RELEASE, Group.RELEASE_RATE)]
    values = {group: draw.normal(size=program.layout.size(group)) for group in groups}
    values[Group.TIME] = np.array(0.75)
    values[Group.P] = np.array(program.layout.defaults) * (1 + 0.1 * values[Group.P])
    return values


def _values(engine: CEngine, program: Program, name: str, given: dict[Group, np.ndarray]) -> np.ndarray:
    results = engine.evaluate(name, *(given[group] for group in program.function(name).arguments))
    return np.concatenate([np.ravel(block) for block in results])


@pytest.mark.parametrize("name", chosen(PROGRAMS, ("closed_chain", "random")))
def test_every_form_gives_the_same_bits_and_means_the_graph(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    program = PROGRAMS[name]()
    engines = []
    for form in FORMS:
        _set(monkeypatch, form)
        engines.append(CEngine(program))
    for seed in range(5):
        given = _arguments(program, seed)
        for function in program.functions:
            straight, *others = (_values(engine, program, function.name, given) for engine in engines)
            for other in others:
                np.testing.assert_array_equal(other, straight, err_msg=function.name)
            roots = [node for block in function.results for node in block.elements]
            for value, (meaning, size) in zip(straight, evaluate_with_size(program.graph, roots, given), strict=True):
                if np.isfinite(size):
                    assert abs(value - meaning) <= 1e-12 * size + 1e-300, function.name


NAMES = ("pendulum", "chain", "closed_chain", "quaternion_body")
LANES = ("straight", "rolled")
IN_LANES = [("chain", "rolled")]


@pytest.mark.parametrize(("name", "form"), chosen(product(NAMES, LANES), IN_LANES))
def test_lanes_give_the_bits_of_single_states(name: str, form: str, monkeypatch: pytest.MonkeyPatch) -> None:
    program = PROGRAMS[name]()
    engine = CEngine(program)
    _set(monkeypatch, form)
    given = [_arguments(program, seed) for seed in range(21)]  # full vectors and a rest
    states = [np.array([one[group] for one in given]) for group in STATE]
    for parameters in (states[-1], np.array(program.layout.defaults)):
        at = [*states[:-1], parameters]
        monkeypatch.setattr(c_engine, "_CROWD", 1000)
        single = engine.solve_many(*at)
        monkeypatch.setattr(c_engine, "_CROWD", 1)
        for threads in (1, 2):
            for found, expected in zip(engine.solve_batch(threads, *at), single, strict=True):
                np.testing.assert_array_equal(found, expected)


BY = ("state", "input", "parameter")
EACH = [("closed_chain", "parameter"), ("pendulum", "input")]


@pytest.mark.parametrize(("name", "by"), chosen(product(NAMES, BY), EACH))
def test_directions_in_lanes_are_those_one_after_the_other(name: str, by: str, monkeypatch: pytest.MonkeyPatch) -> None:
    program = PROGRAMS[name]()
    given = [_arguments(program, seed) for seed in range(3)]
    at = [np.array([one[group] for one in given]) for group in STATE]
    found = []
    for form in ("straight", "rolled"):
        _set(monkeypatch, form)
        found.append(CEngine(program).jacobian_many(by, *at))
    for straight, rolled, expected in zip(*found, NumpyEngine(program).jacobian_many(by, *at), strict=True):
        np.testing.assert_array_equal(rolled, straight)
        np.testing.assert_allclose(straight, expected, rtol=1e-10, atol=1e-11 * np.abs(expected).max(initial=1e-300))


def test_a_singular_state_is_found_in_its_lane(monkeypatch: pytest.MonkeyPatch) -> None:
    program = pendulum()
    engine = CEngine(program)
    monkeypatch.setattr(c_engine, "_CROWD", 1)
    parameters = np.tile(program.layout.defaults, (11, 1))
    parameters[9, 0] = 0.0
    q = np.zeros((11, 1))
    nothing = np.zeros(0)
    with pytest.raises(SingularSystem) as caught:
        engine.solve_many(0.0, q, q, np.zeros(1), np.zeros(1), nothing, parameters)
    assert caught.value.coordinate == 0


def _rolled_length(links: int) -> int:
    """Statements in the text of a recursion outward and one inward."""
    graph = Graph()
    q, qd = graph.symbols(Group.Q, links), graph.symbols(Group.QD, links)
    speed, load = [qd[0]], [q[0]]
    for k in range(1, links):
        speed.append(graph.add(graph.multiply(graph.unary(Op.COS, q[k]), speed[-1]), qd[k]))
    for k in reversed(range(links)):
        load.append(graph.subtract(graph.multiply(speed[k], graph.unary(Op.SIN, q[k])), load[-1]))
    stores = tuple(Store(Place("motion", index), node) for index, node in enumerate([*speed, *load]))
    return reroll(listing(graph, stores, {})).length


def test_the_text_of_a_longer_chain_is_no_longer() -> None:
    assert _rolled_length(200) <= _rolled_length(50) <= 30


def test_constants_that_differ_come_from_tables(monkeypatch: pytest.MonkeyPatch) -> None:
    graph = Graph()
    q = graph.symbols(Group.Q, SYMBOLS)
    rows = [graph.add(graph.multiply(graph.constant(0.1 + k), q[k % SYMBOLS]), q[(k * k) % SYMBOLS]) for k in range(40)]
    program = as_outputs(graph, rows, "Tables")
    _set(monkeypatch, "rolled")
    (text,) = (text for path, text in sources(program).items() if path == "Tables.c")
    assert text.count("y[") < 5
    values = _values(CEngine(program), program, "output", given := _arguments(program, 0))
    np.testing.assert_array_equal(values, [value for value, _ in evaluate_with_size(graph, rows, given)])


def test_parts_are_files_of_their_own() -> None:
    program = replace(pendulum(), name="Lanes")
    assert not {path for path in sources(program) if path.startswith("Lanes_")}
    parts = sources(program, ["states", "tangents"])
    assert {path for path in parts if path.startswith("Lanes_")} == {"Lanes_states.c", "Lanes_tangents.c"}
    assert {path: parts[path] for path in sources(program)} == sources(program)
