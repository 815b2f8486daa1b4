"""The pass over discontinuities: which of them are guards, which are corners, and what stands in their place."""

from __future__ import annotations

from collections.abc import Callable
from math import ceil, floor, pi

import numpy as np
import pytest
from flattening import run

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.evaluate import Values, evaluate
from lagdsl.language.flat.quantity import Variability

FUNCTION = "function f(Real s) -> Real = abs(s);\n"
MODEL = """model M
  coordinate Real x(start = 0.3), y(start = 0.2);
  input Real u = 0;
  mass 1 kg at {x*(1 m), y*(1 m)};
  potential (1 J)*u*y;
"""


def decided(body: str) -> fm.FlatModel:
    flat, sink = run(f"{FUNCTION}{MODEL}{body}\nend M;\n")
    assert flat is not None, [(d.code, d.message) for d in sink.diagnostics]
    return flat


def kinds(body: str) -> tuple[list[str], list[str], int, int]:
    """Relations and time events by name; numbers of corners at which steps end, and of others."""
    events = decided(body).events
    names = [each.name for each in events.relations], [each.name for each in events.timed]
    return *names, len(events.corners), len(events.others)


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("force (1 J)*abs(time/(1 s)) on y;", ([], ["branch of abs(time/(1 s))"], 0, 0)),
        ("force (1 J)*floor(time/(1 s)) on y;", ([], ["floor(time/(1 s))"], 0, 0)),
        ("force (1 J)*sign(time - 1 s) on y;", ([], ["time - 1 s > 0", "time - 1 s < 0"], 0, 0)),
        ("force (1 J)*abs(x) on y;", ([], [], 1, 0)),
        ("force (1 J)*abs(u) on y;", ([], [], 1, 0)),
        ("force (1 J)*floor(x) on y;", (["branch of floor(x)"], [], 0, 0)),
        ("force (if x > 0 then 1 J else 0 J) on y;", (["x > 0"], [], 0, 0)),
        ("force noEvent(if x > 0 then 1 J else 0 J) on y;", ([], [], 0, 1)),
        ("force (1 J)*atan2(x, y) on y;", ([], [], 0, 1)),
        ("output Real o = abs(x);", ([], [], 0, 1)),
        ("constraint y = abs(x);", (["branch of abs(x)"], [], 0, 0)),
        ("constraint der(y) = (1 Hz)*floor(x);", (["branch of floor(x)"], [], 0, 0)),
        ("potential (1 J)*floor(x);", (["branch of floor(x)"], [], 0, 0)),
        ("potential (1 J)*abs(x);", ([], [], 1, 0)),
        # Two distances tell four intervals apart; a cubic has no corner over which velocities jump.
        ('constraint y = table(x, {0, 1, 2}, {0, 1, 0}, "cubic");', ([], [], 2, 0)),
        ("constraint y = table(x, {0, 1, 2}, {0, 1, 0});", (["branch of table(x, {0, 1, 2}, {0, 1, 0})"], [], 0, 0)),
        # The sides of a relation do not bend what it chooses between; their jumps move the instant.
        ("constraint y = (if abs(x) > 1 then x else 2*x);", (["abs(x) > 1"], [], 1, 0)),
        ("potential (if mod(x, 1) > 0.5 then 1 J else 0 J);", (["branch of mod(x, 1)", "mod(x, 1) > 0.5"], [], 0, 0)),
        # A condition of a clause is no way of a mass.
        ("constraint y = abs(x); when abs(x) > 1 then terminate(\"far\"); end when;",
         (["branch of abs(x)", "abs(x) > 1"], [], 1, 0)),
    ],
)  # fmt: skip
def test_kinds(body: str, expected: tuple[list[str], list[str], int, int]) -> None:
    assert kinds(body) == expected


def test_each_use_of_a_function_is_decided_by_itself() -> None:
    """A force reads `f` as it stands, although the same line bends a constraint."""
    assert kinds("constraint y = f(x); force (1 J)*f(x - 1) on y;") == (["branch of abs(s)"], [], 1, 0)


def test_a_number_that_changes_at_guards_only_is_discrete() -> None:
    """Relations of it need no guard of their own, nor does what is computed from it."""
    flat = decided("Real n = floor(x); Real k = max(n, floor(time/(1 s))); potential (if k > 3 then n*(1 J) else 0 J);")
    assert [each.name for each in flat.events.relations] == ["branch of floor(x)"]
    assert flat.events.corners == ()
    found = {item.name: item.variability for item in flat.named if isinstance(item, fm.Definition)}
    assert found == {"n": Variability.DISCRETE, "k": Variability.DISCRETE}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("floor(x)", floor),
        ("ceil(x)", ceil),
        ("mod(x, 0.75)", lambda x: x - 0.75 * floor(x / 0.75)),
        ("wrap(x)", lambda x: (x + pi) % (2 * pi) - pi),
        ("abs(x)", abs),
        ("max(x, 0.5)", lambda x: max(x, 0.5)),
        ("limit(x, -1, 2)", lambda x: min(max(x, -1.0), 2.0)),
        ("table(x, {-1, 0, 2}, {1, 0, 4})", lambda x: -x if x < 0 else 2 * x),
    ],
)
def test_branches_have_the_value_of_the_function(text: str, value: Callable[[float], float]) -> None:
    """Also at whole numbers, where the branch of `floor` turns."""
    flat = decided(f"constraint y = {text};")
    assert all(each.name.startswith("branch of ") for each in flat.events.relations)
    row = flat.constraints[0].residuals[0]
    for x in (*np.linspace(-3.7, 3.7, 38), -2.0, -1.0, 0.0, 1.0, 2.0):
        found = evaluate(flat, row, Values(variables={"x": float(x), "y": 0.0}))
        assert found == pytest.approx(-value(float(x)), abs=1e-12)


def test_nothing_of_the_text_is_left() -> None:
    """A chain of definitions and frames reads entries in place of relations and of functions of time."""
    flat = decided(
        "Boolean b = x > 0.1; Real k = if b then floor(time/(1 s)) else abs(sin(time/(1 s)));"
        "frame A = world.move({k*(1 m), 0 m, 0 m}); mass 1 kg at A;"
    )
    frame = next(item for item in flat.named if isinstance(item, fm.Frame))
    assert isinstance(frame, fm.Frame)
    by_name = {item.name: item.value for item in flat.named if isinstance(item, fm.Definition)}
    assert by_name["b"] == fx.Variable("x > 0.1")
    chosen = by_name["k"]
    assert isinstance(chosen, fx.Conditional)
    assert chosen.value == fx.Variable("floor(time/(1 s))")
    assert isinstance(chosen.otherwise, fx.Conditional)
    assert chosen.otherwise.condition == fx.Variable("branch of abs(sin(time/(1 s)))")
