"""MJCF files: https://mujoco.readthedocs.io/en/stable/XMLreference.html. MuJoCo resolves defaults, classes and shapes.

The tree of elements serves for safety before MuJoCo reads the file, and for the places of diagnostics.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

from lagdsl.robots.description import Actuator, Robot, Servo, Vector
from lagdsl.robots.findings import Findings
from lagdsl.robots.mjcf_actuators import ACTUATORS, actuators_of, tendons_of
from lagdsl.robots.mjcf_bounds import check_bounds, check_numbers
from lagdsl.robots.mjcf_contacts import tell_contacts
from lagdsl.robots.mjcf_features import tell_features
from lagdsl.robots.mjcf_parts import Kind, Places, joints_of, links_of, sites_of
from lagdsl.robots.tree import MAX_LINKS, sound_mimics, weightless_as_rigid
from lagdsl.robots.visuals import leads_out
from lagdsl.robots.xml_tree import Element, read_xml

_MAX_FILES = 100
# Tags of parts by the section of the file that holds them, and what MuJoCo calls them.
_KINDS: dict[str, tuple[frozenset[str], Kind]] = {
    "worldbody": (frozenset({"body"}), "body"),
    "equality": (frozenset({"connect", "weld", "joint", "tendon", "flex", "flexvert", "flexstrain"}), "equality"),
    "tendon": (frozenset({"fixed", "spatial"}), "tendon"),
    "actuator": (ACTUATORS, "actuator"),
}
_IN_BODIES: dict[str, Kind] = {"joint": "joint", "freejoint": "joint", "site": "site"}
_NOT_READ = ("camera", "light", "sensor", "keyframe", "contact", "numeric", "text", "tuple", "spatial")
_GRAVITY_OFF = "mjDSBL_GRAVITY"


def read_mjcf(path: Path, root: Element, findings: Findings) -> Robot | None:
    """The robot of a file, or None after errors."""
    try:
        import mujoco
    except ImportError:
        findings.error("E1014", None)
        return None
    elements = _all_elements(path, root, findings)
    if elements is not None:
        check_bounds(elements, root, findings)
    if elements is None or findings.sink.has_errors:
        return None
    model = _model(mujoco, path, root, findings)
    if model is None:
        return None
    if model.nbody + model.nsite > MAX_LINKS:
        findings.error("E1002", root.head, what="this robot", limit=MAX_LINKS, unit="bodies and sites")
        return None
    check_numbers(model, root, findings)
    if findings.sink.has_errors:
        return None
    parts = _parts(root)
    named = {(kind, part.attributes.get("name", "")): part for kind, own in parts.items() for part in own}
    places = Places(mujoco, model, root.head, parts, named, path.parent)
    tell_features(mujoco, model, places, findings)
    _tell_left_out(elements, findings)
    tell_contacts(places, findings)
    links, base, sites = links_of(places, findings), places.body(0), list(sites_of(places))
    joints = sound_mimics(joints_of(places, findings), findings)
    if findings.sink.has_errors:  # joints that imitate each other in a circle have no leader
        return None
    joints = weightless_as_rigid(base, links, joints, findings)
    links += [link for link, _ in sites]
    joints += [joint for _, joint in sites]
    tendons = tendons_of(places, joints, findings)
    drives = actuators_of(places, joints, findings)
    if findings.sink.has_errors:
        return None
    without = model.opt.disableflags & int(getattr(mujoco.mjtDisableBit, _GRAVITY_OFF))
    x, y, z = (0.0, 0.0, 0.0) if without else map(float, model.opt.gravity)
    gravity: Vector = (x, y, z)
    return Robot(
        name=root.attributes.get("model", "").strip() or path.stem,
        origin=path.name,
        root=base,
        links=tuple(links),
        joints=tuple(joints),
        actuators=tuple(drive for drive in drives if isinstance(drive, Actuator)),
        servos=tuple(drive for drive in drives if isinstance(drive, Servo)),
        tendons=tuple(tendons),
        gravity=gravity,
        span=root.head,
    )


def _model(mujoco: Any, path: Path, root: Element, findings: Findings) -> Any:
    """The model that MuJoCo makes of a file; E1015 where it makes none, N1021 for its warnings.

    Left to itself MuJoCo writes warnings into a file of the current folder.
    """
    warnings: list[str] = []
    mujoco.set_mju_user_warning(warnings.append)
    try:
        model = mujoco.MjModel.from_xml_path(str(path))
    except (ValueError, MemoryError, RuntimeError, mujoco.FatalError) as fault:
        findings.error("E1015", root.head, reason=_one_line(str(fault)))
        return None
    finally:
        mujoco.set_mju_user_warning(None)
    for warning in warnings:
        findings.note("N1021", root.head, text=_one_line(warning))
    return model


def _all_elements(path: Path, root: Element, findings: Findings) -> list[Element] | None:
    """The elements of a file and of those that it includes, which become children of `<include>`; every file is checked
    before MuJoCo opens one.

    E1013 for a name that leads out of the folder of the robot; None after errors of an included file.
    """
    waiting, found, files = [root], [], 1
    while waiting:
        element = waiting.pop()
        found.append(element)
        name = element.attributes.get("file")
        if name is not None and leads_out(name, path, _folders(found)):
            reason = "it lies outside of the folder of the robot"
            findings.error("E1013", element.place("file"), file=name, reason=reason)
        elif name is not None and element.tag == "include":
            files += 1
            inner = read_xml(path.resolve().parent / name, findings.sink) if files <= _MAX_FILES else None
            if inner is None:
                if files > _MAX_FILES:
                    findings.error("E1002", element.head, what="this robot", limit=_MAX_FILES, unit="files")
                return None
            element.children.append(inner)
        waiting += reversed(element.children)
    return found


def _folders(elements: list[Element]) -> list[str]:
    """The folders that the file puts before names of meshes and pictures."""
    names = ("meshdir", "assetdir", "texturedir")
    compilers = [element for element in elements if element.tag == "compiler"]
    return ["", *(element.attributes[name] for element in compilers for name in names if name in element.attributes)]


def _parts(root: Element) -> dict[Kind, list[Element]]:
    """The parts of each kind in the order of the file, which is that of their numbers in MuJoCo."""
    found: dict[Kind, list[Element]] = {kind: [] for _, kind in _KINDS.values()}
    found |= {kind: [] for kind in _IN_BODIES.values()}
    waiting = [(child, "") for child in reversed(root.children)]
    while waiting:
        element, section = waiting.pop()
        tags, kind = _KINDS.get(section, (frozenset(), "body"))
        if element.tag in tags:
            found[kind].append(element)
        elif section == "worldbody" and element.tag in _IN_BODIES:
            found[_IN_BODIES[element.tag]].append(element)
        inside = section if section or element.tag in ("include", "mujocoinclude") else element.tag
        waiting += [(child, inside) for child in reversed(element.children)]
    return found


def _tell_left_out(elements: list[Element], findings: Findings) -> None:
    counts = Counter(element.tag for element in elements if element.tag in _NOT_READ)
    for tag, count in counts.items():
        place = next(element.head for element in elements if element.tag == tag)
        findings.note("N1019", place, tag=tag, times="once" if count == 1 else f"{count} times")


def _one_line(text: str) -> str:
    return " ".join(text.split())[:300]
