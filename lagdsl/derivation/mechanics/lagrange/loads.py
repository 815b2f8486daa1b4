"""Generalized forces of all loads by virtual work and power: Q_j = sum F.dr/dq_j + M.domega/dqd_j + value*ds/dq_j +
value*dg/dqd_j.

One reverse sweep over positions and one over rates, whatever the number of loads and coordinates; forces
enter as weights and are not differentiated. Points with prescribed motion contribute nothing.
"""

from __future__ import annotations

from dataclasses import field
from typing import assert_never

from lagdsl.algebra.graph.differentiate import adjoints
from lagdsl.algebra.graph.graph import Graph
from lagdsl.derivation.mechanics.kinematics import vectors
from lagdsl.derivation.mechanics.kinematics.vectors import Vector
from lagdsl.derivation.mechanics.lowering.acceleration import refuse_accelerations
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.derivation.mechanics.lowering.symbols import Directions
from lagdsl.foundation.record import mutable_record
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import FlatModel, FrameTorque, GeneralizedForce, Load, PointForce, RateForce


@mutable_record()
class VirtualWork:
    """Weights of virtual displacements: of positions and targets; and of virtual velocities: of angular velocities and
    of scalars of the rates."""

    graph: Graph
    displacements: dict[int, int] = field(default_factory=dict)
    velocities: dict[int, int] = field(default_factory=dict)

    def displace(self, positions: tuple[int, ...], forces: tuple[int, ...]) -> None:
        _accumulate(self.graph, self.displacements, positions, forces)

    def turn(self, velocity: Vector, moment: Vector) -> None:
        _accumulate(self.graph, self.velocities, velocity, moment)

    def drive(self, rate: int, force: int) -> None:
        _accumulate(self.graph, self.velocities, (rate,), (force,))


def _accumulate(graph: Graph, weights: dict[int, int], nodes: tuple[int, ...], added: tuple[int, ...]) -> None:
    for node, weight in zip(nodes, added, strict=True):
        weights[node] = graph.add(weights.get(node, graph.zero), weight)


def virtual_work(lowering: Lowering, flat: FlatModel) -> VirtualWork:
    work = VirtualWork(lowering.graph)
    for load in flat.loads:
        lowering.place = load.spans
        forces = add_load(lowering, load, work)
        refuse_accelerations(lowering.graph, forces, load.spans, "this load")
    return work


def generalized_forces(work: VirtualWork, directions: Directions) -> list[int]:
    """Q for each of `directions` [J per unit of the coordinate]."""
    graph = work.graph
    moved = adjoints(graph, work.displacements, (directions.position_group,))
    driven = adjoints(graph, work.velocities, (directions.rate_group,))
    return [
        graph.add(moved.get(position, graph.zero), driven.get(rate, graph.zero))
        for position, rate in zip(directions.positions, directions.rates, strict=True)
    ]


def add_load(lowering: Lowering, load: Load, work: VirtualWork) -> tuple[int, ...]:
    """Add the virtual work of one load; gives the nodes of its force."""
    graph = lowering.graph
    match load:
        case PointForce():
            force = lowering.vector(load.force)
            _add_force(lowering, work, force, load.point, load.frame)
            if load.origin is not None:
                _add_force(lowering, work, vectors.negate(graph, force), load.origin, load.origin_frame)
            return force
        case FrameTorque():
            moment = lowering.vector(load.torque)
            work.turn(lowering.poses(load.frame).world_velocity(load.frame), moment)
            if load.origin is not None:
                reaction = vectors.negate(graph, moment)
                work.turn(lowering.poses(load.origin).world_velocity(load.origin), reaction)
            return moment
        case GeneralizedForce():
            value = lowering.scalar(load.value)
            work.displace((lowering.scalar(load.target),), (value,))
            if load.origin is not None:
                work.displace((lowering.scalar(load.origin),), (graph.negate(value),))
            return (value,)
        case RateForce():
            value = lowering.scalar(load.value)
            work.drive(lowering.scalar(load.rate), value)
            return (value,)
    assert_never(load)


def _add_force(lowering: Lowering, work: VirtualWork, force: Vector, point: FlatExpression, frame: str | None) -> None:
    """At the point itself, or at the material point of `frame` there: the frame's origin moves and the arm turns."""
    position = lowering.vector(point)
    if frame is None:
        work.displace(position, force)
        return
    poses = lowering.poses(frame)
    arm = vectors.subtract(lowering.graph, position, poses[frame].origin)
    work.displace(poses[frame].origin, force)
    work.turn(poses.world_velocity(frame), vectors.cross(lowering.graph, arm, force))
