"""Names that `connect` makes those of one coordinate, beside the one under which the results have it."""

from __future__ import annotations

from lagdsl.flat.model import FlatModel


def other_names(flat: FlatModel) -> dict[str, tuple[str, ...]]:
    """By coordinate `x` and rate `der(x)`, the other names that it has."""
    found: dict[str, tuple[str, ...]] = {}
    for alias in flat.aliases:
        found[alias.of] = (*found.get(alias.of, ()), alias.name)
    rates = {f"der({name})": tuple(f"der({other})" for other in others) for name, others in found.items()}
    return found | rates


def results_names(flat: FlatModel) -> dict[str, str]:
    """By other name of a coordinate or a rate, the name under which the results have it."""
    return {other: name for name, others in other_names(flat).items() for other in others}
