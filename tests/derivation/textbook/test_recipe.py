"""The form that people read says the same as the form that runs, and stays bounded."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from choice import chosen
from sympy import Add, Expr, Symbol

from lagdsl.algebra.graph.evaluate import evaluate, evaluate_with_size
from lagdsl.algebra.graph.graph import Graph
from lagdsl.derivation.textbook.derive import derive
from lagdsl.derivation.textbook.lower import lower, symbol_nodes
from lagdsl.derivation.textbook.reading import STANDARD_GRAVITY
from lagdsl.derivation.textbook.recipe import Derivation, Recipe, recipe
from lagdsl.derivation.textbook.steps.actions import Contribution
from lagdsl.derivation.textbook.symbols import symbols
from lagdsl.derivation.textbook.to_graph import ToGraph
from lagdsl.documents.report.derivation import FORMATS, render
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel, Rotate
from lagdsl.motion.pipeline import flatten_file
from textbook import models
from textbook.build import coordinate, der, energy, force, frame, generalized, mass, model, torque, v, vec
from textbook.compare import random_arguments


def derivation_of(flat: FlatModel) -> Derivation:
    derivation = recipe(flat).derivation
    assert derivation is not None
    return derivation


def made(make: Callable[[], FlatModel]) -> Derivation:
    derivation = models.recipe_of(make).derivation
    assert derivation is not None
    return derivation


def nodes_of(graph: Graph, flat: FlatModel, found: Recipe) -> ToGraph:
    """Letters of a report, numbers and definitions that stay symbols, get their values back."""
    derivation = found.derivation
    assert derivation is not None
    nodes = {Symbol(item.name): graph.constant(item.value) for item in found.flat.parameters}
    nodes |= symbol_nodes(graph, symbols(flat))
    nodes[STANDARD_GRAVITY] = graph.constant(9.80665)
    for symbol, value in (*derivation.dependent_parameters, *derivation.abbreviations):
        nodes[symbol] = ToGraph(graph, nodes).node(value)
    return ToGraph(graph, nodes)


@pytest.mark.parametrize("make", chosen(models.ALL, models.ALL[:6]), ids=lambda make: make.__name__)
def test_report_and_oracle_agree(make: Callable[[], FlatModel]) -> None:
    """Left side - right side of every printed equation is M qdd - f - J' lam of the oracle."""
    flat = make()
    derivation, program = made(make), lower(derive(flat), flat)
    arguments = random_arguments(program, np.random.default_rng(2), states=10)
    graph = Graph()
    to_graph = nodes_of(graph, flat, models.recipe_of(make))
    printed: list[Expr] = []
    for j, step in enumerate(derivation.coordinates):
        upheld = [row.multiplier * row.forces[j] for row in derivation.constraints]
        printed.append(step.left - Add(derivation.generalized_forces[j], derivation.drags[j], *upheld))
    printed += [row.acceleration for row in derivation.constraints]
    values = evaluate(graph, [to_graph.node(expression) for expression in printed], arguments)
    residual = program.function("residual")
    exact = evaluate_with_size(program.graph, [n for block in residual.results for n in block.elements], arguments)
    for value, (expected, extent) in zip(values, exact, strict=True):
        assert np.all(np.abs(value - expected) <= 1e-11 * np.maximum(extent, 1e-12))


def test_count_of_particles_and_bodies() -> None:
    top = made(models.heavy_top).count
    assert (top.in_space, top.built_in, top.declared, top.freedom) == (6, 3, 0, 3)
    atwood = made(models.atwood).count
    assert (atwood.in_space, atwood.built_in, atwood.declared, atwood.freedom) == (6, 4, 1, 1)
    coin = made(models.rolling_coin).count
    assert (coin.freedom, coin.velocity_freedom, coin.rows - coin.rank) == (5, 3, 1)
    free = made(models.quaternion_body).count
    assert (free.placing, free.position_rank) == (5, 1)


def test_redundant_rows_are_counted_on_the_constraint_set() -> None:
    """x^2 + y^2 = 1 twice, in two forms: one restriction."""
    x, y = v("x"), v("y")
    flat = model(
        "Twice",
        coordinates=[coordinate("x", 0.6), coordinate("y", 0.8)],
        masses=[mass(1, vec(x, y))],
        constraints=[
            models.constraint("a", x**2 + y**2 - 1),
            models.constraint("b", models.call("sqrt", x**2 + y**2) - 1),
        ],
    )
    found = derivation_of(flat).count
    assert (found.rows, found.rank, found.freedom) == (2, 1, 1)


