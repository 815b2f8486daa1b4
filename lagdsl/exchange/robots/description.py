"""A robot as its files describe it: links, joints and what hangs on them. Product of the readers, input of the writer.

SI units. Every part has the place in the file that it comes from.
"""

from __future__ import annotations

from dataclasses import field
from pathlib import Path
from typing import Literal, TypeAlias

from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span

Vector: TypeAlias = tuple[float, float, float]
ZERO: Vector = (0.0, 0.0, 0.0)
JointKind: TypeAlias = Literal["revolute", "prismatic", "screw", "spherical", "floating", "planar", "fixed"]
"""`revolute` turns about its axis, with or without limits; `spherical` and `floating` are quaternions."""


@record(kw_only=True)
class Part:
    """One statement of a file, at its place."""

    span: Span = field(compare=False, repr=False)


@record(kw_only=True)
class Pose:
    """A place [m] and a turn against another frame: fixed-axis angles roll, pitch, yaw [rad] about x, y, z in this
    order, which is the intrinsic sequence zyx of yaw, pitch, roll."""

    xyz: Vector = ZERO
    rpy: Vector = ZERO

    @property
    def is_identity(self) -> bool:
        return self.xyz == ZERO and self.rpy == ZERO


@record(kw_only=True)
class Inertial(Part):
    """Mass [kg], mass center [m] and inertia [kg.m2] about it: xx, yy, zz, xy, xz, yz in the axes of the link."""

    mass: float
    com: Vector
    inertia: tuple[float, float, float, float, float, float]
    is_possible: bool = True


@record(kw_only=True)
class Box(Part):
    pose: Pose
    size: Vector


@record(kw_only=True)
class Cylinder(Part):
    """About the z axis of its pose, its middle there."""

    pose: Pose
    radius: float
    length: float


@record(kw_only=True)
class Sphere(Part):
    pose: Pose
    radius: float


@record(kw_only=True)
class Capsule(Part):
    """A cylinder with a half of a ball at both ends; `length` is that of the cylinder."""

    pose: Pose
    radius: float
    length: float


@record(kw_only=True)
class Mesh(Part):
    """A shape in the file of that name, which the text names; `scale`: metres of a unit of the file, by axis."""

    file: str
    place: Path
    pose: Pose
    scale: tuple[float, float, float] = (1.0, 1.0, 1.0)


Visual: TypeAlias = Box | Cylinder | Sphere | Capsule | Mesh


@record(kw_only=True)
class Link(Part):
    """`is_between`: no link of the file, but the place between two joints that follow each other. `lift` is the share
    of its weight that a force at its mass center carries."""

    name: str
    inertial: Inertial | None
    visuals: tuple[Visual, ...]
    is_between: bool = False
    lift: float = 0.0


@record(kw_only=True)
class Limits:
    """`lower`, `upper` [rad or m], `effort` [N.m or N] and `velocity` [rad/s or m/s]; None: no limit."""

    lower: float | None = None
    upper: float | None = None
    effort: float | None = None
    velocity: float | None = None


@record(kw_only=True)
class Mimic(Part):
    """This coordinate is `multiplier` times that of `joint`, plus `offset`."""

    joint: str
    multiplier: float
    offset: float


@record(kw_only=True)
class Passive:
    """Acts in a joint by itself: `damping` [N.m.s/rad or N.s/m], dry `friction` and `stiffness` about `rest`, and
    `armature`, the inertia of the rotor seen from the joint [kg.m2 or kg]. Damping and
    armature of a joint with several coordinates act on each of its rates, in a ball on the angular velocity."""

    damping: float = 0.0
    friction: float = 0.0
    stiffness: float = 0.0
    rest: float = 0.0
    armature: float = 0.0


@record(kw_only=True)
class Joint(Part):
    """From the frame of `parent`, displaced by `before`, to that of `child`, displaced by `after` behind the joint.

    `start` is the coordinate at the beginning, `place` the position [m] and the quaternion of a floating joint, `lead`
    the advance of a screw [m] along its axis in a turn.
    """

    name: str
    kind: JointKind
    parent: str
    child: str
    before: Pose
    after: Pose = Pose()
    axis: Vector = (1.0, 0.0, 0.0)
    start: float | None = None
    place: tuple[float, ...] = ()
    lead: float = 0.0
    limits: Limits = Limits()
    passive: Passive = Passive()
    mimic: Mimic | None = None


@record(kw_only=True)
class Actuator(Part):
    """An input that drives `joint`. Without `gear` it is the effort itself [N.m or N]; else the effort is `gear` times
    a number called `name`. `low` and `high` bound the input."""

    name: str
    joint: str
    gear: float | None = None
    low: float | None = None
    high: float | None = None


Way: TypeAlias = tuple[tuple[str, float], ...]
"""A length, or an angle, as a combination of the coordinates of joints: (joint, factor)."""

Affine: TypeAlias = tuple[float, float, float]
"""A constant, the factor of a length and that of its rate."""


@record(kw_only=True)
class Bounds:
    low: float | None = None
    high: float | None = None


@record(kw_only=True)
class Servo(Part):
    """An input that acts along `way` with the force (gain, an affine function) x activation + (bias, another one).

    The activation is the input itself, its integral, or the input behind a filter of first order with the time constant
    `lag` [s]. `control` bounds the input, `force` the force.
    """

    name: str
    way: Way
    gain: Affine
    bias: Affine
    control: Bounds
    force: Bounds
    activation: Literal["none", "integrator", "filter"]
    lag: float


@record(kw_only=True)
class Tendon(Part):
    """Spring, damper, dry friction and inertia along a combination of coordinates. The spring is without force between
    both ends of `slack`."""

    name: str
    way: Way
    stiffness: float
    slack: tuple[float, float]
    damping: float
    friction: float
    armature: float
    limits: Bounds


@record(kw_only=True)
class Equality(Part):
    """A coordinate of a joint, or the length of a tendon, is a polynomial of another one: the way from the first of
    `rests` is the sum of `coefficients`, from the constant on, times powers of the way from the second [rad or m].
    Without `other` it is the constant."""

    name: str
    of: Literal["joint", "tendon"]
    one: str
    other: str | None
    rests: tuple[float, float]
    coefficients: tuple[float, ...]


@record(kw_only=True)
class Robot(Part):
    """`root` carries all other links, by `joints`; `closures` are joints between links that are carried already.
    `actuators` and `gravity` [m/s2] are None where the file does not tell them."""

    name: str
    origin: str
    root: str
    links: tuple[Link, ...]
    joints: tuple[Joint, ...]
    actuators: tuple[Actuator, ...] | None
    gravity: Vector | None = None
    servos: tuple[Servo, ...] = ()
    tendons: tuple[Tendon, ...] = ()
    closures: tuple[Joint, ...] = ()
    equalities: tuple[Equality, ...] = ()

    @property
    def every_joint(self) -> tuple[Joint, ...]:
        """Joints of the tree, and joints that close loops."""
        return (*self.joints, *self.closures)
