"""Rates in their place: inputs that must be smooth (E0304), velocity constraints that must be linear (E0604)."""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.degree import RateDegree
from lagdsl.language.flat.dependence import Dependence, Orders
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import FlatModel, Input
from lagdsl.language.flat.quantity import Item
from lagdsl.language.flat.spans import around, place
from lagdsl.language.semantics.wellformed.effect import load_expressions


def check_linear(flat: FlatModel, dependence: Dependence, sink: Sink) -> None:
    """E0604 for velocity constraints, E0382 for contacts of rates and E0387 for slips that are not linear in the rates,
    or have none; what cancels is not seen."""
    degree = RateDegree(dependence)
    coordinates = {coordinate.name for coordinate in flat.coordinates}

    def wrong(rate: FlatExpression) -> str | None:
        if degree.of(rate) > 1:
            return "not linear in the rates"
        still = coordinates.isdisjoint(dependence.of(rate).differentiated())
        return "no rate of a coordinate" if still else None

    for contact in flat.events.contacts:
        if contact.one_way and wrong(contact.gap) is not None:
            sink.report("E0382", place(contact), *around(contact))
    for friction in flat.events.frictions:
        faults = [found for found in map(wrong, friction.slips) if found is not None]
        if faults:
            sink.report("E0387", place(friction), *around(friction), found=faults[0])
    for constraint in flat.constraints:
        if constraint.of_law:
            continue
        if constraint.level == "velocity" and any(degree.of(row) > 1 for row in constraint.residuals):
            sink.report("E0604", constraint.spans[0], *around(constraint), name=constraint.name)


def check_inputs(flat: FlatModel, dependence: Dependence, sink: Sink) -> None:
    """Compare the derivatives of inputs that the equations contain with what `smooth` declares."""
    inputs = {item.name: item for item in flat.inputs if item.derivative_of is None}
    reported: set[str] = set()
    for orders, extra, item, what in _uses(flat, dependence) if inputs else ():
        for name, wanting in inputs.items():
            if name in orders and orders[name] + extra > wanting.smooth and name not in reported:
                reported.add(name)
                _report(wanting, item, what, orders[name] + extra, sink)


def _report(wanting: Input, item: Item, what: str, needed: int, sink: Sink) -> None:
    times = {1: "once", 2: "twice"}.get(needed, f"{needed} times")
    name, type_name = wanting.name, wanting.type_name
    sink.report("E0304", place(item), *around(item), name=name, what=what, times=times, type=type_name, count=needed)


Use = tuple[Orders, int, Item, str]


def _uses(flat: FlatModel, dependence: Dependence) -> Iterator[Use]:
    """Quantities that items depend on, with the number of time derivatives that the equations of motion take of
    each."""
    for mass in flat.masses:
        yield dependence.of(mass.position), 2, mass, "moves a mass"
    for body in flat.bodies:
        yield dependence.of_frame(body.frame), 2, body, "moves a body"
    for energy in flat.energies:
        # d/dt of dL/dqd differentiates once what stands beside rates.
        extra = 1 if energy.kind in ("kinetic", "lagrangian") else 0
        yield dependence.of(energy.value), extra, energy, f"occurs in `{energy.kind}`"
    for constraint in flat.constraints:
        extra = 2 if constraint.level == "position" else 1
        what = "occurs in a slip" if constraint.friction else "occurs in a constraint"
        yield dependence.of_all(constraint.residuals), extra, constraint, what
    for value, item, what in _values(flat):
        yield dependence.of(value), 0, item, what


def _values(flat: FlatModel) -> Iterator[tuple[FlatExpression, Item, str]]:
    """Expressions that are evaluated as they stand."""
    for load in flat.loads:
        for value in load_expressions(load):
            yield value, load, "occurs in a load"
    for feedback in flat.events.feedbacks:
        yield feedback.value, feedback, "occurs in a load"
    for delay in flat.events.delays:
        yield delay.value, delay, f"occurs in `{delay.name}`"
    for friction in flat.events.frictions:
        for value in (friction.limit, *(() if friction.sticking is None else (friction.sticking,))):
            yield value, friction, "occurs in a limit of friction"
    for state in flat.states:
        yield state.derivative, state, f"drives `{state.name}`"
    for output in flat.outputs:
        yield output.value, output, f"occurs in `{output.name}`"
    for invariant in flat.invariants:
        yield invariant.value, invariant, f"occurs in `{invariant.name}`"
    for assertion in flat.assertions:
        yield assertion.condition, assertion, "occurs in an assertion"
