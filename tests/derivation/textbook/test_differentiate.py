"""The calculus of the oracle against SymPy's own."""

from __future__ import annotations

import pytest
import sympy
from sympy import Symbol, acos, asin, atan, cos, cosh, exp, log, sin, sinh, sqrt, symbols, tan, tanh

from lagdsl.derivation.textbook import functions as f
from lagdsl.derivation.textbook.differentiate import along, partial

x, y, c = symbols("x y c")

EXPRESSIONS = [
    sin(x * y) ** 3 + cos(x) / y - tan(x**2),
    asin(x / 9) * acos(y / 9) + atan(x * y),
    sinh(x) * cosh(y) - tanh(x / y),
    exp(-x * y) + log(x + y**2) + sqrt(x**2 + c * y),
    x**y + (x + 1) ** 1.3 + c**x,
    (x + y) ** -2 * (x - y) ** 5 * c,
    f.ArcTangent2(x * y, x) + f.Absolute(x - y) * x,
    f.Minimum(x, y * x) + f.Maximum(x**2, y) + f.Modulo(x, y),
    f.Select(f.Less(x, y), x * y, sin(x)) * f.Sign(x) + f.Floor(y) * x + f.Ceil(x * y),
    f.And(f.LessEqual(x, y), f.Not(f.Equal(x, 1))) * x + f.Or(x, y),
    sympy.Integer(3),
]


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_partial_is_that_of_sympy(expression: sympy.Expr) -> None:
    for symbol in (x, y, c):
        difference = (partial(expression, symbol) - expression.diff(symbol)).doit()
        assert sympy.simplify(difference) == 0


def test_step_functions_do_not_change() -> None:
    for kind in (f.Sign, f.Floor, f.Ceil, f.Not):
        assert partial(kind(x), x) == 0
    for kind in (f.Less, f.LessEqual, f.Equal, f.And, f.Or):
        assert partial(kind(x, y), y) == 0


def test_choices_differentiate_what_is_chosen() -> None:
    chosen = f.Select(x, 1, 0)
    assert partial(f.Select(x, y**2, y), y) == 2 * y * chosen + f.Select(x, 0, 1)
    assert f.Select(x, y, c).fdiff(1) == 0
    assert partial(f.Minimum(x, y), x) == f.Select(f.Less(y, x), 0, 1)
    assert partial(f.Maximum(x, y), y) == f.Select(f.Less(x, y), 1, 0)
    assert partial(f.Modulo(x, y), y) == -f.Floor(x / y)
    assert partial(f.Absolute(x), x) == f.Sign(x)


def test_chain_rule() -> None:
    xd, yd = symbols("xd yd")
    assert along(x * sin(y), {x: xd, y: yd}) == xd * sin(y) + x * cos(y) * yd
    assert along(Symbol("z"), {x: xd}) == 0
