"""Points and frames of the flat model as positions and rotation matrices, literally.

A *release* displaces one point, or one frame and all it carries, by an extra coordinate s: the constraint that the text
has built in is taken away, and the equation of s gives the force that upheld it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal, assert_never

from sympy import Expr, Symbol

from lagdsl.derivation.textbook import geometry
from lagdsl.derivation.textbook.geometry import Rotation, Vector
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import Frame, Move, Place, Point, Rotate, RotateAbout, RotateQuaternion, SetAxes


@dataclass(frozen=True, slots=True, kw_only=True)
class Release:
    """The point moves by s*direction; the frame is displaced by, or turned through, s along world axis `axis`."""

    kind: Literal["point", "displace frame", "turn frame"]
    name: str
    direction: Vector = geometry.ZERO
    axis: int = 0


RELEASE = Symbol("released coordinate")
RELEASE_RATE = Symbol("der(released coordinate)")


@dataclass(frozen=True, slots=True)
class Pose:
    """Columns of `rotation` are the axes, in world components; `origin` from the world origin."""

    rotation: Rotation
    origin: Vector


WORLD = Pose(geometry.IDENTITY, geometry.ZERO)


@dataclass
class Kinematics:
    """Poses by name, made in the order of the flat model. `scalar` and `vector` convert expressions; `rate` is d/dt;
    `tidy` leaves everything as it is, except in reports."""

    scalar: Callable[[FlatExpression], Expr]
    vector: Callable[[FlatExpression], Vector]
    rate: Callable[[Expr], Expr]
    tidy: Callable[[Expr], Expr]
    release: Release | None = None
    poses: dict[str, Pose] = field(default_factory=lambda: {"world": WORLD})
    points: dict[str, Vector] = field(default_factory=dict)
    _spins: dict[str, Vector] = field(default_factory=dict)
    _body_spins: dict[str, Vector] = field(default_factory=dict)

    def place_point(self, point: Point) -> None:
        position = self.vector(point.position)
        release = self.release
        if release is not None and release.kind == "point" and release.name == point.name:
            position = geometry.add(position, geometry.scale(RELEASE, release.direction))
        self.points[point.name] = geometry.each(self.tidy, position)

    def place_frame(self, frame: Frame) -> None:
        pose = self.poses[frame.parent]
        for step in frame.steps:
            pose = self._step(pose, step)
        release = self.release
        image = frame.image
        if release is not None and release.name in (frame.name, image.of if image is not None else None):
            # The release is given in the world, the pose as seen from another frame.
            seen = geometry.transpose(self.poses[image.within].rotation) if image is not None else geometry.IDENTITY
            match release.kind:
                case "displace frame":
                    shift = geometry.scale(RELEASE, geometry.apply(seen, geometry.IDENTITY[release.axis]))
                    pose = Pose(pose.rotation, geometry.add(pose.origin, shift))
                case "turn frame":
                    turn = geometry.turn(release.axis, RELEASE)
                    turn = geometry.multiply(seen, geometry.multiply(turn, geometry.transpose(seen)))
                    pose = Pose(geometry.multiply(turn, pose.rotation), pose.origin)
                case "point":
                    pass
        self.poses[frame.name] = Pose(self._tidy(pose.rotation), geometry.each(self.tidy, pose.origin))

    def _tidy(self, rotation: Rotation) -> Rotation:
        x, y, z = (geometry.each(self.tidy, row) for row in rotation)
        return (x, y, z)

    def _step(self, pose: Pose, step: Rotate | RotateAbout | RotateQuaternion | SetAxes | Move | Place) -> Pose:
        match step:
            case Rotate(axis, angle):
                return Pose(geometry.multiply(pose.rotation, geometry.turn(axis, self.scalar(angle))), pose.origin)
            case RotateAbout(axis, angle):
                x, y, z = (self.scalar(component) for component in axis)
                turn = geometry.turn_about((x, y, z), self.scalar(angle))
                return Pose(geometry.multiply(pose.rotation, turn), pose.origin)
            case RotateQuaternion(e):
                w, x, y, z = (self.scalar(component) for component in e)
                return Pose(geometry.multiply(pose.rotation, geometry.turn_quaternion((w, x, y, z))), pose.origin)
            case SetAxes(x_axis, y_axis, z_axis):
                columns = (self.vector(x_axis), self.vector(y_axis), self.vector(z_axis))
                return Pose(geometry.transpose(columns), pose.origin)
            case Move(offset):
                x, y, z = (self.scalar(component) for component in offset)
                return Pose(pose.rotation, geometry.add(pose.origin, geometry.apply(pose.rotation, (x, y, z))))
            case Place(position):
                return Pose(pose.rotation, self.vector(position))
            case _:
                assert_never(step)

    def axis(self, frame: str, axis: int) -> Vector:
        return geometry.transpose(self.poses[frame].rotation)[axis]

    def angular_velocity(self, frame: str) -> Vector:
        """omega in world components: dR/dt R' = [omega]x."""
        if frame not in self._spins:
            rotation = self.poses[frame].rotation
            spin = geometry.multiply(self._rotation_rate(rotation), geometry.transpose(rotation))
            self._spins[frame] = geometry.each(self.tidy, geometry.vee(spin))
        return self._spins[frame]

    def body_angular_velocity(self, frame: str) -> Vector:
        """omega in the frame's own components: R' dR/dt = [omega]x."""
        if frame not in self._body_spins:
            rotation = self.poses[frame].rotation
            spin = geometry.multiply(geometry.transpose(rotation), self._rotation_rate(rotation))
            self._body_spins[frame] = geometry.each(self.tidy, geometry.vee(spin))
        return self._body_spins[frame]

    def _rotation_rate(self, rotation: Rotation) -> Rotation:
        x, y, z = (geometry.each(self.rate, row) for row in rotation)
        return (x, y, z)

    def material_velocity(self, position: Vector, frame: str) -> Vector:
        """Velocity of the point of `frame` that is at `position` now."""
        origin = self.poses[frame].origin
        arm = geometry.subtract(position, origin)
        return geometry.add(geometry.each(self.rate, origin), geometry.cross(self.angular_velocity(frame), arm))
