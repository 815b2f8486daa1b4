"""Expressions of the flat model: names resolved, arrays and functions expanded, units converted to SI.

Two shapes are left: scalars, and geometric vectors (three world components). Vectors stay whole, so that both
derivations lower points, frames and their derivatives in their own way. Comparisons and logic are scalars with the
values 0 and 1. Nodes are immutable and may be shared; they compare by value, lowering passes memoise by identity.
"""

from __future__ import annotations

from dataclasses import field
from typing import Literal, TypeAlias

from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span

# ---- groups: a case over all nodes names the nodes it treats alike by these ------------------------------------------


class Operation:
    """A node with the value that its operands have now."""

    __slots__ = ()


class OfFrame:
    """A node about one frame, named by its field `frame`."""

    __slots__ = ()


class Mechanical:
    """A node that the derivation evaluates; in outputs, invariants and assertions only."""

    __slots__ = ()


class OfMechanism:
    """A node about the forces of the mechanism without its loads: they are known with the state."""

    __slots__ = ()


# ---- scalars ---------------------------------------------------------------------------------------------------------

UnaryOperator: TypeAlias = Literal["-", "not"]
BinaryOperator: TypeAlias = Literal["+", "-", "*", "/", "^", "<", "<=", ">", ">=", "==", "<>", "and", "or"]

# Scalar functions that reach the flat model, with their number of arguments. Everything else (limit, wrap, unit, sum,
# functions of the user) is expanded before.
FUNCTIONS: dict[str, int] = {
    "sin": 1,
    "cos": 1,
    "tan": 1,
    "asin": 1,
    "acos": 1,
    "atan": 1,
    "atan2": 2,
    "sinh": 1,
    "cosh": 1,
    "tanh": 1,
    "exp": 1,
    "log": 1,
    "sqrt": 1,
    "abs": 1,
    "sign": 1,
    "floor": 1,
    "ceil": 1,
    "mod": 2,
    "min": 2,
    "max": 2,
}


@record()
class Number:
    """A value in SI units."""

    value: float


@record()
class Variable:
    """Any named scalar of the flat model (parameter, coordinate, state, input, discrete, definition) or `time`."""

    name: str


@record()
class Previous:
    """Value of the named entry of the vector of discretes before the event; in `when` only. `text` is what `pre` reads
    where that has another name."""

    name: str
    text: str | None = None


@record()
class Derivative:
    """Total time derivative of a scalar or, in the inertial frame, of a vector.

    `Derivative(Variable(q))` is the rate of q.
    """

    operand: FlatExpression


@record()
class Unary(Operation):
    """`-` also negates vectors."""

    operator: UnaryOperator
    operand: FlatExpression


@record()
class Binary(Operation):
    """On scalars every operator; on vectors `+` and `-`; `*` of a scalar (left) and a vector (right); `/` of a vector
    by a scalar. Exponents of `^` are scalars. The scalar product of vectors is `Dot`."""

    operator: BinaryOperator
    left: FlatExpression
    right: FlatExpression


@record()
class Function(Operation):
    """One of FUNCTIONS."""

    name: str
    arguments: tuple[FlatExpression, ...]


@record()
class Conditional(Operation):
    """`if condition then value else otherwise`, of scalars or of vectors."""

    condition: FlatExpression
    value: FlatExpression
    otherwise: FlatExpression


@record()
class Component(Operation):
    """World component 0, 1 or 2 of a vector."""

    vector: FlatExpression
    axis: int


@record()
class Dot(Operation):
    left: FlatExpression
    right: FlatExpression


@record()
class Norm(Operation):
    """Euclidean length; its derivative does not exist at zero (a run-time diagnostic names `element`)."""

    vector: FlatExpression
    element: str


# ---- vectors ---------------------------------------------------------------------------------------------------------


@record()
class Vector(Operation):
    """Three world components."""

    x: FlatExpression
    y: FlatExpression
    z: FlatExpression


@record()
class PointReference:
    """Position of the named point from the world origin."""

    name: str


@record()
class FrameOrigin(OfFrame):
    """Position of the origin of the named frame (`world` included)."""

    frame: str


@record()
class FrameAxis(OfFrame):
    """Unit vector x, y or z (0, 1, 2) of the named frame."""

    frame: str
    axis: int


