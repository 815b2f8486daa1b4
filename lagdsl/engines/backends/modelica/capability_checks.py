"""Statements of a model that flat Modelica has no words for."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.event_flow import branches
from lagdsl.language.flat.events import Impact, Reset
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.quantity import Item
from lagdsl.language.flat.spans import around, place


def report_inexpressible(flat: FlatModel, sink: Sink) -> None:
    """E0915 at every statement whose instants solve a complementarity problem or distribute a momentum: Modelica resets
    single states only."""
    for contact in flat.events.contacts:
        _report(contact, f"contact `{contact.name}`", "an impact over the whole mechanism", sink)
    for friction in flat.events.frictions:
        _report(
            friction, f"friction `{friction.name}`", "slips of the whole mechanism that begin and end together", sink
        )
    for feedback in flat.events.feedbacks:
        _report(feedback, f"load `{feedback.name}`", "forces that depend on the accelerations that they cause", sink)
    for constraint in flat.constraints:
        if constraint.switched and not constraint.of_law:
            _report(constraint, f"constraint `{constraint.name}`", "constraints that come and go", sink)
    for branch in branches(flat):
        for action in branch.actions:
            if isinstance(action, Impact):
                _report(action, "`impact`", "an impact over the whole mechanism", sink)
            elif isinstance(action, Reset) and action.rate and flat.constraints:
                what = f"reinit of `der({action.name})`"
                _report(action, what, "a jump of a rate that constraints pass on to other rates", sink)


def _report(item: Item, what: str, reason: str, sink: Sink) -> None:
    sink.report("E0915", place(item), *around(item), what=what, reason=reason)
