"""A robot as a model text: links, joints, what joins them, what acts in them, what is seen."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import groupby
from pathlib import Path
from typing import assert_never

from lagdsl.exchange.model_text.numbers import angle, array, number, quantity, vector
from lagdsl.exchange.robots.description import ZERO, Actuator, Joint, JointKind, Link, Pose, Vector
from lagdsl.exchange.robots.drawings import drawings
from lagdsl.exchange.robots.equalities import equalities
from lagdsl.exchange.robots.plan import Plan, Role, is_body
from lagdsl.exchange.robots.relations import acting, energies, lifts
from lagdsl.exchange.robots.servos import activations, servo_inputs, servos, tendons
from lagdsl.exchange.robots.turns import behind
from lagdsl.language.syntax.print_expressions import quoted

_DEFAULT_AXES: dict[JointKind, Vector] = {
    "revolute": (0.0, 0.0, 1.0),
    "prismatic": (1.0, 0.0, 0.0),
    "planar": (0.0, 0.0, 1.0),
    "screw": (1.0, 0.0, 0.0),
}
_CUT = "prefer = never"


def model_text(plan: Plan, folder: Path) -> str:
    """The text of the model for a file in `folder`, a statement a line; the printer of the language breaks and indents
    the lines."""
    gravity = plan.robot.gravity
    parts = [
        ["import Lag.Spatial.*;"],
        ["// Links: mass, mass center, inertia about it", *_links(plan)],
        ["// Joints, and what places them in the axes of the link before", *_joints(plan)] if plan.joints else [],
        ["// Joints that close loops", *_components(plan, plan.robot.closures)] if plan.robot.closures else [],
        [*_inputs(plan), *servo_inputs(plan)],
        _connections(plan),
        energies(plan),
        acting(plan),
        list(tendons(plan)),
        list(equalities(plan)),
        lifts(plan),
        list(servos(plan)),
        [f"gravity = {'-g_n*world.z' if gravity is None else _acceleration(gravity)};"],
        list(drawings(plan, folder)),
        activations(plan),
        ["annotation(experiment(StopTime = 1, Tolerance = 1e-8));"],
    ]
    blocks = "\n\n".join("\n".join(part) for part in parts if part)
    return f"model {plan.model} {quoted(f'Imported from {plan.robot.origin}')}\n{blocks}\nend {plan.model};\n"


def _acceleration(gravity: tuple[float, float, float]) -> str:
    return array(quantity(value, "m/s2") for value in gravity) if gravity != ZERO else "0"


# ---- links -----------------------------------------------------------------------------------------------------------


def _links(plan: Plan) -> Iterator[str]:
    for link in plan.robot.links:
        if link.is_between:
            continue
        name = plan.links[link.name]
        if is_body(plan, link):
            yield _body(name, link)
        elif link.inertial is not None:
            yield f'frame {name} "at rest, {number(link.inertial.mass)} kg";'
        elif name != "world":
            yield f"frame {name};"


def _body(name: str, link: Link) -> str:
    assert link.inertial is not None
    entries = link.inertial.inertia
    parts = [f"m = {number(link.inertial.mass)}"]
    if any(link.inertial.com):
        parts.append(f"com = {vector(link.inertial.com)}")
    if any(entries) and link.inertial.is_possible:
        parts.append(f"I = {vector(entries if any(entries[3:]) else entries[:3])}")
    return f"Body {name}({', '.join(parts)});"


# ---- joints ----------------------------------------------------------------------------------------------------------


def _joints(plan: Plan) -> Iterator[str]:
    if plan.base is not None:
        yield f"FreeQuaternion {plan.base};"
    yield from _components(plan, plan.robot.joints)


def _components(plan: Plan, joints: Iterable[Joint]) -> Iterator[str]:
    for joint in joints:
        if joint.kind == "fixed":
            yield _weld(plan.joints[joint.name], behind(joint.before, joint.after))
            continue
        for role, pose in _mounts(joint):
            name = plan.parts[plan.joints[joint.name], role]
            yield _weld(name, pose) if any(pose.rpy) else f"FixedTranslation {name}(r = {vector(pose.xyz)});"
        yield _joint(plan, joint)


def _mounts(joint: Joint) -> Iterator[tuple[Role, Pose]]:
    """The displacements before and behind a joint."""
    mounts: tuple[tuple[Role, Pose], ...] = (("origin", joint.before), ("end", joint.after))
    return ((role, pose) for role, pose in mounts if not pose.is_identity)


def _weld(name: str, pose: Pose) -> str:
    """One turn is one of the angles x, y, z in any sequence; fixed-axis turns are the sequence zyx, last one first."""
    parts = [f"r = {vector(pose.xyz)}"] if any(pose.xyz) else []
    if sum(map(bool, pose.rpy)) > 1:
        parts += ['sequence = "zyx"', f"angles = {array(map(angle, reversed(pose.rpy)))}"]
    elif any(pose.rpy):
        parts.append(f"angles = {array(map(angle, pose.rpy))}")
    return f"Weld {name}({', '.join(parts)});" if parts else f"Weld {name};"


def _joint(plan: Plan, joint: Joint) -> str:
    parts = []
    if joint.kind in _DEFAULT_AXES and joint.axis != _DEFAULT_AXES[joint.kind]:
        parts.append(f"axis = {vector(joint.axis)}")
    attributes = _attributes(plan, joint)
    match joint.kind:
        case "revolute":
            component, coordinate, effort, unit = "Revolute", "q", "tau", "rad/s"
        case "prismatic":
            component, coordinate, effort, unit = "Prismatic", "s", "f", "m/s"
        case "screw":
            component, coordinate, effort, unit = "Screw", "q", "tau", "rad/s"
            parts.append(f"lead = {number(joint.lead)}")
        case "spherical" | "floating" | "planar" | "fixed":
            components = {"spherical": "Spherical", "floating": "FreeQuaternion", "planar": "Planar", "fixed": "Weld"}
            parts += _place(joint) + (_cut(joint) if joint in plan.robot.closures else [])
            return f"{components[joint.kind]} {plan.joints[joint.name]}{_modifiers(parts)};"
        case _:
            assert_never(joint.kind)
    parts += [f"{coordinate}{_modifiers(attributes)}"] if attributes else []
    drives = [_effort(joint, name, actuator.gear) for name, actuator in plan.drives if actuator.joint == joint.name]
    parts += [f"{effort} = {' + '.join(drives)}"] if drives else []
    velocity = joint.limits.velocity
    doc = f' "at most {number(velocity)} {unit}"' if velocity is not None else ""
    return f"{component} {plan.joints[joint.name]}{_modifiers(parts)}{doc};"


def _place(joint: Joint) -> list[str]:
    """Start of a floating joint; the quaternion is that of no turn by itself."""
    position, turn = joint.place[:3], joint.place[3:]
    found = [f"r(start = {vector(position)})"] if any(position) else []
    return found + ([f"e(start = {vector(turn)})"] if turn and turn != (1.0, 0.0, 0.0, 0.0) else [])


def _cut(joint: Joint) -> list[str]:
    """The compiler cuts a joint that closes a loop, and keeps those of the tree."""
    coordinates = {"spherical": ("e",), "planar": ("x", "y", "q")}.get(joint.kind, ())
    return [f"{coordinate}({_CUT})" for coordinate in coordinates]


def _modifiers(parts: Iterable[str]) -> str:
    text = ", ".join(parts)
    return f"({text})" if text else ""


def _attributes(plan: Plan, joint: Joint) -> list[str]:
    """Start and limits of the coordinate. A start that the file does not give lies between the limits."""
    write = number if joint.kind == "prismatic" else angle
    lower, upper = joint.limits.lower, joint.limits.upper
    start = joint.start or 0.0
    if joint.start is None and lower is not None and upper is not None:
        start = min(max(start, lower), upper)
    found = [f"start = {write(start)}"] if start else []
    found += [_CUT] if joint in plan.robot.closures else []
    if plan.style.limits == "range":
        found += [f"min = {write(lower)}"] if lower is not None else []
        found += [f"max = {write(upper)}"] if upper is not None else []
    return found


def _effort(joint: Joint, name: str, gear: float | None) -> str:
    return name if gear is None else f"{number(gear)} {'N' if joint.kind == 'prismatic' else 'N.m'}*{name}"


# ---- inputs and connections ------------------------------------------------------------------------------------------


def _inputs(plan: Plan) -> Iterator[str]:
    """One line for each input; elements of an array have one."""
    for base, group in groupby(sorted(plan.drives, key=_array_order(plan)), key=lambda drive: _base(drive[0])):
        drives = list(group)
        actuators = [actuator for _, actuator in drives]
        joint = next(joint for joint in plan.robot.every_joint if joint.name == actuators[0].joint)
        kind = "Real" if actuators[0].gear is not None else "Force" if joint.kind == "prismatic" else "Torque"
        size = f"[{len(drives)}]" if drives[0][0] != base else ""
        lows, highs = [actuator.low for actuator in actuators], [actuator.high for actuator in actuators]
        parts = [*_bounds("min", lows, "-inf", bool(size)), *_bounds("max", highs, "inf", bool(size))]
        yield f"input {kind} {base}{size}{_modifiers(parts)};"


def _base(name: str) -> str:
    return name.partition("[")[0]


def _array_order(plan: Plan) -> Callable[[tuple[str, Actuator]], int]:
    """Arrays stand where their first element does."""
    bases = [_base(name) for name, _ in plan.drives]
    return lambda drive: bases.index(_base(drive[0]))


def _bounds(word: str, values: list[float | None], none: str, is_array: bool) -> list[str]:
    """A bound of an input; of an array those of its elements, or one for each where they are the same."""
    if all(value is None for value in values):
        return []
    texts = [none if value is None else number(value) for value in values]
    if not is_array:
        return [f"{word} = {texts[0]}"]
    return [f"each {word} = {texts[0]}" if len(set(texts)) == 1 else f"{word} = {array(texts)}"]


def _connections(plan: Plan) -> list[str]:
    """One line for each joint, from the link before it to the link that it carries."""
    root = plan.links[plan.robot.root]
    found = []
    if plan.base is not None:
        found.append(f"connect(world, {plan.base}, {root});")
    elif root != "world":
        found.append(f"connect(world, {root});")
    between = {link.name for link in plan.robot.links if link.is_between}
    chain: list[str] = []
    for joint in plan.robot.every_joint:
        chain += [*([] if chain else [plan.links[joint.parent]]), *_through(plan, joint)]
        if joint.child not in between:  # else the next joint goes on from here
            found.append(f"connect({', '.join([*chain, plan.links[joint.child]])});")
            chain = []
    return found


def _through(plan: Plan, joint: Joint) -> list[str]:
    """A joint with what stands before and behind it."""
    name = plan.joints[joint.name]
    if joint.kind == "fixed":
        return [name]
    roles = [role for role, _ in _mounts(joint)]
    before, after = ([plan.parts[name, role] for role in roles if role == end] for end in ("origin", "end"))
    return [*before, name, *after]
