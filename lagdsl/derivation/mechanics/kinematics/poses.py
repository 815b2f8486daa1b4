"""The poses of all frames of a model, their angular velocities on demand, and what a release adds to them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field, replace
from typing import TypeVar, assert_never

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.kinematics import frames, velocities
from lagdsl.derivation.mechanics.kinematics.frames import Loosened, Motion, Pose, Put, Released, SetTo, Shift
from lagdsl.derivation.mechanics.kinematics.vectors import Axes, Vector, add, scale, to_own, to_world
from lagdsl.derivation.mechanics.kinematics.velocities import Rates, Twist
from lagdsl.foundation.record import record
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import (
    Frame,
    Move,
    Place,
    Rotate,
    RotateAbout,
    RotateQuaternion,
    SetAxes,
)

Value = TypeVar("Value", Vector, Twist)


@record()
class Release:
    """Indices of RELEASE symbols: three for the origin or the turning of a frame, one for a point along a direction."""

    origins: dict[str, int] = field(default_factory=dict)
    turns: dict[str, int] = field(default_factory=dict)
    points: dict[str, list[tuple[int, Vector]]] = field(default_factory=dict)

    def move_point(self, graph: Graph, name: str, position: Vector) -> Vector:
        for index, direction in self.points.get(name, ()):
            position = add(graph, position, scale(graph, graph.symbol(Group.RELEASE, index), direction))
        return position

    def move_frame(self, graph: Graph, name: str, pose: Pose, within: Axes | None) -> Pose:
        """The pose after the release of the frame `name`, which is given in the world; `within`: axes of the frame
        that the pose is seen from."""

        def seen(group: Group, first: int) -> Vector:
            given = _triple(graph, group, first)
            return given if within is None else to_own(graph, within, given)

        if name in self.origins:
            origin = add(graph, pose.origin, seen(Group.RELEASE, self.origins[name]))
            loosened = Loosened(seen(Group.RELEASE_RATE, self.origins[name]), pose.axes)
            pose = replace(pose, origin=origin, motions=(*pose.motions, loosened))
        if name in self.turns:
            angle = seen(Group.RELEASE, self.turns[name])
            rate = seen(Group.RELEASE_RATE, self.turns[name])
            axes, motion = frames.release(graph, pose.axes, angle, rate)
            pose = replace(pose, axes=axes, motions=(*pose.motions, motion))
        return pose


class Poses:
    """Poses by name; `world` is there from the start."""

    def __init__(self, graph: Graph, rates: Rates, release: Release) -> None:
        self._graph = graph
        self._rates = rates
        self.release = release
        self._poses = {"world": frames.world(graph)}
        self._put: set[str] = set()
        self._released: set[str] = set()
        at_rest = (graph.zero, graph.zero, graph.zero)
        self._own = {"world": at_rest}
        self._world = {"world": at_rest}
        self._twists = {"world": (at_rest, at_rest)}

    def __contains__(self, name: str) -> bool:
        return name in self._poses

    def is_released(self, name: str) -> bool:
        """True if a reaction releases this frame or one that carries it."""
        return name in self._released

    def is_carried(self, name: str) -> bool:
        """True if the origin moves as a place of the frames before it, not as a position given in the world."""
        return name not in self._put

    def __getitem__(self, name: str) -> Pose:
        return self._poses[name]

    def make(
        self, frame: Frame, node: Callable[[FlatExpression], int], triple: Callable[[FlatExpression], Vector]
    ) -> None:
        """The pose of a frame whose parent and expressions have been lowered."""
        parent = self._poses[frame.parent]
        axes, origin = parent.axes, parent.origin
        motions: list[Motion] = []
        for step in frame.steps:
            if isinstance(step, Move):
                x, y, z = (node(component) for component in step.offset)
                origin = add(self._graph, origin, to_world(self._graph, axes, (x, y, z)))
                motions.append(Shift((x, y, z)))
            elif isinstance(step, Place):
                origin = triple(step.position)
                motions.append(Put(origin, axes))
            else:
                axes, motion = self._turn(axes, step, node, triple)
                motions.append(motion)
        pose = Pose(frame.parent, axes, origin, tuple(motions))
        within = self._poses[frame.image.within].axes if frame.image is not None else None
        pose = self.release.move_frame(self._graph, frame.name, pose, within)
        if frame.image is not None and frame.image.of is not None:
            pose = self.release.move_frame(self._graph, frame.image.of, pose, within)
        self._poses[frame.name] = pose
        released = any(isinstance(motion, Loosened | Released) for motion in pose.motions)
        if released or self.is_released(frame.parent):
            self._released.add(frame.name)
        places = [motion.origin for motion in pose.motions if isinstance(motion, Put)]
        if any(self._graph.depends(x, Group.Q) for x in places[-1]) if places else not self.is_carried(frame.parent):
            self._put.add(frame.name)

    def _turn(
        self,
        axes: Axes,
        step: Rotate | RotateAbout | RotateQuaternion | SetAxes,
        node: Callable[[FlatExpression], int],
        triple: Callable[[FlatExpression], Vector],
    ) -> tuple[Axes, Motion]:
        match step:
            case Rotate(axis, angle):
                return frames.turn(self._graph, axes, axis, node(angle))
            case RotateAbout((x, y, z), angle):
                return frames.turn_about(self._graph, axes, (node(x), node(y), node(z)), node(angle))
            case RotateQuaternion((w, x, y, z)):
                return frames.turn_quaternion(self._graph, axes, (node(w), node(x), node(y), node(z)))
            case SetAxes(x, y, z):
                given = (triple(x), triple(y), triple(z))
                return given, SetTo(given, axes)
        assert_never(step)

    # ---- velocities --------------------------------------------------------------------------------------------------

    def own_velocity(self, name: str) -> Vector:
        """Angular velocity relative to the world in the frame's own axes."""
        return self._velocity(name, self._own, velocities.own_velocity)

    def world_velocity(self, name: str) -> Vector:
        """Angular velocity relative to the world in world axes."""
        return self._velocity(name, self._world, velocities.world_velocity)

    def own_twist(self, name: str) -> Twist:
        """Angular velocity and velocity of the origin relative to the world, in the frame's own axes."""
        return self._velocity(name, self._twists, velocities.own_twist)

    def _velocity(
        self, name: str, known: dict[str, Value], after: Callable[[Graph, Value, Motion, Rates], Value]
    ) -> Value:
        ancestry = []
        while name not in known:
            ancestry.append(name)
            parent = self._poses[name].parent
            assert parent is not None
            name = parent
        velocity = known[name]
        for descendant in reversed(ancestry):
            for motion in self._poses[descendant].motions:
                velocity = after(self._graph, velocity, motion, self._rates)
            known[descendant] = velocity
        return velocity


def _triple(graph: Graph, group: Group, first: int) -> Vector:
    return (graph.symbol(group, first), graph.symbol(group, first + 1), graph.symbol(group, first + 2))
