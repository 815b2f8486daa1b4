"""Accelerations of frames in their own axes, motion by motion from the parent's, as far as they do not depend on qdd.

Of the origin the classical acceleration (that of the material point), for which no velocity of the origin is needed:
a + (alpha x + omega x omega x) r for the place r of a body (Goldstein, *Classical Mechanics*, 3rd ed., section 4.10).
"""

from __future__ import annotations

from typing import assert_never

from lagdsl.algebra.graph.graph import Graph
from lagdsl.derivation.mechanics.kinematics import velocities
from lagdsl.derivation.mechanics.kinematics.frames import (
    Loosened,
    Motion,
    Put,
    Released,
    SetTo,
    Shift,
    Turn,
    TurnAbout,
    TurnQuaternion,
)
from lagdsl.derivation.mechanics.kinematics.poses import Poses
from lagdsl.derivation.mechanics.kinematics.vectors import Axes, Vector, add, cross, scale, subtract, to_own
from lagdsl.derivation.mechanics.kinematics.velocities import Rates, derivative
from lagdsl.foundation.record import record


@record(kw_only=True)
class FrameAcceleration:
    """Angular velocity, angular acceleration and acceleration of the origin, in own axes."""

    omega: Vector
    alpha: Vector
    origin: Vector


class Accelerations:
    """By frame. The world accelerates with -g, so that whatever is carried has its weight (Luh, Walker, Paul 1980)."""

    def __init__(self, graph: Graph, poses: Poses, rate: Rates, bias: Rates, gravity: Vector) -> None:
        self._graph, self._poses, self._rate, self._bias = graph, poses, rate, bias
        zero = graph.zero
        self.base = subtract(graph, (zero, zero, zero), gravity)
        rest = (zero, zero, zero)
        self._known = {"world": FrameAcceleration(omega=rest, alpha=rest, origin=self.base)}

    def of(self, name: str) -> FrameAcceleration:
        ancestry = []
        while name not in self._known:
            ancestry.append(name)
            parent = self._poses[name].parent
            assert parent is not None
            name = parent
        moving = self._known[name]
        for descendant in reversed(ancestry):
            for motion in self._poses[descendant].motions:
                moving = self._after(moving, motion)
            self._known[descendant] = moving
        return moving

    def _after(self, before: FrameAcceleration, motion: Motion) -> FrameAcceleration:
        graph, bias = self._graph, self._bias
        omega = velocities.own_velocity(graph, before.omega, motion, self._rate)
        match motion:
            case Shift(offset):
                return FrameAcceleration(omega=omega, alpha=before.alpha, origin=self.shifted(before, offset))
            case Put(origin, axes):
                moved = derivative(derivative(origin, self._rate), bias)
                return FrameAcceleration(
                    omega=omega, alpha=before.alpha, origin=to_own(graph, axes, add(graph, moved, self.base))
                )
            case Turn() | TurnAbout():
                return self._turned(before, motion, omega)
            case TurnQuaternion() | SetTo():
                # d/dt of the components of omega along own axes are those of alpha, since omega x omega = 0
                return FrameAcceleration(
                    omega=omega,
                    alpha=derivative(omega, bias),
                    origin=velocities.turned(graph, motion, before.origin),
                )
            case Released() | Loosened():
                raise AssertionError(motion)
            case _:
                assert_never(motion)

    def _turned(self, before: FrameAcceleration, motion: Turn | TurnAbout, omega: Vector) -> FrameAcceleration:
        """alpha + phi'' n + (omega x n) phi'."""
        graph = self._graph
        zero, one = graph.zero, graph.one
        if isinstance(motion, Turn):
            x, y, z = (one if k == motion.axis else zero for k in range(3))
            axis = (x, y, z)
        else:
            axis = motion.axis
        speed = self._rate.of(motion.angle)
        alpha = velocities.turned(graph, motion, before.alpha)
        alpha = add(graph, alpha, scale(graph, speed, cross(graph, omega, axis)))
        alpha = add(graph, alpha, scale(graph, self._bias.of(speed), axis))
        return FrameAcceleration(omega=omega, alpha=alpha, origin=velocities.turned(graph, motion, before.origin))

    def shifted(self, moving: FrameAcceleration, offset: Vector) -> Vector:
        """Acceleration of what is at `offset` in own axes."""
        graph = self._graph
        spread = spread_of(graph, moving)
        carried = (graph.dot(spread[0], offset), graph.dot(spread[1], offset), graph.dot(spread[2], offset))
        slip = derivative(offset, self._rate)
        turning = scale(graph, graph.constant(2.0), cross(graph, moving.omega, slip))
        relative = add(graph, turning, derivative(slip, self._bias))
        return add(graph, add(graph, moving.origin, carried), relative)


def spread_of(graph: Graph, moving: FrameAcceleration) -> Axes:
    """Rows of U = alpha x + omega x omega x: accelerations of a body's places differ by U r."""
    w, a = moving.omega, moving.alpha
    squares = [graph.multiply(x, x) for x in w]

    def entry(i: int, j: int) -> int:
        if i == j:
            return graph.negate(graph.add(squares[(i + 1) % 3], squares[(i + 2) % 3]))
        k = 3 - i - j
        turning = a[k] if (j - i) % 3 == 2 else graph.negate(a[k])
        return graph.add(graph.multiply(w[i], w[j]), turning)

    return (
        (entry(0, 0), entry(0, 1), entry(0, 2)),
        (entry(1, 0), entry(1, 1), entry(1, 2)),
        (entry(2, 0), entry(2, 1), entry(2, 2)),
    )
