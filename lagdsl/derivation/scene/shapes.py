"""The scene of a model: shapes whose numbers are scalars of the flat model, so that they follow every motion."""

from __future__ import annotations

from typing import Literal, TypeAlias

from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.quantity import Spans

ShapeKind: TypeAlias = Literal[
    "rod",
    "spring",
    "damper",
    "box",
    "cylinder",
    "cone",
    "disc",
    "sphere",
    "circle",
    "arrow",
    "trace",
    "text",
    "mesh",
    "mass",
    "body",
    "rope",
    "ground",
    "force",
    "torque",
    "frame",
    "slider",
    "dial",
    "velocity",
    "acceleration",
    "admissible",
    "reaction",
    "reaction torque",
    "constraint",
    "friction",
]
"""The shapes of `draw`, then those that the rules of `implied` add, then the arrows of `vectors`."""


@record(kw_only=True)
class Shape:
    """`numbers` tells by role the column of the scene at which a scalar stands or a vector (three columns) begins.

    Roles: `at`, `to` positions [m]; `x`, `y`, `z` axes of a frame; `vector`, `normal` directions; `axis` a direction in
    the axes of the frame; lengths `radius`, `length`, `width`, `height`, `size` [m]; `scale`, the length of a unit of
    the `file` of a mesh [m], one for all axes or three; `mass` [kg], `com` [m]
    and `inertia` [kg.m2] (six columns: xx, yy, zz, xy, xz, yz) in the axes of the frame; `value` of a coordinate or, in
    one column or two, of the force of friction, with its `mode`.
    """

    kind: ShapeKind
    name: str
    numbers: tuple[tuple[str, int], ...]
    texts: tuple[tuple[str, str], ...] = ()
    vectors: tuple[str, ...] = ()
    spans: Spans


@record(kw_only=True)
class Scene:
    """Shapes and the scalars that they read, column by column. `planar`: nothing leaves the plane z = 0."""

    shapes: tuple[Shape, ...]
    columns: tuple[fx.FlatExpression, ...]
    planar: bool


class Columns:
    """Gives each scalar and each vector its column, once."""

    def __init__(self) -> None:
        self.expressions: list[fx.FlatExpression] = []
        self._known: dict[object, tuple[int, fx.FlatExpression]] = {}

    def scalar(self, expression: fx.FlatExpression) -> int:
        return self._place(expression, (expression,))

    def vector(self, expression: fx.FlatExpression) -> int:
        return self._place(expression, tuple(fx.Component(expression, axis) for axis in range(3)))

    def scalars(self, expressions: tuple[fx.FlatExpression, ...]) -> int:
        """Side by side."""
        first = len(self.expressions)
        self.expressions += expressions
        return first

    def _place(self, expression: fx.FlatExpression, parts: tuple[fx.FlatExpression, ...]) -> int:
        # Names are few and short; comparing long expressions costs more than a column.
        is_name = isinstance(expression, fx.PointReference | fx.FrameOrigin | fx.FrameAxis | fx.Variable)
        key = (len(parts), expression if is_name else id(expression))
        if key not in self._known:  # the expression is kept, so that its identity is not given to another one
            self._known[key] = (self.scalars(parts), expression)
        return self._known[key][0]
