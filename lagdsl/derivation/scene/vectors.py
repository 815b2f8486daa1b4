"""Arrows that one can switch on: velocities, accelerations, admissible motions, reactions, constraint forces, dry
friction.

They are outputs of a model of their own, which has the same equations, so that a page computes them only while somebody
looks at them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import Literal

from lagdsl.derivation.scene.drawings import mass_centre, sum_of
from lagdsl.derivation.scene.living import Living, with_scene
from lagdsl.derivation.scene.looks import dressed
from lagdsl.derivation.scene.rubbing import Rubbing
from lagdsl.derivation.scene.shapes import Shape, ShapeKind, acting, scene_with
from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.listing import force_unit, forces_of
from lagdsl.language.flat.quantity import Spans

MOST_POINTS = 24
"""Reactions are formed for so many points and joints at most; each is an equation of its own."""

_MOST_MOTIONS = 200
_AXES = tuple(fx.Vector(*(fx.Number(float(axis == k)) for k in range(3))) for axis in range(3))
_OF_JOINTS: dict[ShapeKind, Literal["force", "torque"]] = {"reaction": "force", "reaction torque": "torque"}


@record()
class _Element:
    """A mass or the mass centre of a body, with the coordinates that move it."""

    name: str
    position: fx.FlatExpression
    moved: tuple[str, ...]
    spans: Spans

    def arrow(self, kind: ShapeKind, vector: fx.FlatExpression) -> Shape:
        return acting(kind, self.name, self.position, vector, self.spans)


def with_vectors(flat: fm.FlatModel, starts: Collection[str] = ()) -> Living:
    """The model with its arrows as its only outputs, and with the parameters that `living` gives it."""
    carriers = list(_movable_elements(flat))
    shapes = [each.arrow("velocity", fx.Derivative(each.position)) for each in carriers]
    shapes += [each.arrow("acceleration", fx.Derivative(fx.Derivative(each.position))) for each in carriers]
    shapes += [*_admissible(flat, carriers), *_reactions(flat), *_constraint_forces(flat, carriers), *_frictions(flat)]
    scene = scene_with(dressed(shapes, planar=False), planar=False)
    return with_scene(replace(flat, outputs=(), invariants=()), scene, starts)


def _movable_elements(flat: fm.FlatModel) -> Iterator[_Element]:
    """Masses and bodies that move."""
    dependence = Dependence(flat)
    found = [
        (at.name if isinstance(at := item.position, fx.PointReference) else f"mass {k}", at, item.spans)
        for k, item in enumerate(flat.masses, 1)
    ]
    found += [(body.label or f"body {k}", mass_centre(body), body.spans) for k, body in enumerate(flat.bodies, 1)]
    for name, position, spans in found:
        own = dependence.of(position)
        moved = tuple(item.name for item in flat.coordinates if item.name in own)
        if moved or "time" in own:
            yield _Element(name, position, moved, spans)


def _admissible(flat: fm.FlatModel, carriers: Sequence[_Element]) -> Iterator[Shape]:
    """dr/dq_j of each mass: with others held, a coordinate moves it along this arrow (d'Alembert's virtual motions)."""
    units = {item.name: item.unit for item in flat.coordinates}
    moving = [(each, name) for each in carriers for name in each.moved]
    for each, name in moving[:_MOST_MOTIONS]:
        shape = each.arrow("admissible", fx.AdmissibleMotion(each.position, name))
        unit = "m" if units[name] in ("rad", "1") else f"m/({units[name]})" if units[name] != "m" else "1"
        yield replace(shape, texts={"coordinate": name, "unit": unit})


def _reactions(flat: fm.FlatModel) -> Iterator[Shape]:
    """Of joints that close no loop, and of frames with a body and points with a mass that belong to no joint: what
    keeps them on their way."""
    frames = {item.name: item for item in flat.named if isinstance(item, fm.Frame)}
    joints = ((joint, _carried(joint, frames)) for joint in flat.joints if not joint.cut)
    carried = [(joint.name, own, joint.spans) for joint, own in joints if own is not None]
    if not flat.joints:
        dependence, coordinates = Dependence(flat), {item.name for item in flat.coordinates}
        bodies = {body.frame: body.spans for body in flat.bodies if body.frame in frames}
        moving = (name for name in bodies if coordinates & set(dependence.of(fx.FrameAxis(name, 0))))
        carried += [(name, name, bodies[name]) for name in moving]
    for name, frame, spans in carried[:MOST_POINTS]:
        for kind, what in _OF_JOINTS.items():
            reaction = fx.FrameReaction(frame, what)
            yield acting(kind, f"reaction({name}).{what}", fx.FrameOrigin(frame), reaction, spans)
    points = {item.position.name: item.spans for item in flat.masses if isinstance(item.position, fx.PointReference)}
    for name, spans in list(points.items())[:MOST_POINTS]:
        force = fx.Vector(*(fx.ReactionAlong(name, axis) for axis in _AXES))
        yield acting("reaction", f"reaction({name})", fx.PointReference(name), force, spans)


def _carried(joint: fm.Joint, frames: dict[str, fm.Frame]) -> str | None:
    """The frame of a joint that is built on the other one: what the joint carries."""
    for own, other in ((joint.frame_b, joint.frame_a), (joint.frame_a, joint.frame_b)):
        name = own
        while name in frames:
            name = frames[name].parent
            if name == other:
                return own
    return None


def _constraint_forces(flat: fm.FlatModel, carriers: Sequence[_Element]) -> Iterator[Shape]:
    """lambda dphi/dr of each position constraint on the masses whose position is coordinates alone."""
    points = {item.name: item.position for item in flat.named if isinstance(item, fm.Point)}
    dependence = Dependence(flat)
    held = [each for each in flat.constraints if each.level == "position" and not (each.normalisation or each.node)]
    rows = [(each, *pair) for each in held for pair in zip(each.rows, each.residuals, strict=True)]
    for carrier in carriers:
        position = carrier.position
        while isinstance(position, fx.PointReference):
            position = points[position.name]
        names = _cartesian(position, carrier.moved)
        for constraint, row, residual in rows if names else ():
            if set(dependence.of(residual)) & set(carrier.moved):
                force = fx.Vector(*(_slope(residual, name, row) for name in names))
                yield acting("constraint", f"{row} on {carrier.name}", carrier.position, force, constraint.spans)


def _frictions(flat: fm.FlatModel) -> Iterator[Shape]:
    """Of each friction its mode (0: its contact is open, 1: it slides, 2: it sticks) and its force: as arrows where its
    slip is that of a point, else as a size alone."""
    rubbing = Rubbing(flat)
    for friction in flat.events.frictions:
        forces = forces_of(flat, friction)
        sticks = fx.Variable(friction.sticks)
        mode: fx.FlatExpression = fx.Conditional(sticks, fx.Number(2.0), fx.ONE)
        if friction.contact is not None:
            mode = fx.Conditional(fx.Variable(f"closed({friction.contact})"), mode, fx.ZERO)
        value = forces[0] if len(forces) == 1 else fx.Vector(forces[0], forces[1], fx.ZERO)
        told = {"mode": mode, "value": value}
        texts = {"unit": force_unit(friction), "components": str(len(forces))}
        places = rubbing.places(friction)
        shape = Shape(kind="friction", name=friction.name, numbers=told, texts=texts, spans=friction.spans)
        for place in places:
            parts = [fx.Binary("*", f, e) for f, e in zip(forces, place.directions, strict=True)]
            yield replace(shape, numbers={"at": place.at, "vector": sum_of(parts), **told})
        if not places:
            yield shape


def _slope(residual: fx.FlatExpression, name: str | None, row: str) -> fx.FlatExpression:
    if name is None:
        return fx.ZERO
    gradient = fx.AdmissibleMotion(fx.Vector(residual, fx.ZERO, fx.ZERO), name)
    return fx.Binary("*", fx.Multiplier(row), fx.Component(gradient, 0))


def _cartesian(position: fx.FlatExpression, moved: tuple[str, ...]) -> tuple[str | None, ...]:
    """The coordinates that are the components of a position, None for a component that stays; else nothing."""
    parts = (position.x, position.y, position.z) if isinstance(position, fx.Vector) else ()
    names = tuple(part.name if isinstance(part, fx.Variable) else None for part in parts)
    told = all(name in moved or isinstance(part, fx.Number) for name, part in zip(names, parts, strict=True))
    return names if told and any(names) else ()
