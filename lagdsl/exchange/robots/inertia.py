"""Masses and inertias of links: read, turned into the axes of the link, checked."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from lagdsl.exchange.robots.attributes import Attributes
from lagdsl.exchange.robots.description import Inertial, Vector
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.xml_tree import Element
from lagdsl.foundation.source import Span

Floats = NDArray[np.float64]
_SLACK = 1e-9  # a thin disc lies on the boundary, up to rounding: the bound of the compiler
_ROUNDING = 1e-8  # radius of gyration [m] below which a moment is a rounding error of whoever wrote the file
_ENTRIES = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")


def read_inertial(link: Element, read: Attributes, findings: Findings) -> Inertial | None:
    """The `<inertial>` of a link. None if there is none, or none that counts."""
    inertial = read.only(link, "inertial")
    if inertial is None:
        return None
    pose = read.pose(inertial)
    mass = read.required(read.only(inertial, "mass"), "value", inertial, "mass")
    tensor = read.only(inertial, "inertia")
    if tensor is None:
        findings.error("E1005", inertial.head, element="inertial", what="element `<inertia>`")
        return None
    entries = [read.required(tensor, name, inertial, "inertia") for name in _ENTRIES]
    turned = entries if not any(pose.rpy) else entries_of(turn(entries, rotation(pose.rpy)))
    least = abs(mass) * _ROUNDING**2
    xx, yy, zz, xy, xz, yz = (0.0 if abs(entry) <= least else entry for entry in turned)
    place = tensor.head if mass >= 0.0 else (inertial.first("mass") or inertial).place("value")
    name = link.attributes.get("name", "")
    return checked(mass, pose.xyz, (xx, yy, zz, xy, xz, yz), name, place, findings)


def checked(
    mass: float,
    com: Vector,
    inertia: tuple[float, float, float, float, float, float],
    name: str,
    span: Span,
    findings: Findings,
) -> Inertial | None:
    """The inertial of a link, None if it is nothing; E1011 for what no body has."""
    if mass < 0.0:
        instead = "the link is written without mass and inertia"
        findings.error("E1011", span, name=name, reason=f"its mass is {mass:g} kg", instead=instead)
        return None
    if mass == 0.0 and not any(inertia):
        return None
    fault = impossible(inertia)
    if fault is not None:
        instead = "its kinetic energy is written with these moments, as an energy"
        findings.error("E1011", span, name=name, reason=fault, instead=instead)
    return Inertial(mass=mass, com=com, inertia=inertia, is_possible=fault is None, span=span)


def impossible(inertia: tuple[float, ...]) -> str | None:
    """The reason for which no distribution of mass has this inertia, or None."""
    moments = np.linalg.eigvalsh(tensor_of(inertia))
    slack = _SLACK * float(np.abs(moments).max())
    shown = ", ".join(f"{moment:.4g}" for moment in moments)
    if moments[0] < -slack or min(inertia[:3]) < 0.0:
        return f"its principal moments {shown} kg.m2 are not all positive"
    xx, yy, zz = inertia[:3]
    if min(xx + yy - zz, yy + zz - xx, zz + xx - yy, moments[0] + moments[1] - moments[2]) < -slack:
        return f"the largest of its principal moments {shown} kg.m2 is larger than the two others together"
    return None


def rotation(rpy: Vector) -> Floats:
    """The matrix of fixed-axis angles roll, pitch, yaw: Rz(yaw) Ry(pitch) Rx(roll)."""
    (cr, sr), (cp, sp), (cy, sy) = ((math.cos(angle), math.sin(angle)) for angle in rpy)
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )


def tensor_of(entries: tuple[float, ...] | list[float]) -> Floats:
    """The symmetric matrix of xx, yy, zz, xy, xz, yz."""
    xx, yy, zz, xy, xz, yz = entries
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def turn(entries: list[float], matrix: Floats) -> Floats:
    """The tensor in the axes that `matrix` leads to: R I R'."""
    return matrix @ tensor_of(entries) @ matrix.T


def entries_of(tensor: Floats) -> list[float]:
    """xx, yy, zz, xy, xz, yz of a symmetric matrix."""
    return [float(tensor[i, j]) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
