"""MJCF files: https://mujoco.readthedocs.io/en/stable/XMLreference.html. MuJoCo resolves defaults, classes and shapes.

The tree of elements serves for safety before MuJoCo reads the file, and for the places of diagnostics.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

from lagdsl.robots.description import Actuator, Robot, Servo, Vector
from lagdsl.robots.findings import Findings
from lagdsl.robots.mjcf_actuators import actuators_of, tendons_of
from lagdsl.robots.mjcf_bounds import check_bounds, check_numbers
from lagdsl.robots.mjcf_contacts import tell_contacts
from lagdsl.robots.mjcf_features import tell_features
from lagdsl.robots.mjcf_parts import Places, joints_of, links_of
from lagdsl.robots.tree import MAX_LINKS, weightless_as_rigid
from lagdsl.robots.visuals import leads_out
from lagdsl.robots.xml_tree import Element, read_xml
from lagdsl.source import Span

_MAX_FILES = 100
_NOT_READ = ("camera", "light", "sensor", "site", "keyframe", "contact", "numeric", "text", "tuple", "spatial")
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
    if model.nbody > MAX_LINKS:
        findings.error("E1002", root.head, what="this robot", limit=MAX_LINKS, unit="bodies")
        return None
    check_numbers(model, root, findings)
    if findings.sink.has_errors:
        return None
    places = Places(mujoco, model, root.head, _named(elements), path.parent)
    tell_features(mujoco, model, places, findings)
    _tell_left_out(elements, findings)
    tell_contacts(places, findings)
    links, base = links_of(places, findings), places.body(0)
    joints = weightless_as_rigid(base, links, joints_of(places, findings), findings)
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
    """The elements of a file and of those that it includes; every file is checked before MuJoCo opens one.

    E1013 for a name that leads out of the folder of the robot; None after errors of an included file.
    """
    waiting, found, files = [root], [], 1
    while waiting:
        element = waiting.pop()
        found.append(element)
        waiting += reversed(element.children)
        name = element.attributes.get("file")
        if name is None:
            continue
        if leads_out(name, path, _folders(found)):
            reason = "it lies outside of the folder of the robot"
            findings.error("E1013", element.place("file"), file=name, reason=reason)
            continue
        if element.tag == "include":
            files += 1
            inner = read_xml(path.resolve().parent / name, findings.sink) if files <= _MAX_FILES else None
            if inner is None:
                if files > _MAX_FILES:
                    findings.error("E1002", element.head, what="this robot", limit=_MAX_FILES, unit="files")
                return None
            waiting.append(inner)
    return found


def _folders(elements: list[Element]) -> list[str]:
    """The folders that the file puts before names of meshes and pictures."""
    names = ("meshdir", "assetdir", "texturedir")
    compilers = [element for element in elements if element.tag == "compiler"]
    return ["", *(element.attributes[name] for element in compilers for name in names if name in element.attributes)]


def _named(elements: list[Element]) -> dict[tuple[str, str], Span]:
    """Places of elements by tag and name."""
    found: dict[tuple[str, str], Span] = {}
    for element in elements:
        if "name" in element.attributes:
            tag = "joint" if element.tag == "freejoint" else element.tag
            found.setdefault((tag, element.attributes["name"]), element.place("name"))
    return found


def _tell_left_out(elements: list[Element], findings: Findings) -> None:
    counts = Counter(element.tag for element in elements if element.tag in _NOT_READ)
    for tag, count in counts.items():
        place = next(element.head for element in elements if element.tag == tag)
        findings.note("N1019", place, tag=tag, times="once" if count == 1 else f"{count} times")


def _one_line(text: str) -> str:
    return " ".join(text.split())[:300]
