"""Equalities of a model that MuJoCo has read: loops that joints close, and constraints of coordinates and tendons.

MuJoCo holds them by stiff springs and dampers, the text exactly. Source: MuJoCo documentation, XML reference,
"equality".
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from lagdsl.exchange.robots.description import Equality, Joint, Pose
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.mjcf.parts import Places
from lagdsl.exchange.robots.turns import fixed_angles, inverse, matrix_of, vector_of
from lagdsl.foundation.source import Span

_LEFT_OUT = "it is left out"
_COEFFICIENTS = 5
_OFF = ("mjDSBL_EQUALITY", "mjDSBL_CONSTRAINT")


def active(places: Places, findings: Findings) -> list[int]:
    """Numbers of the equalities that hold from the start; N1019 for others."""
    model, bits = places.model, places.mujoco.mjtDisableBit
    is_off = any(model.opt.disableflags & int(getattr(bits, flag)) for flag in _OFF if hasattr(bits, flag))
    found = []
    for index in range(model.neq):
        if model.eq_active0[index] and not is_off:
            found.append(index)
            continue
        place = places.place("equality", index)
        findings.note("N1019", place, tag="equality", times="since the file switches it off")
    return found


def closures_of(places: Places, numbers: list[int], findings: Findings) -> list[Joint]:
    """A ball for each `connect`, a rigid joint for each `weld`; E1016 for what has no counterpart."""
    kinds = places.mujoco.mjtEq
    found = []
    for index in numbers:
        kind, span = int(places.model.eq_type[index]), places.place("equality", index)
        if kind in (int(kinds.mjEQ_JOINT), int(kinds.mjEQ_TENDON)):
            continue
        if kind not in (int(kinds.mjEQ_CONNECT), int(kinds.mjEQ_WELD)):
            findings.error("E1016", span, what="an equality of a flexible body", instead=_LEFT_OUT)
        elif any(places.model.body_mocapid[body] >= 0 for body in _bodies(places, index)):
            findings.error("E1016", span, what="an equality with a body that motion capture moves", instead=_LEFT_OUT)
        else:
            found.append(_closure(places, index, kind == int(kinds.mjEQ_WELD), span))
    return found


def _bodies(places: Places, index: int) -> tuple[int, int]:
    """The bodies that an equality joins, by themselves or by sites."""
    model = places.model
    one, two = int(model.eq_obj1id[index]), int(model.eq_obj2id[index])
    if _joins_sites(places, index):
        return int(model.site_bodyid[one]), int(model.site_bodyid[two])
    return one, two


def _joins_sites(places: Places, index: int) -> bool:
    return int(places.model.eq_objtype[index]) == int(places.mujoco.mjtObj.mjOBJ_SITE)


def _closure(places: Places, index: int, is_weld: bool, span: Span) -> Joint:
    """A weld with a torque scale of zero holds a point only, as `connect` does."""
    model, data = places.model, places.model.eq_data[index]
    holds_turn = is_weld and float(data[10]) != 0.0
    if _joins_sites(places, index):
        sites = int(model.eq_obj1id[index]), int(model.eq_obj2id[index])
        before, behind = (_seat(model.site_pos[site], model.site_quat[site], holds_turn) for site in sites)
    elif is_weld:  # a point of the second body comes first
        before, behind = _seat(data[3:6], data[6:10], holds_turn), Pose(xyz=vector_of(data[:3]))
    else:
        before, behind = Pose(xyz=vector_of(data[:3])), Pose(xyz=vector_of(data[3:6]))
    one, two = (places.body(body) for body in _bodies(places, index))
    return Joint(
        name=_name(places, index, "weld" if is_weld else "connect"),
        kind="fixed" if holds_turn else "spherical",
        parent=one,
        child=two,
        before=before,
        after=inverse(behind),
        span=span,
    )


def _seat(position: Any, quaternion: Any, turns: bool) -> Pose:
    angles = fixed_angles(matrix_of(np.asarray(quaternion))) if turns else (0.0, 0.0, 0.0)
    return Pose(xyz=vector_of(position), rpy=angles)


def _name(places: Places, index: int, kind: str) -> str:
    return str(places.model.equality(index).name) or f"{kind}_{index + 1}"


def equalities_of(
    places: Places, numbers: list[int], joints: list[Joint], tendons: set[str], findings: Findings
) -> Iterator[Equality]:
    """Polynomials of coordinates and of lengths of tendons; E1016 for lengths that the text does not have."""
    model, kinds = places.model, places.mujoco.mjtEq
    moved = {joint.name for joint in joints if joint.kind in ("revolute", "prismatic")}
    for index in numbers:
        kind, span = int(model.eq_type[index]), places.place("equality", index)
        if kind not in (int(kinds.mjEQ_JOINT), int(kinds.mjEQ_TENDON)):
            continue
        of_joints = kind == int(kinds.mjEQ_JOINT)
        sides = [int(side) for side in (model.eq_obj1id[index], model.eq_obj2id[index]) if side >= 0]
        names = [places.joint(side) if of_joints else places.tendon(side) for side in sides]
        known = moved if of_joints else tendons
        unknown = [name for name in names if name not in known]
        if unknown:
            instead = "which is no fixed one of hinges and slides" if not of_joints else "which does not move"
            what = f"an equality of the {'joint' if of_joints else 'tendon'} {unknown[0]}, {instead}"
            findings.error("E1016", span, what=what, instead=_LEFT_OUT)
            continue
        starts = [
            float(model.qpos0[int(model.jnt_qposadr[side])]) if of_joints else float(model.tendon_length0[side])
            for side in sides
        ]
        yield Equality(
            name=_equality_name(places, index, names[0], of_joints),
            of="joint" if of_joints else "tendon",
            one=names[0],
            other=names[1] if len(names) > 1 else None,
            rests=(starts[0], starts[1] if len(starts) > 1 else 0.0),
            coefficients=tuple(map(float, model.eq_data[index][:_COEFFICIENTS])),
            span=span,
        )


def _equality_name(places: Places, index: int, one: str, of_joints: bool) -> str:
    return str(places.model.equality(index).name) or f"{one}_{'gear' if of_joints else 'tie'}"


def tied_tendons(places: Places, numbers: list[int]) -> set[int]:
    """Numbers of the tendons that equalities tie."""
    model, tendon = places.model, int(places.mujoco.mjtEq.mjEQ_TENDON)
    ties = [index for index in numbers if int(model.eq_type[index]) == tendon]
    return {int(side) for index in ties for side in (model.eq_obj1id[index], model.eq_obj2id[index]) if side >= 0}
