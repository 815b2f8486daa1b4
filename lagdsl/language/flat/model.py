"""The flat model: product of the semantics floor and input of both derivations.

Names are qualified and unique, modifiers applied, arrays and structural `for`/`if` expanded, functions inlined, units
SI, dimensions checked. Definitions, points and frames stand in one order in which nothing is used before it is defined.
Every item keeps the stack of source spans that produced it, innermost first (today of length one for a single class).
"""

from __future__ import annotations

from dataclasses import field
from typing import Literal, TypeAlias

from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span
from lagdsl.foundation.units import Dimension
from lagdsl.language.flat.events import Events
from lagdsl.language.flat.expression import Conditional, FlatExpression, Number
from lagdsl.language.flat.quantity import Experiment, Item, Measurement, Page, Quantity, Variability


@record(kw_only=True)
class Parameter(Quantity):
    """An independent parameter: a number that may be changed without recompiling. Booleans are 0 and 1. `structural`
    and `constant` ones are listed for reports, folded into the expressions and never in `p`. A `free` one is found with
    the start of the motion, an `estimated` one from data: its value is a guess, `nominal` a large change of it."""

    value: float
    free: bool = False
    estimated: bool = False
    nominal: float | None = None
    minimum: float | None = None
    maximum: float | None = None
    structural: bool = False
    constant: bool = False
    kind: Literal["Real", "Integer", "Boolean", "String"] = "Real"
    text: str | None = None


@record(kw_only=True)
class Coordinate(Quantity):
    """A generalized coordinate; starts may depend on parameters. `explicit` says that the user wrote the start."""

    start: FlatExpression
    start_explicit: bool
    fixed: bool
    rate_start: FlatExpression
    rate_start_explicit: bool
    rate_fixed: bool
    nominal: float | None = None
    minimum: float | None = None
    maximum: float | None = None
    start_span: Span | None = field(default=None, compare=False, repr=False)
    rate_start_span: Span | None = field(default=None, compare=False, repr=False)


@record(kw_only=True)
class State(Quantity):
    """A first-order state and its equation `der(x) = derivative`."""

    start: FlatExpression
    start_explicit: bool
    fixed: bool
    derivative: FlatExpression
    nominal: float | None = None
    minimum: float | None = None
    maximum: float | None = None


@record(kw_only=True)
class Input(Quantity):
    """A top-level input. `smooth` is the number of time derivatives the caller provides, as further inputs `der(name)`,
    `der(der(name))` that follow it directly in the list of inputs: items of their own, each with `derivative_of` naming
    the input whose time derivative it is (the one before it). `stated`: the model states its default."""

    default: FlatExpression
    stated: bool = False
    smooth: int = 0
    derivative_of: str | None = None
    nominal: float | None = None
    minimum: float | None = None
    maximum: float | None = None


@record(kw_only=True)
class Definition(Quantity):
    """A named scalar with a binding: dependent parameters, algebraic variables, labels of energies and loads."""

    value: FlatExpression
    variability: Variability


@record(kw_only=True)
class Output(Quantity):
    """A result column; `value` may use what the mechanics provides. `joint` names the cut joint whose coordinate this
    is: computed from the motion of its frames, listed after the outputs of the user. `turn`: such an angle is known up
    to multiples of this, which a run counts; zero for the parts of a unit quaternion, four in a row, which is known up
    to its sign. None: all others."""

    value: FlatExpression
    joint: str | None = None
    turn: FlatExpression | None = None
    nominal: float | None = None
    minimum: float | None = None
    maximum: float | None = None


@record(kw_only=True)
class Alias(Item):
    """`name` is another name of the coordinate `of`, which `connect` made one with it. `protected`: its class does not
    show it."""

    name: str
    of: str
    doc: str | None = None
    protected: bool = False


