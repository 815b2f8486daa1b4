"""The regressor: the equations of motion are linear in masses, first moments and inertias about frame origins.

    Y(q, qd, qdd) pi = sum of what masses and bodies add to d/dt(dL/dqd) - dL/dq

For a body with angular velocity w and velocity v of its frame's origin, in the frame's own axes, and pi = m, h = m c,
I about the origin, L = m v.v / 2 + v.(w x h) + w.I w / 2 + m g.r + g.(R h); each column is Lagrange's equation of
what one entry multiplies (Atkeson, An and Hollerbach, *Int. J. Robotics Research* 5(3), 1986). Columns of friction
stand behind those of the bodies.
"""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.algebra.graph.differentiate import adjoints
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.mechanics.kinematics.vectors import Vector, cross
from lagdsl.derivation.mechanics.lagrange.inertia import about_origin
from lagdsl.derivation.mechanics.lagrange.inertial_elements import place_of, tensor_of
from lagdsl.derivation.mechanics.regression.friction_columns import friction_columns
from lagdsl.derivation.program.program import Block, Slot, matrix_block, vector_block
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import LENGTH, MASS
from lagdsl.foundation.units.naming import unit_text
from lagdsl.language.flat.model import PointMass, RigidBody

_PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
_NAMES = ("m", "hx", "hy", "hz", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz")


def regressor(equations: Equations) -> tuple[tuple[Block, ...], tuple[Slot, ...]]:
    """Results of the function `regressor`, and the names of the inertial parameters and of the coefficients of
    friction."""
    slots, values, columns = [], [], []
    for slot, value, lagrangian in _entries(equations):
        slots.append(slot)
        values.append(value)
        columns.append(_equation(equations, lagrangian))
    for slot, value, column in friction_columns(equations):
        slots.append(slot)
        values.append(value)
        columns.append(column)
    rows, count = len(equations.symbols.q), len(slots)
    entries = [[column[j] for column in columns] for j in range(rows)]
    blocks = (matrix_block("Y", entries, count), vector_block("pi", values))
    return blocks, tuple(slots)


def _equation(equations: Equations, lagrangian: int) -> list[int]:
    """d/dt(dL/dqd) - dL/dq with the accelerations as symbols."""
    graph, symbols, rate = equations.graph, equations.symbols, equations.lowering.rate
    found = adjoints(graph, {lagrangian: graph.one}, (Group.Q, Group.QD))
    return [
        graph.subtract(rate.of(found.get(speed, graph.zero)), found.get(place, graph.zero))
        for place, speed in zip(symbols.q, symbols.qd, strict=True)
    ]


def _entries(equations: Equations) -> Iterator[tuple[Slot, int, int]]:
    """Name, value and Lagrangian per unit of every inertial parameter."""
    flat, lowering = equations.flat, equations.lowering
    gravity = lowering.vector(flat.gravity) if flat.gravity is not None else (lowering.graph.zero,) * 3
    for number, mass in enumerate(flat.masses, 1):
        yield _of_mass(equations, mass, f"mass[{number}].m", gravity)
    for number, body in enumerate(flat.bodies, 1):
        yield from _of_body(equations, body, body.label or f"body[{number}]", gravity)


def _of_mass(equations: Equations, mass: PointMass, name: str, gravity: Vector) -> tuple[Slot, int, int]:
    graph, lowering = equations.graph, equations.lowering
    position = lowering.vector(mass.position)
    velocity = lowering.velocity(position)
    square = graph.multiply(graph.constant(0.5), graph.dot(velocity, velocity))
    value = lowering.scalar(mass.mass)
    return Slot(name=name, unit="kg"), value, graph.add(square, graph.dot(gravity, position))


def _of_body(equations: Equations, body: RigidBody, name: str, gravity: Vector) -> Iterator[tuple[Slot, int, int]]:
    graph, lowering = equations.graph, equations.lowering
    poses = lowering.poses(body.frame)
    pose, (turning, velocity) = poses[body.frame], poses.own_twist(body.frame)
    half, mass, com = graph.constant(0.5), lowering.scalar(body.mass), place_of(lowering, body)
    tensor = about_origin(graph, mass, com, tensor_of(lowering, body))
    values = [mass, *(graph.multiply(mass, x) for x in com), *(tensor[i][j] for i, j in _PAIRS)]
    crossed = cross(graph, velocity, turning)  # v . (w x h) = h . (v x w)
    heights = [graph.dot(gravity, axis) for axis in pose.axes]
    lagrangians = [graph.add(graph.multiply(half, graph.dot(velocity, velocity)), graph.dot(gravity, pose.origin))]
    lagrangians += [graph.add(moved, height) for moved, height in zip(crossed, heights, strict=True)]
    for i, j in _PAIRS:
        product = graph.multiply(turning[i], turning[j])
        lagrangians.append(graph.multiply(half, product) if i == j else product)
    for entry, value, lagrangian in zip(_NAMES, values, lagrangians, strict=True):
        yield Slot(name=f"{name}.{entry}", unit=unit_text(_dimension(entry))), value, lagrangian


def _dimension(entry: str) -> Dimension:
    return {"m": MASS, "h": MASS * LENGTH, "I": MASS * LENGTH * LENGTH}[entry[0]]
