"""Forces of MuJoCo that the text does not have: each is an error, since the motion would be another one."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.mjcf.parts import Places
from lagdsl.foundation.source import Span

_LEFT_OUT = "it is left out"


def tell_features(mujoco: Any, model: Any, places: Places, findings: Findings) -> None:
    """E1016 for each."""
    for span, what in (*_of_the_whole(mujoco, model, places), *_of_joints(model, places)):
        findings.error("E1016", span, what=what, instead=_LEFT_OUT)


def _of_the_whole(mujoco: Any, model: Any, places: Places) -> Iterator[tuple[Span, str]]:
    if model.opt.density or model.opt.viscosity:
        yield places.head, "drag of a medium (density, viscosity)"
    for count, what in (
        (model.nflex, "a flexible body"),
        (model.nplugin, "a plugin"),
        (model.nmocap, "a body that motion capture moves"),
        (getattr(model, "nplastic", 0), "a plastic spring"),
    ):
        if count:
            yield places.head, what
    for flag in ("mjDSBL_SPRING", "mjDSBL_DAMPER", "mjDSBL_PASSIVE", "mjDSBL_ACTUATION", "mjDSBL_FRICTIONLOSS"):
        if hasattr(mujoco.mjtDisableBit, flag) and model.opt.disableflags & int(getattr(mujoco.mjtDisableBit, flag)):
            yield places.head, f"the flag {flag}"


def _of_joints(model: Any, places: Places) -> Iterator[tuple[Span, str]]:
    """Springs and dampers that are no straight lines; all of joints with more than one coordinate, and their limits."""
    for index in range(model.njnt):
        first = int(model.jnt_dofadr[index])
        count = {0: 6, 1: 3}.get(int(model.jnt_type[index]), 1)
        dofs = slice(first, first + count)
        name = places.joint(index)
        curved = [getattr(model, "jnt_stiffnesspoly", None), getattr(model, "dof_dampingpoly", None)]
        rows = [table[at] for table, at in zip(curved, (index, dofs), strict=True) if table is not None]
        if any(np.any(row) for row in rows):
            yield places.place("joint", index), f"a spring or damper of {name} that is no straight line"
        if count == 3 and model.jnt_limited[index]:
            yield places.place("joint", index), f"the limit of {name}, a joint in space"
        if count > 1 and (np.any(model.dof_frictionloss[dofs]) or np.any(model.jnt_stiffness[index])):
            yield places.place("joint", index), f"spring or friction of {name}, a joint in space"
        if model.jnt_actgravcomp[index] and model.jnt_actfrclimited[index]:
            yield places.place("joint", index), f"the limit of {name} for efforts that compensate gravity"
