"""W0520: corners and jumps along the motion in positions of masses and in energies.

A bead on a track `y = abs(x)` meets a corner at which its velocity jumps. The balance of momenta does not determine the
jump: it depends on the materials of bead and track. The simulation takes the limit of a steep smooth Lagrangian
(`docs/adr/0071`), at functions such as `abs` as at relations: their branches become relations. Where a constraint has
the corner, only its impulse acts. Jumps of functions such as `floor` leave the rates of coordinates (`docs/adr/0070`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import assert_never

from lagdsl.diagnostics import Sink
from lagdsl.flat import expression as fx
from lagdsl.flat import model as fm
from lagdsl.flat.dependence import Dependence
from lagdsl.flat.events import Corner, Relation
from lagdsl.flat.quantity import Spans
from lagdsl.flat.reached import reached
from lagdsl.semantics.scope.product import Met
from lagdsl.semantics.scope.values import Order
from lagdsl.source import Span

_JUMPING = ("floor", "ceil", "mod")
_AT_A_JUMP = "the simulation keeps the rates of the coordinates there"
_AT_A_RELATION = "the simulation takes the limit of a steep smooth change there"
_AT_A_CONSTRAINT = "only the impulse of the constraint acts there, as in an inelastic blow"


def corners_of_motion(corners: Sequence[Met], flat: fm.FlatModel) -> tuple[Corner, ...]:
    """Corners of forces, energies, constraints, gaps and rates of states, in the order of the text."""
    if not corners:
        return ()
    found = {id(x) for x in reached(flat, _what_moves(flat))}
    return tuple(
        Corner(spans=each.spans, distance=each.distance, solved=each.order >= Order.ACCELERATION)
        for each in corners
        if id(each.expression) in found
    )


def _what_moves(flat: fm.FlatModel) -> Iterator[fx.FlatExpression]:
    """All expressions on which accelerations and rates depend."""
    yield from (term.value for term in flat.energies)
    for mass in flat.masses:
        yield from (mass.mass, mass.position)
    for body in flat.bodies:
        yield from (body.mass, *body.com, *body.inertia, fx.FrameOrigin(body.frame))
    if flat.gravity is not None:
        yield flat.gravity
    for load in flat.loads:
        match load:
            case fm.PointForce():
                yield from (load.force, load.point)
                yield from () if load.origin is None else (load.origin,)
            case fm.FrameTorque():
                yield from (load.torque, fx.AngularVelocity(load.frame))
            case fm.GeneralizedForce():
                yield from (load.value, load.target)
                yield from () if load.origin is None else (load.origin,)
            case _:
                assert_never(load)
    for constraint in flat.constraints:
        yield from constraint.residuals
    yield from (contact.gap for contact in flat.events.contacts)
    yield from (state.derivative for state in flat.states)


def over_which_velocities_jump(corners: Sequence[Met], flat: fm.FlatModel) -> frozenset[Spans]:
    """Places of functions with a corner in the way of a mass: their branches are to change at events."""
    found = {id(x) for x in reached(flat, _ways(flat))} if corners else set()
    return frozenset(
        each.spans for each in corners if id(each.expression) in found and _bends(each) and not _jumps(each.expression)
    )


def check_corners(corners: Sequence[Met], flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """W0520 for each text with a corner over which velocities or energies jump; `corners` are those that move."""
    branching = _relations_of_the_motion(flat, dependence)
    if not corners and not branching:
        return
    energies = [term.value for term in flat.energies if term.kind != "dissipation"]
    held = [x for each in flat.constraints if each.level == "position" and not each.contact for x in each.residuals]
    _tell(_ways(flat), "velocities of masses jump", branching, _AT_A_RELATION, flat, sink)
    _tell(held, "velocities jump", _without_switches(held, branching), _AT_A_CONSTRAINT, flat, sink)
    for what, roots, law, tells in (
        ("velocities of masses jump", _ways(flat), _AT_A_JUMP, _bends),
        ("velocities jump", held, _AT_A_CONSTRAINT, _bends),
        ("an energy jumps", energies, _AT_A_JUMP, lambda each: _jumps(each.expression)),
    ):
        found = {id(x) for x in reached(flat, roots)}
        told: set[Span] = set()
        for each in corners:
            span = each.spans[0]
            if id(each.expression) in found and span not in told and tells(each):
                told.add(span)
                sink.report("W0520", span, name=span.text, what=what, law=law)


def _ways(flat: fm.FlatModel) -> list[fx.FlatExpression]:
    """Positions of masses, and what the kinetic energy differentiates."""
    places = [mass.position for mass in flat.masses] + [fx.FrameOrigin(body.frame) for body in flat.bodies]
    kinetic = [term.value for term in flat.energies if term.kind in ("kinetic", "lagrangian")]
    return [*places, *(x.operand for x in reached(flat, kinetic) if isinstance(x, fx.Derivative))]


def _tell(
    roots: Sequence[fx.FlatExpression],
    what: str,
    branching: dict[str, Relation],
    law: str,
    flat: fm.FlatModel,
    sink: Sink,
) -> None:
    """W0520 for the relations of the motion on which these depend."""
    for name in dict.fromkeys(x.name for x in reached(flat, roots) if isinstance(x, fx.Variable)):
        if name in branching:
            span = branching[name].spans[0]
            sink.report("W0520", span, name=span.text, what=what, law=law)


def _without_switches(roots: Sequence[fx.FlatExpression], branching: dict[str, Relation]) -> dict[str, Relation]:
    """Without relations that switch a constraint on and off: `(if l > l0 then l - l0 else 0) = 0`."""
    sides = [x.left if isinstance(x, fx.Binary) and x.operator == "-" and x.right == fx.ZERO else x for x in roots]
    switched = [x for x in sides if isinstance(x, fx.Conditional) and fx.ZERO in (x.value, x.otherwise)]
    off = {x.condition.name for x in switched if isinstance(x.condition, fx.Variable)}
    return {name: each for name, each in branching.items() if name not in off}


def check_changing_inertia(flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """N0521 for each discrete variable of which the kinetic energy is made: what is kept where it changes."""
    inertias = [term.value for term in flat.energies if term.kind == "kinetic"]
    inertias += [mass.mass for mass in flat.masses]
    inertias += [x for body in flat.bodies for x in (body.mass, *body.com, *body.inertia)]
    found = dependence.of_all(inertias)
    for discrete in flat.events.discretes:
        if discrete.name in found:
            sink.report("N0521", discrete.spans[0], name=discrete.name)


def _relations_of_the_motion(flat: fm.FlatModel, dependence: Dependence) -> dict[str, Relation]:
    """Relations that coordinates or states turn, by name."""
    moving = {item.name for item in (*flat.coordinates, *flat.states)}
    return {
        each.name: each
        for each in flat.events.relations
        if each.spans and not moving.isdisjoint(dependence.of(each.difference))
    }


def _bends(each: Met) -> bool:
    return each.sharp and each.order >= Order.CONFIGURATION


def _jumps(expression: fx.FlatExpression) -> bool:
    return isinstance(expression, fx.Function) and expression.name in _JUMPING
