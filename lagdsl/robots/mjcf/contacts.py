"""Contacts between shapes, which MuJoCo makes by itself and the text does not have.

Source: MuJoCo documentation, Computation, "Collision detection: selection".
"""

from __future__ import annotations

from typing import Any

import numpy as np

from lagdsl.robots.findings import Findings
from lagdsl.robots.mjcf.parts import Places

_BITS = 32  # of contype and conaffinity
_CONTACT_OFF = "mjDSBL_CONTACT"


def tell_contacts(places: Places, findings: Findings) -> None:
    """N1024 if MuJoCo lets bodies touch."""
    found = touching(places.mujoco, places.model)
    if found:
        place = places.place("body", found[0])
        findings.note("N1024", place, bodies="one body" if len(found) == 1 else f"{len(found)} bodies")


def touching(mujoco: Any, model: Any) -> list[int]:
    """Numbers of the moving bodies with a shape that MuJoCo lets touch one of another body.

    Bodies that are welded are one. A shape meets another where the `contype` of one and the `conaffinity` of the other
    share a bit; a body and the one that carries it do not meet, unless that is the world.
    """
    if model.opt.disableflags & int(getattr(mujoco.mjtDisableBit, _CONTACT_OFF)):
        return []
    welded = np.asarray(model.body_weldid)
    carrier = welded[np.asarray(model.body_parentid)[welded]]  # of each body, as one that is welded
    body = np.asarray(model.geom_bodyid)
    part = welded[body]
    meets = np.zeros(len(part), dtype=bool)
    for mine, other in (("geom_contype", "geom_conaffinity"), ("geom_conaffinity", "geom_contype")):
        for bit in range(_BITS):
            has = (np.asarray(getattr(model, mine)) >> bit) & 1 == 1
            there = np.zeros(model.nbody, dtype=int)
            there[part[(np.asarray(getattr(model, other)) >> bit) & 1 == 1]] = 1
            carried = np.bincount(carrier, weights=there * (welded == np.arange(model.nbody)), minlength=model.nbody)
            carried[0] = 0  # the world meets what it carries
            on_moving = np.where(carrier[part] > 0, there[carrier[part]], 0)
            meets |= has & (there.sum() - there[part] - on_moving - carried[part] > 0)
    return sorted({int(each) for each in body[meets & (part > 0)]})
