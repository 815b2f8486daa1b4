"""The scene of a model: shapes whose numbers are scalars of the flat model, so that they follow every motion."""

from __future__ import annotations

from typing import Literal, TypeAlias

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


Primitive: TypeAlias = Literal["surface", "line", "trace", "label"]
"""All that painters know: triangles of a unit body, a tube through points, the way of a point, a text."""


@record()
class Size:
    """`factor` times the scalar in a `column`, if there is one; `relative` to the length of the machine."""

    factor: float
    column: int | None = None
    relative: bool = True


@record(kw_only=True)
class Part:
    """A primitive and where it stands. `numbers` tells by role at which column of the scene a vector begins.

    `at` is its origin, `z` its axis, `x` about the direction of its first axis, world axes where they are not given.
    With `to` the axis leads there and the unit length along it is stretched to the distance. `sizes` [m] stretch the
    unit lengths along the axes. With a `scale`, which is the unit of `z`, those that are not relative are multiplied by
    the length of `z` in the picture; nothing is seen of a part whose axis has no length. A line has its `points` (n
    vectors) or is the coil of a spring; `sizes` ends with the radius of its tube. A `still` part does not move: it
    stands where the motion begins, along its plane (with `x`: along its line) beside the middle of the machine. `shade`
    times the color. The vectors of a part on a `board`, by its number, are in the axes and the unit of that board of
    the stage.
    """

    primitive: Primitive = "surface"
    form: str = ""
    numbers: tuple[tuple[str, int], ...]
    sizes: tuple[Size, Size, Size] = (Size(1.0), Size(1.0), Size(1.0))
    color: str = "#64748b"
    shade: float = 1.0
    opacity: float = 1.0
    scale: str = ""
    still: bool = False
    offset: float = 0.0
    count: int = 0
    board: int | None = None


@record(kw_only=True)
class Shape:
    """A thing with its parts. `numbers` tells by role the column of the scene at which a scalar stands or a vector
    (three columns) begins: `at`, `to`, `vector`, `normal`, and `value` of a coordinate or, in one column or two, of the
    force of friction, with its `mode`.
    """

    kind: ShapeKind
    name: str
    numbers: tuple[tuple[str, int], ...]
    parts: tuple[Part, ...] = ()
    texts: tuple[tuple[str, str], ...] = ()
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
