"""The form of energies that are written by hand (E0502, E0504, E0512, W0514, W0518, W0522)."""

from __future__ import annotations

import math
from functools import cached_property
from itertools import product

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.degree import RateDegree
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.language.flat.probe import ProbeState, probes
from lagdsl.language.flat.spans import around, place
from lagdsl.language.semantics.wellformed.damping import check_damping
from lagdsl.language.semantics.wellformed.semidefinite import Semidefinite

_POINTS = 6
# Through zero for abs(v); on one side of it for what is defined there only.
_FACTORS = ((-2.0, -0.5, 1.0, 2.5), (0.5, 1.0, 1.5, 2.0))


def check_energies(flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """Each `kinetic`, `potential`, `lagrangian`, `dissipation` must have its form and an effect."""
    coordinates = {coordinate.name for coordinate in flat.coordinates}
    differences = {each.name: each.difference for each in flat.events.relations}

    def turns(name: str) -> bool:
        return name in differences and any(each in coordinates for each in dependence.of(differences[name]))

    degree = RateDegree(dependence)
    trials = _Trials(flat)
    for term in flat.energies:
        orders = dependence.of(term.value)
        rates = [next((name for name in orders.differentiated(k) if name in coordinates), None) for k in (1, 2)]
        rate, acceleration = rates
        if acceleration is not None:
            sink.report(
                "E0512", place(term), *around(term), keyword=term.kind, acceleration=f"der(der({acceleration}))"
            )
        elif term.kind == "potential" and rate is not None:
            sink.report("E0502", place(term), *around(term), keyword=term.kind, rate=f"der({rate})")
        elif term.kind == "kinetic" and degree.of(term.value) > 2 and not _is_quadratic(trials, term):
            sink.report("E0504", place(term), *around(term))
        elif term.kind == "dissipation" and rate is None:
            _report_idle(term, "it depends on no rate, and only rates dissipate", sink)
        elif coordinates.isdisjoint(orders) and not any(map(turns, orders)):
            _report_idle(term, "it depends on no coordinate", sink)
    if not sink.has_errors:
        _check_sign(flat, trials, sink)
        if not check_damping(flat, sink):
            _check_dissipation(flat, trials, sink)


class _Trials:
    """The model at random moments with all rates multiplied by a factor; what terms share is computed once."""

    def __init__(self, flat: fm.FlatModel) -> None:
        self._flat = flat
        self._evaluators: dict[tuple[int, float], Evaluator] = {}

    @cached_property
    def _moments(self) -> list[ProbeState]:
        return probes(self._flat, _POINTS)

    def value(self, term: fm.EnergyTerm, moment: int, factor: float) -> float:
        """Raises NotEvaluable."""
        key = (moment, factor)
        if key not in self._evaluators:
            at = self._moments[moment]
            rates = {name: factor * rate for name, rate in at.rates.items()}
            self._evaluators[key] = Evaluator(self._flat, Values(variables=at.variables, rates=rates))
        return self._evaluators[key].scalar(term.value)


def _check_sign(flat: fm.FlatModel, trials: _Trials, sink: Sink) -> None:
    """W0518 where the kinetic energy written by hand is the whole of it and its quadratic part is negative for some
    rates: no mechanism is like that, a sign is wrong."""
    terms = [term for term in flat.energies if term.kind == "kinetic"]
    if not terms or flat.masses or flat.bodies or any(term.kind == "lagrangian" for term in flat.energies):
        return
    if _are_semidefinite(flat, terms):
        return
    for moment in range(_POINTS):
        parts = []
        for term in terms:
            try:
                forth, back, rest = (trials.value(term, moment, factor) for factor in (1.0, -1.0, 0.0))
            except NotEvaluable:
                return
            parts.append((forth + back) / 2.0 - rest)
        if sum(parts) < -1e-9 * max(map(abs, parts)):
            worst = min(zip(parts, terms, strict=True), key=lambda pair: pair[0])[1]
            sink.report("W0518", place(worst), *around(worst))
            return


def _are_semidefinite(flat: fm.FlatModel, terms: list[fm.EnergyTerm]) -> bool:
    """True if none needs to be tried, as most are sums of squares."""
    known = Semidefinite(flat)
    return all(known.of(term.value) for term in terms)


def _check_dissipation(flat: fm.FlatModel, trials: _Trials, sink: Sink) -> None:
    """W0522 where the dissipation functions together are negative for some rates."""
    terms = [term for term in flat.energies if term.kind == "dissipation"]
    if _are_semidefinite(flat, terms):
        return
    for moment in range(_POINTS):
        try:
            parts = [trials.value(term, moment, 1.0) for term in terms]
        except NotEvaluable:
            return
        if sum(parts) < -1e-9 * max(map(abs, parts)):
            worst, term = min(zip(parts, terms, strict=True), key=lambda pair: pair[0])
            sink.report(
                "W0522", place(term), *around(term), subject="dissipation", value=f"{worst:.3g} W for some rates"
            )
            return


def _report_idle(term: fm.EnergyTerm, reason: str, sink: Sink) -> None:
    sink.report("W0514", place(term), *around(term), keyword=term.kind, reason=reason)


def _is_quadratic(trials: _Trials, term: fm.EnergyTerm) -> bool:
    """True if the term is a quadratic polynomial along random lines of rates: the third difference vanishes.

    For texts whose degree does not show, such as `norm(v)*norm(v)`. Undecided counts as quadratic.
    """
    for moment, factors in product(range(_POINTS), _FACTORS):
        try:
            values = [trials.value(term, moment, factor) for factor in factors]
        except NotEvaluable:
            return True
        size = max(map(abs, values))
        difference = values[3] - 3 * values[2] + 3 * values[1] - values[0]
        if math.isfinite(difference) and abs(difference) > 1e-9 * size:
            return False
    return True
