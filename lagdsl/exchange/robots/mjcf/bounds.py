"""Bounds of what MuJoCo makes of an MJCF file: elements that multiply others, and numbers that nothing can be."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from lagdsl.exchange.robots.attributes import LARGEST, LONGEST
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.xml_tree import MAX_ELEMENTS, Element

_MAX_SAMPLES = 20_000_000  # of a picture or a field of heights
_MAX_RESERVED = 1_000_000  # numbers that a file lets MuJoCo reserve
_MAX_MEMORY = 2**30  # bytes that it does
_MAX_ACTUATORS = 500  # efforts of one joint are one sum, and sums are nested
_UNITS = {"K": 2**10, "M": 2**20, "G": 2**30, "T": 2**40, "P": 2**50, "E": 2**60}
# Attributes whose product is a number of parts, by tag.
_PRODUCTS: dict[str, tuple[tuple[str, ...], int, str]] = {
    "texture": (("width", "height"), _MAX_SAMPLES, "samples"),
    "hfield": (("nrow", "ncol"), _MAX_SAMPLES, "samples"),
    "flexcomp": (("count",), MAX_ELEMENTS, "parts"),
    "composite": (("count",), MAX_ELEMENTS, "parts"),
}
# Arrays of MjModel that become numbers of the text.
_ARRAYS = (
    *(f"body_{name}" for name in ("pos", "quat", "ipos", "iquat", "mass", "inertia")),
    *("jnt_axis", "jnt_pos", "jnt_stiffness", "qpos0", "qpos_spring"),
    *("dof_damping", "dof_frictionloss", "dof_armature"),
    *(f"actuator_{name}" for name in ("gear", "gainprm", "biasprm", "dynprm")),
    *("wrap_prm", "tendon_stiffness", "tendon_damping", "eq_data"),
)


def check_bounds(elements: Sequence[Element], root: Element, findings: Findings) -> None:
    """E1002 for files that make MuJoCo take much time or memory, E1006 for numbers that are none: MuJoCo takes some of
    them for attributes that are not there."""
    for element in elements:
        for name, text in element.attributes.items():
            if name != "name" and "nan" in text.lower().split():
                shown = text[:LONGEST]
                findings.error("E1006", element.place(name), name=name, text=shown, expected="made of numbers")
        if element.tag in _PRODUCTS:
            names, limit, unit = _PRODUCTS[element.tag]
            count = math.prod(number for name in names for number in _numbers(element, name))
            _check(element, f"`<{element.tag}>`", count, limit, unit, findings)
        elif element.tag == "size":
            for name in element.attributes:
                most = max(_numbers(element, name), default=0.0)
                limit, unit = (_MAX_MEMORY, "bytes") if name == "memory" else (_MAX_RESERVED, "entries")
                _check(element, f"`{name}`", most, limit, unit, findings)
        elif element.tag == "actuator":
            _check(element, "`<actuator>`", len(element.children), _MAX_ACTUATORS, "elements", findings)
    if not findings.sink.has_errors:
        _check(root, "this file", _expanded(root), MAX_ELEMENTS, "elements", findings)


def check_numbers(model: Any, root: Element, findings: Findings) -> None:
    """E1015 for numbers that are none, infinite, or larger than 1e100."""
    arrays = {name: getattr(model, name) for name in _ARRAYS if hasattr(model, name)}
    for name, values in {"gravity": model.opt.gravity, **arrays}.items():
        if not np.all(np.abs(values) <= LARGEST):
            reason = f"{name} holds a number that is not finite or larger than {LARGEST:g}"
            findings.error("E1015", root.head, reason=reason)
            return


def _check(element: Element, what: str, count: float, limit: int, unit: str, findings: Findings) -> None:
    if not count <= limit:
        findings.error("E1002", element.head, what=what, limit=limit, unit=unit)


def _expanded(root: Element) -> float:
    """Number of elements after repetition."""
    total, waiting = 0.0, [(root, 1.0)]
    while waiting:
        element, times = waiting.pop()
        total += times
        inner = times * math.prod(_numbers(element, "count")) if element.tag == "replicate" else times
        waiting += [(child, inner) for child in element.children]
    return total


def _numbers(element: Element, name: str) -> list[float]:
    """Magnitudes in an attribute, `100M` among them; words that are none are left to MuJoCo."""
    found = []
    for word in element.attributes.get(name, "").split():
        scale = _UNITS.get(word[-1].upper(), 1)
        try:
            found.append(abs(float(word if scale == 1 else word[:-1])) * scale)
        except ValueError:
            continue
    return found
