"""Newton-Euler equations of a URDF file, all vectors in the world: shares no line with the import or the compiler."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Mapping
from pathlib import Path

import numpy as np

G = np.array([0.0, 0.0, -9.80665])


def numbers(element: ET.Element | None, name: str, default: str = "0 0 0") -> np.ndarray:
    return np.array((element.get(name, default) if element is not None else default).split(), float)


def turn(axis: np.ndarray, angle: float) -> np.ndarray:
    """Rodrigues' formula."""
    x, y, z = axis / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def fixed_angles(rpy: np.ndarray) -> np.ndarray:
    ex, ey, ez = np.eye(3)
    return turn(ez, rpy[2]) @ turn(ey, rpy[1]) @ turn(ex, rpy[0])


class Robot:
    """Reads a file; every joint has one coordinate or is fixed, and stands behind the joint that carries it."""

    def __init__(self, path: Path) -> None:
        root = ET.parse(path).getroot()
        self.links = {link.get("name"): link for link in root.findall("link")}
        self.joints = root.findall("joint")
        self.moved = [joint.get("name") for joint in self.joints if joint.get("type") != "fixed"]
        children = {joint.find("child").get("link") for joint in self.joints}
        (self.root,) = self.links.keys() - children

    def motion(self, q: Mapping[str, float], qd: Mapping[str, float], qdd: Mapping[str, float]) -> dict:
        """Rotation, origin, angular velocity and acceleration, velocity and acceleration of origins, by link."""
        zero = np.zeros(3)
        found = {self.root: (np.eye(3), zero, zero, zero, zero, zero)}
        self.axes = {}
        for joint in self.joints:
            R, o, w, dw, v, a = found[joint.find("parent").get("link")]
            origin = joint.find("origin")
            arm = R @ numbers(origin, "xyz")
            R = R @ fixed_angles(numbers(origin, "rpy"))
            v, a, o = v + np.cross(w, arm), a + np.cross(dw, arm) + np.cross(w, np.cross(w, arm)), o + arm
            name, kind = joint.get("name"), joint.get("type")
            if kind != "fixed":
                own = numbers(joint.find("axis"), "xyz", "1 0 0")
                axis = R @ own / np.linalg.norm(own)
                self.axes[name] = (axis, o, kind)
                if kind == "prismatic":
                    way = q[name] * axis
                    a = a + np.cross(dw, way) + np.cross(w, np.cross(w, way))
                    a = a + 2 * np.cross(w, qd[name] * axis) + qdd[name] * axis
                    v, o = v + np.cross(w, way) + qd[name] * axis, o + way
                else:
                    R = R @ turn(own, q[name])
                    dw = dw + qdd[name] * axis + np.cross(w, qd[name] * axis)
                    w = w + qd[name] * axis
            found[joint.find("child").get("link")] = (R, o, w, dw, v, a)
        return found

    def efforts(self, q, qd, qdd, gravity: np.ndarray = G) -> dict[str, float]:
        """Forces and torques in the joints, every joint free."""
        motion = self.motion(q, qd, qdd)
        forces, moments = {}, {}
        for name, link in self.links.items():
            R, o, w, dw, _, a = motion[name]
            forces[name], moments[name] = np.zeros(3), np.zeros(3)
            inertial = link.find("inertial")
            if inertial is None:
                continue
            m = float(inertial.find("mass").get("value"))
            tensor = inertial.find("inertia")
            xx, xy, xz, yy, yz, zz = (float(tensor.get(f"i{k}")) for k in ("xx", "xy", "xz", "yy", "yz", "zz"))
            turned = R @ fixed_angles(numbers(inertial.find("origin"), "rpy"))
            I = turned @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ turned.T
            c = R @ numbers(inertial.find("origin"), "xyz")
            forces[name] = m * (a + np.cross(dw, c) + np.cross(w, np.cross(w, c)) - gravity)
            moments[name] = I @ dw + np.cross(w, I @ w) + np.cross(o + c, forces[name])  # about the world's origin
        found = {}
        for joint in reversed(self.joints):
            child, parent = joint.find("child").get("link"), joint.find("parent").get("link")
            if joint.get("type") != "fixed":
                axis, at, kind = self.axes[joint.get("name")]
                moment = moments[child] - np.cross(at, forces[child])
                found[joint.get("name")] = axis @ (forces[child] if kind == "prismatic" else moment)
            forces[parent] = forces[parent] + forces[child]
            moments[parent] = moments[parent] + moments[child]
        return found
