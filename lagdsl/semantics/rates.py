"""Rates in their place: inputs that must be smooth (E0304), velocity constraints that must be linear (E0604)."""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.diagnostics import Sink
from lagdsl.semantics.flat_degree import RateDegree
from lagdsl.semantics.flat_dependence import Dependence, Orders
from lagdsl.semantics.flat_expression import FlatExpression
from lagdsl.semantics.flat_model import FlatModel
from lagdsl.semantics.flat_spans import around
from lagdsl.semantics.wellformed_effect import load_expressions
from lagdsl.source import Span


def check_linear(flat: FlatModel, dependence: Dependence, sink: Sink) -> None:
    """Velocity constraints are linear in the rates; what cancels is not seen."""
    degree = RateDegree(dependence)
    for constraint in flat.constraints:
        if constraint.level == "velocity" and any(degree.of(row) > 1 for row in constraint.residuals):
            sink.report("E0604", constraint.spans[0], *around(constraint), name=constraint.name)


def check_inputs(flat: FlatModel, dependence: Dependence, sink: Sink) -> None:
    """Compare the derivatives of inputs that the equations contain with what `smooth` declares."""
    inputs = {item.name: item for item in flat.inputs if item.derivative_of is None}
    reported: set[str] = set()
    for orders, extra, span, what in _uses(flat, dependence) if inputs else ():
        for name, order in orders.items():
            if name in inputs and order + extra > inputs[name].smooth and name not in reported:
                reported.add(name)
                needed = order + extra
                times = {1: "once", 2: "twice"}.get(needed, f"{needed} times")
                type_name = inputs[name].type_name
                sink.report("E0304", span, name=name, what=what, times=times, type=type_name, count=needed)


Use = tuple[Orders, int, Span, str]


def _uses(flat: FlatModel, dependence: Dependence) -> Iterator[Use]:
    """What items depend on, with the number of time derivatives that the equations of motion take of it."""
    for mass in flat.masses:
        yield dependence.of(mass.position), 2, mass.spans[0], "moves a mass"
    for body in flat.bodies:
        yield dependence.of_frame(body.frame), 2, body.spans[0], "moves a body"
    for energy in flat.energies:
        # d/dt of dL/dqd differentiates once what stands beside rates.
        extra = 1 if energy.kind in ("kinetic", "lagrangian") else 0
        yield dependence.of(energy.value), extra, energy.spans[0], f"occurs in `{energy.kind}`"
    for constraint in flat.constraints:
        extra = 2 if constraint.level == "position" else 1
        yield dependence.of_all(constraint.residuals), extra, constraint.spans[0], "occurs in a constraint"
    for value, span, what in _values(flat):
        yield dependence.of(value), 0, span, what


def _values(flat: FlatModel) -> Iterator[tuple[FlatExpression, Span, str]]:
    """Expressions that are evaluated as they stand."""
    for load in flat.loads:
        for value in load_expressions(load):
            yield value, load.spans[0], "occurs in a load"
    for state in flat.states:
        yield state.derivative, state.spans[0], f"drives `{state.name}`"
    for output in flat.outputs:
        yield output.value, output.spans[0], f"occurs in `{output.name}`"
    for invariant in flat.invariants:
        yield invariant.value, invariant.spans[0], f"occurs in `{invariant.name}`"
    for assertion in flat.assertions:
        yield assertion.condition, assertion.spans[0], "occurs in an assertion"
