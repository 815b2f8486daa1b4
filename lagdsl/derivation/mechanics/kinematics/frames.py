"""Frames on the graph: three world axes, an origin, and what moved them since the parent.

Structural zeros of the world's axes make planar code planar. Rotations follow Goldstein, *Classical Mechanics* (3rd
ed.), sections 4.2 to 4.9; quaternions are homogeneous, scalar first: the rotation is that of e/|e|.
"""

from __future__ import annotations

import math
from typing import TypeAlias

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Op
from lagdsl.derivation.mechanics.kinematics.vectors import Axes, Vector, add, cross, scale, subtract, to_world
from lagdsl.foundation.record import record

# An angle this close to a quarter turn, relatively, is one: a few units in the last place.
_ROUNDING = 1e-15

Quaternion: TypeAlias = tuple[int, int, int, int]


@record()
class Turn:
    """About own axis 0, 1 or 2 by an angle with this cosine and sine; `direction` is the axis in the world."""

    axis: int
    angle: int
    cosine: int
    sine: int
    direction: Vector


@record()
class TurnAbout:
    """About a unit vector `axis` in own components by an angle; `direction` is the axis in the world."""

    axis: Vector
    angle: int
    columns: Axes
    direction: Vector


@record()
class TurnQuaternion:
    """By a quaternion; `columns` is its matrix, `axes` the world axes after it."""

    e: Quaternion
    columns: Axes
    axes: Axes


@record()
class SetTo:
    """Axes given in the world, whatever the parent does; `before` are those that the origin's velocity is known in."""

    axes: Axes
    before: Axes


@record()
class Shift:
    """The origin moved by an offset in own components."""

    offset: Vector


@record()
class Put:
    """The origin at a position of the world; `axes` are those of that moment."""

    origin: Vector
    axes: Axes


@record()
class Loosened:
    """The origin moved by a small displacement that vanishes, but not its `rate` (world components)."""

    rate: Vector
    axes: Axes


@record()
class Released:
    """Turned by a small rotation `angle` (world components) that vanishes, but not its `rate`; `axes` after it."""

    angle: Vector
    rate: Vector
    axes: Axes


Rotation: TypeAlias = "Turn | TurnAbout | TurnQuaternion | SetTo | Released"
Motion: TypeAlias = "Rotation | Shift | Put | Loosened"


@record()
class Pose:
    """Position and orientation of a frame, and its motion relative to its parent: enough for its velocities."""

    parent: str | None
    axes: Axes
    origin: Vector
    motions: tuple[Motion, ...] = ()


def world(graph: Graph) -> Pose:
    zero, one = graph.zero, graph.one
    return Pose(None, ((one, zero, zero), (zero, one, zero), (zero, zero, one)), (zero, zero, zero))


def is_put(pose: Pose) -> bool:
    """True if the origin is known as a position of the world, not as a place that the parent carries."""
    moved = [motion for motion in pose.motions if isinstance(motion, Shift | Put)]
    return bool(moved) and isinstance(moved[-1], Put)


def cosine_and_sine(graph: Graph, angle: int) -> tuple[int, int]:
    """Of whole numbers of quarter turns, which no number of radians is exactly, 0, 1 and -1: the axes stay aligned."""
    if graph.is_constant(angle):
        quarters = graph.value[angle] / (0.5 * math.pi)
        whole = round(quarters)
        if abs(quarters - whole) <= _ROUNDING * max(1.0, abs(quarters)):
            cosine, sine = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[whole % 4]
            return graph.constant(cosine), graph.constant(sine)
    return graph.unary(Op.COS, angle), graph.unary(Op.SIN, angle)


# ---- orientation -----------------------------------------------------------------------------------------------------


def turn(graph: Graph, axes: Axes, axis: int, angle: int) -> tuple[Axes, Turn]:
    """Rotation by `angle` about own axis 0, 1 or 2."""
    cosine, sine = cosine_and_sine(graph, angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    turned = list(axes)
    turned[i] = add(graph, scale(graph, cosine, axes[i]), scale(graph, sine, axes[j]))
    turned[j] = subtract(graph, scale(graph, cosine, axes[j]), scale(graph, sine, axes[i]))
    return (turned[0], turned[1], turned[2]), Turn(axis, angle, cosine, sine, axes[axis])


def turn_about(graph: Graph, axes: Axes, axis: Vector, angle: int) -> tuple[Axes, Turn | TurnAbout]:
    """Rotation by `angle` about `axis` in own components, normalized (Rodrigues); about an own axis where it is one."""
    along = [k for k in range(3) if axis[k] != graph.zero]
    if len(along) == 1 and graph.is_constant(axis[along[0]]):
        opposite = graph.value[axis[along[0]]] < 0.0
        return turn(graph, axes, along[0], graph.negate(angle) if opposite else angle)
    length = graph.unary(Op.SQRT, graph.dot(axis, axis))
    n = (graph.divide(axis[0], length), graph.divide(axis[1], length), graph.divide(axis[2], length))
    cosine, sine = cosine_and_sine(graph, angle)
    versine = graph.subtract(graph.one, cosine)
    columns = []
    for k in range(3):
        unit = _unit(graph, k)
        lengthwise = scale(graph, graph.multiply(versine, n[k]), n)
        across = scale(graph, sine, cross(graph, n, unit))
        columns.append(add(graph, add(graph, scale(graph, cosine, unit), across), lengthwise))
    matrix = (columns[0], columns[1], columns[2])
    turned = _compose(graph, axes, matrix)
    return turned, TurnAbout(n, angle, matrix, to_world(graph, axes, n))


def turn_quaternion(graph: Graph, axes: Axes, e: Quaternion) -> tuple[Axes, TurnQuaternion]:
    """Rotation of e/|e| (Euler-Rodrigues): 1 - 2 (y^2 + z^2)/|e|^2 on the diagonal, so that zeros stay zeros."""
    factor = graph.divide(graph.constant(2.0), graph.dot(e, e))

    def double(i: int, j: int) -> int:
        return graph.multiply(factor, graph.multiply(e[i], e[j]))

    def diagonal(i: int, j: int) -> int:
        return graph.subtract(graph.one, graph.add(double(i, i), double(j, j)))

    matrix = (
        (diagonal(2, 3), graph.add(double(1, 2), double(0, 3)), graph.subtract(double(1, 3), double(0, 2))),
        (graph.subtract(double(1, 2), double(0, 3)), diagonal(1, 3), graph.add(double(2, 3), double(0, 1))),
        (graph.add(double(1, 3), double(0, 2)), graph.subtract(double(2, 3), double(0, 1)), diagonal(1, 2)),
    )
    turned = _compose(graph, axes, matrix)
    return turned, TurnQuaternion(e, matrix, turned)


def release(graph: Graph, axes: Axes, angle: Vector, rate: Vector) -> tuple[Axes, Released]:
    """Each axis moved by angle x axis: exact to first order, which is all a release needs."""
    x, y, z = (add(graph, axis, cross(graph, angle, axis)) for axis in axes)
    return (x, y, z), Released(angle, rate, (x, y, z))


def _unit(graph: Graph, axis: int) -> Vector:
    x, y, z = (graph.one if k == axis else graph.zero for k in range(3))
    return (x, y, z)


def _compose(graph: Graph, axes: Axes, matrix: Axes) -> Axes:
    return (to_world(graph, axes, matrix[0]), to_world(graph, axes, matrix[1]), to_world(graph, axes, matrix[2]))
