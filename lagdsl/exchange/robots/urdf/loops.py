"""`<loop_joint>`: a joint between two links of the tree, as in Isaac Sim, in Drake's RigidBodyTree and in files for
RigidBodyDynamics.jl. The frame of `<link1>` is that of the joint and of its axis, `<link2>` the one that it moves.
"""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.exchange.robots.description import Joint, JointKind, Pose
from lagdsl.exchange.robots.turns import inverse
from lagdsl.exchange.robots.urdf.joints import Joints
from lagdsl.exchange.robots.xml_tree import Element

_KINDS: dict[str, JointKind] = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": "fixed",
    "planar": "planar",
    "spherical": "spherical",
    "ball": "spherical",
    "floating": "floating",
}


def loop_joints(root: Element, own: Joints) -> Iterator[Joint]:
    """Joints that close loops; E1010 for types that no dialect has. A floating one holds nothing and is left out."""
    for element in root.all("loop_joint"):
        name, spelled = own.read.text(element, "name"), own.read.text(element, "type")
        ends = [_end(element, tag, own) for tag in ("link1", "link2")]
        if name is None or spelled is None or ends[0] is None or ends[1] is None:
            continue
        if spelled not in _KINDS:
            words = {"type": spelled, "known": ", ".join(_KINDS)}
            own.findings.error("E1010", element.place("type"), instead="the joint is left out", **words)
            continue
        kind = _KINDS[spelled]
        if kind == "floating":
            own.read.leave_out(element)
            continue
        (parent, before), (child, behind) = ends[0], ends[1]
        yield Joint(
            name=name,
            kind=kind,
            parent=parent,
            child=child,
            before=before,
            after=inverse(behind),
            axis=own.axis(element, kind),
            limits=own.limits(element, kind),
            passive=own.passive(element, kind),
            span=element.place("name"),
        )


def _end(element: Element, tag: str, own: Joints) -> tuple[str, Pose] | None:
    found = own.read.only(element, tag)
    if found is None:
        own.findings.error("E1005", element.head, element=element.tag, what=f"element `<{tag}>`")
        return None
    link = own.read.text(found, "link")
    pose = Pose(xyz=own.read.vector(found, "xyz"), rpy=own.read.vector(found, "rpy"))
    return None if link is None else (link, pose)
