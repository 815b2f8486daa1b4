"""Places, velocities and energies of masses and bodies, and the power of loads, at k moments."""

from __future__ import annotations

from collections.abc import Callable
from typing import assert_never

import numpy as np

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.evaluate import Floats, ManyEvaluator


def centre(evaluator: ManyEvaluator, item: fm.PointMass | fm.RigidBody) -> Floats:
    """World position (3, k) of the mass centre [m]."""
    if isinstance(item, fm.PointMass):
        return evaluator.vector(item.position)
    origin, axes = evaluator.frame(item.frame)
    com = np.array([evaluator.scalar(component) for component in item.com])
    return np.asarray(origin + np.einsum("ijk,jk->ik", axes, com))


def velocity(evaluator: ManyEvaluator, item: fm.PointMass | fm.RigidBody) -> Floats:
    """World velocity (3, k) of the mass centre [m/s]."""
    if isinstance(item, fm.PointMass):
        return evaluator.vector(fx.Derivative(item.position))
    origin, _ = evaluator.frame(item.frame)
    arm = centre(evaluator, item) - origin
    turning = np.cross(evaluator.vector(fx.AngularVelocity(item.frame)), arm, axis=0)
    return np.asarray(evaluator.vector(fx.Derivative(fx.FrameOrigin(item.frame))) + turning)


def weight(flat: fm.FlatModel, evaluator: ManyEvaluator, item: fm.PointMass | fm.RigidBody, *, moving: bool) -> Floats:
    """m g.r [J] or, `moving`, its power m g.v [W]."""
    assert flat.gravity is not None
    along = velocity(evaluator, item) if moving else centre(evaluator, item)
    return evaluator.scalar(item.mass) * _dot(evaluator.vector(flat.gravity), along)


def kinetic_energies(evaluator: ManyEvaluator, item: fm.PointMass | fm.RigidBody) -> tuple[Floats, ...]:
    """Of a mass; of a body that of its mass centre, that of its rotation, and both together [J]."""
    moving = velocity(evaluator, item)
    straight = 0.5 * evaluator.scalar(item.mass) * _dot(moving, moving)
    if isinstance(item, fm.PointMass):
        return (straight,)
    _, axes = evaluator.frame(item.frame)
    omega = np.einsum("jik,jk->ik", axes, evaluator.vector(fx.AngularVelocity(item.frame)))
    xx, yy, zz, xy, xz, yz = (evaluator.scalar(element) for element in item.inertia)
    tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    turning = 0.5 * np.einsum("ik,ijk,jk->k", omega, tensor, omega)
    return straight, turning, straight + turning


def _dot(left: Floats, right: Floats) -> Floats:
    return np.asarray((left * right).sum(axis=0))


def power_of(load: fm.Load, value: fx.FlatExpression) -> Callable[[ManyEvaluator], Floats]:
    """The power (k,) [W] of a part of a load, whose `value` is a vector or a generalized force as that of the load."""

    def power(evaluator: ManyEvaluator) -> Floats:
        match load:
            case fm.PointForce():
                speed = _speed(evaluator, load.point, load.frame)
                if load.origin is not None:
                    speed = speed - _speed(evaluator, load.origin, load.origin_frame)
                return _dot(evaluator.vector(value), speed)
            case fm.FrameTorque():
                turning = evaluator.vector(fx.AngularVelocity(load.frame))
                if load.origin is not None:
                    turning = turning - evaluator.vector(fx.AngularVelocity(load.origin))
                return _dot(evaluator.vector(value), turning)
            case fm.GeneralizedForce():
                rate = evaluator.scalar(fx.Derivative(load.target))
                if load.origin is not None:
                    rate = rate - evaluator.scalar(fx.Derivative(load.origin))
                return evaluator.scalar(value) * rate
            case fm.RateForce():
                return evaluator.scalar(value) * evaluator.scalar(load.rate)
            case _:
                assert_never(load)

    return power


def _speed(evaluator: ManyEvaluator, point: fx.FlatExpression, frame: str | None) -> Floats:
    return evaluator.vector(fx.Derivative(point) if frame is None else fx.MaterialVelocity(point, frame))
