"""The search for conserved quantities.

Rates of candidates along the motion are numbers at random states on the constraints: loads, multipliers, inputs and
discretes included. A combination of candidates is constant if its rates cancel at all of them, which is a linear
system; an impact must not change it either. Each solution is written with simple fractions, or with parameters where
it depends on them, and what is written is tested: rates that are analytic and cancel at all random states of random
parameters, down to the rounding of their terms, are identically zero.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from math import lcm

import numpy as np

from lagdsl.exchange.verify.conserved.ansatz import ZERO, cancelling, is_new, remainder
from lagdsl.exchange.verify.conserved.candidates import MOST_COORDINATES, Candidate, Family, candidates
from lagdsl.exchange.verify.conserved.coefficient import Coefficient, plain, with_parameters
from lagdsl.exchange.verify.conserved.independence import Gradients, gradients, is_independent
from lagdsl.exchange.verify.conserved.quantity import (
    ConservedQuantity,
    Term,
    because,
    expression_of,
    statements_of,
    unit_of,
)
from lagdsl.exchange.verify.conserved.samples import Samples, samples
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.event_flow import branches
from lagdsl.language.flat.events import Reset
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation

_FEW = 20
_SPARE = 12
_FAMILIES: tuple[tuple[Family, ...], ...] = (
    ("momentum",),
    ("linear",),
    ("angular",),
    ("momentum", "coordinate"),
    ("momentum", "product"),
    ("energy", "momentum"),
    ("energy", "linear", "angular"),
)


def conserved_quantities(compilation: Compilation) -> tuple[ConservedQuantity, ...]:
    """All that were found, simple ones first, none that follows from those before it.

    None in models whose events set rates or states to other values.
    """
    flat = compilation.flat
    if any(isinstance(action, Reset) for branch in branches(flat) for action in branch.actions):
        return ()
    tried = candidates(compilation.equations)
    if not tried or not flat.coordinates:
        return ()
    count = _FEW if len(flat.coordinates) > MOST_COORDINATES else max(_FEW, len(tried) + _SPARE)
    anywhere = samples(compilation, tried, count)
    given = samples(compilation, tried, count, p=np.array(compilation.program.layout.defaults, dtype=float))
    if anywhere is None or given is None:
        return ()
    slopes = gradients(compilation, [each.value for each in tried], given)
    search = _Search(flat, tried, given, slopes)
    search.singles(anywhere)
    others: list[Samples] = []
    for family in _FAMILIES:
        search.combinations(family, anywhere)
        rows = search.left(family)
        if rows and not others:
            elsewhere = (samples(compilation, tried, count, p=p) for p in anywhere.p[:2])
            others = [found for found in elsewhere if found is not None]
        search.with_parameters(family, rows, anywhere, others)
    return search.found


class _Search:
    """The quantities found so far, their values `_known` and coefficients `_weights`. `_given` are samples with the
    parameters of the model, `_gradients` those of candidates there."""

    def __init__(self, flat: FlatModel, tried: Sequence[Candidate], given: Samples, slopes: Gradients) -> None:
        self._parameters = [item for item in flat.parameters if not item.structural]
        self._tried = tried
        self._given = given
        self._gradients = slopes
        self._known: list[Floats] = []
        self._weights: list[tuple[Floats, list[int]]] = []
        self._found: list[ConservedQuantity] = []

    @property
    def found(self) -> tuple[ConservedQuantity, ...]:
        return tuple(self._found)

    def singles(self, at: Samples) -> None:
        """Candidates that are constant by themselves."""
        order: tuple[Family, ...] = ("energy", "momentum", "linear", "angular")
        for family in order:
            for k in self._columns((family,)):
                self._take([Term(Coefficient(number=Fraction(1)), self._tried[k])], [k], at, everywhere=True)

    def combinations(self, family: Sequence[Family], at: Samples) -> None:
        """Combinations with coefficients that are the same for all parameters."""
        columns = self._columns(family)
        for row in self._rows(columns, at):
            terms, used = self._terms(row, columns)
            if len(terms) > 1:
                self._take(terms, used, at, everywhere=True)

    def left(self, family: Sequence[Family]) -> list[Floats]:
        """Coefficients of those that are constant with the parameters of the model, and new."""
        columns = self._columns(family)
        return [row for row in self._rows(columns, self._given) if is_new(*self._sum(row, columns), self._known)]

    def with_parameters(
        self, family: Sequence[Family], rows: Sequence[Floats], anywhere: Samples, others: Sequence[Samples]
    ) -> None:
        """Combinations whose coefficients depend on parameters, or that are constant for the given ones only."""
        columns = self._columns(family)
        elsewhere = [self._rows(columns, at) for at in others]
        for row in rows:
            like = [next((r for r in found if np.array_equal(r != 0, row != 0)), None) for found in elsewhere]
            sets = [self._given.p[0], *(at.p[0] for at in others)]
            alike = [row, *(r for r in like if r is not None)]
            terms = self._parametric(alike, sets, columns) if len(alike) == len(sets) > 1 else None
            used = [columns[k] for k in np.flatnonzero(row)]
            if terms is None or not self._take(terms, used, anywhere, everywhere=True):
                terms, used = self._terms(row, columns)
                if all(term.coefficient.is_plain for term in terms):
                    self._take(terms, used, self._given, everywhere=False)

    def _columns(self, family: Sequence[Family]) -> list[int]:
        return [k for wanted in family for k, each in enumerate(self._tried) if each.family == wanted]

    def _rows(self, columns: list[int], at: Samples) -> list[Floats]:
        if not columns or len(columns) + 2 > len(at.changes):
            return []
        return list(cancelling(at.changes[:, columns], at.sizes[:, columns]))

    def _terms(self, row: Floats, columns: list[int]) -> tuple[list[Term], list[int]]:
        """With whole numbers where the coefficients are fractions."""
        used = [int(k) for k in np.flatnonzero(row)]
        units = [self._tried[columns[used[0]]].dimension / self._tried[columns[k]].dimension for k in used]
        found = [plain(float(row[k]), unit) for k, unit in zip(used, units, strict=True)]
        denominators = [each.number.denominator for each in found if not isinstance(each.number, float)]
        common = lcm(*denominators) if len(denominators) == len(found) else 1
        terms = [
            Term(Coefficient(number=common * each.number, unit=each.unit), self._tried[columns[k]])
            for each, k in zip(found, used, strict=True)
        ]
        return terms, [columns[k] for k in used]

    def _parametric(self, alike: Sequence[Floats], sets: Sequence[Floats], columns: list[int]) -> list[Term] | None:
        used = [int(k) for k in np.flatnonzero(alike[0])]
        first = self._tried[columns[used[0]]].dimension
        terms = []
        for k in used:
            candidate = self._tried[columns[k]]
            values = [float(row[k]) for row in alike]
            coefficient = with_parameters(values, sets, self._parameters, first / candidate.dimension)
            if coefficient is None:
                return None
            terms.append(Term(coefficient, candidate))
        return terms

    def _take(self, terms: Sequence[Term], used: list[int], at: Samples, *, everywhere: bool) -> bool:
        """Keep a combination if its changes cancel `at` all states, and it is new."""
        names = [item.name for item in self._parameters]
        weights = np.stack([term.coefficient.of(at.p[at.of], names) for term in terms], axis=1)
        part = remainder(weights, at.changes[:, used], at.sizes[:, used])
        if not part <= ZERO:
            return False
        own = np.stack([term.coefficient.of(self._given.p, names) for term in terms], axis=1)
        values, size = self._sum(own, used)
        if not is_new(values, size, self._known):
            self._tell_also(terms, values, size)
            return True
        if len(terms) > 1 and not is_independent(own[0], used, self._weights, self._gradients):
            return True
        self._known.append(values)
        self._weights.append((own[0], used))
        self._found.append(
            ConservedQuantity(
                expression=expression_of(terms),
                unit=unit_of(terms),
                because=because(terms),
                statements=statements_of(terms),
                also=(),
                for_all_parameters=everywhere,
                remainder=part,
                terms=tuple(terms),
            )
        )
        return True

    def _tell_also(self, terms: Sequence[Term], values: Floats, size: float) -> None:
        """A second name for a quantity that is known by another one."""
        text = expression_of(terms)
        if len(terms) > 1 or not is_new(values, size, []):
            return
        for k, (known, quantity) in enumerate(zip(self._known, self._found, strict=True)):
            if not is_new(values, size, [known]):
                if text not in (quantity.expression, *quantity.also):
                    self._found[k] = replace(quantity, also=(*quantity.also, text))
                return

    def _sum(self, weights: Floats, columns: list[int]) -> tuple[Floats, float]:
        """Values of a combination at the given states, and the natural size of its terms."""
        values, natural = (np.asarray(each[:, columns]) for each in (self._given.values, self._given.natural))
        size = np.sum(np.abs(weights) * natural, axis=1)
        return np.sum(weights * values, axis=1), float(np.max(size, initial=0.0))
