"""Corners of the motion: discontinuities that the equations read as they stand. Steps end at them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.events import Corner
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.reached import reached
from lagdsl.language.semantics.discontinuities.distances import distances
from lagdsl.language.semantics.scope.product import Met
from lagdsl.language.semantics.scope.values import Order
from lagdsl.language.semantics.wellformed.effect import load_expressions


def with_corners(flat: fm.FlatModel, kinks: Sequence[Met]) -> fm.FlatModel:
    """`flat` with its corners, in the order of the text: those of forces, energies, constraints, gaps and rates of
    states, at which steps end, and the others."""
    if not kinks:
        return flat
    motion = list(what_moves(flat))
    found = {id(x) for x in reached(flat, [*motion, *(x.difference for x in flat.events.relations)])}
    seen = {id(x) for x in reached(flat, [*motion, *(output.value for output in flat.outputs)])}
    located = [each for each in kinks if each.located and id(each.expression) in found]
    known = {id(each) for each in located}
    others = [each for each in kinks if id(each.expression) in seen and id(each) not in known]
    events = replace(flat.events, corners=tuple(_corners(located)), others=tuple(_corners(others)))
    return replace(flat, events=events)


def _corners(kinks: Sequence[Met]) -> Iterator[Corner]:
    """One for tables that bend at the same places, as the rows of a surface do."""
    seen: set[tuple[int, tuple[float, ...], bool]] = set()
    for met in kinks:
        if met.pieces is not None:
            borders = (id(met.pieces.x), met.pieces.borders, met.order >= Order.ACCELERATION)
            if borders in seen:
                continue
            seen.add(borders)
        for distance in distances(met):
            yield Corner(spans=met.spans, distance=distance, solved=met.order >= Order.ACCELERATION)


def what_moves(flat: fm.FlatModel) -> Iterator[FlatExpression]:
    """All expressions on which accelerations and rates depend."""
    yield from (term.value for term in flat.energies)
    for mass in flat.masses:
        yield from (mass.mass, mass.position)
    for body in flat.bodies:
        yield from (body.mass, *body.com, *body.inertia, fx.FrameOrigin(body.frame))
    if flat.gravity is not None:
        yield flat.gravity
    for load in flat.loads:
        yield from load_expressions(load)
        if isinstance(load, fm.FrameTorque):
            yield fx.AngularVelocity(load.frame)
    for constraint in flat.constraints:
        yield from constraint.residuals
    yield from (contact.gap for contact in flat.events.contacts)
    yield from (feedback.value for feedback in flat.events.feedbacks)
    yield from (delay.value for delay in flat.events.delays)
    yield from (state.derivative for state in flat.states)
