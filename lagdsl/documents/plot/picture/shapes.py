"""One maker for each kind of shape: its parts at one row of the scene, in sizes and colors of the living page."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import field

import numpy as np

from lagdsl.derivation.scene.shapes import Shape, ShapeKind
from lagdsl.documents.plot.picture.colors import color_of
from lagdsl.documents.plot.picture.faces import (
    Faces,
    Part,
    Ribbon,
    Words,
    between,
    coil,
    cube,
    cylinder,
    matrix_of,
    placed,
    sphere,
    torus,
)
from lagdsl.documents.plot.picture.stage import Stage
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

_WORLD = np.eye(3)
_CLEAR = 0.55  # opacity of ellipsoids of inertia
_SPOKE = (0.973, 0.980, 0.988)
_AXES = ((0.863, 0.149, 0.149), (0.086, 0.639, 0.290), (0.145, 0.388, 0.922))


@record(kw_only=True)
class Pose:
    """A shape of a stage at row `row` of its motion."""

    shape: Shape
    stage: Stage
    row: int
    numbers: dict[str, int] = field(default_factory=dict)
    mesh: Floats | None = None

    def vector(self, role: str) -> Floats:
        return self.wide(role, 3)

    def wide(self, role: str, width: int) -> Floats:
        first = self.numbers[role]
        return np.array(self.stage.rows[self.row, first : first + width])

    def scalar(self, role: str, otherwise: float) -> float:
        return float(self.wide(role, 1)[0]) if role in self.numbers else otherwise

    @property
    def color(self) -> tuple[float, float, float]:
        return color_of(self.shape)

    @property
    def axes(self) -> Floats:
        """Axes of the frame that the shape stands on, else of the world, as rows."""
        return np.array([self.vector(axis) for axis in "xyz"]) if "x" in self.numbers else _WORLD

    @property
    def along(self) -> Floats:
        """Direction of `axis` in the frame's own axes, else z."""
        if "axis" not in self.shape.vectors:
            return np.asarray(self.axes[2])
        made = self.vector("axis") @ self.axes
        size = float(np.linalg.norm(made))
        return np.asarray(made / size if size > 0.0 else _WORLD[2])

    def solid(self, unit: Floats, matrix: Floats, opacity: float = 1.0) -> Faces:
        return Faces(corners=placed(unit, matrix), color=self.color, opacity=opacity)


Maker = Callable[[Pose], list[Part]]


def parts_of(stage: Stage, row: int, without: Collection[ShapeKind] = ()) -> list[Part]:
    """Everything that is drawn of the machine at a row, but for some kinds of shapes."""
    found: list[Part] = []
    for k, shape in enumerate(stage.scene.shapes):
        maker = MAKERS.get(shape.kind)
        if maker is None or shape.kind in without:
            continue
        pose = Pose(shape=shape, stage=stage, row=row, numbers=dict(shape.numbers), mesh=stage.meshes.get(k))
        used = {role: stage.rows[row, column] for role, column in shape.numbers}
        if all(np.isfinite(value) for value in used.values()):
            found += maker(pose)
    return found


def _bar(part: float) -> Maker:
    def make(pose: Pose) -> list[Part]:
        radius = pose.scalar("radius", part * pose.stage.length)
        return [pose.solid(cylinder(), between(pose.vector("at"), pose.vector("to"), radius))]

    return make


def _spring(pose: Pose) -> list[Part]:
    radius = pose.scalar("radius", 0.03 * pose.stage.length)
    points = placed(coil(), between(pose.vector("at"), pose.vector("to"), radius))
    return [Ribbon(points=points, width=0.32 * radius, color=pose.color)]


def _damper(pose: Pose) -> list[Part]:
    """Thick in the middle."""
    a, b, length = pose.vector("at"), pose.vector("to"), pose.stage.length
    thick = between(a + 0.2 * (b - a), a + 0.6 * (b - a), 0.016 * length)
    return [pose.solid(cylinder(), between(a, b, 0.005 * length)), pose.solid(cylinder(), thick)]


def _ball(pose: Pose) -> list[Part]:
    most = pose.stage.scales["mass"]
    share = float(np.cbrt(max(pose.scalar("mass", most), 0.0) / most)) if most > 0.0 else 1.0
    radius = pose.scalar("radius", 0.04 * pose.stage.length * max(share, 0.25))
    x, y, z = pose.axes * radius
    return [pose.solid(sphere(), matrix_of(x, y, z, pose.vector("at")))]


