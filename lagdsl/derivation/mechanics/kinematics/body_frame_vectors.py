"""Geometric vectors in the axes of the frame that carries them, as far as their expressions tell.

omega(A) along A.x, the square of der(P) for a point P of A: in world components these go through the directions of all
axes up to the world, in A's own they are as small as those of a rigid body (Luh, Walker, Paul 1980). Scalar products do
not depend on the axes, so they are taken there.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TypeAlias, assert_never, cast

from lagdsl.algebra.graph.graph import Graph
from lagdsl.derivation.mechanics.kinematics.frames import Loosened, Put, Shift
from lagdsl.derivation.mechanics.kinematics.poses import Poses
from lagdsl.derivation.mechanics.kinematics.vectors import Vector, add, cross, divide, negate, scale, to_own
from lagdsl.derivation.mechanics.kinematics.velocities import Rates, Twist, derivative
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import Point

Parts: TypeAlias = "dict[str, Vector]"
"""A vector as a sum: components by frame whose axes they are along."""

# A sum over more frames than this is left in world components.
_MOST_FRAMES = 2


class OwnVectors:
    """Parts of the vectors of a model, memoised by identity. `lowered` gives scalars and world components."""

    def __init__(
        self,
        graph: Graph,
        poses: Poses,
        rates: Rates,
        points: Mapping[str, Point],
        lowered: Callable[[FlatExpression], int | Vector],
    ) -> None:
        self._graph, self._poses, self._rates, self._points, self._lowered = graph, poses, rates, points, lowered
        self._values: dict[int, Parts] = {}
        self._velocities: dict[int, Parts] = {}
        self.used: dict[str, None] = {}
        """Frames whose twist occurs."""
        self.places: dict[Vector, tuple[str, Vector]] = {}
        """Points whose velocity was taken along the axes of the frame that carries them: by world position the frame,
        and the place from its origin."""

    def dot(self, left: FlatExpression, right: FlatExpression) -> int:
        """The scalar product, in the axes of one frame where both are along its axes."""
        self._prepare(left)
        self._prepare(right)
        a, b = self._values_of(left), self._values_of(right)
        frames = [frame for frame in dict.fromkeys((*a, *b)) if frame != "world"]
        square = a == b
        if len(frames) != 1 or (not square and ("world" in a or "world" in b)):
            return self._graph.dot(self._world(left), self._world(right))
        own = self._along(frames[0], a)
        return self._graph.dot(own, own if square else self._along(frames[0], b))

    def velocity(self, point: FlatExpression) -> Vector | None:
        """The velocity of a point along the axes of the frame that carries it; None where none does alone."""
        self._prepare(point, moving=True)
        parts = self._velocity_of(point)
        self._note_place(point)
        return next(iter(parts.values())) if len(parts) == 1 and "world" not in parts else None

    def _along(self, frame: str, parts: Parts) -> Vector:
        graph, zero = self._graph, self._graph.zero
        own = parts.get(frame, (zero, zero, zero))
        if "world" in parts:
            own = add(graph, own, to_own(graph, self._poses[frame].axes, parts["world"]))
        return own

    def _world(self, expression: FlatExpression) -> Vector:
        return cast(Vector, self._lowered(expression))

    def _prepare(self, expression: FlatExpression, *, moving: bool = False) -> None:
        """Values and velocities of all operands first, so that long sums meet no limit of recursion."""
        stack = [(expression, moving)]
        while stack:
            current, of_rate = stack[-1]
            known = self._velocities if of_rate else self._values
            operands = [] if id(current) in known else _operands(self._points, current, moving=of_rate)
            missing = [(x, rate) for x, rate in operands if id(x) not in (self._velocities if rate else self._values)]
            if missing:
                stack += missing
                continue
            self._velocity_of(current) if of_rate else self._values_of(current)
            stack.pop()

    # ---- vectors -----------------------------------------------------------------------------------------------------

    def _values_of(self, expression: FlatExpression) -> Parts:
        known = self._values.get(id(expression))
        if known is None:
            known = self._values[id(expression)] = self._compact(self._value(expression), expression)
        return known

    def _compact(self, parts: Parts | None, expression: FlatExpression, *, rate: bool = False) -> Parts:
        zero = self._graph.zero
        if parts is not None:
            parts = {frame: own for frame, own in parts.items() if own != (zero, zero, zero)}
            if len(parts) <= _MOST_FRAMES:
                return parts
        world = self._world(expression)
        return {"world": derivative(world, self._rates) if rate else world}

    def _value(self, expression: FlatExpression) -> Parts | None:
        match expression:
            case flat.FrameAxis(frame, axis):
                x, y, z = (self._graph.one if k == axis else self._graph.zero for k in range(3))
                return {self._turned(frame): (x, y, z)}
            case flat.AngularVelocity(frame):
                return {self._turned(frame): self._twist(frame)[0]}
            case flat.Derivative(operand):
                self._note_place(operand)
                return self._velocity_of(operand)
            case flat.Unary("-", operand):
                return {frame: negate(self._graph, own) for frame, own in self._values_of(operand).items()}
            case flat.Binary("+" | "-" as sign, left, right):
                return self._sum(self._values_of(left), self._values_of(right), sign)
            case flat.Binary("*", factor, vector):
                return self._scaled(factor, self._values_of(vector))
            case flat.Binary("/", vector, divisor):
                by = cast(int, self._lowered(divisor))
                return {frame: divide(self._graph, own, by) for frame, own in self._values_of(vector).items()}
            case flat.Cross(left, right):
                a, b = self._values_of(left), self._values_of(right)
                if len(a) == len(b) == 1 and a.keys() == b.keys():
                    return {frame: cross(self._graph, own, b[frame]) for frame, own in a.items()}
                return None
            case flat.Number() | flat.Variable() | flat.Previous() | flat.Operation():
                return None
            case flat.PointReference() | flat.OfFrame() | flat.Mechanical() | flat.OfMechanism():
                return None
            case _:
                assert_never(expression)

    def _sum(self, left: Parts, right: Parts, sign: str) -> Parts:
        graph = self._graph
        total = dict(left)
        for frame, own in right.items():
            signed = own if sign == "+" else negate(graph, own)
            total[frame] = add(graph, total[frame], signed) if frame in total else signed
        return total

    def _scaled(self, factor: FlatExpression, parts: Parts) -> Parts:
        by = cast(int, self._lowered(factor))
        return {frame: scale(self._graph, by, own) for frame, own in parts.items()}

    def _twist(self, frame: str) -> Twist:
        """Both parts are made at once: motion by motion, the order in which they are eliminated best."""
        self.used[frame] = None
        return self._poses.own_twist(frame)

    def _turned(self, frame: str) -> str:
        """The frame itself or the ancestor that has its axes."""
        pose = self._poses[frame]
        while pose.parent is not None and all(isinstance(motion, Shift | Put | Loosened) for motion in pose.motions):
            frame = pose.parent
            pose = self._poses[frame]
        return frame

    def _note_place(self, point: FlatExpression) -> None:
        zero = self._graph.zero
        offset: Vector = (zero, zero, zero)
        axes: dict[str, None] = {}
        frame: str | None = None
        current: FlatExpression | None = point
        while current is not None:
            if isinstance(current, flat.PointReference):
                current = self._points[current.name].position
                continue
            if isinstance(current, flat.FrameOrigin):
                frame, current = current.frame, None
                continue
            if isinstance(current, flat.Binary) and current.operator == "+":
                arm, current = current.right, current.left
            else:
                arm, current = current, None
            for along, own in self._values_of(arm).items():
                offset = add(self._graph, offset, own)
                axes[along] = None
        if frame is None and len(axes) == 1:
            (frame,) = axes
            if self._poses[frame].origin != (zero, zero, zero):
                return
        if frame not in (None, "world") and not axes.keys() - {self._turned(frame)}:
            self.places[self._world(point)] = (frame, offset)

    # ---- velocities --------------------------------------------------------------------------------------------------

    def _velocity_of(self, expression: FlatExpression) -> Parts:
        known = self._velocities.get(id(expression))
        if known is None:
            parts = self._compact(self._velocity(expression), expression, rate=True)
            known = self._velocities[id(expression)] = parts
        return known

    def _velocity(self, expression: FlatExpression) -> Parts | None:
        match expression:
            case flat.PointReference(name):
                return self._velocity_of(self._points[name].position)
            case flat.FrameOrigin(frame) if self._poses.is_carried(frame):
                return {self._turned(frame): self._twist(frame)[1]}
            case flat.FrameAxis():
                return self._carried(self._values_of(expression))
            case flat.Unary("-", operand):
                return {frame: negate(self._graph, own) for frame, own in self._velocity_of(operand).items()}
            case flat.Binary("+" | "-" as sign, left, right):
                return self._sum(self._velocity_of(left), self._velocity_of(right), sign)
            case flat.Binary("*", factor, vector):
                growth = self._rates.of(cast(int, self._lowered(factor)))
                grown = {frame: scale(self._graph, growth, own) for frame, own in self._values_of(vector).items()}
                return self._sum(self._scaled(factor, self._velocity_of(vector)), grown, "+")
            case flat.Number() | flat.Variable() | flat.Previous() | flat.Derivative() | flat.Operation():
                return None
            case flat.OfFrame() | flat.Mechanical() | flat.OfMechanism():
                return None
            case _:
                assert_never(expression)

    def _carried(self, parts: Parts) -> Parts:
        """omega x r."""
        return {frame: cross(self._graph, self._twist(frame)[0], own) for frame, own in parts.items()}


def _operands(
    points: Mapping[str, Point], expression: FlatExpression, *, moving: bool
) -> list[tuple[FlatExpression, bool]]:
    """Vectors, or with True their velocities, that a vector or its velocity is made of."""
    match expression:
        case flat.PointReference(name) if moving:
            return [(points[name].position, True)]
        case flat.Derivative(operand) if not moving:
            return [(operand, True)]
        case flat.Unary("-", operand) | flat.Binary("/", operand, _):
            return [(operand, moving)]
        case flat.Binary("*", _, vector):
            return [(vector, False), (vector, moving)]
        case flat.Binary("+" | "-", left, right) | flat.Cross(left, right):
            return [(left, moving), (right, moving)]
        case flat.Number() | flat.Variable() | flat.Previous() | flat.Derivative() | flat.Operation():
            return []
        case flat.PointReference() | flat.OfFrame() | flat.Mechanical() | flat.OfMechanism():
            return []
        case _:
            assert_never(expression)
