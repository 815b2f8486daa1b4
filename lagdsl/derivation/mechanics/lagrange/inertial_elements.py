"""Items with mass: positions, velocities and angular momenta of point masses and rigid bodies."""

from __future__ import annotations

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.kinematics import vectors
from lagdsl.derivation.mechanics.kinematics.frames import is_put
from lagdsl.derivation.mechanics.kinematics.vectors import Axes, Vector
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel, RigidBody

# Components of axes that turn about one that does not.
_TURNING_IN_A_PLANE = 4


@record()
class Spin:
    """Turning of a rigid body in its own axes: angular velocity, and angular momentum about the mass centre."""

    axes: Axes
    velocity: Vector
    momentum: Vector


@record()
class InertialElement:
    """A mass [kg] and its centre's position [m] in world components; point masses have no spin.

    `velocity` [m/s] is given along whatever axes cost least: its square is meant.
    """

    label: str | None
    mass: int
    position: Vector
    velocity: Vector
    spin: Spin | None


def inertial_elements(lowering: Lowering, flat: FlatModel) -> tuple[InertialElement, ...]:
    found = []
    for item in flat.masses:
        lowering.place = item.spans
        position = lowering.vector(item.position)
        velocity = lowering.own_velocity(item.position) or lowering.velocity(position)
        found.append(InertialElement(None, lowering.scalar(item.mass), position, velocity, None))
    found += [_body(lowering, body) for body in flat.bodies]
    return tuple(found)


def _body(lowering: Lowering, body: RigidBody) -> InertialElement:
    graph = lowering.graph
    lowering.place = body.spans
    mass = lowering.scalar(body.mass)
    poses = lowering.poses(body.frame)
    pose = poses[body.frame]
    x, y, z = place_of(lowering, body)
    position = vectors.add(graph, pose.origin, vectors.to_world(graph, pose.axes, (x, y, z)))
    if mass == graph.zero:
        velocity = (graph.zero, graph.zero, graph.zero)
    elif is_in_world(lowering, body.frame, position):
        velocity = lowering.velocity(position)
    else:
        turning, velocity = poses.own_twist(body.frame)
        velocity = vectors.add(graph, velocity, vectors.cross(graph, turning, (x, y, z)))
    return InertialElement(body.label, mass, position, velocity, _spin(lowering, body))


def is_in_world(lowering: Lowering, frame: str, position: Vector) -> bool:
    """True if the mass centre of a body has its velocity at hand in the world: at an origin that is put there, or in a
    plane, where turning costs little."""
    poses = lowering.poses(frame)
    if position == poses[frame].origin and is_put(poses[frame]):
        return True
    turning = [x for axis in poses[frame].axes for x in axis if lowering.graph.depends(x, Group.Q)]
    return not poses.is_carried(frame) and len(turning) <= _TURNING_IN_A_PLANE


def place_of(lowering: Lowering, body: RigidBody) -> Vector:
    """The mass centre in the axes of the body's frame."""
    x, y, z = body.com
    return (lowering.scalar(x), lowering.scalar(y), lowering.scalar(z))


def tensor_of(lowering: Lowering, body: RigidBody) -> Axes:
    """The inertia about the mass centre in the same axes."""
    xx, yy, zz, xy, xz, yz = (lowering.scalar(entry) for entry in body.inertia)
    return ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))


def _spin(lowering: Lowering, body: RigidBody) -> Spin | None:
    graph = lowering.graph
    tensor = tensor_of(lowering, body)
    if all(entry == graph.zero for row in tensor for entry in row):
        return None
    poses = lowering.poses(body.frame)
    velocity = poses.own_velocity(body.frame)
    momentum = (graph.dot(tensor[0], velocity), graph.dot(tensor[1], velocity), graph.dot(tensor[2], velocity))
    return Spin(poses[body.frame].axes, velocity, momentum)


def kinetic_energy(graph: Graph, carrier: InertialElement) -> int:
    """1/2 m v.v + 1/2 omega.I omega."""
    half = graph.constant(0.5)
    twice = graph.multiply(carrier.mass, graph.dot(carrier.velocity, carrier.velocity))
    if carrier.spin is not None:
        twice = graph.add(twice, graph.dot(carrier.spin.velocity, carrier.spin.momentum))
    return graph.multiply(half, twice)


def linear_momentum(lowering: Lowering, found: tuple[InertialElement, ...]) -> Vector:
    """Sum of m v [kg.m/s], world components."""
    graph = lowering.graph
    total = (graph.zero, graph.zero, graph.zero)
    for carrier in found:
        velocity = lowering.velocity(carrier.position)
        total = vectors.add(graph, total, vectors.scale(graph, carrier.mass, velocity))
    return total


def angular_momentum(lowering: Lowering, found: tuple[InertialElement, ...], about: Vector) -> Vector:
    """Sum of (r - about) x m v and of the bodies' own angular momenta [kg.m2/s], world components."""
    graph = lowering.graph
    total = (graph.zero, graph.zero, graph.zero)
    for carrier in found:
        arm = vectors.subtract(graph, carrier.position, about)
        moved = vectors.cross(graph, arm, vectors.scale(graph, carrier.mass, lowering.velocity(carrier.position)))
        total = vectors.add(graph, total, moved)
        if carrier.spin is not None:
            own = vectors.to_world(graph, carrier.spin.axes, carrier.spin.momentum)
            total = vectors.add(graph, total, own)
    return total