def _ellipsoid(pose: Pose) -> list[Part]:
    """The homogeneous ellipsoid of the mass and inertia: a^2 = 5 (I_yy + I_zz - I_xx) / (2 m), or a bar."""
    mass, length = pose.scalar("mass", 1.0), pose.stage.length
    xx, yy, zz, xy, xz, yz = pose.wide("inertia", 6)
    values, own = np.linalg.eigh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    least = 0.012 * length
    squares = 2.5 * (values.sum() - 2.0 * values) / mass if mass > 0.0 else np.zeros(3)
    semi = [min(max(float(np.sqrt(square)), least), length) if square > 0.0 else least for square in squares]
    com = pose.vector("com")
    if _is_bar(values, com):
        semi = [min(float(np.sqrt(3.0 * values[2] / mass)), length), least, least]
        along = com / np.linalg.norm(com)
        own = np.array([along, np.cross([0.0, 0.0, 1.0], along), [0.0, 0.0, 1.0]]).T
    if np.linalg.det(own) < 0.0:
        own[:, 0] *= -1.0
    x, y, z = ((own[:, k] @ pose.axes) * semi[k] for k in range(3))
    # Bodies may stand in each other: gimbals and their rotor.
    return [pose.solid(sphere(), matrix_of(x, y, z, pose.vector("at") + com @ pose.axes), _CLEAR)]


def _is_bar(moments: Floats, com: Floats) -> bool:
    """True for the moment about the normal of a plane alone: a slender bar from its frame to both sides of its mass
    center has it, I = m l^2/12; no ellipsoid does."""
    flat = abs(moments[1]) <= 1e-9 * moments[2] and abs(com[2]) <= 1e-9 * np.linalg.norm(com)
    return bool(flat and moments[2] > 0.0 and np.linalg.norm(com[:2]) > 0.0)


def _box(pose: Pose) -> list[Part]:
    """Length along x (or from A to B), width and height across; in planar pictures the height is upright."""
    size = 0.09 * pose.stage.length
    width, height = pose.scalar("width", size), pose.scalar("height", size)
    across, up = (height, width) if pose.stage.scene.planar else (width, height)
    if "to" in pose.numbers:
        laid = between(pose.vector("at"), pose.vector("to"), across, up)
        return [pose.solid(np.asarray(cube() + np.array([0.0, 0.0, 0.5])), laid)]
    sized = "size" in pose.shape.vectors
    sizes = pose.vector("size") if sized else np.array([pose.scalar("length", size), across, up])
    x, y, z = pose.axes * sizes[:, None]
    return [pose.solid(cube(), matrix_of(x, y, z, pose.vector("at")))]


def _turned(part: float, slim: float, top: float) -> Maker:
    """Cylinders, discs and cones on a frame stand about their axis, their middle at its origin."""

    def make(pose: Pose) -> list[Part]:
        return [pose.solid(cylinder(top), _upright(pose, part, slim, top))]

    return make


def _upright(pose: Pose, part: float, slim: float, top: float) -> Floats:
    """Of a body of revolution; its cross section turns with the frame."""
    radius, a = pose.scalar("radius", part * pose.stage.length), pose.vector("at")
    if "to" in pose.numbers:
        return between(a, pose.vector("to"), radius)
    axis = pose.along
    length = pose.scalar("length", pose.scalar("height", slim * radius))
    start, end = (-length / 2.0, length / 2.0) if top == 1.0 else (length, 0.0)
    matrix = between(a + start * axis, a + end * axis, radius)
    unit = matrix[:3, 2] / (np.linalg.norm(matrix[:3, 2]) or 1.0)
    own = pose.axes[0] - (pose.axes[0] @ unit) * unit
    size = float(np.linalg.norm(own))
    if size > 1e-6:
        own /= size
        matrix[:3, 0], matrix[:3, 1] = own * radius, np.cross(unit, own) * radius
    return matrix


def _disc(pose: Pose) -> list[Part]:
    """A disc shows that it turns: a spoke on both faces."""
    matrix = _upright(pose, 0.1, 0.12, 1.0)
    spoke = cube() * [0.9, 0.08, 1.04] + [0.45, 0.0, 0.5]
    return [pose.solid(cylinder(), matrix), Faces(corners=placed(np.asarray(spoke), matrix), color=_SPOKE)]


