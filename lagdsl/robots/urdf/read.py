"""URDF files: http://wiki.ros.org/urdf/XML. Links and joints; transmissions are actuators."""

from __future__ import annotations

import re
from collections import deque
from pathlib import Path

from lagdsl.robots.actuators import effort_of
from lagdsl.robots.attributes import Attributes
from lagdsl.robots.description import Actuator, Joint, JointKind, Limits, Link, Mimic, Passive, Robot
from lagdsl.robots.findings import Findings
from lagdsl.robots.idle import Tree, idle_as_rigid
from lagdsl.robots.inertia import read_inertial
from lagdsl.robots.reach import Reach
from lagdsl.robots.tree import root_of, sound_mimics
from lagdsl.robots.urdf.visuals import read_visuals
from lagdsl.robots.xml_tree import Element
from lagdsl.source import Span

_KINDS: dict[str, JointKind] = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": "fixed",
    "floating": "floating",
    "planar": "planar",
}
_TOP = frozenset({"link", "joint", "transmission", "material"})
_MACRO = re.compile(r"\$[({]")
_OF_LINKS = frozenset({"inertial", "visual"})
_OF_JOINTS = frozenset({"origin", "parent", "child", "axis", "limit", "dynamics", "mimic"})


def read_urdf(path: Path, root: Element, reach: Reach, findings: Findings) -> Robot | None:
    """The robot of a file, or None after errors; what is left out is told."""
    reader = _Reader(path, reach, Attributes(findings), findings)
    return reader.robot(root)


