"""Elements and attributes of URDF files that the import knows; it tells all others."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from lagdsl.exchange.robots.attributes import Attributes
from lagdsl.exchange.robots.xml_tree import Element
from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.foundation.source import Span

# By tag: attributes, and children that are read.
_KNOWN: dict[str, tuple[str, str]] = {
    "robot": ("name version", "link joint loop_joint transmission"),
    "link": ("name", "inertial visual"),
    "inertial": ("", "origin mass inertia"),
    "mass": ("value", ""),
    "inertia": ("ixx iyy izz ixy ixz iyz", ""),
    "origin": ("xyz rpy", ""),
    "visual": ("name", "origin geometry"),
    "geometry": ("", "box cylinder sphere mesh"),
    "box": ("size", ""),
    "cylinder": ("radius length", ""),
    "sphere": ("radius", ""),
    "mesh": ("filename scale", ""),
    "joint": ("name type", "origin parent child axis limit dynamics mimic"),
    "loop_joint": ("name type", "link1 link2 axis limit dynamics"),
    "link1": ("link xyz rpy", ""),
    "link2": ("link xyz rpy", ""),
    "parent": ("link", ""),
    "child": ("link", ""),
    "axis": ("xyz", ""),
    "limit": ("lower upper effort velocity", ""),
    "dynamics": ("damping friction", ""),
    "mimic": ("joint multiplier offset", ""),
}
# Without influence on the motion of a robot that touches nothing.
_HARMLESS = frozenset(
    {"material", "collision", "sensor", "gazebo", "safety_controller", "calibration", "contact", "verbose", "surface"}
    | {"self_filter", "collision_checking", "self_collision_checking", "fixed_frame", "frame", "ros2_control", "mujoco"}
    | {f"drake:{name}" for name in ("collision_filter_group", "proximity_properties", "illustration_properties")}
)
_ACTING = frozenset(
    {"force_element", "drake:joint", "drake:linear_bushing_rpy", "drake:linear_spring_damper", "drake:ball_constraint"}
)


def tell_unread(root: Element, read: Attributes) -> None:
    """N1019 for elements that change no motion, E1016 for those that do, W1026 for attributes and elements that are not
    known, once for each kind."""
    first: dict[tuple[str, str, bool], Span] = {}
    counts: Counter[tuple[str, str, bool]] = Counter()
    for element in _elements(root):
        attributes, children = (known.split() for known in _KNOWN[element.tag])
        for name in element.attributes:
            if name not in attributes and not name.startswith("xmlns"):
                counts[element.tag, name, True] += 1
                first.setdefault((element.tag, name, True), _name(element, name))
        for child in element.children:
            if child.tag in _ACTING:
                read.findings.error("E1016", child.head, what=f"<{child.tag}>", instead="it is left out")
            elif child.tag in _HARMLESS:
                if not _holds_loops(child):
                    read.leave_out(child)
            elif child.tag not in children and element.tag != "geometry":  # shapes are told where they are read
                counts[element.tag, child.tag, False] += 1
                first.setdefault((element.tag, child.tag, False), child.head)
    for (tag, name, is_attribute), span in first.items():
        count = counts[tag, name, is_attribute]
        written = f"attribute `{name}`" if is_attribute else f"element `<{name}>`"
        times = "" if count == 1 else f", {count} times"
        help = _help(tag, name, is_attribute)
        read.findings.sink.report("W1026", span, help=help, written=written, owner=tag, times=times)


def _elements(root: Element) -> Iterator[Element]:
    """Elements that are read, in the order of the file."""
    waiting = [root]
    while waiting:
        element = waiting.pop()
        yield element
        children = _KNOWN[element.tag][1].split()
        waiting += [child for child in reversed(element.children) if child.tag in children and child.tag in _KNOWN]


def _holds_loops(element: Element) -> bool:
    """True for an extension of Gazebo that has joints only."""
    tags = {child.tag for child in element.children}
    return element.tag == "gazebo" and "reference" not in element.attributes and tags == {"joint"}


def _help(tag: str, name: str, is_attribute: bool) -> str | None:
    attributes, children = (known.split() for known in _KNOWN[tag])
    if is_attribute and name in children:
        return f"`{name}` is an element: write `<{name} .../>` inside of `<{tag}>`"
    if not is_attribute and name in attributes:
        return f'`{name}` is an attribute: write `<{tag} {name}="...">`'
    known = attributes if is_attribute else children
    listed = ", ".join(known) or "none"
    return did_you_mean(name, known, f"known {'attributes' if is_attribute else 'elements'} of `<{tag}>`: {listed}")


def _name(element: Element, name: str) -> Span:
    """The place of the name of an attribute."""
    value = element.place(name)
    before = value.file.text[element.span.start : value.start]
    start = element.span.start + max(before.rfind(name), 0)
    return Span(value.file, start, start + len(name)) if name in before else value
