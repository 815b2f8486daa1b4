"""Values given by name."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from math import isfinite
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.engines.backends.python.support.names import real_numbers
from lagdsl.foundation.diagnostics.unknown import unknown, unknown_among
from lagdsl.language.settings.arrays import family
from lagdsl.language.settings.arrays import spread as spread_braces
from lagdsl.language.settings.target import Target, value_of

# A number in SI units, a text such as `2 kg`, or an array of these where the name is that of an array.
Value: TypeAlias = "float | str | Sequence[float | str] | ArrayLike"
# A vector in the order of the model's names, or some of its entries by name.
Given: TypeAlias = ArrayLike | Mapping[str, Value] | None


def known(what: str, given: Mapping[str, Any] | None, targets: Mapping[str, Target]) -> dict[str, float]:
    """`given` as numbers in SI units, by the names of the model, which are the keys of `targets`.

    An array may be given by its name, a start by `theta` and by `theta.start`. Raises UnknownName for a name that is
    none of these, with the nearest one, and ValueError for what is no number, no text with the right unit or too many
    of them.
    """
    values: dict[str, float] = {}
    for name, value in (given or {}).items():
        for key, single in spread(what, name, value, targets):
            if key in values:
                raise ValueError(f"`{key}` is given twice")
            values[key] = number(targets[key], single)
    return values


def listed(given: Sequence[str] | str) -> Sequence[str]:
    """Names, also as one text with commas between them."""
    if not isinstance(given, str):
        return given
    from lagdsl.language.settings.arrays import names_in

    return names_in(given)


def spread(what: str, name: str, value: Any, targets: Mapping[str, Target]) -> Iterable[tuple[str, Any]]:
    """The elements that `name` stands for, with their values: one, or those of an array."""
    keys = keys_of(what, name, targets)
    if keys == [name] or keys == [name.removesuffix(".start")]:
        return [(keys[0], value)]
    array = np.asarray(_listed(name.removesuffix(".start"), value, keys), dtype=object)
    if array.ndim == 0:
        raise unknown(what, name, f"`{name}` is an array of {len(keys)}: give as many values, or `{keys[0]}`")
    single = array.ravel().tolist()
    if len(single) != len(keys):
        raise ValueError(f"`{name}` has {len(keys)} elements ({keys[0]} to {keys[-1]}), not {len(single)}")
    return zip(keys, single, strict=True)


def numbers(what: str, given: Mapping[str, Any], targets: Mapping[str, Target]) -> dict[str, Any]:
    """`given` with texts as numbers in SI units, arrays of any shape. Raises UnknownName, and ValueError for a text
    without the right unit."""
    found = {}
    for name, value in given.items():
        keys = keys_of(what, name, targets)
        found[name] = _array_of(_listed(name, value, keys), targets[keys[0]])
    return found


def _listed(name: str, value: Any, keys: Sequence[str]) -> Any:
    """`{30, 20} deg` as the texts of its elements; anything else as it is."""
    if not isinstance(value, str) or "{" not in value:
        return value
    return list(spread_braces({name: value}, keys).values())


def _array_of(value: Any, target: Target) -> Any:
    array = np.asarray(value)
    if array.dtype.kind in "biuf":
        return array
    single = [number(target, each) for each in np.asarray(value, dtype=object).ravel().tolist()]
    return np.reshape(single, array.shape)


def keys_of(what: str, name: str, targets: Mapping[str, Target]) -> list[str]:
    """The names of the model that `name` stands for. Raises UnknownName."""
    base = name.removesuffix(".start") if isinstance(name, str) else name
    for candidate in dict.fromkeys((name, base)):
        if candidate in targets and (candidate == name or targets[candidate].kind == "start"):
            return [candidate]
        elements = family(candidate, targets) if isinstance(candidate, str) else []
        if elements and (candidate == name or targets[elements[0]].kind == "start"):
            return elements
    raise unknown_among(what, name, list(targets))


def entries(what: str, given: Given, targets: Mapping[str, Target]) -> dict[str, float]:
    """A vector in the order of `targets`, or some of its entries by name, as entries by name. Raises UnknownName and
    ValueError for what does not fit."""
    if given is None or isinstance(given, Mapping):
        return known(what, given, targets)
    array = real_numbers(what, given)
    if array.shape != (len(targets),) and not (array.ndim == 0 and len(targets) == 1):
        raise ValueError(f"{what} must have {len(targets)} entries, its shape is {array.shape}")
    return known(what, dict(zip(targets, array.reshape(-1).tolist(), strict=True)), targets)


def number(target: Target, value: object) -> float:
    """In SI units. Raises ValueError for a text that is no quantity of that dimension, and for what is no number."""
    name = target.key
    if isinstance(value, str):
        return quantity(target, value)
    try:
        found = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError) as error:
        raise ValueError(f"`{name}` must be a number in SI units or a text, not {str(value)[:40]!r}") from error
    if not isfinite(found):
        raise ValueError(f"`{name}` must be a finite number, not {found}")
    return found


def quantity(target: Target, text: str) -> float:
    """A text such as `2 kg` in SI units. Raises ValueError, also for a text without a unit where there is one."""
    given = value_of(target, text)
    if given.dimension is None and target.unit:
        shown = target.display.unit
        raise ValueError(
            f"`{target.key}`: write the text with a unit, {text.strip() + ' ' + shown!r}, or give a number"
        )
    return given.value
