"""Bodies, joints and actuators of a model that MuJoCo has read, as parts of a robot."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lagdsl.exchange.robots.description import (
    Box,
    Capsule,
    Cylinder,
    Inertial,
    Joint,
    JointKind,
    Limits,
    Link,
    Mesh,
    Passive,
    Pose,
    Sphere,
    Visual,
)
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.inertia import checked, entries_of
from lagdsl.exchange.robots.turns import fixed_angles, matrix_of, turn_about, vector_of, without_rounding
from lagdsl.exchange.robots.xml_tree import Element
from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span

Floats = NDArray[np.float64]
Kind: TypeAlias = Literal["body", "joint", "site", "equality", "tendon", "actuator"]
_VISIBLE_GROUPS = 3  # MuJoCo's viewer shows the groups 0 to 2 at first: the others are shapes for collisions
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

    def tendon(self, index: int) -> str:
        """The name of a tendon; those without one are counted."""
        return str(self.model.tendon(index).name) or f"tendon_{index + 1}"

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
        lift = float(model.body_gravcomp[index])
        found.append(Link(name=name, inertial=inertial, visuals=_visuals(places, index, span), lift=lift, span=span))
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
        seat = Pose(xyz=vector_of(model.site_pos[index]), rpy=fixed_angles(matrix_of(model.site_quat[index])))
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
    matrix = matrix_of(model.body_iquat[index])
    entries = entries_of(matrix @ np.diag(model.body_inertia[index]) @ matrix.T)
    xx, yy, zz, xy, xz, yz = without_rounding(entries, max(entries))
    return checked(
        float(model.body_mass[index]), vector_of(model.body_ipos[index]), (xx, yy, zz, xy, xz, yz), name, span, findings
    )


def _visuals(places: Places, body: int, span: Span) -> tuple[Visual, ...]:
    """Shapes of the first groups: planes, ellipsoids and fields of heights have no counterpart."""
    model, found, kinds = places.model, list[Visual](), places.mujoco.mjtGeom
    first, count = int(model.body_geomadr[body]), int(model.body_geomnum[body])
    for index in range(first, first + count):
        if model.geom_group[index] >= _VISIBLE_GROUPS:
            continue
        pose = Pose(xyz=vector_of(model.geom_pos[index]), rpy=fixed_angles(matrix_of(model.geom_quat[index])))
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
    axes = matrix_of(model.geom_quat[geom]) @ matrix_of(model.mesh_quat[mesh]).T
    at = model.geom_pos[geom] - axes @ model.mesh_pos[mesh]
    return Mesh(
        file=file,
        place=place,
        pose=Pose(xyz=vector_of(np.round(at, 12)), rpy=fixed_angles(axes)),
        scale=vector_of(model.mesh_scale[mesh]),
        span=span,
    )


# ---- joints ----------------------------------------------------------------------------------------------------------


def joints_of(places: Places) -> list[Joint]:
    """The joints of all bodies; a body without one is welded to the body before."""
    model, found = places.model, []
    for body in range(1, model.nbody):
        parent, name = places.body(int(model.body_parentid[body])), places.body(body)
        seat = Pose(xyz=vector_of(model.body_pos[body]), rpy=fixed_angles(matrix_of(model.body_quat[body])))
        first, count = int(model.body_jntadr[body]), int(model.body_jntnum[body])
        if count == 0:
            span = places.place("body", body)
            joint = Joint(name=f"{name}_mount", kind="fixed", parent=parent, child=name, before=seat, span=span)
            found.append(joint)
        elif model.jnt_type[first] == 0:  # a free joint counts from the world
            found.append(_free(places, first, parent, name))
        else:
            found += _row(places, list(range(first, first + count)), parent, name)
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
        passive=_passive(places.model, index, "floating"),
        span=places.place("joint", index),
    )


def _row(places: Places, joints: list[int], parent: str, child: str) -> list[Joint]:
    """Joints of one body turn and slide it one after the other, each about a point that is fixed in the body."""
    model, found = places.model, []
    body = int(model.jnt_bodyid[joints[0]])
    origin, matrix = model.body_pos[body].copy(), matrix_of(model.body_quat[body])
    anchor = np.zeros(3)
    for number, index in enumerate(joints):
        kind, axis = _KINDS[int(model.jnt_type[index])], model.jnt_axis[index]
        start = float(model.qpos0[int(model.jnt_qposadr[index])]) if kind != "spherical" else 0.0
        origin = origin + matrix @ (model.jnt_pos[index] - anchor)
        anchor = model.jnt_pos[index]
        if kind == "prismatic":  # the coordinate is `ref`, not zero, where the file shows the body
            origin = origin - matrix @ axis * start
        elif kind == "revolute" and start:
            matrix = matrix @ turn_about(axis, -start)
        last = index == joints[-1]
        name = places.joint(index)
        found.append(
            Joint(
                name=name,
                kind=kind,
                parent=_between(child, number) if number else parent,
                child=child if last else _between(child, number + 1),
                before=Pose(xyz=vector_of(origin), rpy=fixed_angles(matrix)),
                after=Pose(xyz=vector_of(-anchor)) if last else Pose(),
                axis=vector_of(axis),
                start=start,
                limits=_limits(model, index, kind),
                passive=_passive(model, index, kind),
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
    """MuJoCo gives all rates of a joint the damping and the armature of the joint."""
    dof = int(model.jnt_dofadr[index])
    damping, armature = float(model.dof_damping[dof].item()), float(model.dof_armature[dof])
    if kind not in ("revolute", "prismatic"):
        return Passive(damping=damping, armature=armature)
    return Passive(
        damping=damping,
        friction=float(model.dof_frictionloss[dof]),
        stiffness=float(model.jnt_stiffness[index].item()),
        rest=float(model.qpos_spring[int(model.jnt_qposadr[index])]),
        armature=armature,
    )
