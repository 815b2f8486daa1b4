"""Coefficients of a conserved quantity: a number times parameters, `2`, `-0.5*l`, `m/k`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations_with_replacement, permutations
from math import prod

import numpy as np

from lagdsl.exchange.verify.conserved.ansatz import fraction
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.foundation.units.naming import unit_text
from lagdsl.language.flat.model import Parameter

_AGREE = 1e-6
_MOST_PARAMETERS = 60
_SMALL = 12


@record(kw_only=True)
class Coefficient:
    """`number` times the parameters `over`, over those `under`, by name; `unit` is that of the number."""

    number: Fraction | float
    over: tuple[str, ...] = ()
    under: tuple[str, ...] = ()
    unit: Dimension = DIMENSIONLESS

    @property
    def is_plain(self) -> bool:
        """Is it a small number as people write it, without a unit?"""
        small = isinstance(self.number, Fraction) and max(abs(self.number.numerator), self.number.denominator) <= _SMALL
        return small and self.unit.is_dimensionless

    def of(self, p: Floats, names: Sequence[str]) -> Floats:
        """Values for rows of parameters (..., np)."""
        found = np.full(p.shape[:-1], float(self.number))
        for name in self.over:
            found = found * p[..., names.index(name)]
        for name in self.under:
            found = found / p[..., names.index(name)]
        return found

    def times(self, text: str, *, first: bool) -> str:
        """The term of a sum in the language: `+ 2*momentum(x)`."""
        sign = "-" if self.number < 0 else "" if first else "+"
        size: Fraction | float = -self.number if self.number < 0 else self.number
        pieces = [piece for piece in (_number(size, self.unit), *self.over, text) if piece]
        return (sign if first else f" {sign} ") + "*".join(pieces) + "".join(f"/{name}" for name in self.under)


def _number(size: Fraction | float, unit: Dimension) -> str:
    if unit.is_dimensionless:
        return "" if size == 1 else _plain(size)
    return f"{_plain(size)} {unit_text(unit)}"


def _plain(size: Fraction | float) -> str:
    if isinstance(size, Fraction) and size.denominator not in (1, 2, 4, 5, 8, 10, 20, 25, 40, 50):
        return f"{size.numerator}/{size.denominator}"
    return f"{float(size):.12g}"


def plain(value: float, unit: Dimension) -> Coefficient:
    """A number alone."""
    near = fraction(value)
    return Coefficient(number=value if near is None else near, unit=unit)


def with_parameters(
    values: Sequence[float], sets: Sequence[Floats], parameters: Sequence[Parameter], unit: Dimension
) -> Coefficient | None:
    """A fraction, times or over a parameter or a quotient of two, of the right unit, that gives `values` at all `sets`
    of parameters; None if there is none."""
    near = fraction(values[0])
    if near is not None and unit.is_dimensionless and all(abs(v - float(near)) <= _AGREE * abs(v) for v in values):
        return Coefficient(number=near)
    usable = [p for p in parameters[:_MOST_PARAMETERS] if p.kind == "Real" and all(s[_at(p, parameters)] for s in sets)]
    for over, under in _monomials(usable):
        if _unit(over) / _unit(under) != unit:
            continue
        factors = [_product(over, parameters, s) / _product(under, parameters, s) for s in sets]
        ratios = [value / factor for value, factor in zip(values, factors, strict=True)]
        near = fraction(ratios[0])
        if near is not None and all(abs(r - float(near)) <= _AGREE * abs(r) for r in ratios):
            return Coefficient(number=near, over=tuple(p.name for p in over), under=tuple(p.name for p in under))
    return None


def _monomials(usable: Sequence[Parameter]) -> Iterator[tuple[tuple[Parameter, ...], tuple[Parameter, ...]]]:
    """m, 1/m, m/k, m*k, 1/(m*k)."""
    for p in usable:
        yield (p,), ()
        yield (), (p,)
    for p, other in permutations(usable, 2):
        yield (p,), (other,)
    for both in combinations_with_replacement(usable, 2):
        yield both, ()
        yield (), both


def _unit(factors: Sequence[Parameter]) -> Dimension:
    found = DIMENSIONLESS
    for each in factors:
        found = found * each.dimension
    return found


def _product(factors: Sequence[Parameter], parameters: Sequence[Parameter], p: Floats) -> float:
    return prod(float(p[_at(each, parameters)]) for each in factors)


def _at(parameter: Parameter, parameters: Sequence[Parameter]) -> int:
    return next(k for k, each in enumerate(parameters) if each is parameter)