def _circle(pose: Pose) -> list[Part]:
    radius = pose.scalar("radius", 0.014 * pose.stage.length)
    x, y, z = pose.axes * radius
    unit = torus(0.02 if "radius" in pose.numbers else 0.28)
    return [pose.solid(unit, matrix_of(x, y, z, pose.vector("at")))]


def _surface(pose: Pose) -> list[Part]:
    """Triangles of a file; none where the file has none."""
    if pose.mesh is None:
        return []
    sizes = pose.vector("scale") if "scale" in pose.shape.vectors else np.full(3, pose.scalar("scale", 1.0))
    x, y, z = pose.axes * sizes[:, None]
    turned = pose.mesh[:, ::-1] if np.prod(sizes) < 0.0 else pose.mesh
    return [pose.solid(turned, matrix_of(x, y, z, pose.vector("at")))]


def _load(kind: str) -> Maker:
    """Loads are as long as they are large."""
    return lambda pose: _arrow(pose, pose.vector("vector") * pose.stage.scales[kind])


def _direction(pose: Pose) -> list[Part]:
    """A direction of the user has one length, two points theirs."""
    if "vector" not in pose.numbers:
        return _arrow(pose, pose.vector("to") - pose.vector("at"))
    way = pose.vector("vector")
    size = float(np.linalg.norm(way))
    return _arrow(pose, way * (0.2 * pose.stage.length / size) if size > 0.0 else way)


def _arrow(pose: Pose, way: Floats) -> list[Part]:
    at, size, length = pose.vector("at"), pose.stage.length, float(np.linalg.norm(way))
    if length <= 1e-6 * size:
        return []
    neck = at + way * (1.0 - min(0.05 * size, 0.6 * length) / length)
    shaft, tip = between(at, neck, 0.006 * size), between(neck, at + way, 0.018 * size)
    return [pose.solid(cylinder(), shaft), pose.solid(cylinder(0.001), tip)]


def _trace(pose: Pose) -> list[Part]:
    """The way of a point so far, and faintly all of it."""
    first, width = pose.numbers["at"], 0.006 * pose.stage.length
    every = pose.stage.rows[:, first : first + 3]
    found: list[Part] = [Ribbon(points=every, width=width, color=pose.color, opacity=0.2)]
    if pose.row > 0:
        found.append(Ribbon(points=every[: pose.row + 1], width=width, color=pose.color))
    return found


def _written(pose: Pose) -> list[Part]:
    text = dict(pose.shape.texts).get("text", pose.shape.name)
    return [Words(text=text, at=pose.vector("at"), size=0.06 * pose.stage.length)]


def _ground(pose: Pose) -> list[Part]:
    """A plane that a contact keeps something from: it lies still; hatched where one sees its edge."""
    still = Pose(shape=pose.shape, stage=pose.stage, row=0, numbers=pose.numbers)
    normal, foot = still.vector("normal"), still.vector("at")
    length, center = pose.stage.length, pose.stage.center
    middle = center + (normal @ (foot - center)) * normal
    depth = 0.02 * length
    slab = cube() - np.array([0.0, 0.0, 0.5])
    x, y, z = between(middle - normal, middle, 1.3 * length)[:3, :3].T
    found: list[Part] = [pose.solid(slab, matrix_of(x, y, z / np.linalg.norm(z) * depth, middle))]
    if pose.stage.scene.planar:
        along = np.array([normal[1], -normal[0], 0.0])
        for part in np.linspace(-0.62, 0.64, 22):
            top = middle + along * part * length - depth * normal
            points = np.array([top, top - 1.6 * depth * normal - 1.6 * depth * along])
            found.append(Ribbon(points=points, width=0.2 * depth, color=pose.color))
    return found


MAKERS: dict[str, Maker] = {
    "rod": _bar(0.007),
    "rope": _bar(0.004),
    "spring": _spring,
    "damper": _damper,
    "box": _box,
    "cylinder": _turned(0.03, 2.4, 1.0),
    "cone": _turned(0.06, 2.0, 0.001),
    "disc": _disc,
    "sphere": _ball,
    "mass": _ball,
    "body": _ellipsoid,
    "circle": _circle,
    "mesh": _surface,
    "arrow": _direction,
    "force": _load("force"),
    "torque": _load("torque"),
    "trace": _trace,
    "text": _written,
    "ground": _ground,
}
