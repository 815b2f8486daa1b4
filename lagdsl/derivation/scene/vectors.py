"""Arrows that one can switch on: velocities, accelerations, admissible motions, reactions, constraint forces, dry
friction.

They are outputs of a model of their own, which has the same equations, so that a page computes them only while somebody
looks at them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from typing import Literal

from lagdsl.derivation.scene.drawings import mass_centre, sum_of
from lagdsl.derivation.scene.living import Living, with_scene
from lagdsl.derivation.scene.looks import dressed
from lagdsl.derivation.scene.rubbing import Rubbing
from lagdsl.derivation.scene.shapes import Shape, ShapeKind, scene_with
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
_OF_JOINTS: tuple[tuple[ShapeKind, Literal["force", "torque"]], ...] = (
    ("reaction", "force"),
    ("reaction torque", "torque"),
)
UNITS: dict[ShapeKind, str] = {
    "velocity": "m/s",
    "acceleration": "m/s2",
    "reaction": "N",
    "reaction torque": "N.m",
    "constraint": "N",
    "friction": "N",
}
"""Of the numbers behind an arrow; admissible motions have that of their coordinate."""


@record()
class _Place:
    """A mass or the mass centre of a body, with the coordinates that move it."""

    name: str
    position: fx.FlatExpression
    moved: tuple[str, ...]
    spans: Spans


def with_vectors(flat: fm.FlatModel, starts: Collection[str] = ()) -> Living:
    """The model with its arrows as its only outputs, and with the parameters that `living` gives it."""
    places = _places(flat)
    shapes = [*_motions(places), *_admissible(flat, places), *_reactions(flat)]
    shapes += [*_constraint_forces(flat, places), *_frictions(flat)]
    scene = scene_with(dressed(shapes, planar=False), planar=False)
    return with_scene(replace(flat, outputs=(), invariants=()), scene, starts)


def _places(flat: fm.FlatModel) -> tuple[_Place, ...]:
    dependence = Dependence(flat)
    found = [(_name_of(item.position, k), item.position, item.spans) for k, item in enumerate(flat.masses, 1)]
    for k, body in enumerate(flat.bodies, 1):
        found.append((body.label or f"body {k}", mass_centre(body), body.spans))
    coordinates = [item.name for item in flat.coordinates]
    moved = [frozenset(dependence.of(position)) for _, position, _ in found]
    return tuple(
        _Place(name, position, tuple(each for each in coordinates if each in own), spans)
        for (name, position, spans), own in zip(found, moved, strict=True)
        if own & set(coordinates) or "time" in own
    )


def _name_of(position: fx.FlatExpression, number: int) -> str:
    return position.name if isinstance(position, fx.PointReference) else f"mass {number}"


def _motions(places: tuple[_Place, ...]) -> Iterator[Shape]:
    """Velocities, then accelerations."""
    for place in places:
        yield _arrow("velocity", place, fx.Derivative(place.position))
    for place in places:
        yield _arrow("acceleration", place, fx.Derivative(fx.Derivative(place.position)))


def _admissible(flat: fm.FlatModel, places: tuple[_Place, ...]) -> Iterator[Shape]:
    """dr/dq_j of each mass: with others held, a coordinate moves it along this arrow (d'Alembert's virtual motions)."""
    units = {item.name: item.unit for item in flat.coordinates}
    moving = [(place, name) for place in places for name in place.moved]
    for place, name in moving[:_MOST_MOTIONS]:
        shape = _arrow("admissible", place, fx.AdmissibleMotion(place.position, name))
        unit = "m" if units[name] in ("rad", "1") else f"m/({units[name]})" if units[name] != "m" else "1"
        yield replace(shape, texts={"coordinate": name, "unit": unit})


def _reactions(flat: fm.FlatModel) -> Iterator[Shape]:
    """Of joints that close no loop, and of frames with a body and points with a mass that belong to no joint: what
    keeps them on their way."""
    frames = {item.name: item for item in flat.named if isinstance(item, fm.Frame)}
    carried = [(joint.name, _carried(joint, frames), joint.spans) for joint in flat.joints if not joint.cut]
    of_joints = {frame for _, frame, _ in carried}
    dependence = Dependence(flat)
    coordinates = {item.name for item in flat.coordinates}
    if not flat.joints:
        bodies = {body.frame: body.spans for body in flat.bodies if body.frame in frames}
        moving = [name for name in bodies if coordinates & set(dependence.of(fx.FrameAxis(name, 0)))]
        carried += [(name, name, bodies[name]) for name in moving if name not in of_joints]
    for name, frame, spans in carried[:MOST_POINTS]:
        if frame is None:
            continue
        place = _Place(f"reaction({name})", fx.FrameOrigin(frame), (), spans)
        for kind, what in _OF_JOINTS:
            yield _arrow(kind, place, fx.FrameReaction(frame, what), f"{place.name}.{what}")
    points = {item.position.name: item.spans for item in flat.masses if isinstance(item.position, fx.PointReference)}
    for name, spans in list(points.items())[:MOST_POINTS]:
        force = fx.Vector(*(fx.ReactionAlong(name, axis) for axis in _AXES))
        yield _arrow("reaction", _Place(f"reaction({name})", fx.PointReference(name), (), spans), force)


def _carried(joint: fm.Joint, frames: dict[str, fm.Frame]) -> str | None:
    """The frame of a joint that is built on the other one: what the joint carries."""
    for own, other in ((joint.frame_b, joint.frame_a), (joint.frame_a, joint.frame_b)):
        name = own
        while name in frames:
            name = frames[name].parent
            if name == other:
                return own
    return None


def _constraint_forces(flat: fm.FlatModel, places: tuple[_Place, ...]) -> Iterator[Shape]:
    """lambda dphi/dr of each position constraint on the masses whose position is coordinates alone."""
    points = {item.name: item.position for item in flat.named if isinstance(item, fm.Point)}
    dependence = Dependence(flat)
    for place in places:
        position = place.position
        while isinstance(position, fx.PointReference):
            position = points[position.name]
        names = _cartesian(position, place.moved)
        if names is None:
            continue
        for constraint in flat.constraints:
            if constraint.level != "position" or constraint.normalisation or constraint.node:
                continue
            for row, residual in zip(constraint.rows, constraint.residuals, strict=True):
                if not set(dependence.of(residual)) & set(place.moved):
                    continue
                force = fx.Vector(*(_slope(residual, name, row) for name in names))
                shape = _arrow("constraint", place, force, f"{row} on {place.name}")
                yield replace(shape, spans=constraint.spans)


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


def _cartesian(position: fx.FlatExpression, moved: tuple[str, ...]) -> tuple[str | None, ...] | None:
    """The coordinates that are the components of a position, None for a component that stays; None for any other."""
    if not isinstance(position, fx.Vector):
        return None
    names = [part.name if isinstance(part, fx.Variable) else None for part in (position.x, position.y, position.z)]
    rests = (isinstance(part, fx.Number) for part in (position.x, position.y, position.z))
    if not all(name in moved or still for name, still in zip(names, rests, strict=True)):
        return None
    return tuple(names) if any(names) else None


def _arrow(kind: ShapeKind, place: _Place, vector: fx.FlatExpression, name: str = "") -> Shape:
    numbers = {"at": place.position, "vector": vector}
    return Shape(kind=kind, name=name or place.name, numbers=numbers, spans=place.spans)