@record(kw_only=True)
class Joint(Item):
    """A component with kinematics that may move: `coordinates` are its own, by qualified name. `cut`: it closes a loop
    by constraints, and its coordinates, unless they were kept, are outputs."""

    name: str
    kind: str
    frame_a: str
    frame_b: str
    coordinates: tuple[str, ...]
    cut: bool = False


# ---- geometry --------------------------------------------------------------------------------------------------------


@record(kw_only=True)
class Point(Item):
    name: str
    position: FlatExpression
    doc: str | None = None


@record()
class Rotate:
    """Turn about the frame's own x, y or z axis (0, 1, 2)."""

    axis: int
    angle: FlatExpression


@record()
class RotateAbout:
    """Turn about an axis given in the frame's own axes; it is normalised. `axis` depends on parameters only."""

    axis: tuple[FlatExpression, FlatExpression, FlatExpression]
    angle: FlatExpression


@record()
class RotateQuaternion:
    """Turn by the rotation of e/|e|, scalar first."""

    e: tuple[FlatExpression, FlatExpression, FlatExpression, FlatExpression]


@record()
class SetAxes:
    """World axes of the new frame: three orthonormal vectors."""

    x: FlatExpression
    y: FlatExpression
    z: FlatExpression


@record()
class Move:
    """Displace the origin by a vector given in the frame's own axes."""

    offset: tuple[FlatExpression, FlatExpression, FlatExpression]


@record()
class Place:
    """Put the origin at a world position (vector)."""

    position: FlatExpression


FrameStep: TypeAlias = "Rotate | RotateAbout | RotateQuaternion | SetAxes | Move | Place"


@record(kw_only=True)
class Image:
    """The frame is that of a loop seen from the frame `within`: where `within` is the world. `of` names the frame that
    it copies, if it is a copy: a release of that one, given in the world, moves this one, too."""

    of: str | None
    within: str


@record(kw_only=True)
class Frame(Item):
    """`parent` is a frame of the model or `world`; the steps are applied in order."""

    name: str
    parent: str
    steps: tuple[FrameStep, ...]
    doc: str | None = None
    image: Image | None = None


Named: TypeAlias = "Definition | Point | Frame"

# ---- physics ---------------------------------------------------------------------------------------------------------


@record(kw_only=True)
class EnergyTerm(Item):
    """A contribution to T, V, L or D, in J or W."""

    kind: Literal["kinetic", "potential", "lagrangian", "dissipation"]
    label: str | None
    value: FlatExpression


@record(kw_only=True)
class PointMass(Item):
    mass: FlatExpression
    position: FlatExpression


@record(kw_only=True)
class RigidBody(Item):
    """`com` in the axes of `frame` from its origin; `inertia` is Ixx, Iyy, Izz, Ixy, Ixz, Iyz about the mass centre in
    the same axes (tensor elements)."""

    label: str | None
    frame: str
    mass: FlatExpression
    com: tuple[FlatExpression, FlatExpression, FlatExpression]
    inertia: tuple[FlatExpression, FlatExpression, FlatExpression, FlatExpression, FlatExpression, FlatExpression]


@record(kw_only=True)
class PointForce(Item):
    """A force vector at a point. With `frame` the material point of that frame is displaced, else the point itself;
    with `origin` the opposite force acts there."""

    label: str | None
    force: FlatExpression
    point: FlatExpression
    frame: str | None
    origin: FlatExpression | None
    origin_frame: str | None


@record(kw_only=True)
class FrameTorque(Item):
    """A moment vector on a frame and, with `origin`, the opposite one on another."""

    label: str | None
    torque: FlatExpression
    frame: str
    origin: str | None


@record(kw_only=True)
class GeneralizedForce(Item):
    """Q_j = value * d(target)/dq_j; `target` is any scalar of q, t. `origin`: the opposite value on another scalar."""

    label: str | None
    keyword: Literal["force", "torque"]
    value: FlatExpression
    target: FlatExpression
    origin: FlatExpression | None


@record(kw_only=True)
class RateForce(Item):
    """Q_j = value * d(rate)/dqd_j; `rate` is any scalar that is linear in the rates, such as the slip of friction."""

    label: str | None
    value: FlatExpression
    rate: FlatExpression


