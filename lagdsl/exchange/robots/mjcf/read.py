"""MJCF files: https://mujoco.readthedocs.io/en/stable/XMLreference.html. MuJoCo resolves defaults, classes and shapes.

The tree of elements serves for safety before MuJoCo reads the file, and for the places of diagnostics.
"""

from __future__ import annotations

import warnings
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

from lagdsl.exchange.robots.description import Actuator, Robot, Servo, Vector
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.idle import Tree, idle_as_rigid
from lagdsl.exchange.robots.mjcf.actuators import ACTUATORS, actuators_of, tendons_of
from lagdsl.exchange.robots.mjcf.bounds import check_bounds, check_numbers
from lagdsl.exchange.robots.mjcf.contacts import tell_contacts
from lagdsl.exchange.robots.mjcf.equalities import active, closures_of, equalities_of, tied_tendons
from lagdsl.exchange.robots.mjcf.features import tell_features
from lagdsl.exchange.robots.mjcf.files import all_elements, mesh_files, take_assets
from lagdsl.exchange.robots.mjcf.parts import Kind, Places, joints_of, links_of, sites_of
from lagdsl.exchange.robots.reach import Reach
from lagdsl.exchange.robots.tree import MAX_LINKS
from lagdsl.exchange.robots.xml_tree import Element

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


def read_mjcf(path: Path, root: Element, reach: Reach, findings: Findings) -> Robot | None:
    """The robot of a file, or None after errors."""
    try:
        import mujoco
    except ImportError:
        findings.error("E1014", None)
        return None
    elements = all_elements(path, root, reach, findings)
    if elements is not None:
        check_bounds(elements, root, findings)
    if elements is None or findings.sink.has_errors:
        return None
    spec = _specification(mujoco, path, root, findings)
    if spec is not None:
        take_assets(spec, elements, reach, findings)
    model = None if spec is None or findings.sink.has_errors else _model(mujoco, spec, root, findings)
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
    places = Places(mujoco, model, root.head, parts, named, mesh_files(spec, reach))
    tell_features(mujoco, model, places, findings)
    _tell_left_out(elements, findings)
    tell_contacts(places, findings)
    links, base, sites = links_of(places, findings), places.body(0), list(sites_of(places))
    holding = active(places, findings)
    joints, closures = joints_of(places), closures_of(places, holding, findings)
    tendons = tendons_of(places, joints, tied_tendons(places, holding), findings)
    equalities = list(equalities_of(places, holding, joints, {tendon.name for tendon in tendons}, findings))
    joints = idle_as_rigid(Tree(base, links, joints, closures, equalities, tendons), findings)
    links += [link for link, _ in sites]
    joints += [joint for _, joint in sites]
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
        closures=tuple(closures),
        equalities=tuple(equalities),
        span=root.head,
    )


def _specification(mujoco: Any, path: Path, root: Element, findings: Findings) -> Any:
    """The specification that MuJoCo reads in a file, before it opens files of shapes; None after E1015."""
    return _of_mujoco(mujoco, lambda: mujoco.MjSpec.from_file(str(path.resolve())), root, findings)


def _model(mujoco: Any, spec: Any, root: Element, findings: Findings) -> Any:
    """The model that MuJoCo makes of a specification; None after E1015."""
    return _of_mujoco(mujoco, spec.compile, root, findings)


def _of_mujoco(mujoco: Any, made: Callable[[], Any], root: Element, findings: Findings) -> Any:
    """The product of MuJoCo; E1015 where it makes none, N1021 for its warnings.

    Left to itself MuJoCo writes warnings into a file of the current folder, or gives them to Python.
    """
    told: list[str] = []
    mujoco.set_mju_user_warning(told.append)
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            product = made()
    except (ValueError, MemoryError, RuntimeError, mujoco.FatalError) as fault:
        findings.error("E1015", root.head, reason=_one_line(str(fault)))
        return None
    finally:
        mujoco.set_mju_user_warning(None)
    for text in (*told, *(str(warning.message) for warning in caught)):
        findings.note("N1021", root.head, text=_one_line(text))
    return product


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
