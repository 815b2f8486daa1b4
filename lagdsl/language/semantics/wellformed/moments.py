"""Places, velocities and energies of masses and bodies, and the power of loads, at one moment."""

from __future__ import annotations

from collections.abc import Callable
from typing import assert_never

import numpy as np
from numpy.typing import NDArray

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.evaluate import Evaluator

Floats = NDArray[np.float64]


def centre(evaluator: Evaluator, item: fm.PointMass | fm.RigidBody) -> Floats:
    """World position (3,) of the mass centre [m]."""
    if isinstance(item, fm.PointMass):
        return evaluator.vector(item.position)
    origin, axes = evaluator.frame(item.frame)
    return np.asarray(origin + axes @ np.array([evaluator.scalar(component) for component in item.com]))


def velocity(evaluator: Evaluator, item: fm.PointMass | fm.RigidBody) -> Floats:
    """World velocity (3,) of the mass centre [m/s]."""
    if isinstance(item, fm.PointMass):
        return evaluator.vector(fx.Derivative(item.position))
    origin, _ = evaluator.frame(item.frame)
    arm = centre(evaluator, item) - origin
    turning = np.cross(evaluator.vector(fx.AngularVelocity(item.frame)), arm)
    return np.asarray(evaluator.vector(fx.Derivative(fx.FrameOrigin(item.frame))) + turning)


def weight(flat: fm.FlatModel, evaluator: Evaluator, item: fm.PointMass | fm.RigidBody, *, moving: bool) -> float:
    """m g.r [J] or, `moving`, its power m g.v [W]."""
    assert flat.gravity is not None
    along = velocity(evaluator, item) if moving else centre(evaluator, item)
    return evaluator.scalar(item.mass) * float(evaluator.vector(flat.gravity) @ along)


def kinetic_energies(evaluator: Evaluator, item: fm.PointMass | fm.RigidBody) -> tuple[float, ...]:
    """Of a mass; of a body that of its mass centre, that of its rotation, and both together [J]."""
    moving = velocity(evaluator, item)
    straight = 0.5 * evaluator.scalar(item.mass) * float(moving @ moving)
    if isinstance(item, fm.PointMass):
        return (straight,)
    _, axes = evaluator.frame(item.frame)
    omega = axes.T @ evaluator.vector(fx.AngularVelocity(item.frame))
    xx, yy, zz, xy, xz, yz = (evaluator.scalar(element) for element in item.inertia)
    tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    turning = 0.5 * float(omega @ tensor @ omega)
    return straight, turning, straight + turning


def power_of(load: fm.Load, value: fx.FlatExpression) -> Callable[[Evaluator], float]:
    """The power [W] of a part of a load, whose `value` is a vector or a generalized force as that of the load."""

    def power(evaluator: Evaluator) -> float:
        match load:
            case fm.PointForce():
                speed = _speed(evaluator, load.point, load.frame)
                if load.origin is not None:
                    speed = speed - _speed(evaluator, load.origin, load.origin_frame)
                return float(evaluator.vector(value) @ speed)
            case fm.FrameTorque():
                turning = evaluator.vector(fx.AngularVelocity(load.frame))
                if load.origin is not None:
                    turning = turning - evaluator.vector(fx.AngularVelocity(load.origin))
                return float(evaluator.vector(value) @ turning)
            case fm.GeneralizedForce():
                rate = evaluator.scalar(fx.Derivative(load.target))
                if load.origin is not None:
                    rate -= evaluator.scalar(fx.Derivative(load.origin))
                return evaluator.scalar(value) * rate
            case fm.RateForce():
                return evaluator.scalar(value) * evaluator.scalar(load.rate)
            case _:
                assert_never(load)

    return power


def _speed(evaluator: Evaluator, point: fx.FlatExpression, frame: str | None) -> Floats:
    return evaluator.vector(fx.Derivative(point) if frame is None else fx.MaterialVelocity(point, frame))
