"""`<gazebo><joint>`: a joint of SDFormat between two links of the tree, http://sdformat.org/spec?elem=joint.

The frame of such a joint stands at its pose in the frame of its child, and meets that of the parent where all
coordinates of the robot are zero.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from lagdsl.exchange.robots.description import Joint, JointKind, Limits, Passive, Pose, Vector
from lagdsl.exchange.robots.turns import inverse, place_of, pose_of, vector_of
from lagdsl.exchange.robots.urdf.joints import Joints
from lagdsl.exchange.robots.xml_tree import Element
from lagdsl.foundation.numerics.rank import Floats

_KINDS: dict[str, tuple[JointKind, ...]] = {
    "revolute": ("revolute",),
    "continuous": ("revolute",),
    "prismatic": ("prismatic",),
    "screw": ("screw",),
    "ball": ("spherical",),
    "fixed": ("fixed",),
    "universal": ("revolute", "revolute"),
    "revolute2": ("revolute", "revolute"),
}
_LEFT_OUT = "the joint is left out"
_UNBOUNDED = 1e16  # SDFormat writes this number for no limit
_WORLD = "world"


def gazebo_joints(root: Element, base: str, joints: list[Joint], own: Joints) -> list[Joint]:
    """Joints that close loops; E1010 and E1016 for types without a counterpart. Two axes are two joints in a row."""
    places = _places(base, joints)
    places["__model__"] = np.eye(4)
    places.setdefault(_WORLD, np.eye(4))
    places |= {joint.name: places[joint.child] for joint in joints if joint.name not in places}
    found: list[Joint] = []
    for gazebo in root.all("gazebo"):
        if "reference" not in gazebo.attributes:
            for element in gazebo.all("joint"):
                found += _joint(element, places, own)
    return found


def _places(base: str, joints: list[Joint]) -> dict[str, Floats]:
    """Places of links against the base where all coordinates are zero."""
    places = {base: np.eye(4)}
    below: dict[str, list[Joint]] = {}
    for joint in joints:
        below.setdefault(joint.parent, []).append(joint)
    waiting = [base]
    while waiting:
        for joint in below.get(waiting.pop(), ()):
            places[joint.child] = places[joint.parent] @ place_of(joint.before) @ place_of(joint.after)
            waiting.append(joint.child)
    return places


def _joint(element: Element, places: dict[str, Floats], own: Joints) -> Iterator[Joint]:
    name, spelled = own.read.text(element, "name"), own.read.text(element, "type")
    parent, child = (_link(element, tag, own) for tag in ("parent", "child"))
    if name is None or spelled is None or parent is None or child is None:
        return
    if spelled not in _KINDS:
        code = "E1016" if spelled == "gearbox" else "E1010"
        words = {"what": "a joint of the type gearbox", "type": spelled, "known": ", ".join(_KINDS)}
        own.findings.error(code, element.place("type"), instead=_LEFT_OUT, **words)
        return
    for link in (parent, child):
        if link not in places:
            own.findings.error("E1008", element.place("name"), what="link", name=link, instead=_LEFT_OUT)
            return
    at = _pose(element, child, places, own)
    if at is None:
        return
    kinds = _KINDS[spelled]
    before = pose_of(np.asarray(np.linalg.inv(places[parent]) @ at, dtype=float))
    after = inverse(pose_of(np.asarray(np.linalg.inv(places[child]) @ at, dtype=float)))
    for number, kind in enumerate(kinds):
        first, last = number == 0, number == len(kinds) - 1
        axis = own.read.only(element, "axis2" if number else "axis")
        yield Joint(
            name=name if first else f"{name}_2",
            kind=kind,
            parent=parent if first else f"{name} after joint {number}",
            child=child if last else f"{name} after joint {number + 1}",
            before=before if first else Pose(),
            after=after if last else Pose(),
            axis=_axis(axis, at, places, own) if axis is not None else (0.0, 0.0, 1.0),
            lead=_lead(element, own) if kind == "screw" else 0.0,
            limits=_limits(axis, own, is_bounded=spelled != "continuous"),
            passive=_passive(axis, own),
            span=element.place("name"),
        )


def _link(element: Element, tag: str, own: Joints) -> str | None:
    """The link that `<parent>` or `<child>` names, between its tags or in the attribute of old files."""
    found = own.read.only(element, tag)
    name = "" if found is None else found.text or found.attributes.get("link", "").strip()
    if not name:
        own.findings.error("E1005", element.head, element="joint", what=f"element `<{tag}>`", instead=_LEFT_OUT)
        return None
    return name.rpartition("::")[2]


def _pose(element: Element, child: str, places: dict[str, Floats], own: Joints) -> Floats | None:
    """The place of the joint against the base; None after errors."""
    pose = own.read.only(element, "pose")
    if pose is None or not pose.text:
        return places[child]
    frame = pose.attributes.get("relative_to", pose.attributes.get("frame", "")).strip() or child
    if frame not in places:
        own.findings.error("E1008", pose.head, what="frame", name=frame, instead=_LEFT_OUT)
        return None
    if pose.attributes.get("rotation_format", "euler_rpy").strip() != "euler_rpy":
        what = "a pose of SDFormat with a quaternion"
        own.findings.error("E1016", pose.head, what=what, instead=_LEFT_OUT)
        return None
    with own.read.or_else(_LEFT_OUT):
        numbers = own.read.content(pose, 6)
    if numbers is None:
        return None
    x, y, z, *angles = numbers
    in_degrees = pose.attributes.get("degrees", "").strip() in ("true", "1")
    roll, pitch, yaw = map(math.radians, angles) if in_degrees else angles
    return np.asarray(places[frame] @ place_of(Pose(xyz=(x, y, z), rpy=(roll, pitch, yaw))))


def _axis(axis: Element, at: Floats, places: dict[str, Floats], own: Joints) -> Vector:
    """In the axes of the joint, unless the file names others."""
    element = own.read.only(axis, "xyz")
    numbers = own.read.content(element, 3)
    if element is None or numbers is None:
        return (0.0, 0.0, 1.0)
    if not any(numbers):
        own.findings.error("E1006", element.head, name="<xyz>", text=element.text, expected="a direction")
    frame = element.attributes.get("expressed_in", "").strip()
    parent_model = axis.first("use_parent_model_frame")
    if not frame and parent_model is not None and parent_model.text in ("true", "1"):
        frame = "__model__"
    if not frame:
        return vector_of(np.array(numbers))
    if frame not in places:
        own.findings.error("E1008", element.head, what="frame", name=frame)
        return (0.0, 0.0, 1.0)
    return vector_of(at[:3, :3].T @ places[frame][:3, :3] @ np.array(numbers))


def _lead(element: Element, own: Joints) -> float:
    """`screw_thread_pitch` is the advance in a turn, 1 m by default; `thread_pitch` of old files counts the other way,
    in radians a meter."""
    pitch = own.read.content(own.read.only(element, "screw_thread_pitch"), 1)
    old = own.read.content(own.read.only(element, "thread_pitch"), 1)
    if pitch is None and old is not None and old[0]:
        return -2 * math.pi / old[0]
    return 1.0 if pitch is None else pitch[0]


def _limits(axis: Element | None, own: Joints, is_bounded: bool) -> Limits:
    limit = None if axis is None else own.read.only(axis, "limit")
    if limit is None:
        return Limits()
    lower, upper, effort, velocity = (_bound(limit, name, own) for name in ("lower", "upper", "effort", "velocity"))
    effort, velocity = (None if most is None or most < 0.0 else most for most in (effort, velocity))
    if not is_bounded:
        return Limits(effort=effort, velocity=velocity)
    if lower is not None and upper is not None and lower > upper:
        words = {"lower": lower, "upper": upper}
        own.findings.error("E1009", limit.head, instead="the joint is written without them", **words)
        lower = upper = None
    return Limits(lower=lower, upper=upper, effort=effort, velocity=velocity)


def _bound(limit: Element, name: str, own: Joints) -> float | None:
    element = own.read.only(limit, name)
    if element is None or element.text.lstrip("+-").lower() in ("inf", "infinity"):
        return None
    numbers = own.read.content(element, 1)
    return None if numbers is None or abs(numbers[0]) >= _UNBOUNDED else numbers[0]


def _passive(axis: Element | None, own: Joints) -> Passive:
    dynamics = None if axis is None else own.read.only(axis, "dynamics")
    if dynamics is None:
        return Passive()
    damping, friction, stiffness, rest = (
        (own.read.content(own.read.only(dynamics, name), 1) or (0.0,))[0]
        for name in ("damping", "friction", "spring_stiffness", "spring_reference")
    )
    for name, value in (("damping", damping), ("friction", friction), ("spring_stiffness", stiffness)):
        if value < 0.0:
            words = {"name": name, "text": f"{value:g}", "expected": "no negative number"}
            own.findings.error("E1006", dynamics.head, instead="it is left out", **words)
    return Passive(damping=max(damping, 0.0), friction=max(friction, 0.0), stiffness=max(stiffness, 0.0), rest=rest)