Load: TypeAlias = "PointForce | FrameTorque | GeneralizedForce | RateForce"


@record(kw_only=True)
class Closure:
    """Why a constraint closes a loop: the joint that was cut (None: a plain `connect`), and the names of the components
    around the loop in order, that joint included. `span` is the `connect` that closes it."""

    joint: str | None
    loop: tuple[str, ...]
    span: Span = field(compare=False, repr=False)


@record(kw_only=True)
class Constraint(Item):
    """Rows `residual = left - right = 0` in source order. `level` position: of q and t; velocity: linear in the rates.
    `normalisation` marks the unit-length row that a quaternion brings along. `closure` is given where the compiler
    wrote the rows to close a loop (their names are `closure(D)[2]`), `node` where Kirchhoff's law of a `connect` did.
    `contact`: it is there while the contact of that name is closed, and identically satisfied else; `friction`: while
    the friction of that name sticks. `switched`: it depends on discretes in another way, so that it may be there at
    some times only.
    """

    name: str
    rows: tuple[str, ...]
    residuals: tuple[FlatExpression, ...]
    dimension: Dimension
    level: Literal["position", "velocity"]
    normalisation: bool = False
    closure: Closure | None = None
    node: bool = False
    contact: bool = False
    friction: bool = False
    switched: bool = False

    @property
    def of_law(self) -> bool:
        """True if the law of a contact or of dry friction says when it is there."""
        return self.contact or self.friction


@record(kw_only=True)
class Invariant(Item):
    """A claim that `value` stays constant; `tolerance` None means the default."""

    name: str
    value: FlatExpression
    dimension: Dimension
    tolerance: float | None


@record(kw_only=True)
class Assertion(Item):
    """The simulation stops with `message` when `condition` becomes 0; where it is a warning, the message is told and
    the motion goes on."""

    condition: FlatExpression
    message: str
    warning: bool = False

    @property
    def value(self) -> FlatExpression:
        """1 where the condition holds; elsewhere 0, and -1 for a warning."""
        return Conditional(self.condition, Number(1.0), Number(-1.0)) if self.warning else self.condition


@record(kw_only=True)
class InitialEquation(Item):
    """`residual = 0` at the start time; may hold rates and accelerations."""

    residual: FlatExpression
    dimension: Dimension


@record(kw_only=True)
class Drawing(Item):
    """A shape of the viewer; `anchors` are vectors (points) or the name of a frame."""

    shape: str
    arguments: tuple[tuple[str, FlatExpression | str], ...]
    place: Literal["at", "on", "between"]
    anchors: tuple[FlatExpression | str, ...]


@record(kw_only=True, weak=True)
class FlatModel:
    """One complete model. `observed` are named values that need the solved motion: nothing refers to them by name."""

    name: str
    doc: str | None
    parameters: tuple[Parameter, ...]
    coordinates: tuple[Coordinate, ...]
    states: tuple[State, ...]
    inputs: tuple[Input, ...]
    named: tuple[Named, ...]
    energies: tuple[EnergyTerm, ...]
    masses: tuple[PointMass, ...]
    bodies: tuple[RigidBody, ...]
    gravity: FlatExpression | None
    gravity_span: Span | None = field(default=None, compare=False, repr=False)
    loads: tuple[Load, ...]
    constraints: tuple[Constraint, ...]
    outputs: tuple[Output, ...]
    invariants: tuple[Invariant, ...]
    assertions: tuple[Assertion, ...]
    initial_equations: tuple[InitialEquation, ...]
    drawings: tuple[Drawing, ...]
    experiment: Experiment
    joints: tuple[Joint, ...] = ()
    events: Events = Events()
    observed: tuple[Definition, ...] = ()
    aliases: tuple[Alias, ...] = ()
    measurements: tuple[Measurement, ...] = ()
    page: Page = Page()
