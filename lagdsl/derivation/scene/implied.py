"""Shapes that follow from declarations: masses, bodies, springs, ropes, massless rods, loads, frames, and a dial or a
slider for each coordinate that moves nothing else in the picture.

A `draw` statement of the same instance of a class takes the place of what the rules would draw for it.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lagdsl.derivation.scene.drawings import on_frame
from lagdsl.derivation.scene.shapes import Columns, Shape, ShapeKind
from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.language.flat.quantity import Spans, is_angle
from lagdsl.language.flat.traversal import postorder

_NONE: Mapping[str, float] = {}
_WORLD = fx.FrameOrigin("world")
# A distance is held if it changes by less than this part of itself between positions at random.
_HELD = 1e-9
_POSITIONS = 4
# Drawings beside which a mass is still to be seen.
_THIN = ("trace", "text", "arrow", "rod", "spring", "damper")
# Beyond so many, axes of frames cover the picture.
_MOST_FRAMES = 60


@record()
class Machine:
    """Input of all rules: the model, the columns that they fill, its values at some positions, and what is drawn.

    `standing` are points and frames of drawings with a body of their own, `reached` the second ends of those between
    two points, `owners` the instances of classes that draw themselves.
    """

    flat: fm.FlatModel
    columns: Columns
    positions: tuple[Evaluator, ...]
    dependence: Dependence
    named: Mapping[str, fm.Named]
    standing: frozenset[fx.FlatExpression | str]
    reached: frozenset[fx.FlatExpression | str]
    owners: frozenset[Spans]

    def is_drawn(self, spans: Spans) -> bool:
        """Does the instance of a class that an item comes from draw itself?"""
        return bool(spans[1:]) and spans[1:] in self.owners


def machine_of(flat: fm.FlatModel, columns: Columns) -> Machine:
    drawings = flat.drawings
    return Machine(
        flat,
        columns,
        tuple(evaluator_at(flat, seed) for seed in range(_POSITIONS)),
        Dependence(flat),
        {item.name: item for item in flat.named},
        standing=frozenset(a for drawing in drawings if drawing.shape not in _THIN for a in drawing.anchors),
        reached=frozenset(drawing.anchors[-1] for drawing in drawings if drawing.place == "between"),
        owners=frozenset(drawing.spans[1:] for drawing in drawings),
    )


def masses(machine: Machine) -> Iterator[Shape]:
    """A ball at each point mass to which nothing is drawn."""
    columns = machine.columns
    for k, item in enumerate(machine.flat.masses, 1):
        if item.position in machine.standing or machine.is_drawn(item.spans):
            continue
        numbers = (("at", columns.vector(item.position)), ("mass", columns.scalar(item.mass)))
        yield Shape(kind="mass", name=f"mass {k}", numbers=numbers, spans=item.spans)


def bodies(machine: Machine) -> Iterator[Shape]:
    """The homogeneous ellipsoid of the same mass and inertia, where nothing is drawn on the frame."""
    columns = machine.columns
    for k, item in enumerate(machine.flat.bodies, 1):
        if item.frame in machine.standing or machine.is_drawn(item.spans):
            continue
        numbers = (
            *on_frame(item.frame, columns),
            ("com", columns.scalars(item.com)),
            ("mass", columns.scalar(item.mass)),
            ("inertia", columns.scalars(item.inertia)),
        )
        yield Shape(kind="body", name=item.label or f"body {k}", numbers=numbers, spans=item.spans)


def have_inertia(flat: fm.FlatModel) -> frozenset[Spans]:
    """The instances of classes that hold a body with moments of inertia."""
    at = evaluator_at(flat, 0)
    return frozenset(body.spans[1:] for body in flat.bodies if any(_number(at, each) != 0.0 for each in body.inertia))


def levers(machine: Machine, centres: Iterable[fm.Drawing]) -> Iterator[Shape]:
    """A thin arm from the frame of a body to its mass center, one of the `centres` that components draw."""
    frames = {body.spans[1:]: fx.FrameOrigin(body.frame) for body in machine.flat.bodies}
    for drawing in centres:
        [center] = drawing.anchors
        own = frames.get(drawing.spans[1:])
        if own is None or isinstance(center, str):
            continue
        at = machine.positions[0]
        if np.linalg.norm(at.vector(center) - at.vector(own)) > _HELD:
            yield _between("rope", "to the mass center", own, center, drawing.spans, machine.columns)


def springs(machine: Machine) -> Iterator[Shape]:
    """A spring between two points whose distance stands in a potential; a damper likewise, in a dissipation."""
    seen: set[tuple[str, fx.FlatExpression, fx.FlatExpression]] = set()
    for term in machine.flat.energies:
        if term.kind not in {"potential", "dissipation"} or machine.is_drawn(term.spans):
            continue
        kind: ShapeKind = "spring" if term.kind == "potential" else "damper"
        for a, b in _distances(term.value, machine.named):
            if (kind, a, b) not in seen:
                seen.add((kind, a, b))
                yield _between(kind, term.label or kind, a, b, term.spans, machine.columns)


def ropes(machine: Machine) -> Iterator[Shape]:
    """A massless rod or rope between two points whose distance a constraint holds."""
    for constraint in machine.flat.constraints:
        if constraint.level != "position" or constraint.closure is not None or machine.is_drawn(constraint.spans):
            continue
        for residual in constraint.residuals:
            for a, b in _distances(residual, machine.named):
                yield _between("rope", constraint.name, a, b, constraint.spans, machine.columns)


def rods(machine: Machine) -> Iterator[Shape]:
    """A massless rod to each point mass that keeps its distance from the point it is built on, down to the world."""
    done: set[fx.FlatExpression] = set()
    for item in machine.flat.masses:
        point = item.position
        while point not in done and point not in machine.reached and not machine.is_drawn(item.spans):
            done.add(point)
            base = _base(point, machine.named)
            if base is None or not _is_held(machine.positions, point, base):
                break
            yield _between("rod", "massless rod", base, point, item.spans, machine.columns)
            point = base


def arms(machine: Machine) -> Iterator[Shape]:
    """A thin arm from the origin of a frame to that of one that is built on it elsewhere; from the world, and to a
    frame with a position of its own, only where the distance is held."""
    at = machine.positions
    known = {
        _ends([each.vector(end) for each in at for end in drawing.anchors if not isinstance(end, str)])
        for drawing in machine.flat.drawings
        if drawing.place == "between"
    }
    for item in machine.flat.named:
        if not isinstance(item, fm.Frame) or item.image is not None:
            continue
        parent, own = fx.FrameOrigin(item.parent), fx.FrameOrigin(item.name)
        ends = [each.vector(end) for each in at for end in (parent, own)]
        lengths = np.linalg.norm(np.array(ends[1::2]) - np.array(ends[::2]), axis=1)
        held = np.ptp(lengths) <= _HELD * lengths.max()
        builds = item.parent != "world" and not _is_placed(item)
        if lengths.min() > _HELD and (held or builds) and _ends(ends) not in known:
            known.add(_ends(ends))
            yield _between("rope", f"to {item.name}", parent, own, item.spans, machine.columns)


def _is_placed(frame: fm.Frame) -> bool:
    """Does its origin stand at a position of its own, whatever frame its axes are built on?"""
    return any(isinstance(step, fm.Place) for step in frame.steps)


def _ends(places: list[NDArray[np.float64]]) -> frozenset[bytes]:
    """The same for the same two points, in either order, at all positions."""
    rounded = [np.round(place, 9) + 0.0 for place in places]
    return frozenset(np.array(rounded[first::2]).tobytes() for first in (0, 1))


def grounds(machine: Machine) -> Iterator[Shape]:
    """The plane that a contact keeps a mass or the origin of a body's frame from, where there is one: its gap then
    changes as n . P does, with one unit vector n at all positions. A round shape touches it with its rim."""
    flat, columns = machine.flat, machine.columns
    origins = (fx.FrameOrigin(body.frame) for body in flat.bodies)
    places = [(place, movers_of(machine, place)) for place in (*(mass.position for mass in flat.masses), *origins)]
    for contact in (each for each in flat.events.contacts if not each.one_way):
        own = movers_of(machine, contact.gap)
        for place, movers in places:
            normal = normal_of(flat, contact.gap, place, movers) if own and own <= movers else None
            if normal is None:
                continue
            n = fx.Vector(*(fx.Number(float(x)) for x in normal))
            reach = radius_at(flat, place)
            depth = contact.gap if reach is None else fx.Binary("+", contact.gap, reach)
            foot = fx.Binary("-", place, fx.Binary("*", depth, n))
            numbers = (("at", columns.vector(foot)), ("normal", columns.vector(n)))
            yield Shape(kind="ground", name=contact.name, numbers=numbers, spans=contact.spans)
            break


def movers_of(machine: Machine, expression: fx.FlatExpression) -> frozenset[str]:
    """The coordinates that an expression depends on."""
    coordinates = {coordinate.name for coordinate in machine.flat.coordinates}
    return frozenset(name for name in machine.dependence.of(expression) if name in coordinates)


def radius_at(flat: fm.FlatModel, place: fx.FlatExpression) -> fx.FlatExpression | None:
    """Of what is drawn at a place."""
    names = {place, place.frame} if isinstance(place, fx.FrameOrigin) else {place}
    for drawing in flat.drawings:
        for role, value in drawing.arguments if names & set(drawing.anchors) else ():
            if role == "radius" and not isinstance(value, str):
                return value
    return None


def normal_of(
    flat: fm.FlatModel, gap: fx.FlatExpression, place: fx.FlatExpression, movers: frozenset[str]
) -> NDArray[np.float64] | None:
    """The unit vector n with d(gap)/dq_j = n . d(place)/dq_j for all `movers`, at two positions at random."""
    found = []
    for seed in range(2):
        moves, changes = [], []
        for name in sorted(movers):
            at = evaluator_at(flat, seed, {name: 1.0})
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


def loads(machine: Machine) -> Iterator[Shape]:
    """Forces at their points, torques at the origins of their frames."""
    columns = machine.columns
    for load in machine.flat.loads:
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
            case fm.RateForce():
                pass


def frames(machine: Machine) -> Iterator[Shape]:
    """The axes of the world and of the named frames."""
    columns = machine.columns
    found = [item for item in machine.flat.named if isinstance(item, fm.Frame)][:_MOST_FRAMES]
    yield Shape(kind="frame", name="world", numbers=tuple(on_frame("world", columns)), spans=())
    for item in found:
        yield Shape(kind="frame", name=item.name, numbers=tuple(on_frame(item.name, columns)), spans=item.spans)


def gauges(machine: Machine) -> Iterator[Shape]:
    """A dial for each angle and a slider for each other coordinate that moves nothing of what is drawn."""
    drawn = tuple(machine.columns.expressions)
    for coordinate in machine.flat.coordinates:
        moved = evaluator_at(machine.flat, 0, moved={coordinate.name: 0.1})
        # A ball that turns in its place depends on its angle, and nothing is seen of it.
        likely = (each for each in drawn if coordinate.name in machine.dependence.of(each))
        if any(_is_changed(_number(machine.positions[0], each), _number(moved, each)) for each in likely):
            continue
        kind: ShapeKind = "dial" if is_angle(coordinate) else "slider"
        numbers = (("value", machine.columns.scalar(fx.Variable(coordinate.name))),)
        yield Shape(kind=kind, name=coordinate.name, numbers=numbers, spans=coordinate.spans)


def is_planar(machine: Machine, shapes: Iterable[Shape]) -> bool:
    """Does every place keep z = 0, and every axis the plane, wherever the coordinates are?"""
    firsts = [first for shape in shapes for role, first in shape.numbers if role in {"at", "to"}]
    flat_axes = [first for shape in shapes if shape.kind != "frame" for role, first in shape.numbers if role == "z"]
    for at in machine.positions[:2]:
        values = _numbers(at, machine.columns.expressions)
        sizes = np.abs(values[np.isfinite(values)])
        room = 1e-12 * float(np.max(sizes, initial=1.0))
        if any(abs(values[first + 2]) > room for first in firsts):
            return False
        if any(abs(abs(values[first + 2]) - 1.0) > 1e-12 for first in flat_axes):
            return False
    return True


def _is_changed(before: float, after: float) -> bool:
    return before != after and not (math.isnan(before) and math.isnan(after))


def evaluator_at(
    flat: fm.FlatModel,
    seed: int,
    rates: Mapping[str, float] = _NONE,
    moved: Mapping[str, float] = _NONE,
    *,
    parameters: float = 0.0,
) -> Evaluator:
    """At coordinates, states and a time at random, the same ones for the same seed, plus what is `moved`; rates that
    are not given are 0. Real parameters differ from their values by up to the part `parameters`."""
    chance = random.Random(seed)
    variables = {item.name: chance.uniform(0.2, 1.2) for item in (*flat.coordinates, *flat.states)}
    variables["time"] = chance.uniform(0.1, 1.0)
    for name, step in moved.items():
        variables[name] += step
    known = Values(variables=variables, rates=dict.fromkeys(variables, 0.0) | dict(rates))
    if not parameters:
        return Evaluator(flat, known)
    spread = {
        item.name: item.value * chance.uniform(1.0 - parameters, 1.0 + parameters)
        for item in flat.parameters
        if item.kind == "Real" and not item.structural
    }
    return Evaluator(flat, replace(known, variables={**variables, **spread}))


def _numbers(at: Evaluator, expressions: Iterable[fx.FlatExpression]) -> NDArray[np.float64]:
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


def _distances(
    expression: fx.FlatExpression, named: Mapping[str, fm.Named]
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


def _base(point: fx.FlatExpression, named: Mapping[str, fm.Named]) -> fx.FlatExpression | None:
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


def _is_held(positions: Sequence[Evaluator], a: fx.FlatExpression, b: fx.FlatExpression) -> bool:
    """Is their distance the same, and not zero, at all positions, though the point moves?"""
    try:
        places = np.array([at.vector(a) for at in positions])
        lengths = np.linalg.norm(places - [at.vector(b) for at in positions], axis=1)
    except NotEvaluable:
        return False
    moves = np.ptp(places, axis=0).max() > _HELD
    return bool(moves and lengths.min() > 0.0 and np.ptp(lengths) <= _HELD * lengths.max())
