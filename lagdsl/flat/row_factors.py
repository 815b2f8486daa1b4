"""Factors of the rows of constraints: the equations may multiply rows, so that none is far smaller than others."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from lagdsl.flat.model import FlatModel


def row_factors(flat: FlatModel) -> tuple[float, ...]:
    """One for each row. A multiplier in the text is that of the equations times this."""
    return tuple(factor for each in flat.constraints for factor in each.factors or (1.0,) * len(each.rows))


def with_row_factors(flat: FlatModel, factors: Iterable[float]) -> FlatModel:
    """The same with these factors, in place of those it has."""
    rest = iter(factors)
    constraints = [(each, tuple(next(rest) for _ in each.rows)) for each in flat.constraints]
    scaled = [replace(each, factors=own if any(by != 1.0 for by in own) else ()) for each, own in constraints]
    return replace(flat, constraints=tuple(scaled))


def without_row_factors(flat: FlatModel) -> FlatModel:
    """Constraints as they are written."""
    return with_row_factors(flat, [1.0] * len(row_factors(flat)))
