"""The parts of a flat expression and of a step of a frame."""

from __future__ import annotations

from typing import assert_never

from lagdsl.flat import expression as flat
from lagdsl.flat.expression import FlatExpression
from lagdsl.flat.model import FrameStep, Move, Place, Rotate, RotateAbout, RotateQuaternion, SetAxes


def operands(expression: FlatExpression) -> list[FlatExpression]:
    """What has a value of its own inside `expression`; names have no operands."""
    match expression:
        case flat.Derivative(operand) | flat.Unary(_, operand):
            return [operand]
        case flat.Binary(_, left, right) | flat.Dot(left, right) | flat.Cross(left, right):
            return [left, right]
        case flat.Function(_, arguments):
            return list(arguments)
        case flat.Conditional(condition, value, otherwise):
            return [condition, value, otherwise]
        case flat.Vector(x, y, z):
            return [x, y, z]
        case flat.Component(vector=vector) | flat.Norm(vector=vector):
            return [vector]
        case flat.ReactionAlong(direction=vector) | flat.AngularMomentum(about=vector):
            return [vector]
        case flat.MaterialVelocity(point=vector):
            return [vector]
        case _:
            return []


def step_expressions(step: FrameStep) -> list[FlatExpression]:
    match step:
        case Rotate(angle=angle):
            return [angle]
        case RotateAbout(axis, angle):
            return [*axis, angle]
        case RotateQuaternion(e):
            return list(e)
        case SetAxes(x, y, z):
            return [x, y, z]
        case Move(offset):
            return list(offset)
        case Place(position):
            return [position]
    assert_never(step)
