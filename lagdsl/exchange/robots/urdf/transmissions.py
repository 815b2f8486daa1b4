"""Transmissions of URDF files: joints with actuators, and rotors behind gears.

`drake:rotor_inertia` and `drake:gear_ratio` are those of Drake (Parsing Models, "transmission"): a rotor of inertia J
behind a gear of ratio n adds the kinetic energy n^2 J qd^2/2. `mechanicalReduction` is the ratio of ROS.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from lagdsl.exchange.robots.actuators import effort_of
from lagdsl.exchange.robots.description import Actuator, Joint
from lagdsl.exchange.robots.urdf.joints import Joints
from lagdsl.exchange.robots.xml_tree import Element

_MOVED = ("revolute", "prismatic")
_LEFT_OUT = "the rotor is left out"


def actuators_of(root: Element, joints: list[Joint], own: Joints) -> tuple[Actuator, ...] | None:
    """One for each joint that a transmission names; None in a file without transmissions."""
    known = {joint.name: joint for joint in joints}
    found: dict[str, Actuator] = {}
    for transmission in root.all("transmission"):
        for each in transmission.all("joint"):
            name = own.read.text(each, "name")
            if name is None:
                continue
            if name not in known:
                instead = "the transmission is left out"
                own.findings.error("E1008", each.place("name"), what="joint", name=name, instead=instead)
            elif known[name].kind in _MOVED and known[name].mimic is None:
                found.setdefault(name, effort_of(known[name], each.place("name")))
    return tuple(found.values()) or None


def with_rotors(root: Element, joints: list[Joint], loops: list[Joint], own: Joints) -> tuple[list[Joint], list[Joint]]:
    """The joints with the rotors of their actuators as armatures."""
    armatures: dict[str, float] = {}
    kinds = {joint.name: joint.kind for joint in (*joints, *loops)}
    for transmission in root.all("transmission"):
        for actuator in transmission.all("actuator"):
            element = _child(actuator, ("rotor_inertia", "rotorInertia"))
            if element is None:
                continue
            names = [each.attributes.get("name", "").strip() for each in transmission.all("joint")]
            if len(names) != 1 or kinds.get(names[0], "fixed") not in (*_MOVED, "fixed"):
                what = "a rotor that drives no single joint with one coordinate"
                own.findings.error("E1016", element.head, what=what, instead=_LEFT_OUT)
                continue
            inertia, ratio = _not_negative(element, own), _ratio(transmission, actuator, own)
            armatures[names[0]] = armatures.get(names[0], 0.0) + ratio**2 * inertia
    one, other = (
        [replace(each, passive=replace(each.passive, armature=armatures.get(each.name, 0.0))) for each in group]
        for group in (joints, loops)
    )
    return one, other


def _ratio(transmission: Element, actuator: Element, own: Joints) -> float:
    """Turns of the rotor in one of the joint: `gear_ratio`, else the reduction of ROS, else one."""
    element = _child(actuator, ("gear_ratio", "gearRatio"))
    ratio = None if element is None else own.read.value(element)
    for reduction in _reductions(transmission, actuator):
        found = own.read.value(reduction)
        if element is None and found is not None:
            return found
        if found is not None and ratio is not None and abs(found) not in (1.0, abs(ratio)):
            expected, instead = f"the gear ratio {ratio:g}, nor 1", "the gear ratio counts"
            words = {"name": reduction.tag, "text": f"{found:g}", "expected": expected}
            own.findings.error("E1006", reduction.head, instead=instead, **words)
    return 1.0 if ratio is None else ratio


def _reductions(transmission: Element, actuator: Element) -> Iterator[Element]:
    for owner in (actuator, *transmission.all("joint"), transmission):
        element = _child(owner, ("mechanicalReduction", "mechanical_reduction"))
        if element is not None:
            yield element


def _not_negative(element: Element, own: Joints) -> float:
    value = own.read.value(element)
    if value is not None and value < 0.0:
        words = {"name": element.tag, "text": f"{value:g}", "expected": "no negative number"}
        own.findings.error("E1006", element.head, instead=_LEFT_OUT, **words)
        return 0.0
    return value or 0.0


def _child(owner: Element, names: tuple[str, ...]) -> Element | None:
    """The child of one of these names, whatever stands before its colon."""
    return next((child for child in owner.children if child.tag.rpartition(":")[2] in names), None)
