"""Events as text (`lag flat`): discretes, contacts, friction, relations that are located, clocks, clauses."""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from lagdsl.foundation.units.naming import unit_text
from lagdsl.language.flat import events as fe
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.expression_text import flat_expression_text as text_of
from lagdsl.language.flat.expression_text import number_text
from lagdsl.language.flat.quantity import Item

Line = tuple[str, Item | None]


def level_text(warning: bool) -> str:
    """The third argument of an assertion that is a warning."""
    return ", AssertionLevel.warning" if warning else ""


def event_sections(events: fe.Events) -> list[tuple[str, list[Line]]]:
    """Titles and their lines; empty ones too."""
    return [
        ("discretes", [_discrete(each) for each in events.discretes]),
        ("contacts", [_contact(each) for each in events.contacts]),
        ("frictions", [_friction(each) for each in events.frictions]),
        ("feedbacks", [_feedback(each) for each in events.feedbacks]),
        (
            "delays",
            [(f"{each.name}: {text_of(each.value)}, {text_of(each.time)} s ago", each) for each in events.delays],
        ),
        ("located", [(f"{each.name}: {_located(each)}", each) for each in events.relations]),
        ("timed", [(f"{each.name}: {text_of(each.value)}", each) for each in events.timed]),
        (
            "clocks",
            [(f"{each.name}: {text_of(each.start)} s, every {text_of(each.period)} s", each) for each in events.clocks],
        ),
        ("remembered", [(f"{each.name}: {text_of(each.value)}", each) for each in events.memories]),
        ("events", [line for when in events.whens for line in _when(when)]),
    ]


def _discrete(item: fe.Discrete) -> Line:
    bounds = "".join(
        f", {n} = {number_text(v)}" for n, v in (("min", item.minimum), ("max", item.maximum)) if v is not None
    )
    start = text_of(item.start)
    if item.kind == "Boolean":
        start = {"0": "false", "1": "true"}.get(start, start)
    doc = "" if item.doc is None else f'  "{item.doc}"'
    return f"{item.type_name} {item.name} [{item.unit}], start = {start}{bounds}{doc}", item


def _contact(item: fe.Contact) -> Line:
    options = [("restitution", item.restitution), ("v_stick", item.capture_speed), ("t_eps", item.zeno_time)]
    law = ", ".join(f"{name} = {text_of(value)}" for name, value in options if value is not None)
    return f"{item.name} [{unit_text(item.dimension)}]: {text_of(item.gap)} >= 0 with {law}", item


def _friction(item: fe.Friction) -> Line:
    slip = ", ".join(map(text_of, item.slips))
    law = f"limit = {text_of(item.limit)}"
    law += "" if item.sticking is None else f", sticking = {text_of(item.sticking)}"
    under = "" if item.contact is None else f", under {item.contact}"
    slip = slip if len(item.slips) == 1 else f"{{{slip}}}"
    return f"{item.name} [{unit_text(item.dimension)}]: {slip} with {law}{under}", item


def _feedback(item: fe.Feedback) -> Line:
    return f"{item.name} [{unit_text(item.dimension)}]: {text_of(item.value)}", item


def _located(item: fe.Relation) -> str:
    return f"{text_of(item.difference)} {'>' if item.strict else '>='} 0 [{unit_text(item.dimension)}]"


def _when(when: fe.When) -> Iterator[Line]:
    word = "when"
    for branch in when.branches:
        conditions = [text_of(condition) for condition in branch.conditions]
        condition = conditions[0] if len(conditions) == 1 else f"{{{', '.join(conditions)}}}"
        yield f"{word} {condition} then", branch
        for action in branch.actions:
            guard = "" if action.guard is None else f"if {text_of(action.guard)}: "
            yield f"  {guard}{action_text(action)}", action
        word = "elsewhen"


def action_text(action: fe.Action) -> str:
    match action:
        case fe.Assign():
            return f"{action.variable} = {text_of(action.value)}"
        case fe.Reset():
            target = f"der({action.name})" if action.rate else action.name
            return f"reinit({target}, {text_of(action.value)})"
        case fe.Impact():
            return f"impact({_both(action.gap, action.restitution)})"
        case fe.Terminate():
            return f'terminate("{action.message}")'
        case fe.Check():
            return f'assert({text_of(action.condition)}, "{action.message}"{level_text(action.warning)})'
        case _:
            assert_never(action)


def _both(one: FlatExpression, two: FlatExpression) -> str:
    return f"{text_of(one)}, {text_of(two)}"
