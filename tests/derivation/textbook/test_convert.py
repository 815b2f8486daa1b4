"""From flat expressions to SymPy and on to the graph: numbers, names, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.textbook.convert import NoDerivativeError, plain_number
from lagdsl.derivation.textbook.derive import derive
from lagdsl.derivation.textbook.lower import lower
from lagdsl.derivation.textbook.reading import readable_number
from lagdsl.derivation.textbook.to_graph import ToGraph
from textbook.build import call, coordinate, der, energy, external, model, output, parameter, v


@pytest.mark.parametrize("value", [0.0, 1.0, -3.0, 0.5, 0.125, 0.1, math.pi, 1e-300, 1e300, -9.80665, 2.0**60])
def test_plain_numbers_are_exact(value: float) -> None:
    assert float(plain_number(value)) == value


def test_infinities() -> None:
    assert plain_number(math.inf) is sympy.oo
    assert plain_number(-math.inf) == -sympy.oo


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (1 / 3, "1/3"),
        (2 * math.pi, "2*pi"),
        (-math.pi / 4, "-pi/4"),
        (9.80665, "g_n"),
        (-9.80665, "-g_n"),
        (0.0002, "1/5000"),
        (1.3, "13/10"),
        (123.456, "15432/125"),
    ],
)
def test_readable_numbers(value: float, shown: str) -> None:
    assert str(readable_number(value)) == shown


def test_readable_numbers_beyond_reading() -> None:
    assert readable_number(1e300) == sympy.Float(1e300)


def value_of(expression: sympy.Expr, **values: float) -> float:
    graph = Graph()
    symbols = [sympy.Symbol(name) for name in values]
    nodes = dict(zip(symbols, graph.symbols(Group.P, len(symbols)), strict=True))
    root = ToGraph(graph, nodes).node(expression)
    return float(evaluate(graph, [root], {Group.P: np.array(list(values.values()))})[0])


def test_powers_and_roots_on_the_graph() -> None:
    x, y = sympy.symbols("x y")
    assert value_of(x**-2 * y / sympy.sqrt(x), x=4.0, y=3.0) == 3.0 / 32.0
    assert value_of(x ** sympy.Rational(3, 2), x=4.0) == 8.0
    assert value_of(x ** sympy.Rational(-1, 2), x=4.0) == 0.5
    assert value_of(x ** sympy.Rational(1, 3), x=8.0) == pytest.approx(2.0)
    assert value_of(x**y, x=2.0, y=10.0) == 1024.0
    assert value_of(sympy.pi * sympy.E + sympy.Integer(1)) == math.pi * math.e + 1
    assert value_of(sympy.oo) == math.inf


def test_what_is_no_number_stays_a_run_time_fact() -> None:
    assert not math.isfinite(value_of(sympy.zoo))
    assert not math.isfinite(value_of(sympy.nan))
    assert not math.isfinite(value_of(sympy.I * 2))


def test_deep_expressions_need_no_recursion() -> None:
    x = sympy.Symbol("x")
    expression = x
    for _ in range(300):
        expression = sympy.sin(expression, evaluate=False)
    assert math.isfinite(value_of(expression, x=1.0))
    long = v("x")
    for _ in range(5000):
        long = long + v("x")
    flat = model("Long", coordinates=[coordinate("x")], energies=[energy("kinetic", der(v("x")) ** 2 * 2)],
                 outputs=[output("y", long)])  # fmt: skip
    assert derive(flat).outputs["y"] == 5001 * x


def test_an_input_without_derivative_is_refused() -> None:
    flat = model(
        "Driven",
        parameters=[parameter("m", 1.0)],
        coordinates=[coordinate("x")],
        inputs=[external("u")],
        energies=[energy("kinetic", v("m") * (der(v("x")) + v("u")) ** 2 / 2)],
    )
    with pytest.raises(NoDerivativeError, match="u"):
        derive(flat)


def test_functions_keep_their_values() -> None:
    values = {"x": 0.7, "a": -1.3}
    flat = model(
        "F",
        coordinates=[coordinate("x")],
        parameters=[parameter("a", -1.3)],
        energies=[energy("kinetic", der(v("x")) ** 2)],
        outputs=[
            output("abs", call("abs", v("a"))),
            output("atan2", call("atan2", v("a"), v("x"))),
            output("mod", call("mod", v("a"), v("x"))),
            output("min", call("min", v("a"), v("x"))),
            output("exp", call("exp", v("x"))),
        ],
    )
    outputs = derive(flat).outputs
    assert value_of(outputs["abs"], **values) == 1.3
    assert value_of(outputs["atan2"], **values) == math.atan2(-1.3, 0.7)
    assert value_of(outputs["mod"], **values) == pytest.approx(0.1)
    assert value_of(outputs["min"], **values) == -1.3
    assert value_of(outputs["exp"], **values) == math.exp(0.7)


def test_places_of_the_layout() -> None:
    flat = model("F", coordinates=[coordinate("x")], energies=[energy("kinetic", der(v("x")) ** 2)])
    program = lower(derive(flat), flat)
    assert program.layout.coordinates[0].name == "x"
    assert program.layout.coordinates[0].place is None
