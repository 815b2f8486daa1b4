"""Values given by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isfinite
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.diagnostics.suggest import did_you_mean

# A vector in the order of the model's names, or some of its entries by name.
Given: TypeAlias = ArrayLike | Mapping[str, float] | None


def known(what: str, given: Mapping[str, float] | None, names: Sequence[str]) -> dict[str, float]:
    """`given` as floats. Raises KeyError for a name that is none of `names`, with the nearest one, and ValueError for
    what is no number."""
    values = dict(given or {})
    for name, value in values.items():
        if name not in names:
            hint = did_you_mean(name, names, f"there are {', '.join(names) or 'none'}")
            raise KeyError(f"no {what} `{name}`; {hint}")
        values[name] = _number(name, value)
    return values


def entries(what: str, given: Given, names: Sequence[str]) -> dict[str, float]:
    """A vector in the order of `names`, or some of its entries by name, as entries by name. Raises KeyError and
    ValueError for what does not fit."""
    if given is None or isinstance(given, Mapping):
        return known(what, given, names)
    array = np.asarray(given, dtype=np.float64)
    if array.shape != (len(names),) and not (array.ndim == 0 and len(names) == 1):
        raise ValueError(f"{what} must have {len(names)} entries, its shape is {array.shape}")
    return known(what, dict(zip(names, array.reshape(-1).tolist(), strict=True)), names)


def _number(name: str, value: object) -> float:
    try:
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError) as error:
        raise ValueError(f"`{name}` must be a number in SI units, not {str(value)[:40]!r}") from error
    if not isfinite(number):
        raise ValueError(f"`{name}` must be a finite number, not {number}")
    return number
