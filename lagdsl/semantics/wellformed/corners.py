"""Corners and jumps of the motion in what momenta and energies are made of: what happens there is not decided.

A bead on a track `y = abs(x)` meets a corner at which velocities jump, and no balance says how: that depends on what
the bead and the track are made of. A step of the potential energy takes or gives kinetic energy in a direction that the
step alone does not tell.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from lagdsl.diagnostics import Sink
from lagdsl.flat import expression as fx
from lagdsl.flat import model as fm
from lagdsl.flat.dependence import Dependence
from lagdsl.flat.events import Relation
from lagdsl.flat.traversal import operands, step_expressions
from lagdsl.source import Span

Corner = tuple[fx.FlatExpression, Span]

_JUMPING = ("floor", "ceil", "mod")


def check_corners(corners: Sequence[Corner], flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """W0520 for each text with a corner over which velocities or energies jump; `corners` are those that move."""
    branching = _relations_of_the_motion(flat, dependence)
    if not corners and not branching:
        return
    places = [mass.position for mass in flat.masses] + [fx.FrameOrigin(body.frame) for body in flat.bodies]
    energies = [term.value for term in flat.energies if term.kind != "dissipation"]
    kinetic = [term.value for term in flat.energies if term.kind in ("kinetic", "lagrangian")]
    differentiated = [x.operand for x in _reached(flat, kinetic) if isinstance(x, fx.Derivative)]
    for what, roots, jumps_only in (
        ("velocities of masses jump", [*places, *differentiated], False),
        ("an energy jumps", energies, True),
    ):
        found = {id(x): x for x in _reached(flat, roots)}
        told: set[Span] = set()
        for name in [] if jumps_only else dict.fromkeys(x.name for x in found.values() if isinstance(x, fx.Variable)):
            if name in branching:
                sink.report("W0520", branching[name].spans[0], name=branching[name].spans[0].text, what=what)
        for expression, span in corners:
            if id(expression) in found and span not in told and (_jumps(expression) or not jumps_only):
                told.add(span)
                sink.report("W0520", span, name=span.text, what=what)


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


def _reached(flat: fm.FlatModel, roots: Iterable[fx.FlatExpression]) -> Iterator[fx.FlatExpression]:
    """Every expression below the roots, also behind names, once."""
    named = {item.name: item for item in flat.named}
    seen: set[int] = set()
    stack = list(roots)
    while stack:
        expression = stack.pop()
        if id(expression) not in seen:
            seen.add(id(expression))
            yield expression
            stack += operands(expression)
            stack += _behind(expression, named)


def _behind(expression: fx.FlatExpression, named: dict[str, fm.Named]) -> list[fx.FlatExpression]:
    """What a name stands for."""
    match expression:
        case fx.Variable(name) | fx.PointReference(name):
            item = named.get(name)
        case fx.FrameOrigin(frame) | fx.FrameAxis(frame=frame) | fx.AngularVelocity(frame):
            item = named.get(frame)
        case fx.MaterialVelocity(frame=frame):
            item = named.get(frame)
        case _:
            item = None
    match item:
        case fm.Definition():
            return [item.value]
        case fm.Point():
            return [item.position]
        case fm.Frame():
            found: list[fx.FlatExpression] = [x for step in item.steps for x in step_expressions(step)]
            return [*found, fx.FrameOrigin(item.parent)]
        case None:
            return []
