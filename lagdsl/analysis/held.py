"""Discrete variables in a linearization: they keep their values."""

from __future__ import annotations

from lagdsl.diagnostics import Label, Sink
from lagdsl.flat.model import FlatModel

_MOST_TOLD = 4
_SAMPLED = (
    "an input or a state that acts through it has zero entries, and the loop is open here; "
    "to see it in the modes, write the continuous law in its place"
)
_OTHER = "what acts through it has zero entries; start the model in the mode that you mean"


def report_held(flat: FlatModel, sink: Sink) -> None:
    """N0876 where the model has variables that change at events only: sampled controllers, modes."""
    discretes, clocks = flat.events.discretes, flat.events.clocks
    if not discretes:
        return
    names = [f"`{item.name}`" for item in discretes[:_MOST_TOLD]]
    more = f" and {len(discretes) - len(names)} more" if len(discretes) > len(names) else ""
    by = f", which `{clocks[0].name}` sets" if len(clocks) == 1 else ", set by clocks" if clocks else ""
    places = [Label(item.spans[0]) for item in discretes[:_MOST_TOLD] if item.spans]
    sink.report(
        "N0876",
        places[0] if places else None,
        *places[1:],
        held=f"{', '.join(names)}{more}{by}",
        advice=_SAMPLED if clocks else _OTHER,
    )
