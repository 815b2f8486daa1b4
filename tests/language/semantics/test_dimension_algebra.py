"""Random expressions of known dimension are accepted; the same with one factor too many is rejected."""

from __future__ import annotations

from fractions import Fraction

from choice import examples
from flattening import run
from hypothesis import given, settings
from hypothesis import strategies as st

from lagdsl.foundation.units import Dimension, dimension
from lagdsl.foundation.units.naming import base_text

QUANTITIES = {
    "l": dimension(m=1),
    "m": dimension(kg=1),
    "t": dimension(s=1),
    "c": dimension(A=1),
    "v": dimension(m=1, s=-1),
    "g_n": dimension(m=1, s=-2),
    "2 N": dimension(kg=1, m=1, s=-2),
    "3": dimension(),
    "theta": dimension(),
}
HEAD = """model M
  parameter Length l = 1 m;
  parameter Mass m = 2 kg;
  parameter Time t = 3 s;
  parameter Current c = 4 A;
  parameter Velocity v = 5 m/s;
  coordinate Angle theta;
  kinetic 1/2*m*l^2*der(theta)^2;
"""


@st.composite
def leaves(draw: st.DrawFn) -> tuple[str, Dimension]:
    name = draw(st.sampled_from(sorted(QUANTITIES)))
    return (f"({name})" if " " in name else name), QUANTITIES[name]


def grow(inner: st.SearchStrategy[tuple[str, Dimension]]) -> st.SearchStrategy[tuple[str, Dimension]]:
    pairs = st.tuples(inner, inner)
    return st.one_of(
        pairs.map(lambda p: (f"{p[0][0]}*{p[1][0]}", p[0][1] * p[1][1])),
        pairs.map(lambda p: (f"{p[0][0]}/({p[1][0]})", p[0][1] / p[1][1])),
        inner.map(lambda e: (f"({e[0]} + 2*({e[0]}))", e[1])),
        inner.map(lambda e: (f"(0 - ({e[0]}))", e[1])),
        inner.map(lambda e: (f"({e[0]})^2", e[1] ** 2)),
        inner.map(lambda e: (f"({e[0]})^(-1/2)", e[1] ** Fraction(-1, 2))),
        inner.map(lambda e: (f"sqrt({e[0]})", e[1] ** Fraction(1, 2))),
        inner.map(lambda e: (f"max({e[0]}, {e[0]})", e[1])),
        inner.map(lambda e: (f"(if t > 0 then {e[0]} else 0)", e[1])),
        inner.map(lambda e: (f"der(theta*({e[0]}))", e[1] / dimension(s=1))),
        inner.map(lambda e: (f"cos(theta)*({e[0]})", e[1])),
        inner.map(lambda e: (f"{{{e[0]}, 0}}*{{1, 2}}", e[1])),
        inner.map(lambda e: (f"norm({{{e[0]}, 0, {e[0]}}})", e[1])),
        inner.map(lambda e: (f"sum({e[0]} for i in 1:2)", e[1])),
    )


EXPRESSIONS = st.recursive(leaves(), grow, max_leaves=8).filter(
    lambda e: len(e[0]) < 600 and e[0].count("der(") <= 2 and _small(e[1])  # a third derivative is E0342
)


def _small(found: Dimension) -> bool:
    """What a unit text can say: whole exponents, or halves."""
    return all(abs(power) <= 9 and power.denominator <= 2 for power in found.exponents)


def declare(expression: str, found: Dimension) -> list[str]:
    """Codes of errors when an output of the dimension is given the expression."""
    text = f'{HEAD}  output Real y(unit = "{base_text(found)}") = {expression};\nend M;'
    flat, sink = run(text)
    errors = [d.code for d in sink.diagnostics if d.severity == "error"]
    assert (flat is None) == bool(errors)
    return errors


@settings(max_examples=examples(60), deadline=None)
@given(EXPRESSIONS)
def test_the_dimension_is_the_one_known(pair: tuple[str, Dimension]) -> None:
    assert declare(*pair) == []


@settings(max_examples=examples(60), deadline=None)
@given(EXPRESSIONS, st.sampled_from(["l", "m", "t", "c", "v"]))
def test_another_dimension_is_refused(pair: tuple[str, Dimension], factor: str) -> None:
    expression, found = pair
    assert declare(f"({expression})*{factor}", found) == ["E0407"]
    assert declare(f"({expression}) + ({expression})*{factor}", found) == ["E0401"]
