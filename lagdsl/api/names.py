"""Values given by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isfinite

from lagdsl.diagnostics.suggest import nearest


def known(what: str, given: Mapping[str, float] | None, names: Sequence[str]) -> dict[str, float]:
    """`given` as floats. Raises KeyError for a name that is none of `names`, with the nearest one, and ValueError for
    what is no number."""
    values = dict(given or {})
    for name, value in values.items():
        if name not in names:
            likely = nearest(name, names)
            hint = f"did you mean `{likely}`?" if likely else f"there are {', '.join(names) or 'none'}"
            raise KeyError(f"no {what} `{name}`; {hint}")
        values[name] = _number(name, value)
    return values


def _number(name: str, value: object) -> float:
    try:
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError) as error:
        raise ValueError(f"`{name}` must be a number in SI units, not {str(value)[:40]!r}") from error
    if not isfinite(number):
        raise ValueError(f"`{name}` must be a finite number, not {number}")
    return number
