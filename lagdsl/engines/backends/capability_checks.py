"""Models of which a module would not tell the motion."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.spans import around, place

# Modules in which nothing finds loads that depend on the accelerations that they cause.
_LINEAR = {"casadi": "CasADi", "jax": "JAX"}


def report_loads_to_find(flat: FlatModel, target: str, sink: Sink) -> None:
    """E0916 at every load that depends on accelerations or multipliers, if modules for `target` do not find it."""
    if target not in _LINEAR:
        return
    for each in flat.events.feedbacks:
        sink.report("E0916", place(each), *around(each), name=each.name, language=_LINEAR[target])
