"""Delayed values where their derivatives would be needed (E0391)."""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence

from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.event_flow import branches
from lagdsl.language.flat.events import Impact
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Item
from lagdsl.language.flat.reached import reached
from lagdsl.language.flat.spans import place
from lagdsl.language.flat.traversal import records

Use = tuple[str, Sequence[FlatExpression], Item | None]


def check_delays(flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """E0390 for what is not known with the state. E0391: the equations differentiate energies, places of masses,
    constraints and gaps, by coordinates or by time."""
    delays = {each.name: each for each in flat.events.delays}
    observed = {each.name for each in flat.observed}
    moving = {item.name for item in flat.coordinates}
    for delay in flat.events.delays:
        orders = dependence.of(delay.value)
        accelerates = any(orders[name] > 1 for name in orders.differentiated() if name in moving)
        if accelerates or any(
            isinstance(x, fx.Mechanical) or _is_in(x, observed) for x in reached(flat, [delay.value])
        ):
            sink.report("E0390", place(delay))
    for what, roots, item in _differentiated(flat) if delays else ():
        name = next((x.name for x in reached(flat, roots) if isinstance(x, fx.Variable) and x.name in delays), None)
        if name is not None:
            here = () if item is None else tuple(Label(span, "differentiated here") for span in item.spans[:1])
            sink.report("E0391", place(delays[name]), *here, name=name, what=what)


def _is_in(x: FlatExpression, names: Container[str]) -> bool:
    return isinstance(x, fx.Variable) and x.name in names


def _differentiated(flat: fm.FlatModel) -> Iterator[Use]:
    for term in flat.energies:
        yield ("the dissipation" if term.kind == "dissipation" else "an energy"), [term.value], term
    for mass in flat.masses:
        yield "a mass or its place", [mass.mass, mass.position], mass
    for body in flat.bodies:
        yield "a body or its place", [body.mass, *body.com, *body.inertia, fx.FrameOrigin(body.frame)], body
    if flat.gravity is not None:
        yield "the gravity", [flat.gravity], None
    for constraint in flat.constraints:
        if not constraint.of_law:
            yield "a constraint", constraint.residuals, constraint
    actions = (action for branch in branches(flat) for action in branch.actions)
    for contact in flat.events.contacts:
        yield "a gap", [contact.gap], contact
    for action in actions:
        if isinstance(action, Impact):
            yield "a gap", [action.gap], action
    for friction in flat.events.frictions:
        yield "a slip", friction.slips, friction
    yield from _written_derivatives(flat)


def _written_derivatives(flat: fm.FlatModel) -> Iterator[Use]:
    for node in records(flat):
        if isinstance(node, fx.Derivative):
            yield "`der(...)`", [node.operand], None
        elif isinstance(node, fx.MaterialVelocity | fx.AngularVelocity):
            yield "a velocity", [fx.FrameOrigin(node.frame)], None
