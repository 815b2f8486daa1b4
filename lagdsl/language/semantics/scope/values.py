"""Typed values: what an expression means while the flat model is made.

A value knows its dimension (None fits any: `0` and `inf` by themselves), when it may change (variability) and on which
derivative of the motion it depends (order). A dimension is one for all components of a vector or elements of an array.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntEnum
from typing import Protocol, TypeAlias, final

from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import LENGTH
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import FrameStep
from lagdsl.language.flat.quantity import Variability

Kind: TypeAlias = str
"""`Real`, `Integer`, `Boolean` or the name of an enumeration."""

NUMERIC = ("Real", "Integer")
AnyDimension: TypeAlias = "Dimension | None"


class Order(IntEnum):
    """The part of the motion that an expression needs: nothing but time, inputs, q, its first, its second derivative,
    or the solved equations."""

    STILL = -2
    GIVEN = -1
    CONFIGURATION = 0
    RATE = 1
    ACCELERATION = 2
    SOLUTION = 3


_RANK = {variability: rank for rank, variability in enumerate(Variability)}


class AnyValue:
    """Base of all values: a case over all entries of a scope names the values by it."""

    __slots__ = ()


@final
@record()
class Scalar(AnyValue):
    """`is_nothing`: a sum over nothing, of any dimension in products too; the `0` of a text is a number there."""

    expression: FlatExpression
    dimension: AnyDimension
    variability: Variability = Variability.CONSTANT
    order: Order = Order.STILL
    kind: Kind = "Real"
    is_nothing: bool = False


@final
@record()
class Vector(AnyValue):
    """Geometric: three world components. A point is one with the dimension of a length."""

    expression: FlatExpression
    dimension: AnyDimension
    variability: Variability = Variability.CONTINUOUS
    order: Order = Order.CONFIGURATION


@record()
class Array(AnyValue):
    """Scalars in row-major order."""

    elements: tuple[FlatExpression, ...]
    shape: tuple[int, ...]
    dimension: AnyDimension
    variability: Variability = Variability.CONSTANT
    order: Order = Order.STILL
    kind: Kind = "Real"


@record()
class FrameValue(AnyValue):
    """The named frame, moved on by `steps` (none: the frame itself)."""

    name: str
    steps: tuple[FrameStep, ...] = ()
    variability: Variability = Variability.CONTINUOUS
    order: Order = Order.CONFIGURATION


@record()
class Text(AnyValue):
    value: str


@record()
class Reaction(AnyValue):
    """`reaction(F)`: the wrench that carries the frame; read its `.force` or `.torque`.

    `opposite`: the reaction to it; `about`: with the torque about the origin of another frame.
    """

    frame: str
    opposite: bool = False
    about: str | None = None


@record()
class ContactValue:
    """Quantities of a contact: `closed(c)`, `impacts(c)` (None: none are counted), its force. Not `present`: its
    condition is false, and all of them are zero."""

    name: str
    closed: FlatExpression
    impacts: FlatExpression | None
    multiplier: Scalar
    present: bool = True


@record()
class FrictionValue:
    """Quantities of dry friction: `sticks(f)`, and its force, an array where it acts in a plane; zeros where its
    condition is false."""

    sticks: FlatExpression
    multiplier: Scalar | Array


class Declared(Protocol):
    """Entry of a component or an array of components in a scope."""

    name: str
    span: Span


@record()
class Component(AnyValue):
    """A component or an array of them: read its members."""

    instance: Declared


@record()
class Poison(AnyValue):
    """The value of what was already reported: everything fits it, nothing more is said."""


POISON = Poison()
Numeric: TypeAlias = "Scalar | Vector | Array"
Value: TypeAlias = "Scalar | Vector | Array | FrameValue | Text | Reaction | Component | Poison"


def rank(variability: Variability) -> int:
    return _RANK[variability]


def is_structural(value: Scalar | Vector | Array) -> bool:
    """Known while compiling."""
    return _RANK[value.variability] <= _RANK[Variability.STRUCTURAL]


def latest(*values: Scalar | Vector | Array | FrameValue) -> Variability:
    found = Variability.CONSTANT
    for value in values:
        if _RANK[value.variability] > _RANK[found]:
            found = value.variability
    return found


def highest(*values: Scalar | Vector | Array | FrameValue) -> Order:
    found = Order.STILL
    for value in values:
        found = max(found, value.order)
    return found


def is_zero(value: Value) -> bool:
    """The literal `0`, which fits any dimension and any shape."""
    return isinstance(value, Scalar) and value.dimension is None and value.expression == flat.ZERO


def as_vector(value: Value) -> Vector | None:
    """The value as a geometric vector: frames are their origin, 2 and 3 scalars are world components."""
    if isinstance(value, Vector):
        return value
    if isinstance(value, Array) and value.shape in ((2,), (3,)):
        components = (*value.elements, flat.ZERO)[:3]
        return Vector(flat.Vector(*components), value.dimension, value.variability, value.order)
    if isinstance(value, FrameValue) and not value.steps:
        expression = flat.ZERO_VECTOR if value.name == "world" else flat.FrameOrigin(value.name)
        return Vector(expression, LENGTH, value.variability, value.order)
    return Vector(flat.ZERO_VECTOR, None, Variability.CONSTANT, Order.STILL) if is_zero(value) else None


def component(vector: FlatExpression, axis: int) -> FlatExpression:
    if isinstance(vector, flat.Vector):
        return (vector.x, vector.y, vector.z)[axis]
    return flat.Component(vector, axis)


def components(value: Vector) -> Array:
    parts = tuple(component(value.expression, axis) for axis in range(3))
    return Array(parts, (3,), value.dimension, value.variability, value.order)


def element_at(array: Array, index: int) -> Scalar | Array:
    """`array[index]`, 0-based, of the first dimension."""
    if len(array.shape) == 1:
        return Scalar(array.elements[index], array.dimension, array.variability, array.order, array.kind)
    size = len(array.elements) // array.shape[0]
    part = array.elements[index * size : (index + 1) * size]
    return Array(part, array.shape[1:], array.dimension, array.variability, array.order, array.kind)


def balanced_sum(terms: Sequence[FlatExpression]) -> FlatExpression:
    """A sum whose depth grows with the logarithm of the number of terms."""
    if len(terms) == 1:
        return terms[0]
    middle = (len(terms) + 1) // 2
    return flat.Binary("+", balanced_sum(terms[:middle]), balanced_sum(terms[middle:]))