class _Reader:
    def __init__(self, path: Path, reach: Reach, attributes: Attributes, findings: Findings) -> None:
        self.path = path
        self.reach = reach
        self.read = attributes
        self.findings = findings

    def robot(self, root: Element) -> Robot | None:
        macro = _unexpanded(root)
        if macro is not None:
            self.findings.error("E1025", macro)
            return None
        self.read.leave_out_others(root, _TOP)
        links = [link for element in root.all("link") if (link := self._link(element)) is not None]
        self.read.tell_untaken()
        joints = [joint for element in root.all("joint") if (joint := self._joint(element)) is not None]
        if self.findings.sink.has_errors:
            return None
        joints = sound_mimics(joints, self.findings)
        base = root_of(root, links, joints, self.findings)
        if base is None or self.findings.sink.has_errors:
            return None
        joints = idle_as_rigid(Tree(base, links, joints, [], [], []), self.findings)
        moved = {joint.name: joint for joint in joints if joint.kind in ("revolute", "prismatic")}
        actuators = self._actuators(root, moved, {joint.name for joint in joints})
        self.read.tell_left_out()
        return Robot(
            name=root.attributes.get("name", "").strip() or self.path.stem,
            origin=self.path.name,
            root=base,
            links=tuple(links),
            joints=tuple(joints),
            actuators=actuators,
            span=root.head,
        )

    def _link(self, element: Element) -> Link | None:
        name = self.read.text(element, "name")
        self.read.leave_out_others(element, _OF_LINKS)
        inertial = read_inertial(element, self.read, self.findings)
        visuals = read_visuals(element, self.reach, self.read, self.findings)
        return None if name is None else Link(name=name, inertial=inertial, visuals=visuals, span=element.place("name"))

    def _joint(self, element: Element) -> Joint | None:
        self.read.leave_out_others(element, _OF_JOINTS)
        name = self.read.text(element, "name")
        kind = self._kind(element)
        ends = [self._end(element, tag) for tag in ("parent", "child")]
        if name is None or kind is None or ends[0] is None or ends[1] is None:
            return None
        mimic = self._mimic(element, kind)
        return Joint(
            name=name,
            kind=kind,
            parent=ends[0],
            child=ends[1],
            before=self.read.pose(element),
            axis=self._axis(element, kind),
            limits=self._limits(element, kind),
            passive=self._passive(element, kind),
            mimic=mimic,
            span=element.place("name"),
        )

    def _kind(self, element: Element) -> JointKind | None:
        spelled = self.read.text(element, "type")
        if spelled is None:
            return None
        if spelled not in _KINDS:
            known = ", ".join(_KINDS)
            instead = "the joint is written as a rigid one"
            self.findings.error("E1010", element.place("type"), type=spelled, known=known, instead=instead)
            return "fixed"
        return _KINDS[spelled]

    def _end(self, element: Element, tag: str) -> str | None:
        """The link that `<parent>` or `<child>` names."""
        found = self.read.only(element, tag)
        if found is None:
            self.findings.error("E1005", element.head, element="joint", what=f"element `<{tag}>`")
            return None
        return self.read.text(found, "link")

    def _axis(self, element: Element, kind: JointKind) -> tuple[float, float, float]:
        axis = self.read.only(element, "axis")
        found = self.read.vector(axis, "xyz", (1.0, 0.0, 0.0))
        if axis is not None and kind in ("revolute", "prismatic", "planar") and not any(found):
            self.findings.error("E1006", axis.place("xyz"), name="xyz", text="0 0 0", expected="a direction")
        return found

    def _limits(self, element: Element, kind: JointKind) -> Limits:
        """Bounds of the angle or the length; a continuous joint has none, a missing bound is 0."""
        limit = self.read.only(element, "limit")
        if limit is None or kind not in ("revolute", "prismatic"):
            return Limits()
        effort, velocity = (self.read.number(limit, name) or None for name in ("effort", "velocity"))
        if element.attributes.get("type", "").strip() == "continuous":
            return Limits(effort=effort, velocity=velocity)
        lower, upper = (self.read.number(limit, name, 0.0) for name in ("lower", "upper"))
        if lower is not None and upper is not None and lower > upper:
            instead = "the joint is written without them"
            self.findings.error("E1009", limit.place("lower"), lower=lower, upper=upper, instead=instead)
            lower = upper = None
        return Limits(lower=lower, upper=upper, effort=effort, velocity=velocity)

    def _passive(self, element: Element, kind: JointKind) -> Passive:
        dynamics = self.read.only(element, "dynamics")
        if dynamics is None or kind not in ("revolute", "prismatic"):
            return Passive()
        values = {name: self.read.number(dynamics, name, 0.0) or 0.0 for name in ("damping", "friction")}
        for name, value in values.items():
            if value < 0.0:
                instead = "it is left out"
                expected = "no negative number"
                self.findings.error(
                    "E1006", dynamics.place(name), name=name, text=f"{value:g}", expected=expected, instead=instead
                )
        return Passive(damping=max(values["damping"], 0.0), friction=max(values["friction"], 0.0))

    def _mimic(self, element: Element, kind: JointKind) -> Mimic | None:
        mimic = self.read.only(element, "mimic")
        if mimic is None:
            return None
        if kind not in ("revolute", "prismatic"):  # it has no coordinate that could follow another
            self.read.leave_out(mimic)
            return None
        joint = self.read.text(mimic, "joint")
        multiplier, offset = self.read.number(mimic, "multiplier", 1.0), self.read.number(mimic, "offset", 0.0)
        if joint is None or multiplier is None or offset is None:
            return None
        return Mimic(joint=joint, multiplier=multiplier, offset=offset, span=mimic.place("joint"))

    def _actuators(self, root: Element, moved: dict[str, Joint], known: set[str]) -> tuple[Actuator, ...] | None:
        """One for each joint that a transmission names; None in a file without transmissions."""
        found: dict[str, Actuator] = {}
        for transmission in root.all("transmission"):
            for each in transmission.all("joint"):
                name = self.read.text(each, "name")
                if name is None:
                    continue
                if name not in known:
                    instead = "the transmission is left out"
                    self.findings.error("E1008", each.place("name"), what="joint", name=name, instead=instead)
                elif name in moved and moved[name].mimic is None:
                    span = each.place("name")
                    found.setdefault(name, effort_of(moved[name], span))
        return tuple(found.values()) or None


def _unexpanded(root: Element) -> Span | None:
    """The first macro, or value with a macro, of xacro, in what is read: links and joints would be missing."""
    waiting = deque([root, *(child for child in root.children if child.tag in _TOP or child.tag.startswith("xacro:"))])
    while waiting:
        element = waiting.popleft()
        if element.tag.startswith("xacro:"):
            return element.head
        for name, value in element.attributes.items():
            if _MACRO.search(value):
                return element.place(name)
        waiting.extend(element.children if element is not root else ())
    return None
