"""Velocities of frames, motion by motion from the parent's: in own axes, where turning about own axes costs least, or
in world axes, where nothing has to be turned back.

Angular velocities add (Goldstein, *Classical Mechanics*, 3rd ed., section 4.9); the origin of a frame that is carried
has the velocity v + omega x r of the place where it is (section 4.10 there).
"""

from __future__ import annotations

from typing import Protocol, TypeAlias, assert_never

from lagdsl.algebra.graph.graph import Graph
from lagdsl.derivation.mechanics.kinematics.frames import (
    Loosened,
    Motion,
    Put,
    Quaternion,
    Released,
    SetTo,
    Shift,
    Turn,
    TurnAbout,
    TurnQuaternion,
)
from lagdsl.derivation.mechanics.kinematics.vectors import Vector, add, cross, negate, scale, subtract, to_own, to_world

Twist: TypeAlias = tuple[Vector, Vector]
"""Angular velocity and velocity of the origin, both in the frame's own axes."""


class Rates(Protocol):
    """Time derivatives of nodes, as velocities need them."""

    def of(self, root: int) -> int: ...


def own_velocity(graph: Graph, before: Vector, motion: Motion, rates: Rates) -> Vector:
    """Angular velocity in own axes after `motion`, from that in own axes before it."""
    match motion:
        case Turn(axis=axis, angle=angle):
            after = list(turned(graph, motion, before))
            after[axis] = graph.add(after[axis], rates.of(angle))
            return (after[0], after[1], after[2])
        case TurnAbout(axis=n, angle=angle):
            return add(graph, turned(graph, motion, before), scale(graph, rates.of(angle), n))
        case TurnQuaternion(e=e):
            return add(graph, turned(graph, motion, before), quaternion_velocity(graph, e, rates))
        case SetTo((x, y, z)):
            dx, dy, dz = derivative(x, rates), derivative(y, rates), derivative(z, rates)
            return (graph.dot(dy, z), graph.dot(dz, x), graph.dot(dx, y))
        case Released(rate=rate, axes=axes):
            return add(graph, before, to_own(graph, axes, rate))
        case Shift() | Put() | Loosened():
            return before
    assert_never(motion)


def world_velocity(graph: Graph, before: Vector, motion: Motion, rates: Rates) -> Vector:
    """Angular velocity in world axes after `motion`, from that in world axes before it."""
    match motion:
        case Turn(angle=angle, direction=direction) | TurnAbout(angle=angle, direction=direction):
            return add(graph, before, scale(graph, rates.of(angle), direction))
        case TurnQuaternion(e, _, axes):
            return add(graph, before, to_world(graph, axes, quaternion_velocity(graph, e, rates)))
        case SetTo(axes):
            return to_world(graph, axes, own_velocity(graph, before, motion, rates))
        case Released(angle, rate):
            return add(graph, add(graph, before, cross(graph, angle, before)), rate)
        case Shift() | Put() | Loosened():
            return before
    assert_never(motion)


def own_twist(graph: Graph, before: Twist, motion: Motion, rates: Rates) -> Twist:
    """Twist in own axes after `motion`, from that in own axes before it."""
    turning, velocity = before
    match motion:
        case Shift(offset):
            carried = add(graph, velocity, cross(graph, turning, offset))
            return turning, add(graph, carried, derivative(offset, rates))
        case Put(origin, axes):
            return turning, to_own(graph, axes, derivative(origin, rates))
        case Loosened(rate, axes):
            return turning, add(graph, velocity, to_own(graph, axes, rate))
        case Turn() | TurnAbout() | TurnQuaternion() | SetTo() | Released():
            return own_velocity(graph, turning, motion, rates), turned(graph, motion, velocity)
        case _:
            assert_never(motion)


def turned(graph: Graph, motion: Turn | TurnAbout | TurnQuaternion | SetTo | Released, before: Vector) -> Vector:
    """Components along the axes after a rotation of a vector given along the axes before it."""
    match motion:
        case Turn(axis, _, cosine, sine):
            i, j = (axis + 1) % 3, (axis + 2) % 3
            after = list(before)
            after[i] = graph.add(graph.multiply(cosine, before[i]), graph.multiply(sine, before[j]))
            after[j] = graph.subtract(graph.multiply(cosine, before[j]), graph.multiply(sine, before[i]))
            return (after[0], after[1], after[2])
        case TurnAbout(columns=columns) | TurnQuaternion(columns=columns):
            return to_own(graph, columns, before)
        case SetTo(after_, axes):
            return to_own(graph, after_, to_world(graph, axes, before))
        case Released(angle=angle, axes=axes):
            return subtract(graph, before, cross(graph, to_own(graph, axes, angle), before))
    assert_never(motion)


def quaternion_velocity(graph: Graph, e: Quaternion, rates: Rates) -> Vector:
    """2 conj(e) der(e) / |e|^2 without its scalar part: the rate of turning in the axes after the turn."""
    w, v = e[0], (e[1], e[2], e[3])
    dw, dv = rates.of(w), (rates.of(e[1]), rates.of(e[2]), rates.of(e[3]))
    vector = subtract(graph, scale(graph, w, dv), scale(graph, dw, v))
    vector = add(graph, vector, negate(graph, cross(graph, v, dv)))
    return scale(graph, graph.divide(graph.constant(2.0), graph.dot(e, e)), vector)


def derivative(vector: Vector, rates: Rates) -> Vector:
    return (rates.of(vector[0]), rates.of(vector[1]), rates.of(vector[2]))
