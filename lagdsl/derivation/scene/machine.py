"""Answers that the rules of shapes need of a model: numbers at positions at random, directions, parts of bodies.

A rule looks at values, not at texts: it holds for every model that says the same. A `draw` statement of the same
instance of a class takes the place of what the rules would draw for it.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from lagdsl.derivation.scene.drawings import along_axes, is_symbol, is_vector
from lagdsl.derivation.scene.shapes import Columns
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
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


@record()
class Machine:
    """Input of all rules: the model, the columns that they fill, its values at some positions, and what is drawn.

    `standing` are the places of drawings with a body of their own, `reached` the second ends of those between two
    points, `owners` the instances of classes that draw themselves, `down` the direction of gravity, if it has one.
    """

    flat: fm.FlatModel
    columns: Columns
    positions: tuple[Evaluator, ...]
    start: Evaluator
    dependence: Dependence
    named: Mapping[str, fm.Named]
    standing: frozenset[bytes]
    reached: frozenset[fx.FlatExpression | str]
    owners: frozenset[Spans]
    down: Floats | None

    def is_drawn(self, spans: Spans) -> bool:
        """Does the instance of a class that an item comes from draw itself?"""
        return bool(spans[1:]) and spans[1:] in self.owners

    def spelled(self, place: fx.FlatExpression) -> bytes:
        """The same for the same place at all positions."""
        return _spelled(self.positions, place)

    def is_hidden(self, symbol: fm.Drawing) -> bool:
        """Does a thing stand where a component would draw its symbol?"""
        return symbol.place != "between" and self.is_standing(anchors_of(symbol)[0])

    def is_standing(self, place: fx.FlatExpression) -> bool:
        """Does something with a body of its own stand at a place, wherever the machine is?"""
        return self.spelled(place) in self.standing


def _start(flat: fm.FlatModel) -> Evaluator:
    """The coordinates have their start values."""
    known = Evaluator(flat, Values())
    return Evaluator(flat, Values(variables={each.name: number(known, each.start) for each in flat.coordinates}))


def _spelled(positions: tuple[Evaluator, ...], place: fx.FlatExpression) -> bytes:
    return (np.round([vector(at, place) for at in positions], 9) + 0.0).tobytes()


def anchors_of(drawing: fm.Drawing) -> list[fx.FlatExpression]:
    """The points that a drawing stands at."""
    return [fx.FrameOrigin(each) if isinstance(each, str) else each for each in drawing.anchors]


def machine_of(flat: fm.FlatModel, columns: Columns) -> Machine:
    drawings = flat.drawings
    positions = tuple(evaluator_at(flat, seed) for seed in range(_POSITIONS))
    solid = [drawing for drawing in drawings if drawing.shape not in _THIN and not is_symbol(drawing)]
    return Machine(
        flat,
        columns,
        positions,
        _start(flat),
        Dependence(flat),
        {item.name: item for item in flat.named},
        standing=frozenset(_spelled(positions, place) for drawing in solid for place in anchors_of(drawing)),
        reached=frozenset(drawing.anchors[-1] for drawing in drawings if drawing.place == "between"),
        owners=frozenset(drawing.spans[1:] for drawing in drawings),
        down=gravity_of(flat),
    )


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


def directional_derivatives(
    flat: fm.FlatModel, value: fx.FlatExpression, names: Sequence[str], seed: int, moved: Mapping[str, float] = _NONE
) -> Floats:
    """Derivatives of a scalar (names,) or a vector (names, 3) by coordinates, at a position at random."""
    told, rate = vector if is_vector(value) else number, fx.Derivative(value)
    return np.array([told(evaluator_at(flat, seed, {name: 1.0}, moved), rate) for name in names])


def fixed(values: Floats) -> fx.FlatExpression:
    """The vector (3,) with these components."""
    return fx.Vector(*(fx.Number(round(float(part), 12) + 0.0) for part in values))


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
) -> Floats | None:
    """The unit vector n with d(gap)/dq_j = n . d(place)/dq_j for all `movers`, at two positions at random."""
    names = sorted(movers)
    a, b = (
        unit_vectors(
            directional_derivatives(flat, place, names, k), directional_derivatives(flat, gap, names, k)[:, None]
        )
        for k in range(2)
    )
    return a[0] if a is not None and b is not None and np.abs(a - b).max() <= HELD else None


def unit_vectors(moves: Floats, changes: Floats) -> Floats | None:
    """Orthogonal unit vectors e_k (components, 3) with changes_k = e_k . moves, for `moves` (n, 3) of a place and
    `changes` (n, components)."""
    if not (np.isfinite(moves).all() and np.isfinite(changes).all()):
        return None
    found = np.linalg.lstsq(moves, changes, rcond=HELD)[0].T
    off = np.abs(moves @ found.T - changes).max() > HELD * max(float(np.abs(changes).max()), 1e-300)
    return None if off or np.abs(found @ found.T - np.eye(len(found))).max() > HELD else np.asarray(found)


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


def numbers(machine: Machine, value: fx.FlatExpression) -> Floats:
    """A scalar (positions,) at all positions."""
    return np.array([number(at, value) for at in machine.positions])


def places(machine: Machine, point: fx.FlatExpression) -> Floats:
    """A point (positions, 3) at all positions."""
    return np.array([vector(at, point) for at in machine.positions])


def constant(values: Floats) -> bool:
    """Are all rows the same?"""
    return bool(np.ptp(values, axis=0).max() <= HELD * max(float(np.abs(values).max()), 1.0))


def straight(machine: Machine, point: fx.FlatExpression) -> tuple[str, Floats] | None:
    """Of a point that slides on a line: the one coordinate that moves it, and the constant derivative (3,) by it."""
    movers = movers_of(machine, point)
    if len(movers) != 1 or "time" in machine.dependence.of(point):
        return None
    [name] = movers
    rows = np.array([directional_derivatives(machine.flat, point, [name], seed)[0] for seed in range(3)])
    return (name, rows[0]) if constant(rows) and np.any(rows[0]) else None


def slides(machine: Machine) -> Iterator[tuple[fx.FlatExpression, str, Floats]]:
    """Points that slide on lines, with their coordinates and the derivatives (3,) by these."""
    for point in points_of(machine.flat):
        found = straight(machine, point)
        if found is not None:
            yield point, *found


def points_of(flat: fm.FlatModel) -> tuple[fx.FlatExpression, ...]:
    """Masses, origins of frames with a body, named points: each place once."""
    found = [*(mass.position for mass in flat.masses), *(fx.FrameOrigin(body.frame) for body in flat.bodies)]
    found += [fx.PointReference(item.name) for item in flat.named if isinstance(item, fm.Point)]
    return tuple(dict.fromkeys(found))


def in_frame(machine: Machine, frame: str, point: fx.FlatExpression) -> Floats | None:
    """The components (3,) along the axes of a frame, from its origin, of a point that is fixed in it."""
    origin = fx.FrameOrigin(frame)
    own = np.array([axes_at(at, frame) @ (vector(at, point) - vector(at, origin)) for at in machine.positions[:3]])
    return np.asarray(own[0]) if constant(own) else None


def fixed_points(machine: Machine, frame: str) -> list[tuple[fx.FlatExpression, Floats]]:
    """Points of a body: named ones, origins of frames that are built on its own one, places at which it touches
    something, with their components along its axes. A frame that nothing moves has none."""
    if not movers_of(machine, fx.FrameOrigin(frame)) | movers_of(machine, fx.FrameAxis(frame, 0)):
        return []
    named: list[fx.FlatExpression] = []
    for item in machine.flat.named:
        if isinstance(item, fm.Point) and frame in frames_in(machine, item.position):
            named.append(fx.PointReference(item.name))
        elif isinstance(item, fm.Frame) and item.parent == frame:
            named.append(fx.FrameOrigin(item.name))
    named += [mass.position for mass in machine.flat.masses if frame in frames_in(machine, mass.position)]
    changing = {each.name for each in (*machine.flat.states, *machine.flat.inputs, *machine.flat.events.discretes)}
    lasting = (point for point in named if not changing & set(machine.dependence.of(point)))
    found = [(point, own) for point in lasting if (own := in_frame(machine, frame, point)) is not None]
    for _, gap in gaps(machine):
        touching = touching_point(machine, frame, gap)
        if touching is not None:
            found.append((on_body(frame, touching[1]), touching[1]))
    return found


def frames_in(machine: Machine, point: fx.FlatExpression) -> frozenset[str]:
    """The frames that the text of a point names, and those of points that it names."""
    found: set[str] = set()
    for node in postorder(point):
        if isinstance(node, fx.FrameOrigin | fx.FrameAxis):
            found.add(node.frame)
        elif isinstance(node, fx.PointReference):
            item = machine.named[node.name]
            found |= frames_in(machine, item.position) if isinstance(item, fm.Point) else set()
    return frozenset(found)


def on_body(frame: str, own: Floats) -> fx.FlatExpression:
    """The point with these components along the axes of a frame."""
    origin = fx.FrameOrigin(frame)
    return fx.Binary("+", origin, in_axes(frame, own)) if np.any(own) else origin


def in_axes(frame: str, own: Floats) -> fx.FlatExpression:
    """The vector with these components (3,) along the axes of a frame."""
    return fixed(own) if frame == "world" else along_axes(frame, [fx.Number(round(x, 12) + 0.0) for x in own.tolist()])


def gaps(machine: Machine) -> list[tuple[Contact | fm.Constraint, fx.FlatExpression]]:
    """Distances from walls that contacts keep positive and constraints of position keep zero."""
    flat = machine.flat
    found: list[tuple[Contact | fm.Constraint, fx.FlatExpression]] = []
    found += [(each, each.gap) for each in flat.events.contacts if not each.one_way]
    for each in flat.constraints:
        own = each.level == "position" and not (each.of_law or each.closure or each.normalisation or each.node)
        if own and len(each.residuals) == 1:  # several rows hold a point, as a pin does
            found.append((each, each.residuals[0]))
    return found


def touching_point(machine: Machine, frame: str, gap: fx.FlatExpression) -> tuple[Floats, Floats] | None:
    """The unit normal n (3,) of a plane, and the components r (3,) along the axes of a body's frame of its point whose
    distance from it is the gap: n . (origin + r) + c at all positions. Rotations of the body have to move the point."""
    origin = fx.FrameOrigin(frame)
    movers = movers_of(machine, gap)
    turning = movers_of(machine, fx.FrameAxis(frame, 0)) | movers_of(machine, fx.FrameAxis(frame, 1))
    sliding = (movers & movers_of(machine, origin)) - turning
    if not (sliding and movers & turning and movers <= sliding | turning):
        return None
    normal = normal_of(machine.flat, gap, origin, sliding)
    if normal is None:
        return None
    rows = np.array([[*(axes_at(at, frame) @ normal), 1.0] for at in machine.positions])
    right = numbers(machine, gap) - places(machine, origin) @ normal
    if not (np.isfinite(rows).all() and np.isfinite(right).all()):
        return None
    found = np.linalg.lstsq(rows, right, rcond=1e-9)[0]
    exact = np.abs(rows @ found - right).max() <= HELD * max(1.0, float(np.abs(right).max()))
    return (normal, np.asarray(found[:3])) if exact else None


def length_behind(
    machine: Machine, moment: fx.FlatExpression, mass: fx.FlatExpression
) -> tuple[fx.FlatExpression, float] | None:
    """A parameter l with moment = c m l^2 whatever the parameters are, and c."""
    own = machine.dependence.of(moment)
    lengths = [each for each in machine.flat.parameters if each.name in own and each.dimension == LENGTH]
    ats = [evaluator_at(machine.flat, seed, parameters=_SPREAD) for seed in range(3)]
    for each in lengths:
        name = fx.Variable(each.name)
        factors = np.array([number(at, moment) / (number(at, mass) * number(at, name) ** 2) for at in ats])
        if np.isfinite(factors).all() and np.ptp(factors) <= HELD * abs(factors[0]):
            return name, float(factors[0])
    return None
