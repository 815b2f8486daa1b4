"""The route of the textbook derives the same equations of dry friction and of contacts of rates, and prints them."""

from __future__ import annotations

import numpy as np
import pytest
from friction_texts import ALL, BLOCK, PUCK, SLOPE

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.textbook.recipe import recipe
from lagdsl.documents.report.derivation import render
from lagdsl.exchange.verify.states import random_discretes
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import compile_flat, flatten_file
from textbook.compare import FUNCTIONS, disagreement, random_arguments


def flat_of(text: str) -> FlatModel:
    sink = Sink()
    flat = flatten_file(SourceFile("<text>", text), sink)
    assert flat is not None, sink.diagnostics
    return flat


@pytest.mark.parametrize("name", ALL)
def test_all_functions_agree(name: str) -> None:
    flat = flat_of(ALL[name])
    graph, textbook = (compile_flat(flat, Sink(), route) for route in ("graph", "textbook"))
    assert graph is not None and textbook is not None
    random = np.random.default_rng(11)
    arguments = random_arguments(graph.program, random, states=40)
    arguments[Group.W] = random_discretes(flat, graph.program, arguments[Group.TIME], arguments[Group.P], random)
    for column, kind in zip(arguments[Group.W].T, graph.program.layout.kinds, strict=True):
        assert kind in ("impacts", "direction", "load") or {0.0, 1.0} == set(column.tolist())
    for function in (*FUNCTIONS, *(f for f in ("friction", "load", "contact") if graph.program.has(f))):
        worst = disagreement(graph.program, textbook.program, function, arguments)
        assert all(value < 1e-12 for value in worst.values()), (function, worst)


def test_a_row_of_friction_is_the_slip_while_it_sticks() -> None:
    derivation = recipe(flat_of(SLOPE)).derivation
    assert derivation is not None
    floor, friction = derivation.constraints
    (x, h), (speed, _) = derivation.symbols.q, derivation.symbols.qd
    assert (floor.contact, floor.friction, floor.residual, floor.forces) == (True, False, h, (0, 1))
    assert (friction.contact, friction.friction, friction.residual, friction.forces) == (False, True, speed, (1, 0))
    assert derivation.count.velocity_freedom == 2  # neither row always holds
    assert not derivation.energy_conserved and x not in derivation.cyclic


def test_a_report_writes_the_law_as_a_book_does() -> None:
    lines = [" ".join(line.split()) for line in render(recipe(flat_of(BLOCK)), "text").splitlines()]
    assert "m₁ s̈ = λ + push − 3/5 g_n (ṡ² + 1) sign(ṡ)" in lines
    assert "f = λ − 3/5 g_n (ṡ² + 1) sign(ṡ)" in lines
    assert "While all friction slides, so that their multipliers are zero:" in lines
    assert "Dry friction holds the system at rest in whole ranges of positions; lag trim finds one of them" in lines
    lines = [" ".join(line.split()) for line in render(recipe(flat_of(PUCK)), "text").splitlines()]
    assert "m₁ ÿ = λ_pad,2 − ẏ limit(pad)/√(ẋ² + ẏ²)" in lines
    assert "limit(pad) 0.3*multiplier(floor)" in lines
