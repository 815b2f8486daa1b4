"""Discrete variables against each other: who assigns which, and in which order they can be computed at one event."""

from __future__ import annotations

from graphlib import CycleError, TopologicalSorter
from itertools import pairwise

from lagdsl.diagnostics import Label, Sink
from lagdsl.flat.dependence import Dependence
from lagdsl.flat.event_flow import assignments, branches, needs
from lagdsl.flat.events import Assign, Branch, Reset
from lagdsl.flat.model import FlatModel


def check_events(flat: FlatModel, dependence: Dependence, sink: Sink) -> None:
    """E0307 for a variable that two clauses assign, E0384 for one that none does, E0385 for circles."""
    given = _given_once(flat, sink)
    for branch in branches(flat):
        _check_twice(branch, sink)
    for discrete in flat.events.discretes:
        if discrete.name not in given:
            sink.report("E0384", discrete.spans[0], name=discrete.name)
    try:
        TopologicalSorter(needs(flat, dependence)).prepare()
    except CycleError as circle:
        names: list[str] = circle.args[1]
        path = ", ".join(f"`{second}` depends on `{first}`" for first, second in pairwise(names))
        sink.report("E0385", given[names[0]].spans[0], path=path, name=names[0])


def _given_once(flat: FlatModel, sink: Sink) -> dict[str, Assign]:
    """The first assignment of each variable."""
    found: dict[str, tuple[int, Assign]] = {}
    for number, when in enumerate(flat.events.whens):
        for action, _ in assignments(when):
            clause, first = found.setdefault(action.variable, (number, action))
            if clause != number:
                label = Label(first.spans[0], "assigned here first")
                sink.report("E0307", action.spans[0], label, name=action.variable)
    return {name: action for name, (_, action) in found.items()}


def _check_twice(branch: Branch, sink: Sink) -> None:
    """E0307 for what one branch gives two values whatever happens."""
    known: dict[tuple[str, bool], Assign | Reset] = {}
    for action in branch.actions:
        if isinstance(action, Assign | Reset) and action.guard is None:
            name = action.variable if isinstance(action, Assign) else action.name
            key = (name, isinstance(action, Reset))
            if key in known:
                label = Label(known[key].spans[0], "given a value here first")
                sink.report("E0307", action.spans[0], label, name=name)
            known[key] = action
