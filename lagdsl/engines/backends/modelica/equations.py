"""The equations of the file."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import assert_never

from lagdsl.algebra.graph.operation import Group
from lagdsl.engines.backends.modelica.body import Body
from lagdsl.engines.backends.modelica.clauses import Action, Clause
from lagdsl.engines.backends.modelica.names import quoted, text
from lagdsl.engines.backends.modelica.variables import acceleration, multiplier, rate
from lagdsl.language.flat.events import Assign, Check, Discrete, Reset, Terminate, entries
from lagdsl.language.flat.listing import discrete_outputs


def equations_of(body: Body) -> list[str]:
    """All of them, one a line; `when` clauses over several."""
    return [*_shared(body), *_motion(body), *_outputs(body), *_standing(body), *_assertions(body), *_whens(body)]


def _shared(body: Body) -> Iterator[str]:
    for node, name in body.shared.items():
        if not body.depends_on_parameters_only(node):
            yield f"{name} = {body.expressions.definition(node)};"


def _motion(body: Body) -> Iterator[str]:
    flat, number, found = body.flat, body.expressions.number, body.nodes.motion
    for item in flat.coordinates:
        yield f"der({quoted(item.name)}) = {rate(item.name)};"
        yield f"der({rate(item.name)}) = {acceleration(item.name)};"
    for item, node in zip(flat.coordinates, found.accelerations, strict=False):
        if body.solved.get(node) != acceleration(item.name):
            yield f"{acceleration(item.name)} = {number(node)};"
    rows = [slot.name for slot in body.program.layout.constraints]
    for row, node in zip(rows, found.multipliers, strict=False):
        yield f"{multiplier(row)} = {number(node)};"
    for node in found.residuals:
        yield f"0 = {number(node)};"
    for index in found.idle:
        yield f"{multiplier(rows[index])} = 0;"
    for state, node in zip(flat.states, body.nodes.state_rates, strict=True):
        yield f"der({quoted(state.name)}) = {number(node)};"


def _outputs(body: Body) -> Iterator[str]:
    discrete = discrete_outputs(body.flat)  # clauses give them their values
    for item, node in zip(body.flat.outputs, body.nodes.outputs, strict=True):
        if item.name not in discrete:
            yield f"{quoted(item.name)} = {_value(body, node, item.base == 'Boolean')};"


def _standing(body: Body) -> Iterator[str]:
    """Delayed values, relations, and what time alone changes."""
    for name, (value, time) in body.nodes.delays.items():
        yield f"{quoted(name)} = delay({body.expressions.number(value)}, {body.expressions.number(time)});"
    for index, entry in enumerate(entries(body.flat.events)):
        if entry.name in body.nodes.standing:
            truth = body.expressions.is_truth(body.graph.symbol(Group.W, index))
            yield f"{quoted(entry.name)} = {_value(body, body.nodes.standing[entry.name], truth)};"


def _value(body: Body, node: int, truth: bool) -> str:
    return body.expressions.condition(node) if truth else body.expressions.number(node)


def _assertions(body: Body) -> Iterator[str]:
    for item, node in zip(body.flat.assertions, body.nodes.assertions, strict=True):
        if item.warning:
            yield f"assert({body.expressions.number(node)} > 0, {text(item.message)}, AssertionLevel.warning);"
        else:
            yield f"assert({body.expressions.condition(node)}, {text(item.message)});"


def _whens(body: Body) -> Iterator[str]:
    for when in body.nodes.whens:
        variables = list(dict.fromkeys(name for clause in when for name in _variables(clause)))
        for index, clause in enumerate(when):
            conditions = [body.expressions.condition(node) for node in clause.conditions]
            condition = conditions[0] if len(conditions) == 1 else f"{{{', '.join(conditions)}}}"
            yield f"{'elsewhen' if index else 'when'} {condition} then"
            yield from (f"  {line}" for line in _actions(body, clause, variables))
        yield "end when;"


def _variables(clause: Clause) -> list[str]:
    """Names of what a branch assigns."""
    return [action.item.variable for action in clause.actions if isinstance(action.item, Assign)]


def _actions(body: Body, clause: Clause, variables: Sequence[str]) -> Iterator[str]:
    """One equation for each of `variables`, as Modelica wants it in every branch; other actions one by one."""
    assigned = {name: f"pre({quoted(name)})" for name in variables}
    kinds = {each.name: each for each in body.flat.events.discretes}
    for action in clause.actions:
        if isinstance(action.item, Assign):
            variable = action.item.variable
            assigned[variable] = _assigned(body, action, kinds[variable], assigned[variable])
    yield from (f"{quoted(variable)} = {value};" for variable, value in assigned.items())
    for action in clause.actions:
        yield from _other(body, action)


def _assigned(body: Body, action: Action, variable: Discrete, before: str) -> str:
    assert action.value is not None
    value = _value(body, action.value, variable.kind == "Boolean")
    if action.guard is None:
        return value
    held = f"({before})" if before.startswith("if ") else before
    return f"if {body.expressions.condition(action.guard)} then ({value}) else {held}"


def _other(body: Body, action: Action) -> Iterator[str]:
    guard = None if action.guard is None else body.expressions.condition(action.guard)
    match action.item:
        case Assign():
            return
        case Reset(name=name, rate=of_rate):
            assert action.value is not None
            state, value = rate(name) if of_rate else quoted(name), body.expressions.number(action.value)
            yield f"reinit({state}, {value if guard is None else f'if {guard} then ({value}) else {state}'});"
        case Check(message=message, warning=warning):
            assert action.value is not None
            condition = body.expressions.condition(action.value)
            met = condition if guard is None else f"not ({guard}) or ({condition})"
            yield f"assert({met}, {text(message)}{', AssertionLevel.warning' if warning else ''});"
        case Terminate(message=message):
            call = f"terminate({text(message)});"
            yield from [call] if guard is None else [f"if {guard} then", f"  {call}", "end if;"]
        case _:
            assert_never(action.item)
