"""From the machine at its start to marks: parts by the rules of the scene, coordinates, loads, admissible motions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache, partial

import numpy as np

from lagdsl.derivation.scene.forms import triangles
from lagdsl.derivation.scene.living import scene_of
from lagdsl.derivation.scene.machine import gravity_of, number, up_of, vector
from lagdsl.derivation.scene.posed import Posed, placed
from lagdsl.derivation.scene.stage import Stage, stage_of
from lagdsl.documents.report.boxes import Box, Derivative, bold
from lagdsl.documents.report.figure.drawn_model import DrawnModel
from lagdsl.documents.report.figure.labels import labelled, width
from lagdsl.documents.report.figure.pose import Pose, pose
from lagdsl.documents.report.marks import Arrow, Ball, Caption, Figure, Mark, Place, Role, Stroke, Style
from lagdsl.documents.report.names import indexed
from lagdsl.foundation.numerics.connected_blocks import connected_blocks
from lagdsl.foundation.numerics.hull import hull
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.numerics.sparse_matrix import sparse
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.motion.pipeline import Compilation

_WIDTH = 420.0
_BESIDE, _ABOVE = 62.0, 26.0
_HIGHEST = 420.0
_MOST_LABELS = 8
_MOST_ARROWS = 24
_MOST_COORDINATES = 8
_MOST_NAMES = 12
_LONGEST_NAME = 72.0
_LENGTHS: dict[Role, float] = {"motion": 0.3, "load": 0.26, "weight": 0.2, "coordinate": 0.25}
_LINES: dict[str, Style] = {"rod": "rod", "rope": "thin"}
# Kinds that this drawing tells by marks of its own, forms that lie within others or come from files, and the ground.
_OWN_MARKS = frozenset({"frame", "force", "torque", "trace", "text", "arrow", "slider", "dial"})
_UNSEEN = frozenset({"octants", "marks", "file", "arrow"})
_STANDS = frozenset({"ground", "rail", "plane ground", "plane rail"})


@dataclass
class _Sheet:
    """Marks by their places in the plane of the picture, in meters, and what is made of these on a page.

    `project` takes places in space to the plane. Ground lines reach the edges: they are not counted for the extent.
    """

    project: Callable[[Floats], Floats]
    size: float = 1.0
    marks: list[tuple[Sequence[Floats], Callable[..., Mark]]] = field(default_factory=list)
    extent: list[Floats] = field(default_factory=list)

    def add(self, points: Iterable[Floats], make: Callable[..., Mark], *, counted: bool = True) -> None:
        seen = list(map(self.project, points))
        self.extent += seen if counted else ()
        self.marks.append((seen, make))

    def stroke(self, points: Iterable[Floats], style: Style) -> None:
        ground = style == "ground"
        self.add(points, lambda *at: Stroke(_across(*at) if ground else at, style), counted=not ground)

    def arrow(self, points: Iterable[Floats], role: Role, label: Box | None, number: int = 0) -> None:
        self.add(points, lambda *at: Arrow(at, role, label, at[-1], number))


def figure(drawn: DrawnModel, compilation: Compilation | None = None) -> Figure | None:
    """None for a model without a mass that a coordinate moves, and where its start is not known. `compilation` is that
    of the model if there is one."""
    flat = drawn.flat
    found = pose(flat, compilation)
    if found is None or not found.places or not any(found.moved(item.name) for item in flat.coordinates):
        return None
    scene, at = scene_of(flat), found.at()
    row = np.array([[number(at, each) for each in scene.columns]])
    stage = stage_of(scene, row, up_of(flat, planar=scene.planar))
    sheet = _Sheet(lambda point: np.asarray(stage.turn[:2] @ point))
    _parts(sheet, stage)
    points = len(flat.masses)
    for k, place in found.places:
        sheet.add([place], partial(Ball, radius=5.0 if k < points else 6.0, hollow=k >= points))
    spread = np.ptp([each for seen, _ in sheet.marks for each in seen], axis=0)
    sheet.size = float(max(spread)) or 1.0
    if drawn.in_full:
        _motions(sheet, found, drawn)
        _weights(sheet, found, drawn)
    else:
        _names(sheet, found, drawn)
    for k, item in enumerate(flat.coordinates[:_MOST_COORDINATES]):
        _coordinate(sheet, found, drawn.coordinates[k], item, k)
    _loads(sheet, found, drawn)
    return _placed(sheet, f"{flat.name} where its motion starts")


def _parts(sheet: _Sheet, stage: Stage) -> None:
    for shape in stage.scene.shapes:
        if shape.kind in _OWN_MARKS:
            continue
        for part in shape.parts:
            posed = Posed(stage, part, 0)
            if not posed.is_seen() or part.form in _UNSEEN:
                continue
            if part.primitive == "line":
                sheet.stroke(posed.line(), "thin")
            elif part.primitive != "surface":
                continue
            elif part.form in _STANDS:
                x, place = posed.matrix()[:3, 0], posed.matrix()[:3, 3]
                sheet.stroke([place - x, place + x], "ground")
            elif "to" in part.numbers and shape.kind in _LINES:
                sheet.stroke([posed.vector("at"), posed.vector("to")], _LINES[shape.kind])
            else:
                for points in outlines(part.form, posed.matrix(), sheet.project):
                    sheet.stroke(points, "outline")


def outlines(form: str, matrix: Floats, project: Callable[[Floats], Floats]) -> Iterator[list[Floats]]:
    """Closed lines (n, 3) around a unit form that `matrix` (4, 4) places, seen by `project`."""
    for piece in _pieces(form):
        points = placed(piece, matrix)
        rim = hull(np.array([project(point) for point in points]))
        yield [points[k] for k in (*rim, rim[0])]


@cache
def _pieces(form: str) -> list[Floats]:
    """Points (n, 3) of the connected parts of a form."""
    mesh = triangles(form)
    touched = np.zeros((len(mesh.corners), len(mesh.points)), dtype=bool)
    np.put_along_axis(touched, mesh.corners, True, axis=1)
    labels = connected_blocks(sparse(touched)).column_labels
    return [mesh.points[labels == k] for k in np.unique(labels)]


def _names(sheet: _Sheet, found: Pose, drawn: DrawnModel) -> None:
    """The masses and bodies of a machine without admissible motions, if they are few."""
    for k, place in found.places if len(found.elements) <= _MOST_NAMES else ():
        if width(drawn.carriers[k]) <= _LONGEST_NAME:
            sheet.add([place], lambda at, label=drawn.carriers[k]: Caption(at, label, at), counted=False)


def _motions(sheet: _Sheet, found: Pose, drawn: DrawnModel) -> None:
    """∂r/∂q of every mass that a coordinate moves; arrows of one coordinate have one scale."""
    moved = [found.moved(item.name) for item in drawn.flat.coordinates]
    count = sum(map(len, moved))
    if count > _MOST_ARROWS:
        return
    for j, own in enumerate(moved):
        longest = max((float(np.linalg.norm(rate)) for _, rate in own), default=1.0)
        for k, rate in own:
            place, r = found.vector(found.elements[k]), indexed(bold(drawn.letter("r")), drawn.carriers[k])
            label = Derivative("∂", r, drawn.coordinates[j]) if count <= _MOST_LABELS else None
            sheet.arrow([place, place + rate / longest * _LENGTHS["motion"] * sheet.size], "motion", label, j)


def _coordinate(sheet: _Sheet, found: Pose, label: Box, item: fm.Coordinate, number: int) -> None:
    """The way of the first mass from the zero of the coordinate: an arc about its center, or a line beside it."""
    own = found.moved(item.name)
    value = found.values[item.name]
    if not own:
        _turning(sheet, found, item, label, number)
        return
    k, rate = own[0]
    place, speed = found.vector(found.elements[k]), float(np.linalg.norm(rate))

    def at(step: float) -> Floats:
        return vector(found.at(moved={item.name: value + step}), found.elements[k])

    curve = (at(1e-3) - 2.0 * place + at(-1e-3)) / 1e-6
    if item.unit == "rad" and abs(np.linalg.norm(curve) - speed) < 1e-2 * speed:
        center = place + curve
        begin = 0.0 if 0.12 < abs(value) < 6.3 else value
        last = value if begin == 0.0 else value + 0.6
        ways = [at(s - value) for s in np.linspace(begin, last, 25)]
        if begin == 0.0:
            sheet.stroke([center, center + 0.7 * (ways[0] - center)], "reference")
        points = [center + (0.42 + 0.08 * (number % 3)) * (each - center) for each in ways]
        sheet.arrow(points, "coordinate", label, number)
        return
    begin_at = at(-value)
    long = np.linalg.norm(place - begin_at) > 0.08 * sheet.size
    start, end = (begin_at, place) if long else (place, place + rate / speed * _LENGTHS["coordinate"] * sheet.size)
    side = np.cross(end - start, [0.0, 0.0, 1.0])
    size = float(np.linalg.norm(side))
    shift = side / size * (0.07 + 0.05 * number) * sheet.size if size > 0 else np.zeros(3)
    sheet.stroke([start, start + 1.15 * shift], "reference")
    sheet.arrow([start + shift, end + shift], "coordinate", label, number)


def _turning(sheet: _Sheet, found: Pose, item: fm.Coordinate, label: Box, number: int) -> None:
    """An arc about the mass centre of the first body that the coordinate turns in its place."""
    for body, center in zip(found.flat.bodies, found.elements[len(found.flat.masses) :], strict=True):
        place, spin = found.vector(center), vector(found.at(item.name), fx.AngularVelocity(body.frame))
        if not (np.isfinite(place).all() and np.linalg.norm(spin) > 1e-9):
            continue
        normal = spin / np.linalg.norm(spin)
        first = np.cross(normal, np.eye(3)[int(np.argmin(np.abs(normal)))])
        first *= (0.14 + 0.05 * number) * sheet.size / np.linalg.norm(first)
        arc = [place + np.cos(s) * first + np.sin(s) * np.cross(normal, first) for s in np.linspace(0.0, 1.8, 20)]
        sheet.arrow(arc, "coordinate", label, number)
        return


def _loads(sheet: _Sheet, found: Pose, drawn: DrawnModel) -> None:
    """Forces that have a place; those of a long list without names."""
    for load in drawn.forces:
        at, force = found.vector(load.place), found.vector(load.force)
        if not (np.isfinite(at).all() and np.linalg.norm(force) > 0.0):
            continue
        way = force / np.linalg.norm(force) * _LENGTHS["load"] * sheet.size
        sheet.arrow([at, at + way], "load", load.label if len(drawn.forces) <= _MOST_LABELS else None)


def _weights(sheet: _Sheet, found: Pose, drawn: DrawnModel) -> None:
    down = gravity_of(drawn.flat)
    if down is None:
        return
    few = len(found.elements) <= _MOST_LABELS
    for k, place in found.places:
        way = [place, place + down * _LENGTHS["weight"] * sheet.size]
        sheet.arrow(way, "weight", drawn.weights[k] if few else None)


def _placed(sheet: _Sheet, words: str) -> Figure:
    """The sheet in points of a page."""
    low, high = np.min(sheet.extent, axis=0), np.max(sheet.extent, axis=0)
    spread = np.maximum(high - low, 0.25 * float(max(*(high - low), 1e-9)))
    middle = (low + high) / 2
    scale = min((_WIDTH - 2 * _BESIDE) / spread[0], (_HIGHEST - 2 * _ABOVE) / spread[1])
    height = float(spread[1] * scale + 2 * _ABOVE)

    def at(place: Floats) -> Place:
        x, y = (place - middle) * scale + np.array([_WIDTH, height]) / 2
        return (round(float(x), 1), round(float(y), 1))

    order = (Stroke, Ball, Caption, Arrow)
    marks = sorted((make(*map(at, seen)) for seen, make in sheet.marks), key=lambda mark: order.index(type(mark)))
    return Figure(_WIDTH, round(height, 1), labelled(marks, _WIDTH, height), words)


def _across(a: Place, b: Place) -> tuple[Place, ...]:
    """A line through two places from edge to edge of the picture."""
    way = np.array(b) - np.array(a)
    size = float(np.linalg.norm(way)) or 1.0
    ends = (np.array(a) + sign * way / size * _WIDTH for sign in (-1.0, 1.0))
    return tuple((round(float(x), 1), round(float(y), 1)) for x, y in ends)
