"""Contacts between shapes, which MuJoCo makes by itself and the text does not have.

Source: MuJoCo documentation, Computation, "Collision detection: selection".
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.mjcf.parts import Places

_BITS = 32  # of contype and conaffinity
_SLIDING = 3  # condim of a contact with sliding friction alone; one has none, more have torsional and rolling friction
_CONTACT_OFF = "mjDSBL_CONTACT"


def tell_contacts(places: Places, findings: Findings) -> None:
    """N1024 if MuJoCo lets bodies touch."""
    shapes = touching_shapes(places.mujoco, places.model)
    found = touching(places.mujoco, places.model)
    if found:
        place, bodies = places.place("body", found[0]), "one body" if len(found) == 1 else f"{len(found)} bodies"
        findings.note("N1024", place, bodies=bodies, friction=friction_text(places.model, shapes))


def friction_text(model: Any, shapes: Sequence[int]) -> str:
    """Friction of shapes: of two MuJoCo takes the larger coefficient, and the larger `condim`."""
    condim = int(np.max(np.asarray(model.geom_condim)[shapes]))
    if condim < _SLIDING:
        return "without friction"
    sliding = np.asarray(model.geom_friction)[shapes, 0]
    low, high = float(np.min(sliding)), float(np.max(sliding))
    told = f"with `mu` = {low:g}" + (f" to {high:g}" if high > low else "")
    return told + (", torsional and rolling friction" if condim > _SLIDING else "")


def touching(mujoco: Any, model: Any) -> list[int]:
    """Numbers of the moving bodies with a shape that MuJoCo lets touch one of another body."""
    welded, body = np.asarray(model.body_weldid), np.asarray(model.geom_bodyid)
    return sorted({int(body[each]) for each in touching_shapes(mujoco, model) if welded[body[each]]})


def touching_shapes(mujoco: Any, model: Any) -> list[int]:
    """Numbers of the shapes, those of the world too, that MuJoCo lets touch one of another body.

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
    return [int(each) for each in np.flatnonzero(meets)]
