"""Style of the text, and the names that the text has for the parts of a robot."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, TypeAlias, get_args

from lagdsl.exchange.model_text.identifiers import model_name
from lagdsl.exchange.robots.actuators import effort_of
from lagdsl.exchange.robots.description import Actuator, Equality, Joint, JointKind, Link, Robot, Servo, Tendon
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.names import Names
from lagdsl.exchange.robots.tree import WORLD
from lagdsl.foundation.record import record

LimitStyle: TypeAlias = Literal["range", "contact", "none"]
Drives: TypeAlias = Literal["file", "all", "none"]
Role: TypeAlias = Literal["origin", "end", "gear", "friction", "lower", "upper", "within"]
COORDINATES: dict[JointKind, str] = {"revolute": "q", "prismatic": "s", "screw": "q"}
"""The coordinate of a joint that moves along one."""


@record(kw_only=True)
class Style:
    """Choices of whoever imports: form of limits, joints with inputs, a root that moves freely."""

    limits: LimitStyle = "range"
    actuators: Drives = "file"
    floating: bool = False


@record(kw_only=True)
class NamedServo:
    """A servo with the names of its input, its activation, its force and the length that it sees."""

    servo: Servo
    input: str
    activation: str
    effort: str
    length: str


@record(kw_only=True)
class Plan:
    """Names in the text by the original ones. `resting` are the links that no joint moves; `base` is the joint of a
    root that moves freely, `drives` the actuators with the names of their inputs, those of arrays element by element,
    `tendons` have names of their lengths, `equalities` those of constraints. `parts` has the names of what stands
    beside a joint or a tendon, by its name and the role of the part."""

    robot: Robot
    style: Style
    model: str
    links: dict[str, str]
    joints: dict[str, str]
    base: str | None
    drives: tuple[tuple[str, Actuator], ...]
    servos: tuple[NamedServo, ...]
    tendons: tuple[tuple[str, Tendon], ...]
    equalities: tuple[tuple[str, Equality], ...]
    parts: dict[tuple[str, Role], str]
    resting: frozenset[str]


def planned(robot: Robot, style: Style, findings: Findings) -> Plan:
    """Names that are free, for everything that the text names."""
    names = Names(findings)
    model = names.of(model_name(robot.name, "robot"), "robot")
    links = {link.name: _link_name(link, robot, style, names) for link in robot.links if not link.is_between}
    links.setdefault(WORLD, "world")
    joints = {joint.name: names.of(joint.name, "joint", joint.span) for joint in robot.every_joint}
    drives = _drives(robot, _actuators(robot, style), names)
    base = names.of("floating_base", "joint") if style.floating else None
    servos = tuple(_servo(servo, names) for servo in robot.servos) if style.actuators == "file" else ()
    tendons = tuple((names.of(tendon.name, "tendon", tendon.span), tendon) for tendon in robot.tendons)
    owners = [*joints.values(), *(name for name, _ in tendons)]
    return Plan(
        robot=robot,
        style=style,
        model=model,
        links=links,
        joints=joints,
        base=base,
        drives=tuple(drives),
        servos=servos,
        tendons=tendons,
        equalities=tuple((names.of(each.name, "constraint"), each) for each in robot.equalities),
        parts={(owner, role): names.of(f"{owner}_{role}", "part") for owner in owners for role in get_args(Role)},
        resting=frozenset() if style.floating else rigid_with_root(robot),
    )


def rigid_with_root(robot: Robot) -> frozenset[str]:
    """The root link and those that rigid joints alone connect with it."""
    rigid: dict[str, list[str]] = {}
    for joint in robot.joints:
        if joint.kind == "fixed":
            rigid.setdefault(joint.parent, []).append(joint.child)
    found = [robot.root]
    for name in found:
        found += rigid.get(name, ())
    return frozenset(found)


def is_body(plan: Plan, link: Link) -> bool:
    """True if a link is written as a body: it has mass, and something moves it."""
    return link.inertial is not None and link.name not in plan.resting


def frame_of(plan: Plan, link: Link) -> str:
    """The frame of a link, as an expression."""
    return f"{plan.links[link.name]}.frame_a" if is_body(plan, link) else plan.links[link.name]


def coordinate_of(plan: Plan, joint: Joint) -> str:
    """The coordinate of a joint, as an expression."""
    return f"{plan.joints[joint.name]}.{COORDINATES[joint.kind]}"


def _link_name(link: Link, robot: Robot, style: Style, names: Names) -> str:
    """A root of the name `world` that is nothing but a place is the world of the language."""
    if link.name == "world" == robot.root and link.inertial is None and not style.floating:
        return "world"
    return names.of(link.name, "link", link.span)


def _input_name(actuator: Actuator, kind: JointKind) -> str:
    """`tau_elbow` and `f_slide` for efforts."""
    if actuator.gear is not None:
        return actuator.name
    return f"{_letter(kind)}_{actuator.name}"


def _drives(robot: Robot, actuators: Sequence[Actuator], names: Names) -> list[tuple[str, Actuator]]:
    """The actuators with the names of their inputs. Where every joint has one and its effort is the input, in the order
    of the joints: two torques or more are elements of `tau`, two forces or more of `f`."""
    kinds = {joint.name: joint.kind for joint in robot.every_joint}
    order = [joint.name for joint in _movable(robot)]
    if sorted(each.joint for each in actuators) != sorted(order) or any(each.gear is not None for each in actuators):
        return [(names.of(_input_name(each, kinds[each.joint]), "input"), each) for each in actuators]
    ordered = sorted(actuators, key=lambda each: order.index(each.joint))
    letters = [_letter(kinds[each.joint]) for each in ordered]
    arrays = {letter: names.of(letter, "input") for letter in sorted(set(letters)) if letters.count(letter) > 1}
    found = []
    for place, (letter, each) in enumerate(zip(letters, ordered, strict=True)):
        if letter in arrays:
            found.append((f"{arrays[letter]}[{letters[: place + 1].count(letter)}]", each))
        else:
            found.append((names.of(_input_name(each, kinds[each.joint]), "input"), each))
    return found


def _letter(kind: JointKind) -> str:
    return "f" if kind == "prismatic" else "tau"


def _servo(servo: Servo, names: Names) -> NamedServo:
    own = names.of(servo.name, "input", servo.span)
    others = {role: names.of(f"{own}_{role}", "variable") for role in ("activation", "effort", "length")}
    return NamedServo(servo=servo, input=own, **others)


def _actuators(robot: Robot, style: Style) -> tuple[Actuator, ...]:
    """The actuators of the file; of every joint if that is wanted, or if the file says nothing of actuators."""
    match style.actuators:
        case "none":
            return ()
        case "file" if robot.actuators is not None:
            return robot.actuators
        case "file" | "all":
            return tuple(effort_of(joint, joint.span) for joint in _movable(robot))


def _movable(robot: Robot) -> list[Joint]:
    """Joints with a coordinate of their own."""
    return [joint for joint in robot.every_joint if joint.kind in COORDINATES and joint.mimic is None]
