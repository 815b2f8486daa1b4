"""From the machine at its start to marks: parts by the rules of the scene, coordinates, loads, admissible motions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from lagdsl.flat import expression as fx
from lagdsl.flat import model as fm
from lagdsl.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.numerics.rank import Floats
from lagdsl.report.boxes import Box, Derivative, Name, Number, Row, Subscript
from lagdsl.report.figure.pose import Pose, pose
from lagdsl.report.marks import Arrow, Ball, Figure, Place, Role, Stroke, Style
from lagdsl.report.names import carrier_labels, indexed
from lagdsl.report.page import Page
from lagdsl.report.unicode_math import line
from lagdsl.scene.living import scene_of
from lagdsl.scene.shapes import Scene, Shape
from lagdsl.textbook.contributions import AppliedForce

_WIDTH = 420.0
_BESIDE, _ABOVE = 62.0, 26.0
_HIGHEST = 420.0
_MOST_LABELS = 8
_MOST_ARROWS = 24
_LENGTHS: dict[Role, float] = {"motion": 0.3, "load": 0.26, "weight": 0.2, "coordinate": 0.25}
_LINES: dict[str, Style] = {"rod": "rod", "rope": "thin", "spring": "thin", "damper": "thin", "slider": "thin"}


@dataclass
class _Sheet:
    """Marks in the plane of the picture, in meters; `project` takes places in space to it."""

    project: Callable[[Floats], Floats]
    size: float = 1.0
    strokes: list[tuple[list[Floats], Style]] = field(default_factory=list)
    balls: list[tuple[Floats, float, bool]] = field(default_factory=list)
    arrows: list[tuple[list[Floats], Role, Box | None, int]] = field(default_factory=list)

    def stroke(self, points: Sequence[Floats], style: Style) -> None:
        self.strokes.append(([self.project(point) for point in points], style))

    def arrow(self, points: Sequence[Floats], role: Role, label: Box | None, number: int = 0) -> None:
        self.arrows.append(([self.project(point) for point in points], role, label, number))


def figure(page: Page) -> Figure | None:
    """None for a model without a mass that a coordinate moves, and where its start is not known."""
    found = pose(page.flat)
    if found is None:
        return None
    places = [place for each in found.carriers if (place := found.vector(each)) is not None]
    if not places or not any(_moved(found, item.name) for item in page.flat.coordinates):
        return None
    scene = scene_of(page.flat)
    sheet = _Sheet(_projection(page.flat, scene.planar))
    _parts(sheet, found, scene)
    _masses(sheet, found)
    shown = [point for points, _ in sheet.strokes for point in points] + [place for place, _, _ in sheet.balls]
    spread = np.ptp(np.array(shown), axis=0)
    sheet.size = float(max(spread)) or 1.0
    _motions(sheet, found, page)
    for number, item in enumerate(page.flat.coordinates):
        _coordinate(sheet, found, page, item, number)
    _loads(sheet, found, page)
    _weights(sheet, found, page)
    return _placed(sheet, f"{page.flat.name} where its motion starts")


def _projection(flat: fm.FlatModel, planar: bool) -> Callable[[Floats], Floats]:
    """The plane itself, or a parallel view from above and aside with the vertical upward."""
    if planar:
        return lambda point: point[:2]
    up = _up(flat)
    first = np.eye(3)[0] if abs(up[0]) < 0.9 else np.eye(3)[1]
    first = first - (first @ up) * up
    first /= np.linalg.norm(first)
    towards = 0.5 * first + 0.4 * up + 0.77 * np.cross(first, up)
    towards /= np.linalg.norm(towards)
    right = np.cross(up, towards)
    right /= np.linalg.norm(right)
    turn = np.array([right, np.cross(towards, right)])
    return lambda point: np.asarray(turn @ point)


def _up(flat: fm.FlatModel) -> Floats:
    down = _gravity(flat)
    return np.array([0.0, 0.0, 1.0]) if down is None else -down


def _gravity(flat: fm.FlatModel) -> Floats | None:
    """Its direction; None without gravity."""
    if flat.gravity is None:
        return None
    try:
        found = Evaluator(flat, Values()).vector(flat.gravity)
    except NotEvaluable:
        return None
    size = float(np.linalg.norm(found))
    return found / size if np.isfinite(size) and size > 0.0 else None


def _parts(sheet: _Sheet, found: Pose, scene: Scene) -> None:
    for shape in scene.shapes:
        place = _place(found, scene, shape, "at")
        end = _place(found, scene, shape, "to")
        if place is None:
            continue
        if end is not None and shape.kind in _LINES:
            sheet.stroke(_zigzag(place, end) if shape.kind == "spring" else [place, end], _LINES[shape.kind])
        elif shape.kind == "ground":
            normal = _place(found, scene, shape, "normal")
            if normal is not None and np.linalg.norm(normal) > 0:
                along = np.cross(normal / np.linalg.norm(normal), [0.0, 0.0, 1.0])
                sheet.stroke([place - along, place + along], "ground")


def _place(found: Pose, scene: Scene, shape: Shape, role: str) -> Floats | None:
    column = dict(shape.numbers).get(role)
    if column is None:
        return None
    parts = scene.columns[column : column + 3]
    return found.vector(fx.Vector(*parts)) if len(parts) == 3 else None


def _zigzag(start: Floats, end: Floats) -> list[Floats]:
    way = end - start
    length = float(np.linalg.norm(way))
    side = np.cross(way, [0.0, 0.0, 1.0])
    if np.linalg.norm(side) < 1e-9 * length or length == 0.0:
        side = np.array([length, 0.0, 0.0])
    side *= 0.05 * length / max(float(np.linalg.norm(side)), 1e-300)
    inner = [start + way * (0.15 + 0.7 * (k + 0.5) / 10) + side * (-1) ** k for k in range(10)]
    return [start, start + 0.15 * way, *inner, start + 0.85 * way, end]


def _masses(sheet: _Sheet, found: Pose) -> None:
    points = len(found.flat.masses)
    for number, expression in enumerate(found.carriers):
        place = found.vector(expression)
        if place is not None:
            sheet.balls.append((sheet.project(place), 5.0 if number < points else 6.0, number >= points))
    for body in found.flat.bodies:
        origin, center = (
            found.vector(fx.FrameOrigin(body.frame)),
            found.carriers[points + found.flat.bodies.index(body)],
        )
        middle = found.vector(center)
        if origin is not None and middle is not None and np.linalg.norm(middle - origin) > 0:
            sheet.stroke([origin, middle], "outline")


def _moved(found: Pose, coordinate: str) -> list[tuple[int, fx.FlatExpression, Floats]]:
    """Masses that a coordinate moves, with the derivatives of their places."""
    rates = ((k, each, found.rate(each, coordinate)) for k, each in enumerate(found.carriers))
    return [(k, each, rate) for k, each, rate in rates if rate is not None and np.linalg.norm(rate) > 1e-9]


def _motions(sheet: _Sheet, found: Pose, page: Page) -> None:
    """∂r/∂q of every mass that a coordinate moves; arrows of one coordinate have one scale."""
    moved = [(number, item, _moved(found, item.name)) for number, item in enumerate(page.flat.coordinates)]
    count = sum(len(each) for _, _, each in moved)
    if count > _MOST_ARROWS:
        return
    labels = carrier_labels(page.flat)
    for number, item, own in moved:
        longest = max((float(np.linalg.norm(rate)) for _, _, rate in own), default=1.0)
        q = page.notation.of(page.derivation.symbols.q[number])
        for k, expression, rate in own:
            place = found.vector(expression)
            if place is None or item.name not in found.values:
                continue
            label = Derivative("∂", indexed(page.notation.letter("r"), labels[k]), q) if count <= _MOST_LABELS else None
            end = place + rate / longest * _LENGTHS["motion"] * sheet.size
            sheet.arrow([place, end], "motion", label, number)


def _coordinate(sheet: _Sheet, found: Pose, page: Page, item: fm.Coordinate, number: int) -> None:
    """The way of the first mass from the zero of the coordinate: an arc about its center, or a line beside it."""
    own = _moved(found, item.name)
    label = page.notation.of(page.derivation.symbols.q[number])
    value = found.values[item.name]
    if not own:
        _turning(sheet, found, item, label, number)
        return
    _, expression, rate = own[0]
    place, speed = found.vector(expression), float(np.linalg.norm(rate))
    curve = _curvature(found, expression, item.name)
    if place is None:
        return
    if item.unit == "rad" and curve is not None and abs(np.linalg.norm(curve) - speed) < 1e-2 * speed:
        center = place + curve
        begin = 0.0 if 0.12 < abs(value) < 6.3 else value
        last = value if begin == 0.0 else value + 0.6
        ways = [found.along(expression, item.name, s - value) for s in np.linspace(begin, last, 25)]
        points = [center + (0.42 + 0.08 * (number % 3)) * (each - center) for each in ways if each is not None]
        start = found.along(expression, item.name, begin - value)
        if start is not None and begin == 0.0:
            sheet.stroke([center, center + 0.7 * (start - center)], "reference")
        sheet.arrow(points, "coordinate", label, number)
        return
    begin_at = found.along(expression, item.name, -value)
    long = begin_at is not None and np.linalg.norm(place - begin_at) > 0.08 * sheet.size
    start = begin_at if long and begin_at is not None else place
    end = place if long else place + rate / speed * _LENGTHS["coordinate"] * sheet.size
    side = np.cross(end - start, [0.0, 0.0, 1.0])
    size = float(np.linalg.norm(side))
    shift = side / size * (0.07 + 0.05 * number) * sheet.size if size > 0 else np.zeros(3)
    sheet.stroke([start, start + 1.15 * shift], "reference")
    sheet.arrow([start + shift, end + shift], "coordinate", label, number)


def _curvature(found: Pose, expression: fx.FlatExpression, coordinate: str) -> Floats | None:
    """Second derivative of the place, by differences."""
    behind, middle, ahead = (found.along(expression, coordinate, step) for step in (-1e-3, 0.0, 1e-3))
    if behind is None or middle is None or ahead is None:
        return None
    return (ahead - 2 * middle + behind) / 1e-6


def _turning(sheet: _Sheet, found: Pose, item: fm.Coordinate, label: Box, number: int) -> None:
    """An arc about the mass centre of the first body that the coordinate turns in its place."""
    for body, center in zip(found.flat.bodies, found.carriers[len(found.flat.masses) :], strict=True):
        axes = [found.vector(fx.FrameAxis(body.frame, axis)) for axis in range(3)]
        rates = [found.rate(fx.FrameAxis(body.frame, axis), item.name) for axis in range(3)]
        place = found.vector(center)
        if place is None or any(each is None for each in (*axes, *rates)):
            continue
        spin = 0.5 * sum((np.cross(a, r) for a, r in zip(axes, rates, strict=True)), np.zeros(3))  # type: ignore[arg-type]
        if np.linalg.norm(spin) < 1e-9:
            continue
        normal = spin / np.linalg.norm(spin)
        first = np.cross(normal, np.eye(3)[int(np.argmin(np.abs(normal)))])
        first *= (0.14 + 0.05 * number) * sheet.size / np.linalg.norm(first)
        arc = [place + np.cos(s) * first + np.sin(s) * np.cross(normal, first) for s in np.linspace(0.0, 1.8, 20)]
        sheet.arrow(arc, "coordinate", label, number)
        return


def _loads(sheet: _Sheet, found: Pose, page: Page) -> None:
    """Forces that have a place, numbered as in the table of loads."""
    for number, step in enumerate(page.derivation.actions, start=1):
        load = page.flat.loads[step.load]
        if not isinstance(step.action, AppliedForce) or not isinstance(load, fm.PointForce):
            continue
        place = load.origin if step.back and load.origin is not None else load.point
        at, force = found.vector(place), found.vector(load.force)
        if at is None or force is None or np.linalg.norm(force) == 0.0:
            continue
        way = force / np.linalg.norm(force) * _LENGTHS["load"] * sheet.size * (-1.0 if step.back else 1.0)
        sheet.arrow([at, at + way], "load", Subscript(page.notation.letter("F"), Number(str(number))))


def _weights(sheet: _Sheet, found: Pose, page: Page) -> None:
    down = _gravity(page.flat)
    if down is None:
        return
    few = len(found.carriers) <= _MOST_LABELS
    for expression, inertial in zip(found.carriers, page.derivation.inertials, strict=True):
        place = found.vector(expression)
        if place is not None:
            label = Row((page.typeset(inertial.mass), Name("𝐠"))) if few and inertial.mass.is_Symbol else None
            sheet.arrow([place, place + down * _LENGTHS["weight"] * sheet.size], "weight", label)


def _placed(sheet: _Sheet, words: str) -> Figure:
    """The sheet in points of a page; ground lines do not count for its extent, they reach its edges."""
    places = [point for points, style in sheet.strokes if style != "ground" for point in points]
    places += [place for place, _, _ in sheet.balls]
    places += [point for points, _, _, _ in sheet.arrows for point in points]
    low, high = np.min(np.array(places), axis=0), np.max(np.array(places), axis=0)
    spread = np.maximum(high - low, 0.25 * float(max(*(high - low), 1e-9)))
    middle = (low + high) / 2
    scale = min((_WIDTH - 2 * _BESIDE) / spread[0], (_HIGHEST - 2 * _ABOVE) / spread[1])
    height = float(spread[1] * scale + 2 * _ABOVE)

    def at(place: Floats) -> Place:
        x, y = (place - middle) * scale + np.array([_WIDTH, height]) / 2
        return (round(float(x), 1), round(float(y), 1))

    marks: list[Stroke | Ball] = []
    for points, style in sheet.strokes:
        marks.append(
            Stroke(_across(at(points[0]), at(points[1])) if style == "ground" else tuple(map(at, points)), style)
        )
    marks += [Ball(at(place), radius, hollow) for place, radius, hollow in sheet.balls]
    pointing = []
    for points, role, label, number in sheet.arrows:
        own = tuple(map(at, points))
        pointing.append(Arrow(own, role, label, own[-1], number))
    return Figure(_WIDTH, round(height, 1), (*marks, *_label_places(pointing, height)), words)


def _across(a: Place, b: Place) -> tuple[Place, ...]:
    """A line through two places from edge to edge of the picture."""
    way = np.array(b) - np.array(a)
    size = float(np.linalg.norm(way)) or 1.0
    ends = (np.array(a) + sign * way / size * _WIDTH for sign in (-1.0, 1.0))
    return tuple((round(float(x), 1), round(float(y), 1)) for x, y in ends)


def _beside(points: Sequence[Place], role: Role) -> tuple[Floats, Floats]:
    """Place and direction of a label: beyond the head of an arrow, beside the middle of a coordinate."""
    if role == "coordinate":
        k = len(points) // 2
        a, b = np.array(points[k - 1]), np.array(points[k])
        middle, beyond = (b if len(points) > 2 else (a + b) / 2), np.array([(b - a)[1], -(b - a)[0]])
    else:
        a, middle = np.array(points[0]), np.array(points[-1])
        beyond = middle - a
    return middle, beyond / (float(np.linalg.norm(beyond)) or 1.0)


def _label_places(arrows: Sequence[Arrow], height: float) -> list[Arrow]:
    """Labels beyond what they name, apart from each other and inside the picture."""
    taken: list[tuple[float, float, float]] = []
    result = []
    for arrow in arrows:
        if arrow.label is None:
            result.append(arrow)
            continue
        wide = 3.1 * len(line(arrow.label)) + 3.0
        place, beyond = _beside(arrow.points, arrow.role)
        x, y = place + beyond * np.array([wide + 3.0, 11.0])
        x = min(max(x, wide), _WIDTH - wide)
        free = (
            (x, min(max(y + dy, 8.0), height - 8.0))
            for dy in (0.0, 14.0, -14.0, 28.0, -28.0, 42.0, -42.0)
            if all(abs(x - a) > wide + w or abs(y + dy - b) > 12.5 for a, b, w in taken)
        )
        x, y = next(free, (x, y))
        taken.append((x, y, wide))
        result.append(replace(arrow, at=(round(float(x), 1), round(float(y), 1))))
    return result
