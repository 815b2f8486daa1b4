"""Terms know the statements that they come from: shares add up to the residual of the other route."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from choice import spread
from derived_programs import derive
from sympy import Add

import lagdsl
from lagdsl.algebra.graph.evaluate import evaluate, evaluate_with_size
from lagdsl.algebra.graph.graph import Graph
from lagdsl.derivation.textbook.contributions import contributions
from lagdsl.derivation.textbook.convert import Converter
from lagdsl.derivation.textbook.lower import symbol_nodes
from lagdsl.derivation.textbook.provenance import angles_apart, shares, sources
from lagdsl.derivation.textbook.recipe import recipe
from lagdsl.derivation.textbook.symbols import symbols
from lagdsl.derivation.textbook.to_graph import ToGraph
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import flatten_file, read
from textbook.compare import random_arguments

_FOLDER = Path(__file__).parents[3] / "models"
_MODELS = sorted([*_FOLDER.glob("*.lag"), *(_FOLDER / "library").glob("*.lag")])


def flat_model(path: Path) -> FlatModel:
    sink = Sink()
    file = read(path, sink)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None, sink.diagnostics
    return flat


@pytest.mark.parametrize("path", spread(_MODELS, 3), ids=lambda path: path.stem)
def test_shares_of_all_items_add_up_to_the_residual(path: Path) -> None:
    """M qdd - f - J' lam of the graph route, at random states."""
    flat = flat_model(path)
    table, program = symbols(flat), derive(flat)
    arguments = random_arguments(program, np.random.default_rng(7), states=5)
    parts = contributions(flat, Converter(model=flat, symbols=table))
    graph = Graph()
    to_graph = ToGraph(graph, symbol_nodes(graph, table))
    found = list(shares(flat, table, parts))
    nodes = [to_graph.node(value) for share in found for value in share.values]
    values = np.array([np.broadcast_to(v, (5,)) for v in evaluate(graph, nodes, arguments)])
    total = values.reshape(len(found), len(table.q), 5).sum(axis=0)
    r = program.function("residual").results[0].elements
    exact = evaluate_with_size(program.graph, r, arguments)
    for value, (expected, extent) in zip(total, exact, strict=True):
        possible = np.isfinite(np.broadcast_to(expected, (5,)))  # a loop may not close at a random state
        assert np.any(possible)
        assert np.array_equal(np.isfinite(value), possible)
        error = np.abs(value - expected)[possible]
        assert np.all(error <= 1e-12 * np.maximum(np.broadcast_to(extent, (5,))[possible], 1e-12))
    named = sources(flat)
    assert {index for share in found for index in share.sources} <= set(range(len(named)))


@pytest.mark.parametrize("path", spread(_MODELS, 3), ids=lambda path: path.stem)
def test_each_printed_term_has_a_parent(path: Path) -> None:
    """The terms of each side are the side, and each comes from a statement."""
    derivation = recipe(flat_model(path)).derivation
    if derivation is None:
        return
    for term in derivation.terms:
        assert term.sources, term
        assert all(derivation.sources[index].spans for index in term.sources), term
    for number, step in enumerate(derivation.coordinates):
        for side, whole in (("left", step.left), ("right", derivation.rights[number])):
            own = [term.value for term in derivation.terms if term.equation == number and term.side == side]
            assert Add(*own) == whole


def test_merged_terms_belong_to_all_parents_and_others_to_none_but_theirs() -> None:
    model = lagdsl.compile(_FOLDER / "double_pendulum.lag")
    named = {
        (term.coordinate, str(term.value)): {source.spans[0].text for source in term.sources}
        for term in model.derive().terms
    }
    both = {"mass m1 at P1;", "mass m2 at P2;"}
    assert named["a", "der(der(a))*l1**2*(m1 + m2)"] == both
    assert named["a", "g_n*l1*(m1 + m2)*sin(a)"] == {*both, "gravity = -g_n*world.y;"}
    assert named["b", "der(der(b))*l2**2*m2"] == {"mass m2 at P2;"}


def test_a_line_of_the_text_knows_its_terms() -> None:
    derivation = lagdsl.compile(_FOLDER / "double_pendulum.lag").derive()
    lines = (_FOLDER / "double_pendulum.lag").read_text().splitlines()
    [first, gravity] = [next(n for n, text in enumerate(lines, 1) if key in text) for key in ("mass m1", "gravity")]
    assert {term.coordinate for term in derivation.terms_of(first)} == {"a"}
    assert {term.coordinate for term in derivation.terms_of(gravity)} == {"a", "b"}
    assert not derivation.terms_of(1)


def test_terms_as_data_and_in_pages() -> None:
    derivation = lagdsl.compile(_FOLDER / "rolling_coin.lag").derive()
    found = json.loads(derivation.to("json"))
    assert found["written_out"]
    assert len(found["terms"]) == len(derivation.terms)
    [grip] = [term for term in found["terms"] if term["text"] == "λ_rolling,1"]
    assert [found["sources"][index]["name"] for index in grip["sources"]] == ["rolling"]
    assert derivation.to("html").count('class="term" data-from=') >= len(derivation.terms)


def test_sums_of_angles_are_taken_apart_exactly() -> None:
    from sympy import cos, sin
    from sympy.abc import a, b, c

    values = {a: 0.3, b: -1.1, c: 2.0}
    for expression in (sin(a + b - c), cos(a + b + c) * sin(a - b), cos(2 * a + b)):
        apart = angles_apart(expression)
        assert abs(float(apart.subs(values)) - float(expression.subs(values))) < 1e-14
        assert not any(node.args[0].is_Add for node in apart.atoms(sin, cos))
