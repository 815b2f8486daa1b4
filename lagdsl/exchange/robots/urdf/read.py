"""URDF files: http://wiki.ros.org/urdf/XML. Links and joints; transmissions are actuators."""

from __future__ import annotations

import re
from collections import deque
from pathlib import Path

from lagdsl.exchange.robots.attributes import Attributes
from lagdsl.exchange.robots.description import Link, Robot
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.idle import Tree, idle_as_rigid
from lagdsl.exchange.robots.inertia import read_inertial
from lagdsl.exchange.robots.reach import Reach
from lagdsl.exchange.robots.tree import root_of, sound_closures, sound_mimics
from lagdsl.exchange.robots.urdf.gazebo import gazebo_joints
from lagdsl.exchange.robots.urdf.joints import Joints
from lagdsl.exchange.robots.urdf.loops import loop_joints
from lagdsl.exchange.robots.urdf.transmissions import actuators_of, with_rotors
from lagdsl.exchange.robots.urdf.visuals import read_visuals
from lagdsl.exchange.robots.urdf.vocabulary import tell_unread
from lagdsl.exchange.robots.xml_tree import Element
from lagdsl.foundation.source import Span

_TOP = frozenset({"link", "joint", "transmission", "material", "loop_joint"})
_MACRO = re.compile(r"\$[({]")


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
        links = [link for element in root.all("link") if (link := self._link(element)) is not None]
        self.read.tell_untaken()
        own = Joints(self.read, self.findings)
        joints = [joint for element in root.all("joint") if (joint := own.joint(element)) is not None]
        if self.findings.sink.has_errors:
            return None
        joints = sound_mimics(joints, self.findings)
        base = root_of(root, links, joints, self.findings)
        if base is None or self.findings.sink.has_errors:
            return None
        loops = [*loop_joints(root, own), *gazebo_joints(root, base, joints, own)]
        joints, loops = with_rotors(root, joints, loops, own)
        between, closures = sound_closures(links, joints, loops, self.findings)
        if self.findings.sink.has_errors:
            return None
        joints = idle_as_rigid(Tree(base, links, joints, closures, [], []), self.findings)
        actuators = actuators_of(root, [*joints, *closures], own)
        tell_unread(root, self.read)
        self.read.tell_left_out()
        return Robot(
            name=root.attributes.get("name", "").strip() or self.path.stem,
            origin=self.path.name,
            root=base,
            links=(*links, *between),
            joints=tuple(joints),
            closures=tuple(closures),
            actuators=actuators,
            span=root.head,
        )

    def _link(self, element: Element) -> Link | None:
        name = self.read.text(element, "name")
        inertial = read_inertial(element, self.read, self.findings)
        visuals = read_visuals(element, self.reach, self.read, self.findings)
        return None if name is None else Link(name=name, inertial=inertial, visuals=visuals, span=element.place("name"))


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