def test_singular_rows_do_not_stop_the_count() -> None:
    """Rows that are no number near the starts count in full."""
    x, y = v("x"), v("y")
    rows = [models.constraint("a", models.call("log", x - 90) - y)]
    flat = model("Far", coordinates=[coordinate("x"), coordinate("y")], masses=[mass(1, vec(x, y))], constraints=rows)
    assert derivation_of(flat).count.rank == 1


def test_loads_without_work_are_told_with_the_reason() -> None:
    x = v("x")
    flat = model(
        "Slider",
        coordinates=[coordinate("x")],
        named=[frame("F", "world", Rotate(2, x.e))],
        masses=[mass(1, vec(x, 0))],
        loads=[
            force(vec(0, 5, 0), vec(x, 0)),
            force(vec(5, 0, 0), vec(0, 1)),
            torque(vec(1, 0, 0), "F"),
            torque(vec(0, 0, 1), "world"),
            generalized(0, x),
            generalized(v("time"), x, origin=2 * x),
            force(vec(0, 0, 0), vec(x, 0)),
        ],
    )
    reasons = [action.contribution for action in derivation_of(flat).actions]
    assert reasons == [
        Contribution.PERPENDICULAR,
        Contribution.PLACE_HELD,
        Contribution.PERPENDICULAR,
        Contribution.PLACE_HELD,
        Contribution.ZERO,
        Contribution.CONTRIBUTES,
        Contribution.CONTRIBUTES,
        Contribution.ZERO,
    ]


def test_conserved_quantities() -> None:
    top = made(models.heavy_top)
    assert top.cyclic == (Symbol("psi"), Symbol("phi"))
    assert top.energy_conserved
    hoop = made(models.hoop)
    assert hoop.jacobi_conserved
    assert not hoop.energy_conserved
    cart = made(models.cart_pendulum)
    assert not cart.jacobi_conserved
    assert made(models.spherical_pendulum).cyclic == (Symbol("phi"),)


def test_textbook_forms() -> None:
    """T of the top as Goldstein prints it."""
    assert str(made(models.heavy_top).kinetic) == (
        "C*(der(phi) + der(psi)*cos(theta))**2/2 + (A + l**2*m)*(der(psi)**2*sin(theta)**2 + der(theta)**2)/2"
    )


def test_large_models_stay_outlines() -> None:
    names = [f"q[{i}]" for i in range(1, 31)]
    rates = [energy("kinetic", der(v(name)) ** 2) for name in names]
    flat = model(
        "Large",
        coordinates=[coordinate(name) for name in names],
        energies=rates,
        constraints=[models.constraint("c", v(names[0]) - v(names[1]))],
    )
    found = recipe(flat)
    assert found.derivation is None
    assert found.extent.reasons == ("30 coordinates (at most 6)",)
    for to in FORMATS:
        text = render(found, to)  # type: ignore[arg-type]
        assert "30 coordinates" in text
        assert len(text) < 14_000
    plain = render(found, "text")
    assert "q[k], k = 1…30" in plain
    assert "… and 10 more." in plain
    assert "M q̈ − J^T λ = f" in plain


def test_deeply_turned_frames_stay_outlines() -> None:
    frames = [frame(f"F{i}", f"F{i - 1}" if i else "world", Rotate(i % 3, v("a").e)) for i in range(9)]
    flat = model("Deep", coordinates=[coordinate("a")], named=frames, masses=[mass(1, vec(1, 0))])
    assert recipe(flat).extent.reasons == ("9 rotations in a row (at most 6)",)


def test_nested_definitions_stay_outlines() -> None:
    """Each definition uses the one before twice: short as a text, endless written out."""
    steps = [models.definition("d0", v("x"))]
    for k in range(1, 41):
        steps.append(models.definition(f"d{k}", models.sin(v(f"d{k - 1}")) * models.cos(v(f"d{k - 1}"))))
    flat = model(
        "Swell",
        coordinates=[coordinate("x")],
        named=steps,
        energies=[energy("kinetic", der(v("x")) ** 2), energy("potential", v("d40"))],
    )
    assert recipe(flat).extent.reasons == ("1000000 symbols in one expression, definitions written out (at most 2000)",)
    assert len(lower(derive(flat), flat).graph) < 5000


def test_dependent_parameters_and_the_standard_gravity_may_stand_in_constraints() -> None:
    text = """
        model Wire
          parameter Length l = 0.2 m;
          Length a = 2*l, b = a + l;
          coordinate Length x, y;
          gravity = -g_n*world.y;
          mass 1 kg at {x, y};
          constraint wire: x^2 + a*y = b^2 + g_n*(1 s)^2*l;
        end Wire;
        """
    flat = flatten_file(SourceFile("wire.lag", text), Sink())
    assert flat is not None
    assert derivation_of(flat).count.position_rank == 1
