"""Discrete variables in a linearization: they keep their values."""

from __future__ import annotations

from lagdsl.diagnostics import Sink
from lagdsl.flat.model import FlatModel

_MOST_TOLD = 4
_SAMPLED = "the sampled loop is open here, its entries are zero; write the continuous law in its place to see it closed"
_OTHER = "entries of what acts through them are zero; start the model in the mode that you mean"


def report_held(flat: FlatModel, sink: Sink) -> None:
    """N0876 where the model has variables that change at events only: sampled controllers, modes."""
    discretes, clocks = flat.events.discretes, flat.events.clocks
    if not discretes:
        return
    names = [f"`{item.name}`" for item in discretes[:_MOST_TOLD]]
    more = f" and {len(discretes) - len(names)} more" if len(discretes) > len(names) else ""
    by = f", which `{clocks[0].name}` sets" if len(clocks) == 1 else ", set by clocks" if clocks else ""
    sink.report(
        "N0876",
        discretes[0].spans[0] if discretes[0].spans else None,
        held=f"{', '.join(names)}{more}{by}",
        advice=_SAMPLED if clocks else _OTHER,
    )
