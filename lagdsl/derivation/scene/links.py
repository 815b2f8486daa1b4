"""Massless links between points: springs and dampers behind energies, ropes behind constraints, rods and arms."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import combinations

import numpy as np

from lagdsl.derivation.scene.looks import COLORS, parts_of
from lagdsl.derivation.scene.machine import HELD, WORLD, Machine, anchors_of, constant, fixed, number, vector
from lagdsl.derivation.scene.shapes import Part, Shape, ShapeKind
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.traversal import postorder, substituted

_STEP = 1e-3
_PARALLEL = 1e-6  # of gradients, one of which comes from differences
_MOST_POINTS = 40
_ROOM = 3.0  # of its start value: so far a spring without a natural length is from its wall
_WALL = 0.5  # [m], of one that starts at zero

Ends = tuple[fx.FlatExpression, fx.FlatExpression]


def springs(machine: Machine) -> Iterator[Shape]:
    """A spring between two points on whose distance alone a part of a potential depends, with a stiffness above zero;
    from a wall to a mass that slides with the only coordinate of one. Dampers likewise, by dissipations."""
    seen: set[tuple[str, Ends]] = set()
    for term in machine.flat.energies:
        if term.kind not in {"potential", "dissipation"} or machine.is_drawn(term.spans):
            continue
        kind: ShapeKind = "spring" if term.kind == "potential" else "damper"
        if any(each.shape == kind and each.spans[1:] == term.spans[1:] for each in machine.flat.drawings):
            continue  # somebody draws those of this class by hand
        for part in _summands(machine, term.value):
            told = _distances(part, machine.named)
            pairs = [ends for ends in told if kind == "damper" or _stiff(machine, part, ends)]
            for ends in pairs or _ends_by_numbers(machine, part, kind):
                if (kind, ends) not in seen:
                    seen.add((kind, ends))
                    numbers = dict(zip(("at", "to"), ends, strict=True))
                    link = Shape(kind=kind, name=term.label or kind, numbers=numbers, spans=term.spans)
                    yield replace(link, parts=_with_wall(machine, link, ends))


def _with_wall(machine: Machine, link: Shape, ends: Ends) -> tuple[Part, ...]:
    """A link with a hatched wall across it, at an end that stands still while the other one slides on a line."""
    parts = tuple(parts_of(link, planar=False))
    for still, other, role in ((*ends, "at"), (*ends[::-1], "to")):
        if constant(machine.places(still)) and machine.straight(other) is not None:
            numbers = {"at": link.numbers[role], "z": fx.Binary("-", other, still)}
            return (*parts, Part(form="wall", numbers=numbers, color=COLORS["ground"]))
    return parts


def _summands(machine: Machine, value: fx.FlatExpression) -> Iterator[fx.FlatExpression]:
    """The terms of a sum, also in brackets behind constant factors; a name is what it stands for."""
    if isinstance(value, fx.Variable) and isinstance(item := machine.named.get(value.name), fm.Definition):
        yield from _summands(machine, item.value)
    elif isinstance(value, fx.Binary) and value.operator in {"+", "-"}:
        yield from _summands(machine, value.left)
        yield from _summands(machine, value.right)
    elif isinstance(value, fx.Binary) and value.operator == "*" and not machine.movers_of(value.left):
        yield from _summands(machine, value.right)
    else:
        yield value


def _gradient(
    machine: Machine, value: fx.FlatExpression, kind: ShapeKind, seed: int, moved: Mapping[str, float]
) -> Floats:
    """dV/dq at a position by the coordinates in the order of their names; of a dissipation c s^2/2 in the rates the
    direction in which the slip s grows."""
    names = sorted(machine.movers_of(value))
    if kind == "spring":
        return machine.derivatives(value, names, seed, moved)

    def power(rates: Mapping[str, float]) -> float:
        return number(machine.at(seed, rates, moved), value)

    own = np.array([power({n: 1.0}) for n in names])
    first = names[int(np.argmax(own))]
    both = np.array([power({first: 1.0, n: 1.0 + (n == first)}) for n in names])
    return np.asarray(0.5 * (both - own.max() - own))


def _ends_by_numbers(machine: Machine, value: fx.FlatExpression, kind: ShapeKind) -> list[Ends]:
    names = sorted(machine.movers_of(value))
    if len(names) == 1:
        return _from_wall(machine, value, kind, names[0])
    ends = _by_distance(machine, value, kind) if names else []
    return [each for each in ends if kind == "damper" or _stiff(machine, value, each, linear=True)]


def _by_distance(machine: Machine, value: fx.FlatExpression, kind: ShapeKind) -> list[Ends]:
    """Two points on whose distance alone a value depends."""
    names = machine.movers_of(value)
    gradients = [_gradient(machine, value, kind, seed, {}) for seed in (0, 1)]
    if not all(np.isfinite(each).all() and np.any(each) for each in gradients):
        return []
    moving = [each for each in machine.points[:_MOST_POINTS] if machine.movers_of(each)]
    for a, b in combinations([WORLD, *moving], 2):
        if machine.movers_of(a) | machine.movers_of(b) == names and _is_distance(machine, (a, b), gradients):
            return [(a, b)]
    return []


def _is_distance(machine: Machine, ends: Ends, gradients: list[Floats]) -> bool:
    """Do the gradients lie along those of the distance?"""
    way = fx.Norm(fx.Binary("-", ends[1], ends[0]), "spring")
    for seed, gradient in enumerate(gradients):
        own = machine.derivatives(way, sorted(machine.movers_of(way)), seed)
        sizes = float(np.linalg.norm(own) * np.linalg.norm(gradient))
        if not (np.isfinite(own).all() and sizes > 0.0) or abs(abs(own @ gradient) - sizes) > _PARALLEL * sizes:
            return False
    return True


def _stiff(machine: Machine, value: fx.FlatExpression, ends: Ends, *, linear: bool = False) -> bool:
    """Does dV/ds grow with the distance s of the ends? With `linear` in proportion: angles have no such springs."""
    way = fx.Norm(fx.Binary("-", ends[1], ends[0]), "spring")
    names = sorted(machine.movers_of(way))
    along = machine.derivatives(way, names, 0)
    if not (np.isfinite(along).all() and np.any(along)):
        return False
    lengths, forces = [], []
    for step in (0.0, _STEP, 2.0 * _STEP):
        shift = dict(zip(names, (step * along).tolist(), strict=True))
        own = machine.derivatives(way, names, 0, shift)
        lengths.append(number(machine.at(0, moved=shift), way))
        forces.append(float(own @ machine.derivatives(value, names, 0, shift)) / float(own @ own))
    stiffness = np.diff(forces) / np.diff(lengths)
    rounding = HELD * abs(forces[0]) / (lengths[1] - lengths[0])
    return bool(stiffness[0] > rounding) and not (linear and abs(np.ptp(stiffness)) > _PARALLEL * stiffness[0])


def _from_wall(machine: Machine, value: fx.FlatExpression, kind: ShapeKind, name: str) -> list[Ends]:
    """From the place where the spring has no length, or from a wall on the side where nothing else is."""
    sliding, at = list(machine.slides()), machine.positions[0]
    found = next(((point, move) for point, own, move in sliding if own == name), None)
    if found is None:
        return []
    point, move = found[0], found[1] / np.linalg.norm(found[1])
    start = next(number(at, each.start) for each in machine.flat.coordinates if each.name == name)
    origin, natural = _at_zero(machine, point, {name}), 0.0
    if kind == "spring":
        low, high = (float(_gradient(machine, value, kind, 0, {name: step})[0]) for step in (0.0, 1.0))
        if not high > low:
            return []
        natural = number(at, fx.Variable(name)) - low / (high - low)
    if abs(natural) > HELD * max(abs(start), 1.0):
        return [(origin, point)]
    zero = vector(at, origin)
    if not np.isfinite(zero).all():
        return []
    sides = np.array([vector(at, _at_zero(machine, each, {own})) - zero for each, own, _ in sliding]) @ move
    others = sides[np.abs(sides) > HELD]
    toward = 1.0 if len(others) and others.max() < 0.0 else -1.0
    free = max(_ROOM * abs(start), _WALL if start == 0.0 else 0.0)
    room = float(np.abs(others).min()) if len(others) else free
    return [(fixed(zero + toward * room * move), point)]


def _at_zero(machine: Machine, point: fx.FlatExpression, names: Iterable[str]) -> fx.FlatExpression:
    """The place of a point while coordinates are zero."""
    return substituted(machine.position_of(point), dict.fromkeys(names, fx.ZERO))


def ropes(machine: Machine) -> Iterator[Shape]:
    """A massless rod or rope between two points whose distance a constraint holds."""
    for constraint in machine.flat.constraints:
        if constraint.level != "position" or constraint.closure is not None or machine.is_drawn(constraint.spans):
            continue
        for residual in constraint.residuals:
            pairs = list(_distances(residual, machine.named))
            if not pairs and len(machine.movers_of(residual)) > 1:
                pairs = _by_distance(machine, residual, "spring")
            on_wire = [p for p in pairs if any(_is_on_circle(machine, *each, residual) for each in (p, p[::-1]))]
            for a, b in (*(each for each in pairs if each not in on_wire), *_hanging(machine, residual)):
                yield Shape(kind="rope", name=constraint.name, numbers={"at": a, "to": b}, spans=constraint.spans)


def _hanging(machine: Machine, residual: fx.FlatExpression) -> list[Ends]:
    """Ropes of masses that slide along gravity and are tied to each other: each from where its coordinate is zero."""
    if machine.down is None:
        return []
    names = machine.movers_of(residual)
    tied = [(point, move) for point, name, move in machine.slides() if name in names]
    falls = all(np.linalg.norm(np.cross(move, machine.down)) <= HELD for _, move in tied)
    return [(_at_zero(machine, point, names), point) for point, _ in tied if falls and len(tied) >= len(names) > 1]


def rods(machine: Machine) -> Iterator[Shape]:
    """A massless rod to each point mass that keeps its distance from the point it is built on, down to the world."""
    done: set[fx.FlatExpression] = set()
    for item in machine.flat.masses:
        point = item.position
        while point not in done and point not in machine.reached and not machine.is_drawn(item.spans):
            done.add(point)
            base = _base(machine.position_of(point))
            if base is None or not _is_held(machine, point, base) or _is_on_circle(machine, point, base):
                break
            yield Shape(kind="rod", name="massless rod", numbers={"at": base, "to": point}, spans=item.spans)
            point = base


def _is_on_circle(
    machine: Machine, point: fx.FlatExpression, center: fx.FlatExpression, residual: fx.FlatExpression | None = None
) -> bool:
    """Does a circle drawn about the center hold the point, as a wire holds a bead? The distance d of the two is the
    radius r at all positions, else a residual that holds it is in proportion to d - r or to d^2 - r^2."""
    way = fx.Norm(fx.Binary("-", point, center), "circle")
    for drawing in machine.flat.drawings:
        radius = dict(drawing.arguments).get("radius")
        if drawing.shape != "circle" or radius is None or isinstance(radius, str):
            continue
        [anchor] = anchors_of(drawing)
        if not np.abs(machine.places(anchor) - machine.places(center)).max() <= HELD:
            continue
        d, r = machine.numbers(way), machine.numbers(radius)
        if residual is None:
            laws = [d - r]
        else:
            held = machine.numbers(residual)
            laws = [held * each[0] - held[0] * each for each in (d - r, d**2 - r**2)]
        if any(np.abs(law).max() <= HELD for law in laws):
            return True
    return False


def arms(machine: Machine) -> Iterator[Shape]:
    """A thin arm from the origin of a frame to that of one that is built on it elsewhere; from the world, and to a
    frame with a position of its own, only where the distance is held. The place that a `draw` statement writes down
    belongs to its shape, and has none; nor has a frame between whose points the same text draws."""
    written = set(_written(machine.flat))
    lines = [each for each in machine.flat.drawings if each.place == "between"]
    joined = {(name, each.spans[1:]) for each in lines for end in anchors_of(each) for name in machine.frames_in(end)}
    known = {frozenset(map(machine.spelled, anchors_of(each))) for each in lines}
    for item in machine.flat.named:
        if not isinstance(item, fm.Frame) or item.image is not None or item.name in written:
            continue
        if {(item.name, item.spans[1:]), (item.parent, item.spans[1:])} & joined:
            continue
        parent, own = fx.FrameOrigin(item.parent), fx.FrameOrigin(item.name)
        lengths = np.linalg.norm(machine.places(own) - machine.places(parent), axis=1)
        moves = machine.movers_of(parent) | machine.movers_of(fx.FrameAxis(item.parent, 0))
        placed = any(isinstance(step, fm.Place) for step in item.steps)
        held = np.ptp(lengths) <= HELD * lengths.max() or (moves and not placed)
        ends = frozenset(map(machine.spelled, (parent, own)))
        if lengths.min() > HELD and held and ends not in known:
            known.add(ends)
            yield Shape(kind="rope", name=f"to {item.name}", numbers={"at": parent, "to": own}, spans=item.spans)


def _written(flat: fm.FlatModel) -> Iterator[str]:
    """Frames that stand in the text of the `draw` statements on them, without a name: `on F.move(r)`."""
    frames = {item.name: item.spans[0] for item in flat.named if isinstance(item, fm.Frame) and item.spans}
    for drawing in (each for each in flat.drawings if each.spans):
        whole = drawing.spans[0]
        for anchor in drawing.anchors:
            if isinstance(anchor, str) and anchor in frames:
                part = frames[anchor]
                if part.file == whole.file and whole.start <= part.start and part.end <= whole.end:
                    yield anchor


def _distances(expression: fx.FlatExpression, named: Mapping[str, fm.Named]) -> Iterator[Ends]:
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


def _base(point: fx.FlatExpression) -> fx.FlatExpression | None:
    """The point that another one is built on: `A` of `A + r`; the origin of the world for a position of its own."""
    if isinstance(point, fx.PointReference | fx.FrameOrigin):
        return None
    if isinstance(point, fx.Binary) and isinstance(point.left, fx.PointReference | fx.FrameOrigin):
        return point.left
    return WORLD


def _is_held(machine: Machine, a: fx.FlatExpression, b: fx.FlatExpression) -> bool:
    """Is their distance the same, and not zero, at all positions, though the point moves?"""
    one, other = machine.places(a), machine.places(b)
    lengths = np.linalg.norm(one - other, axis=1)
    moves = np.ptp(one, axis=0).max() > HELD
    return bool(moves and lengths.min() > 0.0 and np.ptp(lengths) <= HELD * lengths.max())
