"""Around the masses of a machine: grounds, tracks, loads, frames, and gauges of coordinates without a place."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

import numpy as np

from lagdsl.derivation.scene.drawings import on_frame
from lagdsl.derivation.scene.looks import COLORS, OTHER
from lagdsl.derivation.scene.machine import HELD, Machine, anchors_of, constant, fixed, number, on_body, vector
from lagdsl.derivation.scene.masses import radius_of
from lagdsl.derivation.scene.shapes import Numbers, Part, Shape, ShapeKind, Size, acting, scene_with
from lagdsl.derivation.scene.stage import BOARD
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.units.dimension import CHARGE
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.quantity import is_angle
from lagdsl.language.flat.traversal import postorder, substituted

# Beyond so many, axes of frames cover the picture.
_MOST_FRAMES = 60
_STEPS_OF_A_TRACK = 49
_FARTHEST = 6.0  # of its largest start value: so far the track of a length is drawn
_HELD_KINDS = frozenset({"rod", "rope", "spring", "damper", "body", "box", "cylinder"})
_CLEAR_GROUND = 0.3
_X, _Y, _Z = np.eye(3)
_MIDDLE, _RIGHT, _BACK, _BELOW = (fixed(each) for each in (0.0 * _X, _X, _Z, -1.35 * _Y))
"""Of the board of a gauge; its name stands below."""
_ON_A_BOARD: Numbers = {"at": _MIDDLE, "x": _RIGHT, "z": _BACK}


def grounds(machine: Machine) -> Iterator[Shape]:
    """The plane that a contact or a constraint keeps a point, the rim of a round body or a point of a body on or from:
    its gap then changes as n . P does, with one unit vector n at all positions."""
    seen: list[Floats] = []
    for item, gap in machine.gaps():
        found = None if isinstance(item, fm.Constraint) and _is_drawn_at(machine, gap) else _plane_of(machine, gap)
        if found is None:
            continue
        normal, foot = found
        n = fixed(normal)
        still = fx.Binary("*", fx.Dot(foot, n), n)
        at = vector(machine.positions[0], still)
        plane = np.array([*normal, *np.nan_to_num(at)])
        if any(np.abs(plane - other).max() <= HELD for other in seen):
            continue
        seen.append(plane)
        rests = constant(machine.places(still))
        place = {"at": still if rests else foot, "z": n}
        part = Part(form="ground", numbers=place, still=rests, opacity=_CLEAR_GROUND)
        yield Shape(kind="ground", name=item.name, numbers={"at": foot}, parts=(part,), spans=item.spans)


def _is_drawn_at(machine: Machine, gap: fx.FlatExpression) -> bool:
    """Is a point that a residual names drawn by hand, with what keeps it there?"""
    named = {node for node in postorder(gap) if isinstance(node, fx.PointReference)}
    drawings = (each for each in machine.flat.drawings if each.shape not in ("trace", "text"))
    return any(named & set(postorder(anchor)) for each in drawings for anchor in anchors_of(each))


def _plane_of(machine: Machine, gap: fx.FlatExpression) -> tuple[Floats, fx.FlatExpression] | None:
    """The unit normal of a plane, and a point of it."""
    flat, own = machine.flat, machine.movers_of(gap)
    if not own:
        return None
    bodies = {fx.FrameOrigin(body.frame): body for body in flat.bodies}
    for place in machine.points:
        movers = machine.movers_of(place)
        normal = machine.normal_of(gap, place, movers) if own <= movers else None
        if normal is None:
            continue
        n = fixed(normal)
        body = bodies.get(place) if isinstance(place, fx.FrameOrigin) else None
        reach = machine.radius_at(place) or (None if body is None else radius_of(machine, body))
        depth = gap if reach is None else fx.Binary("+", gap, reach)
        return normal, fx.Binary("-", place, fx.Binary("*", depth, n))
    for body in flat.bodies:
        found = machine.touching_point(body.frame, gap)
        if found is not None:
            n = fixed(found[0])
            return found[0], fx.Binary("-", on_body(body.frame, found[1]), fx.Binary("*", gap, n))
    return None


def supports(machine: Machine, shapes: Iterable[Shape], up: Floats) -> Iterator[Shape]:
    """A hatched plate where the ground holds an end of what turns about it: above what hangs, below what stands."""
    known, ats = set(machine.standing), (machine.start, *machine.positions)
    held = [each for each in shapes if each.kind in _HELD_KINDS and not any("wall" in part.form for part in each.parts)]
    for shape, numbers in ((each, part.numbers) for each in held for part in each.parts):
        for role, other in (("at", "to"), ("to", "at")) if {"at", "to"} <= numbers.keys() else ():
            end, far = (np.array([vector(at, numbers[each]) for at in ats]) for each in (role, other))
            way = far - end
            turns = not constant(way / np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-300))
            place = (np.round(end[1:], 9) + 0.0).tobytes()
            if turns and constant(end) and place not in known:
                known.add(place)
                z = fixed(-up if way[0] @ up < 0.0 else up)
                part = Part(form="wall", numbers={"at": numbers[role], "z": z})
                yield Shape(kind="support", name="support", numbers={}, parts=(part,), spans=shape.spans)


def tracks(machine: Machine) -> Iterator[Shape]:
    """The wire of a mass: a constraint that is solved for one of its two coordinates gives it, or the way that one
    coordinate takes it, if that is neither a line nor a circle about the place it is built on."""
    for mass in machine.flat.masses:
        points = _wire(machine, mass) or _way(machine, mass)
        if points:
            sizes = (Size(1.0), Size(1.0), Size(0.006))
            part = Part(primitive="line", form="points", numbers={}, points=tuple(points), sizes=sizes, still=True)
            yield Shape(kind="track", name="track", numbers={}, parts=(part,), spans=mass.spans)


def _wire(machine: Machine, mass: fm.PointMass) -> list[fx.FlatExpression]:
    movers = machine.movers_of(mass.position)
    for item, residual in machine.gaps():
        two = isinstance(item, fm.Constraint) and len(movers) == 2 and machine.movers_of(residual) == movers
        if not two or machine.normal_of(residual, mass.position, movers) is not None:  # a plane has its ground
            continue
        for free, solved in (sorted(movers), sorted(movers)[::-1]):
            slope = np.array([machine.derivatives(residual, [solved], seed) for seed in range(3)])
            if not (constant(slope) and slope[0]):
                continue
            rest = substituted(residual, {solved: fx.ZERO})
            height = fx.Binary("/", rest, fx.Number(-float(slope[0, 0])))
            place = substituted(machine.position_of(mass.position), {solved: height})
            return [substituted(place, {free: fx.Number(s)}) for s in _range(machine, free, movers)]
    return []


def _way(machine: Machine, mass: fm.PointMass) -> list[fx.FlatExpression]:
    movers = machine.movers_of(mass.position)
    if len(movers) != 1 or "time" in machine.dependence.of(mass.position) or machine.straight(mass.position):
        return []
    [name] = movers
    position = machine.position_of(mass.position)
    if any(isinstance(each, fx.PointReference | fx.FrameOrigin | fx.FrameAxis) for each in postorder(position)):
        return []
    points = [substituted(position, {name: fx.Number(s)}) for s in _range(machine, name, movers)]
    found = np.array([vector(machine.positions[0], point) for point in points[::6]])
    return points if np.isfinite(found).all() and not _on_a_circle(found) else []


def _on_a_circle(places: Floats) -> bool:
    """Is |r|^2 = 2 c . r + d for some c and d, as on a sphere, or do all places lie on a line?"""
    rows, squares = np.column_stack([2.0 * places, np.ones(len(places))]), np.sum(places**2, axis=1)
    found = np.linalg.lstsq(rows, squares, rcond=HELD)[0]
    leaves = np.linalg.svd(places - places[0], compute_uv=False)
    return bool(np.abs(rows @ found - squares).max() <= HELD * squares.max() or leaves[1] <= HELD * leaves[0])


def _range(machine: Machine, name: str, movers: Iterable[str]) -> list[float]:
    """A turn of an angle; of a length as far as its start values let one expect; within its bounds."""
    items = {each.name: each for each in machine.flat.coordinates}
    item, starts = items[name], [abs(number(machine.positions[0], items[each].start)) for each in movers]
    far = math.pi if is_angle(item) else _FARTHEST * max(starts) or 1.0
    low = -far if item.minimum is None else max(-far, item.minimum)
    high = far if item.maximum is None else min(far, item.maximum)
    return [float(value) for value in np.linspace(low, high, _STEPS_OF_A_TRACK)]


def loads(machine: Machine) -> Iterator[Shape]:
    """Forces at their points, torques at the origins of their frames, and loads on coordinates at what they move."""
    for load in machine.flat.loads:
        match load:
            case fm.PointForce():
                yield acting("force", load.label or "force", load.point, load.force, load.spans)
            case fm.FrameTorque():
                yield acting("torque", load.label or "torque", fx.FrameOrigin(load.frame), load.torque, load.spans)
            case fm.GeneralizedForce():
                for kind, place, axis in _acts_at(machine, load.target):
                    yield acting(kind, load.label or kind, place, fx.Binary("*", load.value, fixed(axis)), load.spans)
            case fm.RateForce():
                pass


def _acts_at(machine: Machine, target: fx.FlatExpression) -> list[tuple[ShapeKind, fx.FlatExpression, Floats]]:
    """The first thing that a coordinate alone shifts along a line or turns about a direction that does not change."""
    if not isinstance(target, fx.Variable):
        return []
    for point, name, move in machine.slides():
        if name == target.name:
            return [("force", point, move)]
    for body in machine.flat.bodies:
        omega = fx.AngularVelocity(body.frame)
        one, other = (vector(machine.at(seed, {target.name: 1.0}), omega) for seed in range(2))
        if abs(np.linalg.norm(one) - 1.0) <= HELD and np.abs(one - other).max() <= HELD:
            return [("torque", fx.FrameOrigin(body.frame), one)]
    return []


def frames(machine: Machine) -> Iterator[Shape]:
    """The axes of the world and of the named frames."""
    found = [item for item in machine.flat.named if isinstance(item, fm.Frame)][:_MOST_FRAMES]
    yield Shape(kind="frame", name="world", numbers=on_frame("world"), spans=())
    yield from (Shape(kind="frame", name=each.name, numbers=on_frame(each.name), spans=each.spans) for each in found)


def gauges(machine: Machine, shapes: Iterable[Shape]) -> Iterator[Shape]:
    """A dial for each angle and a slider for each other coordinate that moves nothing of what is drawn; charges flow in
    the diagram of a circuit, and frames between which one draws are sections of what bends."""
    anchors = (anchor for each in machine.flat.drawings for anchor in each.anchors)
    bent = sorted({anchor.frame for anchor in anchors if isinstance(anchor, fx.FrameOrigin)})
    turned = [fx.Component(fx.FrameAxis(frame, axis), k) for frame in bent for axis in (0, 1) for k in range(3)]
    drawn = (*scene_with(shapes, planar=False).columns, *turned)
    board = 0
    for coordinate in (each for each in machine.flat.coordinates if each.dimension != CHARGE):
        moved = machine.at(0, moved={coordinate.name: 0.1})
        # A ball that turns in its place depends on its angle, and nothing is seen of it.
        likely = [each for each in drawn if coordinate.name in machine.dependence.of(each)]
        before, after = (np.array([number(at, each) for each in likely]) for at in (machine.positions[0], moved))
        if not np.array_equal(before, after, equal_nan=True):
            continue
        kind: ShapeKind = "dial" if is_angle(coordinate) else "slider"
        value = fx.Variable(coordinate.name)
        parts = tuple(_gauge(kind, value, board))
        yield Shape(kind=kind, name=value.name, numbers={"value": value}, parts=parts, spans=coordinate.spans)
        board += 1


def _gauge(kind: ShapeKind, value: fx.FlatExpression, board: int) -> Iterator[Part]:
    """A rail with a carriage, a ring with a hand that stands upward at zero; the name below."""

    def part(form: str, sizes: tuple[float, float, float], own: Numbers = _ON_A_BOARD, color: str = OTHER) -> Part:
        x, y, z = (Size(size * BOARD) for size in sizes)
        return Part(form=form, numbers=own, sizes=(x, y, z), color=color, board=board)

    yield Part(primitive="label", numbers={"at": _BELOW}, board=board)
    if kind == "slider":
        yield part("cube", (2.2, 0.06, 0.06), color=COLORS["ground"])
        yield part("cube", (0.5, 0.5, 0.5), {**_ON_A_BOARD, "at": fx.Vector(value, fx.ZERO, fx.ZERO)})
        return
    sine, cosine = (fx.Function(name, (value,)) for name in ("sin", "cos"))
    yield part("wire ring", (1.0, 1.0, 1.0), color=COLORS["ground"])
    yield part("cylinder", (0.1, 0.1, 0.15))
    yield part("beam", (0.12, 0.12, 1.0), {"at": _MIDDLE, "to": fx.Vector(fx.Unary("-", sine), cosine, fx.ZERO)})


def is_planar(machine: Machine, shapes: Iterable[Shape]) -> bool:
    """Does every place keep z = 0, and every axis the plane, wherever the coordinates are?"""
    own = [(shape.kind, *each) for shape in shapes for each in shape.numbers.items()]
    for at in machine.positions[:2]:
        places = np.array([np.zeros(3), *(vector(at, value) for _, role, value in own if role in ("at", "to"))])
        axes = np.array([_Z, *(vector(at, value) for kind, role, value in own if role == "z" and kind != "frame")])
        room = 1e-12 * max(float(np.nanmax(np.abs(places))), 1.0)
        if np.any(np.abs(places[:, 2]) > room) or np.any(np.abs(np.abs(axes[:, 2]) - 1.0) > 1e-12):
            return False
    return True
