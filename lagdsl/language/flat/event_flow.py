"""The flow of data at one event: which new values of discrete variables are needed for which."""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.events import Action, Assign, Branch, Check, Impact, Reset, Terminate, When
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import FlatModel


def branches(flat: FlatModel) -> Iterator[Branch]:
    for when in flat.events.whens:
        yield from when.branches


def reset_states(flat: FlatModel) -> frozenset[str]:
    """States that clauses set."""
    actions = (action for branch in branches(flat) for action in branch.actions)
    return frozenset(action.name for action in actions if isinstance(action, Reset) and not action.rate)


def assignments(when: When) -> Iterator[tuple[Assign, list[FlatExpression]]]:
    """Each assignment with the conditions that decide whether it acts."""
    conditions: list[FlatExpression] = []
    for branch in when.branches:
        conditions += branch.conditions
        for action in branch.actions:
            if isinstance(action, Assign):
                yield action, list(conditions)


def needs(flat: FlatModel, dependence: Dependence) -> dict[str, list[str]]:
    """For each variable that a clause assigns those others whose new values it takes."""
    found: dict[str, dict[str, None]] = {}
    for when in flat.events.whens:
        for action, conditions in assignments(when):
            read = dependence.of_all([*conditions, *parts(action)])
            found.setdefault(action.variable, {}).update(dict.fromkeys(read))
    return {name: [each for each in read if each in found] for name, read in found.items()}


def parts(action: Action) -> Iterator[FlatExpression]:
    """The expressions of an action."""
    if action.guard is not None:
        yield action.guard
    match action:
        case Assign(value=value) | Reset(value=value):
            yield value
        case Impact(gap=gap, restitution=restitution):
            yield gap
            yield restitution
        case Check(condition=condition):
            yield condition
        case Terminate():
            pass
