"""Joints of URDF files: http://wiki.ros.org/urdf/XML/joint."""

from __future__ import annotations

from lagdsl.exchange.robots.attributes import Attributes
from lagdsl.exchange.robots.description import Joint, JointKind, Limits, Mimic, Passive, Vector
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.xml_tree import Element

_KINDS: dict[str, JointKind] = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": "fixed",
    "floating": "floating",
    "planar": "planar",
}
_MOVED = ("revolute", "prismatic")


class Joints:
    """Reads joints, and the parts that joints of the tree and those of loops have in common."""

    def __init__(self, read: Attributes, findings: Findings) -> None:
        self.read = read
        self.findings = findings

    def joint(self, element: Element) -> Joint | None:
        """A joint of the tree; None after errors."""
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
            axis=self.axis(element, kind),
            limits=self.limits(element, kind),
            passive=self.passive(element, kind),
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

    def axis(self, element: Element, kind: JointKind) -> Vector:
        """The `<axis>`, x without one."""
        axis = self.read.only(element, "axis")
        found = self.read.vector(axis, "xyz", (1.0, 0.0, 0.0))
        if axis is not None and kind in ("revolute", "prismatic", "planar") and not any(found):
            self.findings.error("E1006", axis.place("xyz"), name="xyz", text="0 0 0", expected="a direction")
        return found

    def limits(self, element: Element, kind: JointKind) -> Limits:
        """Bounds of the angle or the length; a continuous joint has none, a missing bound is 0."""
        limit = self.read.only(element, "limit")
        if limit is None or kind not in _MOVED:
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

    def passive(self, element: Element, kind: JointKind) -> Passive:
        """The damper and the friction of `<dynamics>`."""
        dynamics = self.read.only(element, "dynamics")
        if dynamics is None or kind not in _MOVED:
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
        if kind not in _MOVED:  # it has no coordinate that could follow another
            self.read.leave_out(mimic)
            return None
        joint = self.read.text(mimic, "joint")
        multiplier, offset = self.read.number(mimic, "multiplier", 1.0), self.read.number(mimic, "offset", 0.0)
        if joint is None or multiplier is None or offset is None:
            return None
        return Mimic(joint=joint, multiplier=multiplier, offset=offset, span=mimic.place("joint"))
