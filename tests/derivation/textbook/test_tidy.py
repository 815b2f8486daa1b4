"""Short forms: never wrong, often the textbook's, always bounded."""

from __future__ import annotations

import numpy as np
import pytest
import sympy
from choice import examples
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Symbol, cos, sin, sqrt, symbols

from lagdsl.derivation.textbook.functions import Equal, Select
from lagdsl.derivation.textbook.shortening.whole_sums import KnownSums
from lagdsl.derivation.textbook.tidy import Tidy, size

a, b, m, l, R, w, t = symbols("a b m l R w t")
x, y = symbols("x y")


def tidy(budget: int = 100_000) -> Tidy:
    constants = frozenset({m, l, R})
    return Tidy(constants, constants, budget)


@pytest.mark.parametrize(
    ("given_form", "short"),
    [
        (sin(a) ** 2 + cos(a) ** 2, sympy.Integer(1)),
        (m * sin(a) ** 2 + m * cos(a) ** 2, m),
        (sin(a) * sin(b) + cos(a) * cos(b), cos(a - b)),
        (cos(a) * cos(b) - sin(a) * sin(b), cos(a + b)),
        (sin(a) * cos(b) - cos(a) * sin(b), sin(a - b)),
        (sin(a) * cos(b) + cos(a) * sin(b), sin(a + b)),
        (sqrt(R**2 * sin(a) ** 2 + R**2 * cos(a) ** 2), R),
        (1 - cos(a) ** 2, sin(a) ** 2),
        (6 * x**2 - 5 * x**2 * cos(a) ** 2, x**2 * (1 + 5 * sin(a) ** 2)),
        (m * x**2 / 2 + m * x * y + m * y**2 / 2, m * (x + y) ** 2 / 2),
        ((x**3 + x * y**2) / (x**2 + y**2) ** 2, x / (x**2 + y**2)),
        (x / (x**2 + y**2) - x**3 / (x**2 + y**2) ** 2 - x * y**2 / (x**2 + y**2) ** 2, sympy.Integer(0)),
        (sqrt(x) * sqrt(x), x),
        (sqrt(4 * R**2 * x) / R, 2 * sqrt(x)),
        (sqrt(2 * R**3 * x), R * sqrt(2 * R * x)),
        (1 / (2 * x * y) * x, 1 / (2 * y)),
        ((x * y) ** sympy.Rational(1, 3), (x * y) ** sympy.Rational(1, 3)),
        (1 / (-x), -1 / x),
        (x**100 / x**99, x),
        ((x + y) ** 40, (x + y) ** 40),
        (sympy.pi * x + sympy.pi * y, sympy.pi * (x + y)),
        (sin(x * (-(sin(b) ** 2) - cos(b) ** 2)), -sin(x)),
        (sympy.exp(sympy.log(x) * (sin(b) ** 2 + cos(b) ** 2)), x),
        (x**y * x**y, x ** (2 * y)),
        (1 / (1 + (a**2 + 1) ** -4), 1 / (1 + (a**2 + 1) ** -4)),
        (sqrt(4 * x), 2 * sqrt(x)),
        ((x + y) ** -3 * (x + y), (x + y) ** -2),
        (sin(b) * cos(sin(a) ** 2 + cos(a) ** 2), sin(b) * cos(1)),
        (-x - y, -x - y),
        (sin(x + 0 * y) / sin(x), sympy.Integer(1)),
        (m ** sympy.Rational(3, 2) * sqrt(m), m**2),
        (x ** sympy.Rational(1, 3) * x, x ** sympy.Rational(4, 3)),
        (sin(a) ** 2 / (1 + cos(a)) ** 2 + cos(a) / (1 + cos(a)), 1 / (1 + cos(a))),
        (Select(Equal(x, 0), 0, 1) * y + Select(Equal(x, 0), 1, 0) * y, y),
        (sqrt((R + l) ** 2 * x), (R + l) * sqrt(x)),
    ],
)
def test_known_forms(given_form: sympy.Expr, short: sympy.Expr) -> None:
    assert sympy.expand(tidy()(given_form) - short) == 0 or tidy()(given_form) == short
    assert size(tidy()(given_form)) <= size(given_form)


