"""The way back: steps of a frame undone, last first."""

from __future__ import annotations

from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.model import FrameStep, Move, Place, Rotate, RotateAbout, RotateQuaternion, SetAxes
from lagdsl.language.semantics.assembly.closed_form.algebra import negative


def inverse(steps: tuple[FrameStep, ...]) -> tuple[FrameStep, ...] | None:
    """Steps that lead back; None where one sets a place or axes in the world, which forgets where it came from."""
    undone: list[FrameStep] = []
    for step in reversed(steps):
        match step:
            case Move(offset=(x, y, z)):
                undone.append(Move((negative(x), negative(y), negative(z))))
            case Rotate(axis=axis, angle=angle):
                undone.append(Rotate(axis, negative(angle)))
            case RotateAbout(axis=about, angle=angle):
                undone.append(RotateAbout(about, negative(angle)))
            case RotateQuaternion(e=(s, x, y, z)):
                undone.append(RotateQuaternion((s, negative(x), negative(y), negative(z))))
            case Place() | SetAxes():
                return None
    return tuple(undone)


def names_frame(expression: flat.FlatExpression, name: str) -> bool:
    """True if one node of an expression is about the frame."""
    return isinstance(expression, flat.OfFrame) and expression.frame == name
