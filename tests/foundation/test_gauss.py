"""Gauss' quadrature, as numbers and in a model."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl
from lagdsl.foundation.numerics.gauss import legendre, quadrature, quadrature_to


def test_points_and_weights_are_those_of_numpy() -> None:
    for count in range(1, 25):
        points, weights = quadrature(count)
        others, their_weights = np.polynomial.legendre.leggauss(count)
        assert points == pytest.approx((1 + others) / 2, abs=1e-15)
        assert weights == pytest.approx(their_weights / 2, rel=1e-13)


def test_weights_to_a_place_integrate_polynomials_from_0() -> None:
    for count, x, power in ((1, 0.3, 0), (4, 0.9, 3), (7, 0.2, 2), (31, 0.97, 2), (31, 0.01, 2)):
        points, weights = np.array(quadrature(count)[0]), quadrature_to(x, count, power)
        for degree in (0, count // 2, count - 1):
            exact = x ** (degree + power + 1) / (degree + power + 1)
            assert weights @ points**degree == pytest.approx(exact, rel=1e-12, abs=1e-17)


def test_polynomials_of_legendre_are_those_of_numpy() -> None:
    for x in (0.0, 0.1, 0.7, 1.0):
        others = [np.polynomial.legendre.Legendre.basis(k)(2 * x - 1) for k in range(25)]
        assert legendre(x, 25) == pytest.approx(others, abs=1e-14)
    assert legendre(0.3, 1) == [1.0]


def test_a_model_integrates_a_polynomial() -> None:
    model = lagdsl.compile("""
model Integral
  coordinate Angle q;
  kinetic (1/2*1 kg.m2)*der(q)^2;
  constant Real x[3] = gauss_points(3), w[3] = gauss_weights(3);
  structural parameter Real part[3] = gauss_weights(3, 1/2, 1), P[3] = legendre(1/2, 3);
  output Real whole = sum(w[i]*x[i]^5 for i in 1:3), half = sum(part[i]*x[i]^2 for i in 1:3), values[3] = P;
end Integral;
""")
    exact = [1 / 6, 1 / 64, 1, 0, -1 / 2]
    assert np.ravel(model.output(0.0, [0.0], [0.0])) == pytest.approx(exact, rel=1e-14, abs=1e-15)
