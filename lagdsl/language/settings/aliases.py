"""Names that `connect` makes those of one coordinate, beside the one under which the results have it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TypeVar

from lagdsl.foundation.record import remembered
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.arrays import family
from lagdsl.language.settings.failure import SettingError

_Value = TypeVar("_Value")
_SUBSCRIPT = re.compile(r"\[[^\[\]]*\]")
_START = ".start"


@remembered
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


def own_name(flat: FlatModel, name: str) -> str:
    """The name that the model has for `name`, `name.start` or the array `name`; any other name as it is."""
    if not flat.aliases or not isinstance(name, str):
        return name
    known = results_names(flat)
    base = name.removesuffix(_START)
    ending = name[len(base) :]
    if base in known:
        return known[base] + ending
    elements = family(base, known)
    arrays = {_SUBSCRIPT.sub("", known[each]) for each in elements}
    array = next(iter(arrays)) if len(arrays) == 1 else ""
    own = family(array.removeprefix("der(").removesuffix(")"), [item.name for item in flat.coordinates])
    return f"{array}{ending}" if elements and len(own) == len(elements) else name


def by_own_names(flat: FlatModel, given: Mapping[str, _Value]) -> dict[str, _Value]:
    """`given` by the names of the model. Raises SettingError where two of the names are those of one coordinate."""
    found: dict[str, _Value] = {}
    written: dict[str, str] = {}
    for name, value in given.items():
        own = own_name(flat, name)
        if own in found:
            raise SettingError(f"`connect` made `{written[own]}` and `{name}` one coordinate: give one of them")
        found[own] = value
        written[own] = name
    return found
