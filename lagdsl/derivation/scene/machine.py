"""Answers that the rules of shapes need of a model: numbers at positions at random, directions, parts of bodies.

A rule looks at values, not at texts: it holds for every model that says the same. A `draw` statement of the same
instance of a class takes the place of what the rules would draw for it.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from lagdsl.derivation.scene.drawings import along_axes, is_symbol
from lagdsl.derivation.scene.shapes import is_vector
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.units.dimension import LENGTH
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.language.flat.events import Contact
from lagdsl.language.flat.quantity import Spans
from lagdsl.language.flat.traversal import postorder

_NONE: Mapping[str, float] = {}
WORLD = fx.FrameOrigin("world")
HELD = 1e-9
"""A value is held if it changes by less than this part of itself between positions at random."""
_POSITIONS = 6
# Drawings beside which a mass is still to be seen.
_THIN = ("trace", "text", "arrow", "rod", "spring", "damper")
# Of a length parameter l, by which a moment of inertia m l^2/c is told to be that of a disc, a hoop, a ball, a bar.
_SPREAD = 0.2


class Machine:
    """Input of all rules: the model, its values at some positions, and what is drawn.

    `owners` are the instances of classes that draw themselves, `reached` the second ends of drawings between two
    points, `down` the direction of gravity, if it has one.
    """

    def __init__(self, flat: fm.FlatModel) -> None:
        self.flat = flat
        self.dependence = Dependence(flat)
        self.named = {item.name: item for item in flat.named}
        self.positions = tuple(self.at(seed) for seed in range(_POSITIONS))
        self.owners = frozenset(drawing.spans[1:] for drawing in flat.drawings)
        self.reached = frozenset(each.anchors[-1] for each in flat.drawings if each.place == "between")
        self.down = gravity_of(flat)

    # ---- what is drawn -----------------------------------------------------------------------------------------------

    def is_drawn(self, spans: Spans) -> bool:
        """Does the instance of a class that an item comes from draw itself?"""
        return bool(spans[1:]) and spans[1:] in self.owners

    def is_hidden(self, symbol: fm.Drawing) -> bool:
        """Does a thing stand where a component would draw its symbol?"""
        return symbol.place != "between" and self.is_standing(anchors_of(symbol)[0])

    def is_standing(self, place: fx.FlatExpression) -> bool:
        """Does something with a body of its own stand at a place, wherever the machine is?"""
        return self.spelled(place) in self.standing

    @cached_property
    def standing(self) -> frozenset[bytes]:
        """The places of drawings with a body of their own."""
        solid = [each for each in self.flat.drawings if each.shape not in _THIN and not is_symbol(each)]
        return frozenset(self.spelled(place) for drawing in solid for place in anchors_of(drawing))

    def spelled(self, place: fx.FlatExpression) -> bytes:
        """The same for the same place at all positions."""
        return (np.round(self.places(place), 9) + 0.0).tobytes()

    def radius_at(self, place: fx.FlatExpression) -> fx.FlatExpression | None:
        """Of what is drawn at a place."""
        names = {place, place.frame} if isinstance(place, fx.FrameOrigin) else {place}
        for drawing in self.flat.drawings:
            for role, value in drawing.arguments if names & set(drawing.anchors) else ():
                if role == "radius" and not isinstance(value, str):
                    return value
        return None

    # ---- numbers -----------------------------------------------------------------------------------------------------

    def at(
        self,
        seed: int,
        rates: Mapping[str, float] = _NONE,
        moved: Mapping[str, float] = _NONE,
        *,
        parameters: float = 0.0,
    ) -> Evaluator:
        """At coordinates, states and a time at random, the same ones for the same seed, plus what is `moved`; rates
        that are not given are 0. Real parameters differ from their values by up to the part `parameters`."""
        flat, chance = self.flat, random.Random(seed)
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

    @cached_property
    def start(self) -> Evaluator:
        """The coordinates have their start values."""
        known, coordinates = Evaluator(self.flat, Values()), self.flat.coordinates
        return Evaluator(self.flat, Values(variables={each.name: number(known, each.start) for each in coordinates}))

    def numbers(self, value: fx.FlatExpression) -> Floats:
        """A scalar (positions,) at all positions."""
        return np.array([number(at, value) for at in self.positions])

    def places(self, point: fx.FlatExpression) -> Floats:
        """A point (positions, 3) at all positions."""
        return np.array([vector(at, point) for at in self.positions])

    # ---- what moves --------------------------------------------------------------------------------------------------

    def movers_of(self, expression: fx.FlatExpression) -> frozenset[str]:
        """The coordinates that an expression depends on."""
        coordinates = {coordinate.name for coordinate in self.flat.coordinates}
        return frozenset(name for name in self.dependence.of(expression) if name in coordinates)

    def derivatives(
        self, value: fx.FlatExpression, names: Sequence[str], seed: int, moved: Mapping[str, float] = _NONE
    ) -> Floats:
        """Derivatives of a scalar (names,) or a vector (names, 3) by coordinates, at a position at random."""
        told, rate = vector if is_vector(value) else number, fx.Derivative(value)
        return np.array([told(self.at(seed, {name: 1.0}, moved), rate) for name in names])

    def normal_of(self, gap: fx.FlatExpression, place: fx.FlatExpression, movers: frozenset[str]) -> Floats | None:
        """The unit vector n with d(gap)/dq_j = n . d(place)/dq_j for all `movers`, at two positions at random."""
        names = sorted(movers)
        a, b = (
            unit_vectors(self.derivatives(place, names, seed), self.derivatives(gap, names, seed)[:, None])
            for seed in range(2)
        )
        return a[0] if a is not None and b is not None and np.abs(a - b).max() <= HELD else None

    def straight(self, point: fx.FlatExpression) -> tuple[str, Floats] | None:
        """Of a point that slides on a line: the one coordinate that moves it, and the derivative (3,) by it."""
        movers = self.movers_of(point)
        if len(movers) != 1 or "time" in self.dependence.of(point):
            return None
        [name] = movers
        rows = np.array([self.derivatives(point, [name], seed)[0] for seed in range(3)])
        return (name, rows[0]) if constant(rows) and np.any(rows[0]) else None

    def slides(self) -> Iterator[tuple[fx.FlatExpression, str, Floats]]:
        """Points that slide on lines, with their coordinates and the derivatives (3,) by these."""
        for point in self.points:
            found = self.straight(point)
            if found is not None:
                yield point, *found

    # ---- points ------------------------------------------------------------------------------------------------------

    @property
    def points(self) -> tuple[fx.FlatExpression, ...]:
        """Masses, origins of frames with a body, named points: each place once."""
        flat = self.flat
        found = [*(mass.position for mass in flat.masses), *(fx.FrameOrigin(body.frame) for body in flat.bodies)]
        found += [fx.PointReference(item.name) for item in flat.named if isinstance(item, fm.Point)]
        return tuple(dict.fromkeys(found))

    def position_of(self, point: fx.FlatExpression) -> fx.FlatExpression:
        """A point by coordinates and parameters, as far as it has a name."""
        if isinstance(point, fx.PointReference) and isinstance(item := self.named[point.name], fm.Point):
            return item.position
        return point

    def fixed_points(self, frame: str) -> list[tuple[fx.FlatExpression, Floats]]:
        """Points of a body: named ones, origins of frames that are built on its own one, places at which it touches
        something, with their components along its axes. A frame that nothing moves has none."""
        if not self.movers_of(fx.FrameOrigin(frame)) | self.movers_of(fx.FrameAxis(frame, 0)):
            return []
        flat = self.flat
        named: list[fx.FlatExpression] = []
        for item in flat.named:
            if isinstance(item, fm.Point) and frame in self.frames_in(item.position):
                named.append(fx.PointReference(item.name))
            elif isinstance(item, fm.Frame) and item.parent == frame:
                named.append(fx.FrameOrigin(item.name))
        named += [mass.position for mass in flat.masses if frame in self.frames_in(mass.position)]
        changing = {each.name for each in (*flat.states, *flat.inputs, *flat.events.discretes)}
        lasting = (point for point in named if not changing & set(self.dependence.of(point)))
        found = [(point, own) for point in lasting if (own := self._in_frame(frame, point)) is not None]
        touching = (self.touching_point(frame, gap) for _, gap in self.gaps())
        return found + [(on_body(frame, each[1]), each[1]) for each in touching if each is not None]

    def _in_frame(self, frame: str, point: fx.FlatExpression) -> Floats | None:
        """The components (3,) along the axes of a frame, from its origin, of a point that is fixed in it."""
        origin = fx.FrameOrigin(frame)
        own = np.array([axes_at(at, frame) @ (vector(at, point) - vector(at, origin)) for at in self.positions[:3]])
        return np.asarray(own[0]) if constant(own) else None

    def frames_in(self, point: fx.FlatExpression) -> frozenset[str]:
        """The frames that the text of a point names, and those of points that it names."""
        found: set[str] = set()
        for node in postorder(point):
            if isinstance(node, fx.FrameOrigin | fx.FrameAxis):
                found.add(node.frame)
            elif isinstance(node, fx.PointReference) and (position := self.position_of(node)) is not node:
                found |= self.frames_in(position)
        return frozenset(found)

    def gaps(self) -> list[tuple[Contact | fm.Constraint, fx.FlatExpression]]:
        """Distances from walls that contacts keep positive and constraints of position keep zero."""
        found: list[tuple[Contact | fm.Constraint, fx.FlatExpression]] = []
        found += [(each, each.gap) for each in self.flat.events.contacts if not each.one_way]
        for each in self.flat.constraints:
            own = each.level == "position" and not (each.of_law or each.closure or each.normalisation or each.node)
            if own and len(each.residuals) == 1:  # several rows hold a point, as a pin does
                found.append((each, each.residuals[0]))
        return found

    def touching_point(self, frame: str, gap: fx.FlatExpression) -> tuple[Floats, Floats] | None:
        """The unit normal n (3,) of a plane, and the components r (3,) along the axes of a body's frame of its point
        whose distance from it is the gap: n . (origin + r) + c at all positions. Rotations of the body have to move the
        point."""
        origin = fx.FrameOrigin(frame)
        movers = self.movers_of(gap)
        turning = self.movers_of(fx.FrameAxis(frame, 0)) | self.movers_of(fx.FrameAxis(frame, 1))
        sliding = (movers & self.movers_of(origin)) - turning
        if not (sliding and movers & turning and movers <= sliding | turning):
            return None
        normal = self.normal_of(gap, origin, sliding)
        if normal is None:
            return None
        rows = np.array([[*(axes_at(at, frame) @ normal), 1.0] for at in self.positions])
        right = self.numbers(gap) - self.places(origin) @ normal
        if not (np.isfinite(rows).all() and np.isfinite(right).all()):
            return None
        found = np.linalg.lstsq(rows, right, rcond=1e-9)[0]
        exact = np.abs(rows @ found - right).max() <= HELD * max(1.0, float(np.abs(right).max()))
        return (normal, np.asarray(found[:3])) if exact else None

    def length_behind(
        self, moment: fx.FlatExpression, mass: fx.FlatExpression
    ) -> tuple[fx.FlatExpression, float] | None:
        """A parameter l with moment = c m l^2 whatever the parameters are, and c."""
        own = self.dependence.of(moment)
        ats = [self.at(seed, parameters=_SPREAD) for seed in range(3)]
        for each in self.flat.parameters:
            if each.name in own and each.dimension == LENGTH:
                name = fx.Variable(each.name)
                factors = np.array([number(at, moment) / (number(at, mass) * number(at, name) ** 2) for at in ats])
                if np.isfinite(factors).all() and np.ptp(factors) <= HELD * abs(factors[0]):
                    return name, float(factors[0])
        return None


def anchors_of(drawing: fm.Drawing) -> list[fx.FlatExpression]:
    """The points that a drawing stands at."""
    return [fx.FrameOrigin(each) if isinstance(each, str) else each for each in drawing.anchors]


def gravity_of(flat: fm.FlatModel) -> Floats | None:
    """Its direction (3,) at the start; None without gravity, and where it is not known."""
    if flat.gravity is None:
        return None
    found = vector(Evaluator(flat, Values()), flat.gravity)
    size = float(np.linalg.norm(found))
    return found / size if size > 0.0 else None


def up_of(flat: fm.FlatModel, *, planar: bool) -> Floats:
    """Against gravity at the start (3,); y in planar pictures, z without gravity."""
    down = None if planar else gravity_of(flat)
    return np.array([0.0, float(planar), float(not planar)]) if down is None else -down


def vector(at: Evaluator, expression: fx.FlatExpression) -> Floats:
    """Components (3,), all nan where they have no finite value."""
    try:
        found = at.vector(expression)
    except NotEvaluable:
        return np.full(3, np.nan)
    return found if np.isfinite(found).all() else np.full(3, np.nan)


def number(at: Evaluator, expression: fx.FlatExpression) -> float:
    """nan where it has no value."""
    try:
        return at.scalar(expression)
    except NotEvaluable:
        return float("nan")


def axes_at(at: Evaluator, frame: str) -> Floats:
    """The axes of a frame as rows (3, 3)."""
    return np.array([vector(at, fx.FrameAxis(frame, axis)) for axis in range(3)])


def constant(values: Floats) -> bool:
    """Are all rows the same?"""
    return bool(np.ptp(values, axis=0).max() <= HELD * max(float(np.abs(values).max()), 1.0))


def unit_vectors(moves: Floats, changes: Floats) -> Floats | None:
    """Orthogonal unit vectors e_k (components, 3) with changes_k = e_k . moves, for `moves` (n, 3) of a place and
    `changes` (n, components)."""
    if not (np.isfinite(moves).all() and np.isfinite(changes).all()):
        return None
    found = np.linalg.lstsq(moves, changes, rcond=HELD)[0].T
    off = np.abs(moves @ found.T - changes).max() > HELD * max(float(np.abs(changes).max()), 1e-300)
    return None if off or np.abs(found @ found.T - np.eye(len(found))).max() > HELD else np.asarray(found)


def fixed(values: Floats) -> fx.FlatExpression:
    """The vector (3,) with these components."""
    return fx.Vector(*(fx.Number(round(float(part), 12) + 0.0) for part in values))


def in_axes(frame: str, own: Floats) -> fx.FlatExpression:
    """The vector with these components (3,) along the axes of a frame."""
    return fixed(own) if frame == "world" else along_axes(frame, [fx.Number(round(x, 12) + 0.0) for x in own.tolist()])


def on_body(frame: str, own: Floats) -> fx.FlatExpression:
    """The point with these components along the axes of a frame."""
    origin = fx.FrameOrigin(frame)
    return fx.Binary("+", origin, in_axes(frame, own)) if np.any(own) else origin
