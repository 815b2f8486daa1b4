"""Inverse kinematics of a frame or a point of a model, with arguments as users give them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.derivation.structure.names import grammatical_subject, listed, located
from lagdsl.derivation.structure.points import Geometry, geometry
from lagdsl.engines.backends.python.support.kinematics import FrameKinematics, PointKinematics
from lagdsl.engines.backends.python.support.names import real_numbers
from lagdsl.foundation.diagnostics import Sink, failed
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.interfaces.api.names import Given, entries, keys_of
from lagdsl.language.settings.aliases import by_own_names, own_name
from lagdsl.language.settings.target import Target as SettingTarget
from lagdsl.motion.analysis.integrable import integrable_rows
from lagdsl.motion.analysis.inverse_kinematics import Placement, Pose, Target, inverse_kinematics
from lagdsl.motion.analysis.point import Point, System

_ORTHONORMAL = 1e-6


def placed(
    system: System,
    part: PointKinematics,
    wanted: tuple[ArrayLike | None, ArrayLike | None],
    p: Floats,
    begin: tuple[Mapping[str, SettingTarget], Given, Sequence[str]],
    t: float | None,
) -> Placement:
    """`wanted` are position and rotation, `begin` the coordinates by name, their start and the names of those that keep
    it. Raises ValueError, UnknownName and CompilationFailed (E0867)."""
    target = _target(*wanted)
    space = geometry(system.flat, system.engine, p)
    space = space if t is None else replace(space, t=float(t))
    _refuse_integrable(system, space)
    coordinates, start, hold = begin
    given = by_own_names(system.flat, start) if isinstance(start, Mapping) else start
    chosen = entries("start", given, coordinates)
    q = np.array([chosen.get(name, value) for name, value in zip(coordinates, space.q.tolist(), strict=True)])
    names = [key for name in hold for key in keys_of("coordinate", own_name(system.flat, name), coordinates)]
    held = tuple(list(coordinates).index(name) for name in names)
    return inverse_kinematics(system.flat, space, _pose(part, space), target, q, held)


def _pose(part: PointKinematics, space: Geometry) -> Pose:
    beside: dict[str, Any] = {"z": space.z, "u": space.u, "w": space.w, "p": space.p}

    def pose(q: Floats) -> tuple[Floats, Floats | None, Floats]:
        rotation = part.rotation(space.t, q, **beside) if isinstance(part, FrameKinematics) else None
        return part.position(space.t, q, **beside), rotation, part.jacobian(space.t, q, **beside)

    return pose


def _target(position: ArrayLike | None, rotation: ArrayLike | None) -> Target:
    if position is None and rotation is None:
        raise ValueError("give a position, a rotation, or both: there is nothing to solve for")
    place = None if position is None else _finite("position", position, (3,))
    turn = None if rotation is None else _finite("rotation", rotation, (3, 3))
    if turn is not None and (np.max(np.abs(turn @ turn.T - np.eye(3))) > _ORTHONORMAL or np.linalg.det(turn) < 0.0):
        raise ValueError("rotation is no rotation matrix: its columns must be a right-handed set of unit vectors")
    return Target(position=place, rotation=turn)


def _finite(name: str, given: ArrayLike, shape: tuple[int, ...]) -> Floats:
    value = real_numbers(name, given)
    if value.shape != shape:
        raise ValueError(f"{name} must have the shape {shape}, not {value.shape}")
    if not np.all(np.isfinite(value)):
        raise ValueError(f"{name} must be made of finite numbers")
    return value


def _refuse_integrable(system: System, space: Geometry) -> None:
    """E0867 where a row of velocity level stands for a position: its value is that of the motion before."""
    point = Point(t=space.t, q=space.q, qd=space.qd, z=space.z, u=space.u, w=space.w, p=space.p)
    rows = set(integrable_rows(system, point))
    if not rows:
        return
    found = [item.constraint for item in located(system.flat) if rows & set(item.rows)]
    sink = Sink()
    names = listed([grammatical_subject(system.flat, constraint) for constraint in found])
    sink.report("E0867", found[0].spans[0] if found[0].spans else None, names=names)
    raise failed(sink.diagnostics)
