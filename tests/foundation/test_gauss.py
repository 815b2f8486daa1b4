"""Gauss' quadrature, as numbers and in a model."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl
from lagdsl.foundation.numerics.gauss import quadrature


def test_points_and_weights_are_those_of_numpy() -> None:
    for count in range(1, 25):
        points, weights = quadrature(count)
        others, their_weights = np.polynomial.legendre.leggauss(count)
        assert points == pytest.approx((1 + others) / 2, abs=1e-15)
        assert weights == pytest.approx(their_weights / 2, rel=1e-13)


def test_a_model_integrates_a_polynomial() -> None:
    model = lagdsl.compile("""
model Integral
  coordinate Angle q;
  kinetic (1/2*1 kg.m2)*der(q)^2;
  constant Real x[3] = gauss_points(3), w[3] = gauss_weights(3);
  output Real integral = sum(w[i]*x[i]^5 for i in 1:3);
end Integral;
""")
    assert float(np.ravel(model.output(0.0, [0.0], [0.0]))[0]) == pytest.approx(1 / 6, rel=1e-14)
