"""Unknowns of a fit: parameters and start values of a model, shared by all runs or own to each."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from math import inf
from typing import TypeAlias

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel, Parameter
from lagdsl.language.settings.aliases import own_name
from lagdsl.language.settings.arrays import family, names_in
from lagdsl.language.settings.target import Target, targets, value_of

# Lower and upper bound: numbers in SI units or texts such as `2 kg`; None for one that there is not.
Bounds: TypeAlias = "tuple[float | str | None, float | str | None] | None"
# Names with bounds, names alone, or one text with commas.
Free: TypeAlias = "Mapping[str, Bounds] | Sequence[str] | str"


@record(kw_only=True)
class Unknown:
    """One number of the search: `value` where it begins, within `low` and `high`, in SI units. `run` is the number of
    the run that has it for itself, None for all. `size` is how much counts as a large change of it."""

    target: Target
    label: str
    value: float
    low: float
    high: float
    size: float
    run: int | None = None


def found_targets(flat: FlatModel, names: Collection[str], what: str = "parameter or start value") -> list[Target]:
    """Targets of these names, arrays as their elements. Raises UnknownName."""
    known = targets(flat, ("parameter", "start"))
    found: dict[str, Target] = {}
    for given in names:
        name = own_name(flat, given)
        elements = [name] if name in known else family(name, known)
        if not elements:
            raise unknown_among(what, given, list(known))
        found |= {each: known[each] for each in elements}
    return list(found.values())


def bounded(flat: FlatModel, free: Free, sink: Sink) -> dict[str, tuple[Target, float, float]]:
    """Targets by name with their bounds: those that are given, else `min` and `max` of the model. E1105 for none,
    E1106 for bounds that leave no room. Raises UnknownName, and ValueError for what is no bound."""
    given: Mapping[str, Bounds]
    if isinstance(free, str):
        given = dict.fromkeys(names_in(free))
    else:
        given = free if isinstance(free, Mapping) else dict.fromkeys(free)
    found: dict[str, tuple[Target, float, float]] = {}
    for name, bounds in given.items():
        for target in found_targets(flat, [name]):
            low, high = limits_of(target) if bounds is None else _limits(target, _pair(name, bounds))
            if not low < high:
                sink.report("E1106", None, name=target.name, why=f"the bounds {low:g} and {high:g} leave no room")
            found[target.name] = (target, low, high)
    if not found:
        sink.report("E1105", None, example=next(iter(targets(flat, ("parameter",))), "l"))
    return found


def _pair(name: str, bounds: Bounds) -> tuple[float | str | None, float | str | None]:
    if not isinstance(bounds, (tuple, list)) or len(bounds) != 2:
        raise ValueError(f"the bounds of `{name}` are a pair (lowest, highest) or None, not {str(bounds)[:40]!r}")
    return bounds[0], bounds[1]


def limits_of(target: Target) -> tuple[float, float]:
    """`min` and `max` of the model, infinite where there is none."""
    if target.rate:
        return -inf, inf
    return _limits(target, (getattr(target.quantity, "minimum", None), getattr(target.quantity, "maximum", None)))


def _limits(target: Target, given: tuple[float | str | None, float | str | None]) -> tuple[float, float]:
    low, high = (_bound(target, each) for each in given)
    return -inf if low is None else low, inf if high is None else high


def _bound(target: Target, given: float | str | None) -> float | None:
    if isinstance(given, str):
        return value_of(target, given).value
    return None if given is None else float(given)


def unknown_of(target: Target, value: float, low: float, high: float, sink: Sink) -> Unknown:
    """One that begins at `value`. E1106 for a value outside its bounds."""
    if not low <= value <= high:
        why = f"the search begins at {value:g}, outside of its bounds {low:g} and {high:g}"
        sink.report("E1106", None, name=target.name, why=why)
    nominal = getattr(target.quantity, "nominal", None)
    size = next((each for each in (abs(value), nominal, high - low if high - low < inf else None) if each), 1.0)
    return Unknown(target=target, label=target.name, value=value, low=low, high=high, size=size)


def of_runs(unknowns: Sequence[Unknown], own: Collection[str], runs: Sequence[str]) -> list[Unknown]:
    """The unknowns, those with names in `own` once for each run."""
    found: list[Unknown] = []
    for each in unknowns:
        if each.target.name not in own or len(runs) == 1:
            found.append(each)
        else:
            found += [replace(each, run=k, label=f"{each.target.name} ({run})") for k, run in enumerate(runs)]
    return found


def is_parameter(unknown: Unknown) -> bool:
    return isinstance(unknown.target.quantity, Parameter)
