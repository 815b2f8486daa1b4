"""Interpolation between points, against SciPy's."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from flattening import run
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import CubicHermiteSpline, PchipInterpolator

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.evaluate import Values, evaluate
from lagdsl.language.semantics.operators.pieces import chosen
from lagdsl.language.semantics.operators.tables import interpolation

PLACES = [0.0, 0.5, 2.0, 3.0, 4.5]
VALUES = [1.0, 3.0, 2.5, 2.5, 7.0]
TEXT = """model M
  structural parameter Length at[:] = {0, 0.5, 2, 3, 4.5};
  parameter Force f[5] = {1, 3, 2.5, 2.5, 7};
  coordinate Length x;
  kinetic 1/2*(1 kg)*der(x)^2;
  output Force y = table(x, at, METHOD);
end M;
"""


def text(method: str) -> str:
    given_ = "{1 N, 3 N, 2.5 N, 2.5 N, 7 N}" if method == "monotone" else "f"
    return TEXT.replace("METHOD", f'{given_}, "{method}"')


def expected(method: str, x: np.ndarray) -> np.ndarray:
    """By SciPy inside, straight on outside."""
    if method == "linear":
        first, last = 4.0, 3.0
        inside = np.interp(x, PLACES, VALUES)
    elif method == "cubic":
        # Slope in a point of the parabola through it and its neighbors: by polynomials fitted to three points.
        parabolas = [np.polyfit(PLACES[k : k + 3], VALUES[k : k + 3], 2) for k in range(3)]
        chosen = [0, 0, 1, 2, 2]
        slopes = [np.polyval(np.polyder(parabolas[c]), at) for c, at in zip(chosen, PLACES, strict=True)]
        first, last = slopes[0], slopes[-1]
        inside = CubicHermiteSpline(PLACES, VALUES, slopes)(x)
    else:
        smooth = PchipInterpolator(PLACES, VALUES)
        first, last = smooth.derivative()(PLACES[0]), smooth.derivative()(PLACES[-1])
        inside = smooth(x)
    below = VALUES[0] + first * (x - PLACES[0])
    above = VALUES[-1] + last * (x - PLACES[-1])
    return np.where(x < PLACES[0], below, np.where(x > PLACES[-1], above, inside))


@pytest.mark.parametrize("method", ["linear", "cubic", "monotone"])
def test_values(method: str) -> None:
    flat, sink = run(text(method))
    assert flat is not None, sink.diagnostics
    (output,) = flat.outputs
    x = np.linspace(-1, 6, 141)
    parameters = {f"f[{k}]": value for k, value in enumerate(VALUES, 1)}
    found = [evaluate(flat, output.value, Values(variables={**parameters, "x": float(at)})) for at in x]
    np.testing.assert_allclose(found, expected(method, x), rtol=1e-12)
    assert output.unit == "N"


def value(expression: fx.FlatExpression, x: float) -> float:
    flat, _ = run(TEXT.replace("METHOD", "f"))
    assert flat is not None
    return evaluate(flat, expression, Values(variables={"x": x}))


def cubic(places: Sequence[float], values: Sequence[float]) -> fx.FlatExpression:
    pieces = interpolation(fx.Variable("x"), places, list(map(fx.Number, values)), "cubic")
    return chosen(pieces.x, pieces.borders, pieces.values)


@given(st.lists(st.floats(-5, 5), min_size=3, max_size=3), st.floats(-3, 5))
def test_cubic_meets_quadratic_functions(coefficients: list[float], x: float) -> None:
    y = np.polynomial.Polynomial(coefficients)
    inside = min(max(x, PLACES[0]), PLACES[-1])
    found = cubic(PLACES, [float(y(at)) for at in PLACES])
    assert value(found, inside) == pytest.approx(y(inside), abs=1e-12, rel=1e-12)


def depth(expression: fx.FlatExpression) -> int:
    if isinstance(expression, fx.Conditional):
        return 1 + max(depth(expression.value), depth(expression.otherwise))
    return 0


def test_conditionals_are_balanced() -> None:
    points = [float(k) for k in range(1000)]
    assert depth(cubic(points, points)) == 10


def test_dimensions() -> None:
    _, sink = run(TEXT.replace("at, METHOD", "{0, 1}, {0 N, 1 N}"))
    assert [diagnostic.code for diagnostic in sink.diagnostics] == ["E0401"]
    _, sink = run(TEXT.replace("at, METHOD", "{0 m, 1 m}, {0 m, 1 m}"))
    assert [diagnostic.code for diagnostic in sink.diagnostics] == ["E0407"]