def test_sums_that_the_model_writes_are_factors_with_their_sign() -> None:
    short = Tidy(frozenset({m, l, R}), frozenset({m, l, R}), known=KnownSums(frozenset({R - l})))
    energy = m * (R**2 * x**2 - 2 * R * l * x**2 + l**2 * x**2) / 2 + m * l**2 * y**2 / 4
    assert short(energy) == m * (R - l) ** 2 * x**2 / 2 + m * l**2 * y**2 / 4
    assert str(short(l * cos(a) * m - R * cos(a) * m)) == "-m*(R - l)*cos(a)"
    assert short(R * a + l * (b - a)) == (R - l) * a + l * b


def test_the_factors_of_a_spring_that_changes_its_length_stay_whole() -> None:
    """V = k (s - l)^2/2 with s^2 = x^2 + y^2: dV/dx = k (s - l) x/s."""
    short, s = tidy(), sqrt(x**2 + y**2 + m * x * y)
    short.keep_whole((s - l,))
    slope = sympy.diff(R * (s - l) ** 2 / 2, x)
    assert short(slope) == R * (x + m * y / 2) * (s - l) / s


ATOMS = st.sampled_from([a, b, x, y, m, sympy.Integer(2), sympy.Rational(1, 2), sin(a), cos(a), sin(b), cos(b), 1 / x])
EXPRESSIONS = st.recursive(
    ATOMS,
    lambda inner: st.one_of(
        st.tuples(inner, inner).map(lambda pair: pair[0] + pair[1]),
        st.tuples(inner, inner).map(lambda pair: pair[0] - pair[1]),
        st.tuples(inner, inner).map(lambda pair: pair[0] * pair[1]),
        inner.map(lambda e: e**2),
        inner.map(lambda e: 1 / (e**2 + 1)),
        inner.map(lambda e: sqrt(e**2 + m)),
        inner.map(lambda e: (sqrt(x**2 + m) - y) ** 2 * e),
        inner.map(sin),
    ),
    max_leaves=8,
)


@settings(max_examples=examples(100), deadline=None)
@given(EXPRESSIONS, st.booleans())
def test_never_changes_the_value(expression: sympy.Expr, whole: bool) -> None:
    constants = frozenset({m, l, R})
    known = Tidy(constants, constants, known=KnownSums(frozenset({m - 2, 1 - 2 * m}) if whole else frozenset()))
    if whole:
        known.keep_whole((sqrt(x**2 + m) - y, x - b))
    short = known(expression)
    draw = np.random.default_rng(5)
    for _ in range(3):
        point = {s: sympy.Float(draw.uniform(0.4, 1.9), 30) for s in (a, b, x, y, m)}
        before, after = (complex(e.xreplace(point).evalf(20)) for e in (expression, short))
        assert abs(before - after) <= 1e-9 * (1 + abs(before))


def test_bounded_work() -> None:
    z = [Symbol(f"z{i}") for i in range(12)]
    huge = sympy.Mul(*(sum(z) + i for i in range(12)))
    assert tidy()(huge) == huge
    assert tidy(budget=10)((x + y) ** 2 * (x - y) ** 3) == (x + y) ** 2 * (x - y) ** 3
    assert not tidy(budget=1).is_zero((x + y) ** 2 - (x + y) * (x + y + m))
    assert tidy().is_zero((x + y) ** 2 - x**2 - 2 * x * y - y**2)
    deep = x
    for _ in range(60):
        deep = 1 / (1 + deep)
    assert abs(tidy()(deep).subs(x, 2.0) - deep.subs(x, 2.0)) < 1e-12


def test_size_is_bounded() -> None:
    expression = x + y
    for _ in range(40):
        expression = sympy.Mul(sin(expression), cos(expression), evaluate=False)
    assert size(expression) == 1000
