"""Values given by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from lagdsl.diagnostics.suggest import nearest


def known(what: str, given: Mapping[str, float] | None, names: Sequence[str]) -> dict[str, float]:
    """`given` as floats. Raises KeyError for a name that is none of `names`, with the nearest one."""
    values = {name: float(value) for name, value in (given or {}).items()}
    for name in values:
        if name not in names:
            likely = nearest(name, names)
            hint = f"did you mean `{likely}`?" if likely else f"there are {', '.join(names) or 'none'}"
            raise KeyError(f"no {what} `{name}`; {hint}")
    return values