@record()
class AngularVelocity(OfFrame):
    """omega of the named frame relative to the world."""

    frame: str


@record()
class MaterialVelocity(OfFrame):
    """Velocity of the material point of `frame` that is at `point` now."""

    point: FlatExpression
    frame: str


@record()
class Cross(Operation):
    left: FlatExpression
    right: FlatExpression


# ---- what the mechanics provides -------------------------------------------------------------------------------------


@record()
class Multiplier(Mechanical):
    """Multiplier of one constraint row, by the row's name (`wire`, `pin[2]`)."""

    row: str


@record()
class FrameReaction(Mechanical):
    """Force or torque (vector) that the side of the parent of `frame` exerts on all it carries, at its origin."""

    frame: str
    kind: Literal["force", "torque"]


@record()
class ReactionAlong(Mechanical):
    """d'Alembert value (scalar) of the non-contributing force on the named point along `direction`: the point is
    released by s*direction, and the equation of s is evaluated at s = 0 (direction is not normalised and is held as if
    unreleased)."""

    point: str
    direction: FlatExpression


@record()
class SystemEnergy(Mechanical):
    """`total` is energy(): T + V and, for each lagrangian term Lx, qd.dLx/dqd - Lx; `jacobi` is qd.dL/dqd - L."""

    kind: Literal["total", "kinetic", "potential", "jacobi"]


@record()
class GeneralizedMomentum(Mechanical):
    """dL/dqd of the named coordinate."""

    coordinate: str


@record()
class ForceBalance(Mechanical):
    """Force along a direction without inertia, in the residual of its constraint: the sum over coordinates of their
    weights times f of M qdd - J' lam = f. `ties` are further coordinates, each with a row of the constraints: they move
    so that these rows hold, whatever the parameters are, and pivots in this order are not zero. `still`: it holds no
    rates, and none is left of terms that cancel."""

    weights: tuple[tuple[str, float], ...]
    ties: tuple[tuple[str, str], ...]
    still: bool


@record()
class LinearMomentum(Mechanical):
    """Vector: sum of m v over all masses and bodies."""


@record()
class AngularMomentum(Mechanical):
    """Vector: of the named body (None: of all masses and bodies) about a point."""

    body: str | None
    about: FlatExpression


@record()
class AdmissibleMotion(Mechanical):
    """Vector: dr/dq_j of a point, its motion with the named coordinate while the others and the time are held."""

    point: FlatExpression
    coordinate: str


# ---- forces of the mechanism itself ----------------------------------------------------------------------------------


@record()
class Motion(OfMechanism):
    """A motion that `inverse_dynamics` and `bias` ask about: a state and, for the first, accelerations of the named
    coordinates. All else of the state is as it is. `parameters` have other values there than in the model. A motion has
    no value by itself; its parts are shared by the forces of all of its coordinates."""

    function: Literal["inverse_dynamics", "bias"]
    coordinates: tuple[str, ...]
    positions: tuple[FlatExpression, ...]
    rates: tuple[FlatExpression, ...]
    accelerations: tuple[FlatExpression, ...]
    parameters: tuple[tuple[str, FlatExpression], ...]
    span: Span = field(compare=False, repr=False)


@record()
class RequiredForce(OfMechanism):
    """d/dt(dL/dqd) - dL/dq + dD/dqd of one of the coordinates of `motion`, by its place: the generalized force that
    all loads together have to be. Of `bias` without D, and with no accelerations."""

    motion: Motion
    place: int


FlatExpression: TypeAlias = (
    "Number | Variable | Previous | Derivative | Unary | Binary | Function | Conditional | Component | Dot | Norm "
    "| Vector | PointReference | FrameOrigin | FrameAxis | AngularVelocity | MaterialVelocity | Cross | Multiplier "
    "| FrameReaction | ReactionAlong | SystemEnergy | GeneralizedMomentum | ForceBalance | LinearMomentum "
    "| AngularMomentum | AdmissibleMotion | Motion | RequiredForce"
)

ZERO = Number(0.0)
ONE = Number(1.0)
ZERO_VECTOR = Vector(ZERO, ZERO, ZERO)
TIME = Variable("time")
