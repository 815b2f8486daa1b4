"""The product of a fit: values with intervals, residuals, motions, and what is to be known of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.foundation.diagnostics import Diagnostic
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.display import Display
from lagdsl.motion.fit.identifiability import Hidden
from lagdsl.motion.fit.unknowns import Unknown
from lagdsl.motion.signals.trajectory import Trajectory


@record(kw_only=True)
class Estimate:
    """One unknown: `value` with the `half` of its interval, from `before`, in SI units. `half` is infinite where data
    do not determine it, nan where it stands at a bound."""

    unknown: Unknown
    value: float
    half: float

    @property
    def name(self) -> str:
        return self.unknown.label

    @property
    def display(self) -> Display:
        return self.unknown.target.display

    @property
    def before(self) -> float:
        """The value at which the search began."""
        return self.unknown.value


@record(kw_only=True)
class SeriesResiduals:
    """Values of a column of a run, or times of an event, `measured` and `computed` at `times` [s], in SI units.

    `sigma` is the standard deviation that was given, or found. `white` is the probability of autocorrelations as large
    as those of the residuals, if these were independent; nan for too few."""

    run: str
    name: str
    display: Display
    times: Floats
    measured: Floats
    computed: Floats
    sigma: float
    white: float
    event: bool = False

    @property
    def residuals(self) -> Floats:
        """Computed less measured (rows,), in SI units."""
        return self.computed - self.measured

    @property
    def deviation(self) -> float:
        """Root mean square of the residuals, in SI units."""
        return float(np.sqrt(np.mean(self.residuals**2)))


@record(kw_only=True)
class Fit:
    """Values of unknowns for which the motions are nearest to the data.

    `covariance` and `correlation` (k, k) are those of the `estimates`, in SI units; intervals have the probability
    `confidence`. `deviation` is the standard deviation of residuals in units of the sigmas: 1 where those were right.
    `hidden` are groups of unknowns that data show only together, `corners` unknowns near whose values the order of
    events of a run changes, with its name. `motions` are those of the runs. `notes` are all warnings. The sums are
    those of squares of residuals in units of the sigmas, here and at the first values.
    """

    model: str
    estimates: tuple[Estimate, ...]
    covariance: Floats
    correlation: Floats
    confidence: float
    deviation: float
    freedom: int
    series: tuple[SeriesResiduals, ...]
    motions: tuple[Trajectory, ...]
    hidden: tuple[Hidden, ...]
    corners: tuple[tuple[str, str], ...]
    notes: tuple[Diagnostic, ...]
    sum_of_squares: float
    first_sum_of_squares: float
    trials: int
    converged: bool

    @property
    def values(self) -> dict[str, float]:
        """By name, in SI units; one that each run has for itself as `theta.start (run1)`."""
        return {each.name: each.value for each in self.estimates}

    @property
    def intervals(self) -> dict[str, tuple[float, float]]:
        """Ends of the intervals by name, in SI units."""
        return {each.name: (each.value - each.half, each.value + each.half) for each in self.estimates}

    @property
    def parameters(self) -> dict[str, float]:
        """Values of parameters that all runs share, as `simulate` takes them."""
        return self._of_kind("parameter")

    @property
    def start(self) -> dict[str, float]:
        """Start values that all runs share, as `simulate` takes them."""
        return self._of_kind("start")

    def _of_kind(self, kind: str) -> dict[str, float]:
        shared = [each for each in self.estimates if each.unknown.run is None]
        return {e.unknown.target.key: e.value for e in shared if e.unknown.target.kind == kind}

    def __getitem__(self, name: str) -> float:
        """The value, in SI units."""
        return self.values[name]


def shown(estimate: Estimate) -> tuple[str, str, str]:
    """Value, half of the interval and unit of an estimate as people read them: the half with two digits, the value with
    as many places."""
    display = estimate.display
    half = abs(display.scale) * estimate.half
    value = display(estimate.value)
    if not np.isfinite(half) or half == 0.0:
        return f"{value:.6g}", {True: "at its bound", False: "not determined"}[bool(np.isnan(half))], display.unit
    places = 1 - int(np.floor(np.log10(half)))
    if -6 < places < 12 and abs(value) < 1e6:
        return f"{value:.{max(places, 0)}f}", f"{half:.{max(places, 0)}f}", display.unit
    return f"{value:.8g}", f"{half:.2g}", display.unit


def largest_correlations(fit: Fit, least: float) -> list[tuple[str, str, float]]:
    """Pairs of estimates with correlations beyond `least`, the largest first."""
    names: Sequence[str] = [each.name for each in fit.estimates]
    pairs = [
        (names[i], names[j], float(fit.correlation[i, j]))
        for i in range(len(names))
        for j in range(i)
        if abs(fit.correlation[i, j]) > least
    ]
    return sorted(pairs, key=lambda each: -abs(each[2]))
