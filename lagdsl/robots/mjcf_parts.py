"""Bodies, joints and actuators of a model that MuJoCo has read, as parts of a robot."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lagdsl.record import record
from lagdsl.robots.description import (
    Box,
    Capsule,
    Cylinder,
    Inertial,
    Joint,
    JointKind,
    Limits,
    Link,
    Mesh,
    Mimic,
    Passive,
    Pose,
    Sphere,
    Vector,
    Visual,
)
from lagdsl.robots.findings import Findings
from lagdsl.robots.inertia import checked, entries_of
from lagdsl.robots.xml_tree import Element
from lagdsl.source import Span

Floats = NDArray[np.float64]
Kind: TypeAlias = Literal["body", "joint", "site", "equality", "tendon", "actuator"]
_VISIBLE_GROUPS = 3  # MuJoCo's viewer shows the groups 0 to 2 at first: the others are shapes for collisions
_SMALL = 1e-15
_KINDS: tuple[JointKind, ...] = ("floating", "spherical", "prismatic", "revolute")  # as mjtJoint counts them


@record()
class Places:
    """A model of MuJoCo with the names of its parts and their places in the file; `files` of meshes by their names."""

    mujoco: Any
    model: Any
    head: Span
    parts: dict[Kind, list[Element]]
    named: dict[tuple[Kind, str], Element]
    files: dict[str, tuple[str, Path]]

    def body(self, index: int) -> str:
        """The name of a body; those without one are counted."""
        return str(self.model.body(index).name) or f"body_{index}"

    def joint(self, index: int) -> str:
        """The name of a joint; one without a name has that of its body."""
        body = int(self.model.jnt_bodyid[index])
        number = index - int(self.model.body_jntadr[body])
        return str(self.model.joint(index).name) or f"{self.body(body)}_joint{f'_{number + 1}' if number else ''}"

    def place(self, kind: Kind, index: int) -> Span:
        """The place of a part: found by its number where the file has as many as the model, else by its name.

        A joint that has no name stands at its body, all others at the root of the file.
        """
        model, name = self.model, str(getattr(self.model, kind)(index).name)
        counts = {"body": model.nbody - 1, "equality": model.neq, "tendon": model.ntendon, "actuator": model.nu}
        number = index - 1 if kind == "body" else index
        if number >= 0 and len(self.parts[kind]) == counts.get(kind):
            return self.parts[kind][number].place("name")
        if (kind, name) in self.named:
            return self.named[kind, name].place("name")
        return self.place("body", int(model.jnt_bodyid[index])) if kind == "joint" else self.head


# ---- bodies ----------------------------------------------------------------------------------------------------------


def links_of(places: Places, findings: Findings) -> list[Link]:
    """A link for each body, and a place between joints that follow each other on one body."""
    model, found = places.model, []
    for index in range(model.nbody):
        name = places.body(index)
        span = places.place("body", index)
        for number in range(1, int(model.body_jntnum[index])):
            found.append(Link(name=_between(name, number), inertial=None, visuals=(), is_between=True, span=span))
        inertial = _inertial(places, index, name, span, findings) if index else None
        found.append(Link(name=name, inertial=inertial, visuals=_visuals(places, index, span), span=span))
    return found


def sites_of(places: Places) -> Iterator[tuple[Link, Joint]]:
    """Sites with names: frames that stand still in their body, as the tools of arms are."""
    model, taken = places.model, {places.body(index) for index in range(places.model.nbody)}
    for index in range(model.nsite):
        own = str(model.site(index).name)
        if not own:
            continue
        name = own if own not in taken else f"{own}_site"
        span = places.place("site", index)
        seat = Pose(xyz=_vector(model.site_pos[index]), rpy=fixed_angles(_matrix(model.site_quat[index])))
        parent = places.body(int(model.site_bodyid[index]))
        yield (
            Link(name=name, inertial=None, visuals=(), span=span),
            Joint(name=f"{name}_mount", kind="fixed", parent=parent, child=name, before=seat, span=span),
        )


def _between(body: str, number: int) -> str:
    return f"{body} after joint {number}"


def _inertial(places: Places, index: int, name: str, span: Span, findings: Findings) -> Inertial | None:
    """MuJoCo has principal moments in axes of their own."""
    model = places.model
    matrix = _matrix(model.body_iquat[index])
    entries = entries_of(matrix @ np.diag(model.body_inertia[index]) @ matrix.T)
    xx, yy, zz, xy, xz, yz = _without_rounding(entries, max(entries))
    return checked(
        float(model.body_mass[index]), _vector(model.body_ipos[index]), (xx, yy, zz, xy, xz, yz), name, span, findings
    )


def _visuals(places: Places, body: int, span: Span) -> tuple[Visual, ...]:
    """Shapes of the first groups: planes, ellipsoids and fields of heights have no counterpart."""
    model, found, kinds = places.model, list[Visual](), places.mujoco.mjtGeom
    first, count = int(model.body_geomadr[body]), int(model.body_geomnum[body])
    for index in range(first, first + count):
        if model.geom_group[index] >= _VISIBLE_GROUPS:
            continue
        pose = Pose(xyz=_vector(model.geom_pos[index]), rpy=fixed_angles(_matrix(model.geom_quat[index])))
        a, b, c = map(float, model.geom_size[index])
        kind = int(model.geom_type[index])
        if kind == kinds.mjGEOM_SPHERE:
            found.append(Sphere(pose=pose, radius=a, span=span))
        elif kind == kinds.mjGEOM_CAPSULE:
            found.append(Capsule(pose=pose, radius=a, length=2 * b, span=span))
        elif kind == kinds.mjGEOM_CYLINDER:
            found.append(Cylinder(pose=pose, radius=a, length=2 * b, span=span))
        elif kind == kinds.mjGEOM_BOX:
            found.append(Box(pose=pose, size=(2 * a, 2 * b, 2 * c), span=span))
        elif kind == kinds.mjGEOM_MESH:
            found.append(_mesh(places, index, span))
    return tuple(found)


def _mesh(places: Places, geom: int, span: Span) -> Mesh:
    """MuJoCo has moved the points of the file: the principal axes of the solid are those of the shape."""
    model = places.model
    mesh = int(model.geom_dataid[geom])
    name = str(model.mesh(mesh).name)
    file, place = places.files.get(name, (f"the mesh {name}", Path()))
    axes = _matrix(model.geom_quat[geom]) @ _matrix(model.mesh_quat[mesh]).T
    at = model.geom_pos[geom] - axes @ model.mesh_pos[mesh]
    return Mesh(
        file=file,
        place=place,
        pose=Pose(xyz=_vector(np.round(at, 12)), rpy=fixed_angles(axes)),
        scale=_vector(model.mesh_scale[mesh]),
        span=span,
    )


# ---- joints ----------------------------------------------------------------------------------------------------------


def joints_of(places: Places, findings: Findings) -> list[Joint]:
    """The joints of all bodies; a body without one is welded to the body before."""
    model, found = places.model, []
    mimics = _mimics(places, findings)
    for body in range(1, model.nbody):
        parent, name = places.body(int(model.body_parentid[body])), places.body(body)
        seat = Pose(xyz=_vector(model.body_pos[body]), rpy=fixed_angles(_matrix(model.body_quat[body])))
        first, count = int(model.body_jntadr[body]), int(model.body_jntnum[body])
        if count == 0:
            span = places.place("body", body)
            joint = Joint(name=f"{name}_mount", kind="fixed", parent=parent, child=name, before=seat, span=span)
            found.append(joint)
        elif model.jnt_type[first] == 0:  # a free joint counts from the world
            found.append(_free(places, first, parent, name))
        else:
            found += _row(places, list(range(first, first + count)), parent, name, mimics)
    return found


def _free(places: Places, index: int, parent: str, child: str) -> Joint:
    name = places.joint(index)
    q = list(map(float, places.model.qpos0[int(places.model.jnt_qposadr[index]) :][:7]))
    return Joint(
        name=name,
        kind="floating",
        parent=parent,
        child=child,
        before=Pose(),
        place=(*q,),
        span=places.place("joint", index),
    )


def _row(places: Places, joints: list[int], parent: str, child: str, mimics: dict[int, Mimic]) -> list[Joint]:
    """Joints of one body turn and slide it one after the other, each about a point that is fixed in the body."""
    model, found = places.model, []
    body = int(model.jnt_bodyid[joints[0]])
    origin, matrix = model.body_pos[body].copy(), _matrix(model.body_quat[body])
    anchor = np.zeros(3)
    for number, index in enumerate(joints):
        kind, axis = _KINDS[int(model.jnt_type[index])], model.jnt_axis[index]
        start = float(model.qpos0[int(model.jnt_qposadr[index])]) if kind != "spherical" else 0.0
        origin = origin + matrix @ (model.jnt_pos[index] - anchor)
        anchor = model.jnt_pos[index]
        if kind == "prismatic":  # the coordinate is `ref`, not zero, where the file shows the body
            origin = origin - matrix @ axis * start
        elif kind == "revolute" and start:
            matrix = matrix @ _turn(axis, -start)
        last = index == joints[-1]
        name = places.joint(index)
        found.append(
            Joint(
                name=name,
                kind=kind,
                parent=_between(child, number) if number else parent,
                child=child if last else _between(child, number + 1),
                before=Pose(xyz=_vector(origin), rpy=fixed_angles(matrix)),
                after=Pose(xyz=_vector(-anchor)) if last else Pose(),
                axis=_vector(axis),
                start=start,
                limits=_limits(model, index, kind),
                passive=_passive(model, index, kind),
                mimic=mimics.get(index),
                span=places.place("joint", index),
            )
        )
        origin, matrix = np.zeros(3), np.eye(3)
    return found


def _limits(model: Any, index: int, kind: JointKind) -> Limits:
    if kind not in ("revolute", "prismatic") or not model.jnt_limited[index]:
        return Limits()
    lower, upper = map(float, model.jnt_range[index])
    return Limits(lower=lower, upper=upper)


def _passive(model: Any, index: int, kind: JointKind) -> Passive:
    if kind not in ("revolute", "prismatic"):
        return Passive()
    dof = int(model.jnt_dofadr[index])
    return Passive(
        damping=float(model.dof_damping[dof].item()),
        friction=float(model.dof_frictionloss[dof]),
        stiffness=float(model.jnt_stiffness[index].item()),
        rest=float(model.qpos_spring[int(model.jnt_qposadr[index])]),
        armature=float(model.dof_armature[dof]),
    )


def _mimics(places: Places, findings: Findings) -> dict[int, Mimic]:
    """Joints that an equality of first degree ties to another one; E1016 for other equalities."""
    model, found = places.model, {}
    for index in range(model.neq):
        a0, a1, *higher = map(float, model.eq_data[index][:5])
        span = places.place("equality", index)
        ties_joints = int(model.eq_type[index]) == int(places.mujoco.mjtEq.mjEQ_JOINT)
        if not model.eq_active0[index]:
            continue
        if not ties_joints or any(higher) or model.eq_obj2id[index] < 0:
            findings.error("E1016", span, what="an equality that is no gear of two joints", instead="it is left out")
            continue
        one, two = int(model.eq_obj1id[index]), int(model.eq_obj2id[index])
        if one in found:
            what = f"a second equality of the joint {places.joint(one)}"
            findings.error("E1016", span, what=what, instead="it is left out")
            continue
        starts = [float(model.qpos0[int(model.jnt_qposadr[joint])]) for joint in (one, two)]
        offset = starts[0] + a0 - a1 * starts[1]  # MuJoCo's polynomial is of the distances from the start
        found[one] = Mimic(joint=places.joint(two), multiplier=a1, offset=offset, span=span)
    return found


# ---- turns -----------------------------------------------------------------------------------------------------------


def _matrix(quaternion: Floats) -> Floats:
    """The rotation matrix of a quaternion, scalar first."""
    w, x, y, z = quaternion / np.linalg.norm(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def _turn(axis: Floats, angle: float) -> Floats:
    return _matrix(np.array([math.cos(angle / 2), *(math.sin(angle / 2) * axis / np.linalg.norm(axis))]))


def fixed_angles(matrix: Floats) -> Vector:
    """Roll, pitch, yaw of Rz(yaw) Ry(pitch) Rx(roll), near the vertical pitch, too.

    Roll is found in the axes that yaw has turned: an error of yaw, which nothing determines there, is made good.
    """
    m = matrix
    yaw = math.atan2(m[1, 0], m[0, 0]) if math.hypot(m[0, 0], m[1, 0]) > _SMALL else 0.0
    c, s = math.cos(yaw), math.sin(yaw)
    pitch = math.atan2(-m[2, 0], c * m[0, 0] + s * m[1, 0])
    roll = math.atan2(s * m[0, 2] - c * m[1, 2], c * m[1, 1] - s * m[0, 1])
    if abs(roll) > math.pi / 2 and abs(yaw) > math.pi / 2:  # a turn about y alone is written as one
        roll, pitch, yaw = (math.remainder(a, 2 * math.pi) for a in (roll + math.pi, math.pi - pitch, yaw + math.pi))
    return _snapped(roll), _snapped(pitch), _snapped(yaw)


def _snapped(angle: float) -> float:
    """The whole number of degrees next to it where a rounding error separates them."""
    degrees = math.radians(round(math.degrees(angle)))
    return degrees if abs(angle - degrees) < 4 * _SMALL else angle


def _vector(values: Floats) -> Vector:
    x, y, z = _without_rounding([float(value) for value in values], 1.0)
    return x, y, z


def _without_rounding(values: list[float], size: float) -> list[float]:
    return [0.0 if abs(value) <= _SMALL * size else value for value in values]
