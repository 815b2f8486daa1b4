"""The scene of a model: shapes whose numbers are scalars of the flat model, so that they follow every motion."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field
from typing import Literal, TypeAlias

import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.quantity import Spans

ShapeKind: TypeAlias = Literal[
    "rod", "spring", "damper", "box", "cylinder", "cone", "disc", "sphere", "circle", "arrow", "trace", "text",
    "mesh", "mass", "body", "rope", "ground", "rail", "support", "track", "force", "torque", "frame", "slider",
    "dial", "gear", "branch", "velocity", "acceleration", "admissible", "reaction", "reaction torque",
    "constraint", "friction",
]  # fmt: skip
"""The shapes of `draw`, then those that the rules add, then the arrows of `vectors`."""


TOLD = frozenset({"at", "to", "vector", "value", "mode"})

Primitive: TypeAlias = Literal["surface", "line", "trace", "label"]
"""All that painters know: triangles of a unit body, a tube through points, the way of a point, a text."""


Numbers: TypeAlias = "Mapping[str, fx.FlatExpression]"
"""Scalars and vectors by role."""

Value: TypeAlias = "fx.FlatExpression | tuple[fx.FlatExpression, ...]"
"""A scalar, a vector, or several of them side by side."""

_VECTORS = (
    *(fx.Vector, fx.PointReference, fx.FrameOrigin, fx.FrameAxis, fx.AngularVelocity, fx.MaterialVelocity),
    *(fx.Cross, fx.LinearMomentum, fx.AngularMomentum, fx.FrameReaction, fx.AdmissibleMotion),
)


UPRIGHT = np.array([0.0, 0.0, 1.0])


@record()
class Size:
    """`factor` times a `value`, if there is one; `relative` to the length of the machine."""

    factor: float
    value: fx.FlatExpression | None = None
    relative: bool = True


@record(kw_only=True)
class Part:
    """A primitive and where it stands: `numbers` are vectors.

    `at` is its origin, `z` its axis, `x` about the direction of its first axis, world axes where they are not given.
    With `to` the axis leads there and the unit length along it is stretched to the distance. `sizes` [m] stretch the
    unit lengths along the axes. With a `scale`, which is the unit of `z`, those that are not relative are multiplied by
    the length of `z` in the picture; nothing is seen of a part whose axis has no length. A line has its `points` or is
    the coil of a spring; `sizes` ends with the radius of its tube. A `still` part does not move: it stands where the
    motion begins, along its plane (with `x`: along its line) beside the middle of the machine. `shade` times the color.
    The vectors of a part on a `board`, by its number, are in the axes and the unit of that board of the stage.
    """

    primitive: Primitive = "surface"
    form: str = ""
    numbers: Numbers
    sizes: tuple[Size, Size, Size] = (Size(1.0), Size(1.0), Size(1.0))
    color: str = "#64748b"
    shade: float = 1.0
    opacity: float = 1.0
    scale: str = ""
    still: bool = False
    offset: float = 0.0
    points: tuple[fx.FlatExpression, ...] = ()
    board: int | None = None

    def read(self) -> Iterator[Value]:
        """All that the part reads."""
        yield from self.numbers.values()
        yield from (size.value for size in self.sizes if size.value is not None)
        if self.points:
            yield self.points


@record(kw_only=True)
class Shape:
    """A thing with its parts. `numbers` are the arguments of `draw` until it has its parts, then those that are `TOLD`:
    `value` is that of a coordinate or, as a scalar or a vector, of the force of friction, with its `mode`.
    """

    kind: ShapeKind
    name: str
    numbers: Numbers
    parts: tuple[Part, ...] = ()
    texts: Mapping[str, str] = field(default_factory=dict)
    spans: Spans


@record(kw_only=True)
class Scene:
    """Shapes and the scalars that they read, column by column; `places` are the columns of a value, by its key.
    `planar`: nothing leaves the plane z = 0."""

    shapes: tuple[Shape, ...]
    columns: tuple[fx.FlatExpression, ...]
    places: Mapping[object, slice]
    planar: bool

    def first(self, value: Value) -> int:
        """The column of a scalar, the first one of anything else."""
        return int(self.places[_key(value)].start)

    def values(self, rows: Floats, value: Value) -> Floats:
        """A scalar (...,) or a vector (..., 3) [SI] of `rows` (..., columns); several side by side (..., n, 3)."""
        found = rows[..., self.places[_key(value)]]
        if isinstance(value, tuple):
            return found.reshape(*found.shape[:-1], -1, 3)
        return found if found.shape[-1] > 1 else found[..., 0]


def scene_with(shapes: Iterable[Shape], *, planar: bool) -> Scene:
    """Each scalar and each vector has its columns, once."""
    found = tuple(shapes)
    columns: list[fx.FlatExpression] = []
    places: dict[object, slice] = {}
    for shape in found:
        for value in (*shape.numbers.values(), *(each for part in shape.parts for each in part.read())):
            if _key(value) not in places:
                scalars = _scalars(value)
                places[_key(value)] = slice(len(columns), len(columns) + len(scalars))
                columns += scalars
    return Scene(shapes=found, columns=tuple(columns), places=places, planar=planar)


def _key(value: Value) -> object:
    """Names are few and short; comparing long expressions costs more than a column."""
    is_name = isinstance(value, fx.PointReference | fx.FrameOrigin | fx.FrameAxis | fx.Variable)
    return value if is_name else id(value)


def _scalars(value: Value) -> tuple[fx.FlatExpression, ...]:
    if isinstance(value, tuple):
        return tuple(scalar for each in value for scalar in _scalars(each))
    return tuple(fx.Component(value, axis) for axis in range(3)) if is_vector(value) else (value,)


def axes_along(way: Floats, about: Floats | None) -> tuple[Floats, Floats, Floats]:
    """Unit axes (..., 3): z along a way, x as near as may be to a direction, else across the vertical z (y where z is
    that)."""
    size = np.linalg.norm(way, axis=-1, keepdims=True)
    z = np.where(size > 0.0, way / np.where(size > 0.0, size, 1.0), UPRIGHT)
    free = np.cross(np.where(np.abs(z[..., 2:]) > 0.9, [0.0, 1.0, 0.0], UPRIGHT), z)
    x = free if about is None else about - np.sum(about * z, axis=-1, keepdims=True) * z
    x = np.where(np.linalg.norm(x, axis=-1, keepdims=True) < 1e-6, free, x)
    x = x / np.linalg.norm(x, axis=-1, keepdims=True)
    return x, np.cross(z, x), z


def is_vector(expression: fx.FlatExpression) -> bool:
    """Is it a geometric vector?"""
    while True:
        if isinstance(expression, _VECTORS):
            return True
        if isinstance(expression, fx.Derivative | fx.Unary):
            expression = expression.operand
        elif isinstance(expression, fx.Binary):  # the vector of a product stands on the right
            expression = expression.right if expression.operator == "*" else expression.left
        elif isinstance(expression, fx.Conditional):
            expression = expression.value
        else:
            return False


def acting(kind: ShapeKind, name: str, at: fx.FlatExpression, vector: fx.FlatExpression, spans: Spans) -> Shape:
    return Shape(kind=kind, name=name, numbers={"at": at, "vector": vector}, spans=spans)
