"""The tree of links: names once, one root, no circles, and joints that move something."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from lagdsl.exchange.robots.description import Joint, Link, Mimic
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.xml_tree import Element
from lagdsl.foundation.diagnostics import Label

MAX_LINKS = 1000
WORLD = "world"
"""The end of a closure that is no link of the file."""
_FREE = "let one of the joints that imitate each other move by itself"


def root_of(robot: Element, links: Sequence[Link], joints: Sequence[Joint], findings: Findings) -> str | None:
    """The link that carries all others; None after E1002, E1007, E1008 or E1017."""
    if len(links) > MAX_LINKS:
        findings.error("E1002", robot.head, what="this robot", limit=MAX_LINKS, unit="links")
        return None
    known = _once("link", links, findings)
    _once("joint", joints, findings)
    if findings.sink.has_errors:
        return None
    if not links:
        findings.error("E1005", robot.head, element=robot.tag, what="element `<link>`")
        return None
    carried: dict[str, Joint] = {}
    for joint in joints:
        for name in (joint.parent, joint.child):
            if name not in known:
                findings.error("E1008", joint.span, what="link", name=name)
        if joint.child in carried:
            first = Label(carried[joint.child].span, "carried here already")
            findings.error("E1017", joint.span, first, reason=f"the link `{joint.child}` has two joints to its base")
        carried.setdefault(joint.child, joint)
    if findings.sink.has_errors:
        return None
    return _one_root(robot, links, carried, findings)


def _once(what: str, parts: Sequence[Link] | Sequence[Joint], findings: Findings) -> dict[str, Link | Joint]:
    known: dict[str, Link | Joint] = {}
    for part in parts:
        if part.name in known:
            findings.error("E1007", part.span, Label(known[part.name].span, "first here"), what=what, name=part.name)
        known.setdefault(part.name, part)
    return known


def _one_root(robot: Element, links: Sequence[Link], carried: dict[str, Joint], findings: Findings) -> str | None:
    """Every link leads down to one root."""
    sound: set[str] = set()
    roots = [link for link in links if link.name not in carried]
    for link in links:
        way: dict[str, None] = {}
        name = link.name
        while name in carried and name not in sound and name not in way:
            way[name] = None
            name = carried[name].parent
        if name in way:
            findings.error("E1017", carried[name].span, reason=f"the joints below link `{name}` lead back to it")
            return None
        sound |= way.keys()
    if len(roots) > 1:
        first = Label(roots[0].span, "the first one")
        findings.error(
            "E1017", roots[1].span, first, reason=f"`{roots[1].name}` is a second link that no joint carries"
        )
        return None
    return roots[0].name


def sound_closures(
    links: Sequence[Link], joints: Sequence[Joint], closures: Sequence[Joint], findings: Findings
) -> tuple[list[Link], list[Joint]]:
    """The joints that close loops between two links of the file or the world, and the links between two such joints in
    a row. E1007, E1008 or E1017 for others."""
    _once("joint", [*joints, *closures], findings)
    known = {link.name for link in links} | {WORLD}
    between = {
        joint.child: Link(name=joint.child, inertial=None, visuals=(), is_between=True, span=joint.span)
        for joint, following in pairwise(closures)
        if joint.child == following.parent and joint.child not in known
    }
    for joint in closures:
        for name in (joint.parent, joint.child):
            if name not in known and name not in between:
                findings.error("E1008", joint.span, what="link", name=name)
        if joint.parent == joint.child:
            findings.error("E1017", joint.span, reason=f"`{joint.name}` joins the link `{joint.child}` with itself")
    return list(between.values()), list(closures)


def sound_mimics(joints: Sequence[Joint], findings: Findings) -> list[Joint]:
    """The joints, each imitating one that moves along one coordinate, and not itself around a circle.

    Others lose their `mimic`, with E1008, E1016 or E1017.
    """
    of = {joint.name: joint for joint in joints}
    return [
        joint if joint.mimic is None or _is_sound(joint, joint.mimic, of, findings) else replace(joint, mimic=None)
        for joint in joints
    ]


def _is_sound(joint: Joint, mimic: Mimic, of: dict[str, Joint], findings: Findings) -> bool:
    instead = "the joint moves by itself"
    leader = of.get(mimic.joint)
    if leader is None:
        findings.error("E1008", mimic.span, what="joint", name=mimic.joint, instead=instead)
        return False
    if leader.kind not in ("revolute", "prismatic"):
        findings.error("E1016", mimic.span, what=f"<mimic> of a {leader.kind} joint", instead=instead)
        return False
    seen: set[str] = set()
    now: Joint | None = joint
    while now is not None and now.mimic is not None and now.name not in seen:
        seen.add(now.name)
        now = of.get(now.mimic.joint)
    if now is not None and now.name == joint.name:
        reason = f"the joint `{joint.name}` imitates itself"
        findings.error("E1017", mimic.span, reason=reason, help=_FREE, instead=instead)
        return False
    return True


def leader_of(joint: Joint, of: dict[str, Joint]) -> Joint:
    """The joint at the end of the chain of imitation."""
    while joint.mimic is not None:
        joint = of[joint.mimic.joint]
    return joint
