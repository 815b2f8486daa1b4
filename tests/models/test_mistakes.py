"""Mistakes that a modeling tool may accept in silence: each has its diagnostic at its place, or the right meaning.

A `^` line under a line of the text marks the columns of the caret.
"""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl
from lagdsl.foundation.diagnostics import Diagnostic, Severity

PENDULUM = """\
model Pendulum
  parameter Mass m = 1 kg;
  parameter Length l = 0.5 m;
  coordinate Angle theta(start = 60 deg);
  gravity = -g_n*world.y;
  mass m at l*{{sin(theta), -cos(theta)}};
{}end Pendulum;
"""

# name, text, caret line, code
MISTAKES = [
    (
        "misspelt parameter",
        PENDULUM.format("  parameter Length drop = 1 m;\n  potential m*g_n*dorp*cos(theta);\n"),
        "                  ^^^^           ",
        "E0201",
    ),
    (
        "misspelt initial value",
        PENDULUM.replace("start = 60", "strat = 60").format(""),
        "                         ^^^^^",
        "E0202",
    ),
    (
        "misspelt rate in an initial equation",
        PENDULUM.format("initial equation\n  der(tehta) = 1;\n"),
        "      ^^^^^",
        "E0201",
    ),
    (
        "misspelt target of a force",
        PENDULUM.format("  torque 1 N.m on thta;\n"),
        "                  ^^^^",
        "E0201",
    ),
    (
        "misspelt statement",
        PENDULUM.format("  disipation 1/2*(1 N.m.s)*der(theta)^2;\n"),
        "  ^^^^^^^^^^",
        "E0102",
    ),
    (
        "absurd unit",
        PENDULUM.replace("m = 1 kg", "m = 1 s").format(""),
        "                     ^^^",
        "E0407",
    ),
    (
        "coordinate that redeclares a parameter",
        PENDULUM.format("  coordinate Length l;\n"),
        "                    ^",
        "E0204",
    ),
    (
        "product without its asterisk read as a call",
        PENDULUM.format("  potential m*g_n*l(1 - cos(theta));\n"),
        "                  ^",
        "E0327",
    ),
    (
        "type that does not exist",
        PENDULUM.replace("coordinate Angle", "coordinate Angel").format(""),
        "             ^^^^^",
        "E0208",
    ),
    (
        "force without a place",
        PENDULUM.format("  force 1 N;\n"),
        "           ^",
        "E0100",
    ),
    (
        "unbalanced parenthesis",
        PENDULUM.format("  potential m*g_n*(l - l*cos(theta);\n"),
        "                  ^",
        "E0111",
    ),
    (
        "unit literal that hides a variable",
        PENDULUM.format("  parameter Time s = 1 s;\n  Length path = 2 m/s;\n"),
        "                ^^^^^",
        "E0407",
    ),
]


@pytest.mark.parametrize(("text", "carets", "code"), [m[1:] for m in MISTAKES], ids=[m[0] for m in MISTAKES])
def test_mistake_is_told_at_its_place(text: str, carets: str, code: str) -> None:
    errors = [d for d in lagdsl.check(text) if d.severity is Severity.ERROR]
    assert [d.code for d in errors] == [code], [(d.code, d.message) for d in errors]
    span = errors[0].labels[0].span
    column, end = carets.index("^") + 1, carets.rindex("^") + 2
    assert (span.first.column, span.last.column) == (column, end)
    assert span.first.line == span.last.line
    with pytest.raises(lagdsl.CompilationFailed, match=code):
        lagdsl.compile(text)


def test_misspelt_names_are_answered_with_the_nearest_one() -> None:
    helps = [_error(text).help or "" for name, text, _, _ in MISTAKES if name.startswith("misspelt")]
    for right, text in zip(("drop", "start", "theta", "theta", "dissipation"), helps, strict=True):
        assert f"`{right}`" in text


def test_a_unit_literal_that_hides_variables_is_told_in_a_note() -> None:
    text = {m[0]: m[1] for m in MISTAKES}["unit literal that hides a variable"]
    notes = [d for d in lagdsl.check(text) if d.code == "N0106"]
    joined = " ".join([*(d.message for d in notes), *_error(text).notes])
    assert "2*m/s" in joined


def _error(text: str) -> Diagnostic:
    return next(d for d in lagdsl.check(text) if d.severity is Severity.ERROR)


# ---- texts that are right, and mean what they say -------------------------------------------------------------------


def test_minus_x_squared_is_minus_the_square() -> None:
    model = lagdsl.compile(
        """model M
             coordinate Length x(start = 3);
             gravity = 0;
             mass 1 kg at {x, 0};
             force (2 N/m2)*(-x^2) on x;
           end M;"""
    )
    np.testing.assert_allclose(model.forward_dynamics(0.0, [3.0], [0.0]), [-18.0])


def test_the_type_of_a_coordinate_does_not_change_its_dynamics() -> None:
    text = "model M coordinate {} x(start = 1); gravity = 0; {} potential {}; end M;"
    as_length = lagdsl.compile(text.format("Length", "mass 2 kg at {x, 0};", "1/2*(8 N/m)*x^2"))
    as_number = lagdsl.compile(text.format("Real", "mass 2 kg at {x*(1 m), 0};", "1/2*(8 J)*x^2"))
    for model in (as_length, as_number):
        np.testing.assert_allclose(model.forward_dynamics(0.0, [1.0], [0.0]), [-4.0])


def test_damping_is_not_ignored() -> None:
    """m x'' + c x' = 0."""
    model = lagdsl.compile(
        """model M
             coordinate Length x(der(start = 1));
             gravity = 0;
             mass 2 kg at {x, 0};
             dissipation 1/2*(3 N.s/m)*der(x)^2;
           end M;"""
    )
    motion = model.simulate(stop=2.0, tolerance=1e-10)
    np.testing.assert_allclose(motion["der(x)"], np.exp(-1.5 * motion.time), rtol=1e-7)


def test_a_nonholonomic_constraint_is_not_ignored() -> None:
    """A skate on level ice turns at its rate and runs in a circle of radius v/w."""
    model = lagdsl.compile(
        """model M
             coordinate Length x(der(start = 1)), y;
             coordinate Angle phi(der(start = 2));
             gravity = 0;
             body skate(m = 1, Izz = 1) on world.at({x, y}).rotz(phi);
             constraint edge: -sin(phi)*der(x) + cos(phi)*der(y) = 0;
           end M;"""
    )
    motion = model.simulate(stop=3.0, tolerance=1e-10)
    np.testing.assert_allclose(motion["x"], 0.5 * np.sin(2 * motion.time), atol=1e-7)
    np.testing.assert_allclose(motion["y"], 0.5 * (1 - np.cos(2 * motion.time)), atol=1e-7)


def test_a_force_on_one_scalar_acts_on_it() -> None:
    model = lagdsl.compile("model M coordinate Length x; gravity = 0; mass 2 kg at {x, 0}; force 6 N on x; end M;")
    np.testing.assert_allclose(model.forward_dynamics(0.0, [0.0], [0.0]), [3.0])
