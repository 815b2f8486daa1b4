"""Discrete variables against each other: who assigns which, and in which order they can be computed at one event."""

from __future__ import annotations

from dataclasses import replace
from graphlib import CycleError, TopologicalSorter
from itertools import pairwise

from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.foundation.record import record
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.event_flow import assignments, branches, needs
from lagdsl.language.flat.events import Assign, Branch, Contact, Impact, Reset, entries
from lagdsl.language.flat.expression import Binary, FlatExpression, Unary
from lagdsl.language.flat.model import FlatModel


def check_events(flat: FlatModel, dependence: Dependence, sink: Sink) -> None:
    """E0307 for a variable that two clauses assign, E0384 for one that none does, E0385 for circles."""
    given = _given_once(flat, sink)
    for branch in branches(flat):
        _check_twice(branch, sink)
    _check_resets(flat, sink)
    _check_gaps(flat, dependence, sink)
    for discrete in flat.events.discretes:
        if discrete.name not in given:
            sink.report("E0384", discrete.spans[0], name=discrete.name)
    try:
        TopologicalSorter(needs(flat, dependence)).prepare()
    except CycleError as circle:
        names: list[str] = circle.args[1]
        path = ", ".join(f"`{second}` depends on `{first}`" for first, second in pairwise(names))
        sink.report("E0385", given[names[0]].spans[0], path=path, name=names[0])


def with_switches(flat: FlatModel, dependence: Dependence) -> FlatModel:
    """The model with the constraints told that discretes switch or move. Corners of time leave them continuous."""
    corners = {each.name for each in flat.events.timed if each.kind == "corner"}
    discretes = {entry.name for entry in entries(flat.events)} - corners
    if not discretes:
        return flat
    constraints = tuple(
        replace(each, switched=True)
        if not each.of_law and not discretes.isdisjoint(dependence.of_all(each.residuals))
        else each
        for each in flat.constraints
    )
    return replace(flat, constraints=constraints)


def _given_once(flat: FlatModel, sink: Sink) -> dict[str, Assign]:
    """The first assignment of each variable."""
    found: dict[str, tuple[int, Assign]] = {}
    told: set[str] = set()
    for number, when in enumerate(flat.events.whens):
        for action, _ in assignments(when):
            clause, first = found.setdefault(action.variable, (number, action))
            if clause != number and action.variable not in told:
                told.add(action.variable)
                label = Label(first.spans[0], "assigned here first")
                sink.report("E0307", action.spans[0], label, name=action.variable)
    return {name: action for name, (_, action) in found.items()}


def _check_twice(branch: Branch, sink: Sink) -> None:
    """E0307, once for each name, for what one branch may give two values; whether resets under conditions meet is seen
    at run time."""
    known: dict[tuple[str, bool], list[_Guarded]] = {}
    told: set[str] = set()
    for action in branch.actions:
        if not isinstance(action, Assign | Reset):
            continue
        name = action.variable if isinstance(action, Assign) else action.name
        if name in told:
            continue
        earlier = known.setdefault((name, isinstance(action, Reset)), [])
        guarded = _Guarded(action, *_conditions(action.guard))
        clash = next((other for other in earlier if other.meets(guarded)), None)
        if clash is not None:
            told.add(name)
            label = Label(clash.action.spans[0], "given a value here first")
            sink.report("E0307", action.spans[0], label, name=name)
        earlier.append(guarded)


@record()
class _Guarded:
    """An action and the conditions that hold, and those that do not, where it acts."""

    action: Assign | Reset
    hold: frozenset[FlatExpression]
    fail: frozenset[FlatExpression]

    def meets(self, other: _Guarded) -> bool:
        """True if both may act: not where one stands under a condition that the other excludes."""
        if isinstance(self.action, Reset):
            return self.action.guard is None and other.action.guard is None
        return self.hold.isdisjoint(other.fail) and self.fail.isdisjoint(other.hold)


def _conditions(guard: FlatExpression | None) -> tuple[frozenset[FlatExpression], frozenset[FlatExpression]]:
    """Conditions of which a guard is the conjunction: those that hold, and those that do not."""
    hold, fail = [], []
    stack = [] if guard is None else [guard]
    while stack:
        each = stack.pop()
        if isinstance(each, Binary) and each.operator == "and":
            stack += [each.left, each.right]
        elif isinstance(each, Unary) and each.operator == "not":
            fail.append(each.operand)
        else:
            hold.append(each)
    return frozenset(hold), frozenset(fail)


def _check_resets(flat: FlatModel, sink: Sink) -> None:
    """E0374 for rates that the compiler computes, such as those of the joint that closes a loop."""
    coordinates = {coordinate.name for coordinate in flat.coordinates}
    states = {state.name for state in flat.states}
    for branch in branches(flat):
        for action in branch.actions:
            if isinstance(action, Reset) and action.name not in (coordinates if action.rate else states):
                name = f"der({action.name})" if action.rate else action.name
                sink.report("E0374", action.spans[0], name=name)


def _check_gaps(flat: FlatModel, dependence: Dependence, sink: Sink) -> None:
    """E0382 for a gap that no impulse can change: of states, time and inputs only."""
    coordinates = {coordinate.name for coordinate in flat.coordinates}
    actions = (action for branch in branches(flat) for action in branch.actions)
    gaps: list[Contact | Impact] = [*flat.events.contacts, *(each for each in actions if isinstance(each, Impact))]
    for item in gaps:
        if isinstance(item, Contact) and item.one_way:
            continue  # a rate is looked at where rates are
        if coordinates.isdisjoint(dependence.of(item.gap)):
            sink.report("E0382", item.spans[0])
