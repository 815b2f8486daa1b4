"""Positions, velocities, Jacobians and bias accelerations of chosen frames and points, in world components.

The velocity of a frame is that of its origin, then its angular velocity. Jacobians are the derivatives of velocities
by qd, so that velocity = J qd + what the time alone moves, and acceleration = J qdd + bias.
"""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.algebra.graph.differentiate import jacobian
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.program.program import Block, matrix_block, vector_block
from lagdsl.language.flat.expression import FrameOrigin, PointReference


def frame_kinematics(equations: Equations, frames: Sequence[str], points: Sequence[str]) -> tuple[Block, ...]:
    """Results of the function `kinematics`, frames first."""
    graph, lowering, symbols = equations.graph, equations.lowering, equations.symbols
    positions: list[int] = []
    rotations: list[int] = []
    velocities: list[int] = []
    for name in frames:
        origin = lowering.vector(FrameOrigin(name))
        poses = lowering.poses(name)
        axes = poses[name].axes
        positions += origin
        rotations += [axes[column][row] for row in range(3) for column in range(3)]
        velocities += [*lowering.velocity(origin), *poses.world_velocity(name)]
    for name in points:
        position = lowering.vector(PointReference(name))
        positions += position
        velocities += lowering.velocity(position)
    partial = jacobian(graph, velocities, symbols.qd)
    bias = [lowering.bias_rate.of(velocity) for velocity in velocities]
    return (
        vector_block("r", positions),
        vector_block("R", rotations),
        vector_block("v", velocities),
        matrix_block("J", partial, len(symbols.qd)),
        vector_block("a", bias),
    )
