"""W0520: corners along the motion in positions of masses, in constraints and in rates of the kinetic energy.

A bead on a track `y = abs(x)` meets a corner at which its velocity jumps. The balance of momenta does not determine the
jump: it depends on the materials of bead and track. The simulation takes the limit of a rounded corner, which conserves
the energy (`docs/adr/0017`), at functions such as `abs` as at relations, in ways of coordinates as in constraints:
their branches become relations.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import assert_never

from lagdsl.diagnostics import Sink
from lagdsl.flat import expression as fx
from lagdsl.flat import model as fm
from lagdsl.flat.dependence import Dependence
from lagdsl.flat.event_flow import parts
from lagdsl.flat.events import Assign, Corner, Relation, Reset, SampledCorner
from lagdsl.flat.quantity import Spans
from lagdsl.flat.reached import reached, switch
from lagdsl.flat.traversal import operands
from lagdsl.flat.ways import ways
from lagdsl.semantics.scope.product import Met
from lagdsl.semantics.scope.values import Order

_JUMPING = ("floor", "ceil", "mod")


def with_corners(corners: Sequence[Met], flat: fm.FlatModel) -> fm.FlatModel:
    """`flat` with its corners, in the order of the text: those of forces, energies, constraints, gaps and rates of
    states, at which steps end, and the others."""
    if not corners:
        return flat
    motion = list(_what_moves(flat))
    found = {id(x) for x in reached(flat, [*motion, *(x.difference for x in flat.events.relations)])}
    seen = {id(x) for x in reached(flat, [*motion, *(output.value for output in flat.outputs)])}
    located = [each for each in corners if each.located and id(each.expression) in found]
    known = {id(each) for each in located}
    others = [each for each in corners if id(each.expression) in seen and id(each) not in known]
    events = replace(
        flat.events,
        corners=tuple(map(_corner, located)),
        others=tuple(map(_corner, others)),
        sampled=_sampled(corners, flat),
    )
    return replace(flat, events=events)


def _sampled(corners: Sequence[Met], flat: fm.FlatModel) -> tuple[SampledCorner, ...]:
    """The corners that clauses evaluate, with the variables and states that each of them reaches."""
    met = {id(each.expression): each for each in corners}
    found: dict[int, list[str]] = {}
    for when in flat.events.whens:
        for branch in when.branches:
            for action in branch.actions:
                if isinstance(action, Assign | Reset):
                    name = action.variable if isinstance(action, Assign) else action.name
                    for each in reached(flat, parts(action)):
                        if id(each) in met:
                            found.setdefault(id(each), []).append(name)
    told = [
        SampledCorner(
            spans=each.spans,
            name=" ".join(each.spans[0].text.split()),
            variables=tuple(dict.fromkeys(found[id(each.expression)])),
        )
        for each in corners
        if id(each.expression) in found
    ]
    return tuple({each.spans: each for each in told}.values())


def _corner(met: Met) -> Corner:
    return Corner(spans=met.spans, distance=met.distance, solved=met.order >= Order.ACCELERATION)


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
            case fm.RateForce():
                yield from (load.value, load.rate)
            case _:
                assert_never(load)
    for constraint in flat.constraints:
        yield from constraint.residuals
    yield from (contact.gap for contact in flat.events.contacts)
    yield from (feedback.value for feedback in flat.events.feedbacks)
    yield from (state.derivative for state in flat.states)


def over_which_velocities_jump(corners: Sequence[Met], flat: fm.FlatModel) -> frozenset[Spans]:
    """Places of functions with a corner in the way of a mass, in a constraint or in a gap, or with a jump in these, in
    a row of velocity level, in an energy or in a relation of these: their branches are to change at events."""
    corners = [each for each in corners if each.located]
    if not corners:
        return frozenset()
    gaps = [contact.gap for contact in flat.events.contacts if not contact.one_way]
    bending = {id(x) for x in reached(flat, [*ways(flat), *gaps])}
    bending |= {id(each.expression) for row in _held(flat) for each in corners if _bends_row(flat, row, each)}
    energies = [term.value for term in flat.energies if term.kind != "dissipation"]
    rows = [x for each in flat.constraints for x in each.residuals]
    deciding = [*ways(flat), *gaps, *energies, *rows]
    names = {x.name for x in reached(flat, deciding) if isinstance(x, fx.Variable)}
    deciding += [each.difference for each in flat.events.relations if each.name in names]
    jumping = {id(x) for x in reached(flat, deciding)}
    return frozenset(
        each.spans
        for each in corners
        if each.order >= Order.CONFIGURATION
        and (
            (id(each.expression) in bending and each.sharp)
            or (id(each.expression) in jumping and _jumps(each.expression))
        )
    )


def check_corners(flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """W0520 for each relation of the motion, written or of a function, over which velocities jump."""
    branching = _relations_of_the_motion(flat, dependence)
    if not branching:
        return
    held = _held(flat)
    for what, roots, relations in (
        ("velocities of masses", ways(flat), branching),
        ("velocities", held, _without_switches(held, branching)),
    ):
        for name in dict.fromkeys(x.name for x in reached(flat, roots) if isinstance(x, fx.Variable)):
            if name in relations:
                span = relations[name].spans[0]
                sink.report("W0520", span, name=span.text, what=what)


def _held(flat: fm.FlatModel) -> list[fx.FlatExpression]:
    """Residuals of constraints of position level, without those of contacts."""
    return [x for each in flat.constraints if each.level == "position" and not each.contact for x in each.residuals]


def _bends_row(flat: fm.FlatModel, row: fx.FlatExpression, each: Met) -> bool:
    """True if the row has this corner beside other quantities that move, as a track has; where there is nothing else,
    `max(l - l0, 0) = 0`, the row has no gradient on one side."""
    moving = {item.name for item in (*flat.coordinates, *flat.states)}
    if all(x is not each.expression for x in reached(flat, [row])):
        return False
    beside = reached(flat, [row], lambda x: () if x is each.expression else operands(x))
    return any(isinstance(x, fx.Variable) and x.name in moving for x in beside)


def _without_switches(roots: Sequence[fx.FlatExpression], branching: dict[str, Relation]) -> dict[str, Relation]:
    """Without relations that switch a constraint on and off: `(if l > l0 then l - l0 else 0) = 0`."""
    switches = [found for found in map(switch, roots) if found is not None]
    off = {each.condition.name for each in switches if isinstance(each.condition, fx.Variable)}
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


def _jumps(expression: fx.FlatExpression) -> bool:
    return isinstance(expression, fx.Function) and expression.name in _JUMPING
