"""Statistics of residuals: variance, covariance, intervals, whiteness."""

from __future__ import annotations

import numpy as np
from scipy.stats import chi2
from scipy.stats import t as student

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

# Autocorrelations up to this lag, or a fifth of the values, are tested.
_LAGS, _PART = 10, 5
# Of values with normal errors the median of their sizes is this part of the standard deviation.
_MEDIAN = 0.6745


@record(kw_only=True)
class Uncertainty:
    """`covariance` (k, k) of the unknowns in SI units, `halves` (k,) of their intervals; nan for those that stand at a
    bound, infinite for those that data do not determine. `deviation` is that of residuals from zero, in units of the
    sigmas, with `freedom` degrees of freedom."""

    covariance: Floats
    halves: Floats
    deviation: float
    freedom: int


def uncertainty(
    residuals: Floats, jacobian: Floats, weights: Floats, seen: Floats, moved: list[bool], confidence: float
) -> Uncertainty:
    """Of residuals (n,) and jacobian (n, k), both divided by the sigmas; `weights` (n,) of a robust loss; `seen` (k, v)
    are orthonormal directions that data determine, `moved` tells of unknowns inside their bounds.

    Covariance s^2 (J' W J)^-1 on the directions that are seen, s^2 the weighted sum of squares over the degrees of
    freedom; halves by Student's t: G. A. F. Seber, C. J. Wild, Nonlinear Regression, 1989, sections 2.1 and 5.1.
    """
    n, k = jacobian.shape
    inside = np.flatnonzero(moved)
    directions = seen[inside]
    reduced, upper, _ = np.linalg.svd(directions, full_matrices=False)
    directions = reduced[:, upper > 0.5]
    freedom = max(n - directions.shape[1], 1)
    deviation = float(np.sqrt(np.sum(weights * residuals**2) / freedom))
    covariance = np.full((k, k), np.nan)
    halves = np.full(k, np.nan)
    if directions.size:
        along = np.sqrt(weights)[:, None] * (jacobian[:, inside] @ directions)
        inverse = directions @ np.linalg.pinv(along.T @ along) @ directions.T
        covariance[np.ix_(inside, inside)] = deviation**2 * inverse
    known = np.linalg.norm(directions, axis=1) > 1.0 - 1e-6
    variances = np.where(known, np.diag(covariance)[inside], np.inf)
    halves[inside] = float(student.ppf(0.5 + 0.5 * confidence, freedom)) * np.sqrt(variances)
    return Uncertainty(covariance=covariance, halves=halves, deviation=deviation, freedom=freedom)


def correlation_of(covariance: Floats) -> Floats:
    """Correlations (k, k) from a covariance."""
    deviations = np.sqrt(np.diag(covariance))
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(covariance / np.outer(deviations, deviations))


def whiteness(residuals: Floats) -> float:
    """Probability of autocorrelations as large as those of the residuals (n,), in the order of time, if they were
    independent; nan for too few.

    G. M. Ljung, G. E. P. Box, Biometrika 65 (1978) 297.
    """
    n = len(residuals)
    lags = min(_LAGS, n // _PART)
    centered = residuals - np.mean(residuals)
    power = float(centered @ centered)
    if lags < 2 or power == 0.0:
        return float("nan")
    found = np.array([float(centered[k:] @ centered[:-k]) / power for k in range(1, lags + 1)])
    statistic = n * (n + 2) * float(np.sum(found**2 / (n - np.arange(1, lags + 1))))
    return float(chi2.sf(statistic, lags))


def deviation_of(residuals: Floats, robust: bool) -> float:
    """Standard deviation of residuals about zero; of a robust loss by the median."""
    if robust:
        return float(np.median(np.abs(residuals))) / _MEDIAN
    return float(np.sqrt(np.mean(residuals**2)))


def weights_of(loss: str, residuals: Floats) -> Floats:
    """Derivatives of the loss by the squares of residuals (n,): the weights that it gives them."""
    z = residuals**2
    match loss:
        case "soft_l1":
            return np.asarray((1.0 + z) ** -0.5)
        case "huber":
            return np.asarray(1.0 / np.sqrt(np.maximum(z, 1.0)))
        case "cauchy":
            return np.asarray(1.0 / (1.0 + z))
        case "arctan":
            return np.asarray(1.0 / (1.0 + z**2))
        case _:
            return np.ones(len(z))
