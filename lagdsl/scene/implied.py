"""Shapes that follow from declarations: masses, bodies, springs, ropes, massless rods, loads, frames, and a dial or a
slider for each coordinate that moves nothing else in the picture.

A `draw` statement of the same instance of a class takes the place of what the rules would draw for it.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from lagdsl.flat import expression as fx
from lagdsl.flat import model as fm
from lagdsl.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.flat.quantity import Spans
from lagdsl.flat.traversal import postorder
from lagdsl.scene.drawings import on_frame
from lagdsl.scene.shapes import Columns, Shape, ShapeKind
from lagdsl.units.dimension import LENGTH

_WORLD = fx.FrameOrigin("world")
# A distance is held if it changes by less than this part of itself between positions at random.
_HELD = 1e-9
_POSITIONS = 4
# Drawings beside which a mass is still to be seen.
_THIN = ("trace", "text", "arrow", "rod", "spring", "damper")
# Beyond so many, axes of frames cover the picture.
_MOST_FRAMES = 60


def masses(flat: fm.FlatModel, columns: Columns) -> Iterator[Shape]:
    """A ball at each point mass to which nothing is drawn."""
    taken = _anchors(flat)
    for k, item in enumerate(flat.masses, 1):
        if item.position in taken or _is_drawn(flat, item.spans):
            continue
        numbers = (("at", columns.vector(item.position)), ("mass", columns.scalar(item.mass)))
        yield Shape(kind="mass", name=f"mass {k}", numbers=numbers, spans=item.spans)


def bodies(flat: fm.FlatModel, columns: Columns) -> Iterator[Shape]:
    """The homogeneous ellipsoid of the same mass and inertia, where nothing is drawn on the frame."""
    taken = _anchors(flat)
    for k, item in enumerate(flat.bodies, 1):
        if item.frame in taken or _is_drawn(flat, item.spans):
            continue
        numbers = (
            *on_frame(item.frame, columns),
            ("com", columns.scalars(item.com)),
            ("mass", columns.scalar(item.mass)),
            ("inertia", columns.scalars(item.inertia)),
        )
        yield Shape(kind="body", name=item.label or f"body {k}", numbers=numbers, spans=item.spans)


def springs(flat: fm.FlatModel, columns: Columns) -> Iterator[Shape]:
    """A spring between two points whose distance stands in a potential; a damper likewise, in a dissipation."""
    named = {item.name: item for item in flat.named}
    seen: set[tuple[str, fx.FlatExpression, fx.FlatExpression]] = set()
    for term in flat.energies:
        if term.kind not in {"potential", "dissipation"} or _is_drawn(flat, term.spans):
            continue
        kind: ShapeKind = "spring" if term.kind == "potential" else "damper"
        for a, b in _distances(term.value, named):
            if (kind, a, b) not in seen:
                seen.add((kind, a, b))
                yield _between(kind, term.label or kind, a, b, term.spans, columns)


def ropes(flat: fm.FlatModel, columns: Columns) -> Iterator[Shape]:
    """A massless rod or rope between two points whose distance a constraint holds."""
    named = {item.name: item for item in flat.named}
    for constraint in flat.constraints:
        if constraint.level != "position" or constraint.closure is not None or _is_drawn(flat, constraint.spans):
            continue
        for residual in constraint.residuals:
            for a, b in _distances(residual, named):
                yield _between("rope", constraint.name, a, b, constraint.spans, columns)


def rods(flat: fm.FlatModel, columns: Columns) -> Iterator[Shape]:
    """A massless rod to each point mass that keeps its distance from the point it is built on, down to the world."""
    named = {item.name: item for item in flat.named}
    taken = _anchors(flat, joined=True)
    positions = [evaluator_at(flat, seed) for seed in range(_POSITIONS)]
    done: set[fx.FlatExpression] = set()
    for item in flat.masses:
        point = item.position
        while point not in done and point not in taken and not _is_drawn(flat, item.spans):
            done.add(point)
            base = _base(point, named)
            if base is None or not _is_held(positions, point, base):
                break
            yield _between("rod", "massless rod", base, point, item.spans, columns)
            point = base


def arms(flat: fm.FlatModel, columns: Columns) -> Iterator[Shape]:
    """A thin arm from the origin of a frame to that of one that is built on it elsewhere; from the world only where the
    distance is held."""
    joined = [drawing for drawing in flat.drawings if drawing.place == "between"]
    at = [evaluator_at(flat, seed) for seed in range(_POSITIONS)]
    known = {
        _ends([each.vector(end) for each in at for end in drawing.anchors if not isinstance(end, str)])
        for drawing in joined
    }
    for item in flat.named:
        if not isinstance(item, fm.Frame) or item.image is not None:
            continue
        parent, own = fx.FrameOrigin(item.parent), fx.FrameOrigin(item.name)
        ends = [each.vector(end) for each in at for end in (parent, own)]
        lengths = np.linalg.norm(np.array(ends[1::2]) - np.array(ends[::2]), axis=1)
        held = np.ptp(lengths) <= _HELD * lengths.max()
        if lengths.min() > _HELD and (held or item.parent != "world") and _ends(ends) not in known:
            known.add(_ends(ends))
            yield _between("rope", f"to {item.name}", parent, own, item.spans, columns)


def _ends(places: list[NDArray[np.float64]]) -> frozenset[bytes]:
    """The same for the same two points, in either order, at all positions."""
    rounded = [np.round(place, 9) + 0.0 for place in places]
    return frozenset(np.array(rounded[first::2]).tobytes() for first in (0, 1))


def grounds(flat: fm.FlatModel, columns: Columns) -> Iterator[Shape]:
    """The plane that a contact keeps a mass or the origin of a body's frame from, where there is one: its gap then
    changes as n . P does, with one unit vector n at all positions. A round shape touches it with its rim."""
    places = [*(mass.position for mass in flat.masses), *_origins(flat)]
    for contact in flat.events.contacts:
        for place in places:
            normal = _normal(flat, contact.gap, place)
            if normal is None:
                continue
            n = fx.Vector(*(fx.Number(float(x)) for x in normal))
            reach = _radius(flat, place)
            depth = contact.gap if reach is None else fx.Binary("+", contact.gap, reach)
            foot = fx.Binary("-", place, fx.Binary("*", depth, n))
            numbers = (("at", columns.vector(foot)), ("normal", columns.vector(n)))
            yield Shape(kind="ground", name=contact.name, numbers=numbers, spans=contact.spans)
            break


def _origins(flat: fm.FlatModel) -> list[fx.FlatExpression]:
    return [fx.FrameOrigin(body.frame) for body in flat.bodies]


def _radius(flat: fm.FlatModel, place: fx.FlatExpression) -> fx.FlatExpression | None:
    """Of what is drawn at a place."""
    names = {place, place.frame} if isinstance(place, fx.FrameOrigin) else {place}
    for drawing in flat.drawings:
        for role, value in drawing.arguments if names & set(drawing.anchors) else ():
            if role == "radius" and not isinstance(value, str):
                return value
    return None


def _normal(flat: fm.FlatModel, gap: fx.FlatExpression, place: fx.FlatExpression) -> NDArray[np.float64] | None:
    """The unit vector n with d(gap)/dq_j = n . d(place)/dq_j for all coordinates, at two positions at random."""
    found = []
    for seed in range(2):
        moves, changes = [], []
        for coordinate in flat.coordinates:
            at = evaluator_at(flat, seed, rates={coordinate.name: 1.0})
            try:
                moves.append(at.vector(fx.Derivative(place)))
                changes.append(at.scalar(fx.Derivative(gap)))
            except NotEvaluable:
                return None
        jacobian, change = np.array(moves).reshape(-1, 3), np.array(changes)
        if not np.isfinite(jacobian).all() or not np.isfinite(change).all():
            return None
        n = np.linalg.lstsq(jacobian, change, rcond=None)[0]
        if abs(np.linalg.norm(n) - 1.0) > _HELD or np.abs(jacobian @ n - change).max() > _HELD:
            return None
        found.append(n)
    return found[0] if np.abs(found[0] - found[1]).max() <= _HELD else None


def loads(flat: fm.FlatModel, columns: Columns) -> Iterator[Shape]:
    """Forces at their points, torques at the origins of their frames."""
    for load in flat.loads:
        match load:
            case fm.PointForce():
                numbers = (("at", columns.vector(load.point)), ("vector", columns.vector(load.force)))
                yield Shape(kind="force", name=load.label or "force", numbers=numbers, spans=load.spans)
            case fm.FrameTorque():
                at = columns.vector(fx.FrameOrigin(load.frame))
                numbers = (("at", at), ("vector", columns.vector(load.torque)))
                yield Shape(kind="torque", name=load.label or "torque", numbers=numbers, spans=load.spans)
            case fm.GeneralizedForce():
                pass  # it acts on a coordinate, which is no place


def frames(flat: fm.FlatModel, columns: Columns) -> Iterator[Shape]:
    """The axes of the world and of the named frames."""
    found = [item for item in flat.named if isinstance(item, fm.Frame)][:_MOST_FRAMES]
    yield Shape(kind="frame", name="world", numbers=tuple(on_frame("world", columns)), spans=())
    for item in found:
        yield Shape(kind="frame", name=item.name, numbers=tuple(on_frame(item.name, columns)), spans=item.spans)


def gauges(flat: fm.FlatModel, columns: Columns) -> Iterator[Shape]:
    """A slider for each length and a dial for each other coordinate that moves nothing of what is drawn."""
    drawn = tuple(columns.expressions)
    before = _numbers(evaluator_at(flat, 0), drawn)
    for coordinate in flat.coordinates:
        after = _numbers(evaluator_at(flat, 0, {coordinate.name: 0.1}), drawn)
        if not np.array_equal(before, after, equal_nan=True):
            continue
        kind: ShapeKind = "slider" if coordinate.dimension == LENGTH else "dial"
        numbers = (("value", columns.scalar(fx.Variable(coordinate.name))),)
        yield Shape(kind=kind, name=coordinate.name, numbers=numbers, spans=coordinate.spans)


def is_planar(flat: fm.FlatModel, columns: Columns, shapes: Iterable[Shape]) -> bool:
    """Does every place keep z = 0, and every axis the plane, wherever the coordinates are?"""
    firsts = [first for shape in shapes for role, first in shape.numbers if role in {"at", "to"}]
    flat_axes = [first for shape in shapes if shape.kind != "frame" for role, first in shape.numbers if role == "z"]
    for seed in range(2):
        values = _numbers(evaluator_at(flat, seed), tuple(columns.expressions))
        sizes = np.abs(values[np.isfinite(values)])
        room = 1e-12 * float(np.max(sizes, initial=1.0))
        if any(abs(values[first + 2]) > room for first in firsts):
            return False
        if any(abs(abs(values[first + 2]) - 1.0) > 1e-12 for first in flat_axes):
            return False
    return True


def evaluator_at(
    flat: fm.FlatModel, seed: int, moved: dict[str, float] | None = None, rates: dict[str, float] | None = None
) -> Evaluator:
    """At coordinates, states and a time at random: the same ones for the same seed, plus what is `moved`."""
    chance = random.Random(seed)
    variables = {item.name: chance.uniform(0.2, 1.2) for item in (*flat.coordinates, *flat.states)}
    variables["time"] = chance.uniform(0.1, 1.0)
    for name, step in (moved or {}).items():
        variables[name] += step
    return Evaluator(flat, Values(variables=variables, rates=dict.fromkeys(variables, 0.0) | (rates or {})))


def _numbers(at: Evaluator, expressions: tuple[fx.FlatExpression, ...]) -> NDArray[np.float64]:
    return np.array([_number(at, expression) for expression in expressions])


def _number(at: Evaluator, expression: fx.FlatExpression) -> float:
    try:
        return at.scalar(expression)
    except NotEvaluable:
        return float("nan")


def _between(
    kind: ShapeKind, name: str, a: fx.FlatExpression, b: fx.FlatExpression, spans: Spans, columns: Columns
) -> Shape:
    numbers = (("at", columns.vector(a)), ("to", columns.vector(b)))
    return Shape(kind=kind, name=name, numbers=numbers, spans=spans)


def _anchors(flat: fm.FlatModel, *, joined: bool = False) -> set[fx.FlatExpression | str]:
    """Points and frames that drawings with a body of their own stand at, or, `joined`, those that some reach to."""
    if joined:
        return {drawing.anchors[-1] for drawing in flat.drawings if drawing.place == "between"}
    return {anchor for drawing in flat.drawings if drawing.shape not in _THIN for anchor in drawing.anchors}


def _is_drawn(flat: fm.FlatModel, spans: Spans) -> bool:
    """Does the instance of a class that an item comes from draw itself?"""
    owner = spans[1:]
    return bool(owner) and any(drawing.spans[1:] == owner for drawing in flat.drawings)


def _distances(
    expression: fx.FlatExpression, named: dict[str, fm.Named]
) -> Iterator[tuple[fx.FlatExpression, fx.FlatExpression]]:
    """Pairs of points whose distance, or its square, stands in an expression or in a definition that it uses."""
    waiting, seen = [expression], set[str]()
    while waiting:
        for node in postorder(waiting.pop()):
            way = None
            if isinstance(node, fx.Norm):
                way = node.vector
            elif isinstance(node, fx.Dot) and node.left == node.right:
                way = node.left
            if isinstance(way, fx.Binary) and way.operator == "-":
                yield way.left, way.right
            elif isinstance(node, fx.Variable) and node.name not in seen:
                seen.add(node.name)
                item = named.get(node.name)
                if isinstance(item, fm.Definition):
                    waiting.append(item.value)


def _base(point: fx.FlatExpression, named: dict[str, fm.Named]) -> fx.FlatExpression | None:
    """The point that another one is built on: `A` of `A + r`; the origin of the world for a position of its own."""
    if isinstance(point, fx.PointReference):
        item = named[point.name]
        assert isinstance(item, fm.Point)
        point = item.position
    if isinstance(point, fx.PointReference | fx.FrameOrigin):
        return None
    if isinstance(point, fx.Binary) and isinstance(point.left, fx.PointReference | fx.FrameOrigin):
        return point.left
    return _WORLD


def _is_held(positions: list[Evaluator], a: fx.FlatExpression, b: fx.FlatExpression) -> bool:
    """Is their distance the same, and not zero, at all positions, though the point moves?"""
    try:
        places = np.array([at.vector(a) for at in positions])
        lengths = np.linalg.norm(places - [at.vector(b) for at in positions], axis=1)
    except NotEvaluable:
        return False
    moves = np.ptp(places, axis=0).max() > _HELD
    return bool(moves and lengths.min() > 0.0 and np.ptp(lengths) <= _HELD * lengths.max())
